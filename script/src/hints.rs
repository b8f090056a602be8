//! What to write instead: of names that Python has, and of methods that cannot be there because the
//! script only records.

use assemcad_model::name::nearest;
use assemcad_model::param::clip;

use crate::fault::Fault;
use crate::language::{cq, math_names};
use crate::values::handle;

/// The fault that an attribute is missing, from the interpreter's message and what stands there.
pub(crate) fn missing(text: &str, written: &str) -> Option<Fault> {
    let mut quoted = text.split('`').skip(1).step_by(2);
    if let (true, Some(operation), Some(kind)) = (
        text.starts_with("Operation `") && text.contains("not supported"),
        quoted.next(),
        quoted.next(),
    ) {
        return unsupported(operation, kind);
    }
    let mut quoted = text.split('`').skip(1).step_by(2);
    if !text.contains("has no attribute") {
        return None;
    }
    let (kind, wanted) = (quoted.next()?, quoted.next()?);
    match kind {
        "Workplane" | "Shape" | "Shapes" | "Location" => Some(of_handle(kind, wanted)),
        "cq" => Some(of_cq(wanted, written)),
        "namespace" => {
            let near = nearest(wanted, math_names(), 2);
            Some(near_or(
                Fault::new(format!("math has no '{}'", clip(wanted))),
                &near,
                &math_names(),
            ))
        }
        _ => None,
    }
}

fn near_or(fault: Fault, near: &[&str], all: &[&str]) -> Fault {
    if near.is_empty() {
        fault.hint(format!("there are: {}", all.join(", ")))
    } else {
        fault.hint(format!("did you mean {}?", near.join(" or ")))
    }
}

/// What asks for measures, which nobody knows while the script runs.
const MEASURES: [&str; 31] = [
    "size",
    "Volume",
    "Area",
    "Length",
    "Center",
    "CenterOfBoundBox",
    "centerOfMass",
    "BoundingBox",
    "geomType",
    "isValid",
    "objects",
    "plane",
    "all",
    "largestDimension",
    "toPnt",
    "normalAt",
    "positionAt",
    "tangentAt",
    "startPoint",
    "endPoint",
    "Vertices",
    "Edges",
    "Wires",
    "Faces",
    "Shells",
    "Solids",
    "x",
    "y",
    "z",
    "toTuple",
    "ctx",
];

fn of_handle(kind: &str, wanted: &str) -> Fault {
    let fault = Fault::new(format!("a {kind} has no '{}'", clip(wanted)));
    if kind == "Workplane" || kind == "Shape" || kind == "Shapes" {
        if let Some(hint) = elsewhere(wanted) {
            return Fault::new(format!("there is no '{wanted}' in this language")).hint(hint);
        }
        if MEASURES.contains(&wanted) {
            let instead = match wanted {
                "size" | "all" | "objects" => {
                    "use .first(), .last(), .item(i), or .each(lambda o: ...) for all of them"
                }
                "plane" => "write .workplane(), .copyWorkplane(other) or cq.Plane(...)",
                "Vertices" | "Edges" | "Wires" | "Faces" | "Shells" | "Solids" => {
                    "write .faces(), .edges() and so on, with a selector"
                }
                _ => {
                    "compute it from the numbers of the script, or select with \">Z\" and the like"
                }
            };
            return fault.hint(format!(
                "the solid is made after the script has run and cannot be asked; {instead}"
            ));
        }
    }
    let all: Vec<&str> = handle::members(kind).collect();
    let near = nearest(wanted, all.iter().copied(), 2);
    if near.is_empty() && all.len() > 20 {
        return fault;
    }
    match (kind, near.is_empty()) {
        ("Shapes", _) => fault.hint("take one: shapes[0], or workplane.item(0).val()"),
        ("Location", _) => fault.hint(
            "a location that a function is given is for shape.moved(loc) and shape.located(loc)",
        ),
        (_, false) => fault.hint(format!("did you mean {}?", near.join(" or "))),
        (_, true) => fault.hint(format!("there are: {}", all.join(", "))),
    }
}

/// Methods of CadQuery that are left out, with what to write.
fn elsewhere(wanted: &str) -> Option<&'static str> {
    Some(match wanted {
        "text" => "there are no fonts; draw letters as outlines",
        "sketch" | "placeSketch" | "Sketch" => {
            "draw with rect, circle, polyline, lineTo, close and offset2D"
        }
        "interpPlate" => "draw the solid with extrude, loft or sweep",
        "parametricCurve" | "parametricSurface" => {
            "compute the points in a list and write .spline(points)"
        }
        "export" | "exportSvg" | "exportStep" | "exportStl" | "toSvg" | "toOCC" | "wrapped" => {
            "a script writes no files: leave the solid in `result`"
        }
        "filter" | "sort" | "map" | "apply" | "invoke" => {
            "use a selector such as \">Z\" or \"%CYLINDER\""
        }
        "cutEach" | "cboreCut" => "write .cut(...) with what is to be cut",
        "threePointArcTo" => "write .threePointArc(point1, point2)",
        _ => return None,
    })
}

fn of_cq(wanted: &str, written: &str) -> Fault {
    // What stands there is `cq.Foo` or `cq.selectors.Foo`, under whatever name cq has.
    let group = written.rsplit_once('.').map_or("", |(before, _)| before);
    let path = group.split_once('.').map_or("", |(_, path)| path).trim();
    let path = if cq::has(path) { path } else { "" };
    let shown = if path.is_empty() {
        "cq".to_owned()
    } else {
        format!("cq.{path}")
    };
    let fault = Fault::new(format!("{shown} has no '{}'", clip(wanted)));
    match wanted {
        "Assembly" | "Constraint" | "Color" => {
            return fault.hint("a script makes one part; parts are joined at their ports");
        }
        "Sketch" => return fault.hint(elsewhere("Sketch").unwrap_or_default()),
        "importers" => return fault.hint("a script reads no files"),
        _ => {}
    }
    let all: Vec<&str> = cq::members(path).collect();
    near_or(fault, &nearest(wanted, all.iter().copied(), 2), &all)
}

fn unsupported(operation: &str, kind: &str) -> Option<Fault> {
    if !["Workplane", "Shape", "Shapes", "Location"].contains(&kind) {
        return None;
    }
    let fault = Fault::new(format!("a {kind} has no `{operation}`"));
    Some(match operation {
        "call()" => fault.hint("leave the brackets out"),
        _ => fault.hint(
            "how many objects there are is known only after the script has run: use .item(i), .first(), .last() or .each(lambda o: ...)",
        ),
    })
}

/// What to write instead of a name that Python has.
pub(crate) fn name_hint(name: &str) -> Option<&'static str> {
    Some(match name {
        "isinstance" | "issubclass" => "write `type(x) == \"list\"`",
        "map" | "filter" => "write `[f(x) for x in items]`, with `if` to choose",
        "set" | "frozenset" => "write a dict with the members as keys",
        "open" | "input" | "exec" | "eval" | "compile" => "a script reaches nothing outside itself",
        "Workplane" | "Vector" | "Plane" | "Location" | "Solid" | "Edge" | "Wire" | "Compound" => {
            "it is behind cq: write cq.Workplane(\"XY\") and so on, or `from cadquery import Workplane`"
        }
        "pi" | "sin" | "cos" | "tan" | "sqrt" | "atan2" | "radians" | "degrees" | "floor"
        | "ceil" => "it is in math: write math.pi, math.sin(x) and so on",
        "Exception" | "ValueError" | "TypeError" | "RuntimeError" => "write `fail(message)`",
        "true" => "write `True`",
        "false" => "write `False`",
        "null" | "none" => "write `None`",
        "self" => "there are no classes: write functions",
        "np" | "numpy" => "write lists, `for`, and math.sin(x) and so on",
        "exporters" | "importers" => "a script reads and writes no files",
        "format" => "write `\"bore %s leaves no wall\" % d`",
        _ => return None,
    })
}
