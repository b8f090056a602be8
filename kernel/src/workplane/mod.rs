//! The modelling language on the kernel: from a recipe's calls to a solid and its ports.
//!
//! What CadQuery's `Workplane` does with a stack, a plane and a chain is done here, call by call. One
//! file for each sort of call: planes and selection, drawing, patterns, solids, booleans, motions,
//! ports. Booleans are held against what volumes and points say; unions never fall apart in silence.

mod args;
mod chain;
mod combine;
mod draw;
mod dress;
mod each;
mod face;
mod holes;
mod ports;
mod select;
mod shapes;
mod solid;
mod transform;
mod value;

use std::collections::BTreeSet;

use assemcad_model::ports::Port;
use assemcad_model::recipe::{Call, Recipe, Ref, reference};

pub(crate) use self::select::select;

use self::args::Args;
use self::chain::Index;
use self::value::{Object, Value};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// What a recipe makes, before it is judged.
#[derive(Debug)]
pub struct Made {
    /// The solids, as one shape.
    pub shape: Shape,
    /// How many solids there are.
    pub solids: usize,
    /// The ports, in the part's frame.
    pub ports: Vec<Port>,
}

/// Which call failed, and why.
#[derive(Debug)]
pub struct Failed {
    /// Its index in the recipe.
    pub step: usize,
    /// What is wrong.
    pub error: KernelError,
}

/// Carries out the calls of a recipe.
///
/// `on_call` is told of each call before it is carried out.
///
/// # Errors
/// The first call that is refused.
pub fn carry_out(
    recipe: &Recipe,
    on_call: &mut dyn FnMut(usize, &Call),
) -> core::result::Result<Made, Failed> {
    let mut run = Run {
        calls: &recipe.calls,
        values: Vec::with_capacity(recipe.calls.len()),
    };
    for (step, call) in recipe.calls.iter().enumerate() {
        on_call(step, call);
        if crate::memory::nearly_exhausted() {
            return Err(Failed {
                step,
                error: KernelError {
                    kind: crate::error::Kind::OutOfMemory,
                    message: "what the part needs so far fills the memory".to_owned(),
                },
            });
        }
        let value = run.call(step).map_err(|error| Failed { step, error })?;
        run.values.push(value);
    }
    let last = usize::try_from(recipe.result).unwrap_or(usize::MAX);
    run.result(last)
        .map_err(|error| Failed { step: last, error })
}

/// The calls and what those before the current one gave.
struct Run<'a> {
    calls: &'a [Call],
    values: Vec<Value>,
}

impl Run<'_> {
    fn result(&self, at: usize) -> Result<Made> {
        let (objects, ports) = match self.values.get(at) {
            Some(Value::Node(node)) => {
                let solids = node.solids_on_stack()?;
                let solids = if solids.is_empty() {
                    node.solid()?.parts(Topology::Solid)?
                } else {
                    solids
                };
                (solids, node.ports.as_ref().clone())
            }
            Some(Value::Object(object)) => (solids(core::slice::from_ref(object))?, Vec::new()),
            Some(Value::Objects(objects)) => (solids(objects)?, Vec::new()),
            Some(_) => return Err(KernelError::refused("the script's result is no workplane")),
            None => {
                return Err(KernelError::refused(format!(
                    "the recipe's result is call {at}, and it has {} calls",
                    self.calls.len()
                )));
            }
        };
        let all: Vec<&Shape> = objects.iter().collect();
        let shape = match all.as_slice() {
            [] => return Err(KernelError::refused("the script's result holds no solid")),
            [one] => one.try_clone()?,
            several => Shape::compound(several)?,
        };
        Ok(Made {
            shape,
            solids: all.len(),
            ports,
        })
    }

    /// Carries out one call.
    fn call(&mut self, step: usize) -> Result<Value> {
        let Some(call) = self.calls.get(step) else {
            return Err(KernelError::internal("a call is missing"));
        };
        for input in call.inputs() {
            if usize::try_from(input).map_or(true, |input| input >= step) {
                return Err(KernelError::refused(format!(
                    "it refers to call {input}, which is not an earlier one"
                )));
            }
        }
        match call.call.as_str() {
            "eachLocation" | "eachObject" => return Ok(Value::Later),
            // What the function gave and what stands for its argument may be known later only.
            "Workplane.eachpoint" if !call.on.is_some_and(|on| self.is_later(on)) => {
                return self.each(step, call, false);
            }
            "Workplane.each" if !call.on.is_some_and(|on| self.is_later(on)) => {
                return self.each(step, call, true);
            }
            _ => {}
        }
        if call.inputs().into_iter().any(|input| self.is_later(input)) {
            return Ok(Value::Later);
        }
        perform(&Args {
            call,
            values: &self.values,
        })
    }

    /// Whether what a call gives is known only when a function is applied.
    fn is_later(&self, at: Ref) -> bool {
        let value = usize::try_from(at).ok().and_then(|at| self.values.get(at));
        matches!(value, Some(Value::Later))
    }

    /// `each` and `eachpoint`: the calls of a function are carried out once for each object or place.
    fn each(&mut self, step: usize, call: &Call, objects: bool) -> Result<Value> {
        let result = if objects { "callback" } else { "arg" };
        let referred = |name: &str| {
            call.args
                .get(name)
                .and_then(reference)
                .and_then(|at| usize::try_from(at).ok())
        };
        let Some(variable) = referred("variable") else {
            // A shape or workplane, the same at every place.
            let args = Args {
                call,
                values: &self.values,
            };
            let fixed = args.objects(result)?;
            return each::each_point(&args, |_| Ok(fixed.clone()));
        };
        let Some(target) = referred(result) else {
            return Err(KernelError::refused("the function gives no shape"));
        };
        if variable >= step || target >= step {
            return Err(KernelError::refused(
                "a function uses what is not before it",
            ));
        }
        if self.waits(step) {
            // In the function of another call, of whose argument this one makes use too.
            return Ok(Value::Later);
        }
        let body = self.body(variable, step);
        let before = self.values.clone();
        let args = Args {
            call,
            values: &before,
        };
        let mut apply = |value: Value| -> Result<Vec<Object>> {
            self.put(variable, value);
            for at in &body {
                let value = self.call(*at)?;
                self.put(*at, value);
            }
            match self.values.get(target) {
                Some(Value::Node(node)) => Ok(node.objects.clone()),
                Some(Value::Object(object)) => Ok(vec![object.clone()]),
                Some(Value::Objects(objects)) => Ok(objects.clone()),
                _ => Err(KernelError::refused("the function gives no shape")),
            }
        };
        let done = if objects {
            each::each_object(&args, |object| apply(Value::Object(object)))
        } else {
            each::each_point(&args, |place| {
                apply(Value::Place(place.unwrap_or_default()))
            })
        };
        // The calls of the function have no value outside of it.
        self.values = before;
        done
    }

    /// The calls between the argument of a function and its end that depend on the argument.
    fn body(&self, variable: usize, end: usize) -> Vec<usize> {
        let mut found = Vec::new();
        for at in variable + 1..end {
            let uses = self.calls.get(at).is_some_and(|call| {
                call.inputs().into_iter().any(|input| {
                    usize::try_from(input).is_ok_and(|i| i == variable || found.contains(&i))
                })
            });
            if uses {
                found.push(at);
            }
        }
        found
    }

    /// Whether a call needs what another function is yet to be given: it is found among the calls that
    /// have no value so far, and is not the argument of a function that ends there.
    fn waits(&self, step: usize) -> bool {
        let later = |at: &usize| matches!(self.values.get(*at), Some(Value::Later));
        let (mut arguments, mut bound) = (Vec::new(), Vec::new());
        let (mut seen, mut open) = (BTreeSet::new(), vec![step]);
        while let Some(call) = open.pop().and_then(|at| self.calls.get(at)) {
            let variable = call.args.get("variable").and_then(reference);
            bound.extend(variable.and_then(|at| usize::try_from(at).ok()));
            for input in call.inputs() {
                let input = usize::try_from(input).unwrap_or(usize::MAX);
                if !later(&input) || !seen.insert(input) {
                    continue;
                }
                match self.calls.get(input).map(|call| call.call.as_str()) {
                    Some("eachLocation" | "eachObject") => arguments.push(input),
                    _ => open.push(input),
                }
            }
        }
        arguments.iter().any(|at| !bound.contains(at))
    }

    fn put(&mut self, at: usize, value: Value) {
        if let Some(place) = self.values.get_mut(at) {
            *place = value;
        }
    }
}

/// The solids of some objects.
fn solids(objects: &[Object]) -> Result<Vec<Shape>> {
    let mut found = Vec::new();
    for object in objects {
        if let Some(shape) = object.as_shape() {
            found.extend(shape.parts(Topology::Solid)?);
        }
    }
    Ok(found)
}

fn perform(args: &Args<'_>) -> Result<Value> {
    let name = args.call.call.as_str();
    match name.split_once('.') {
        None if name == "Workplane" => chain::begin(args),
        Some(("Workplane", short)) => on_workplane(args, short),
        Some(("Shape", short)) => shapes::method(args, short),
        Some(("Solid" | "Edge" | "Wire" | "Compound", _)) => shapes::make(args),
        _ => Err(shapes::unknown(name)),
    }
}

fn on_workplane(args: &Args<'_>, short: &str) -> Result<Value> {
    match short {
        "workplane" => chain::workplane(args),
        "copyWorkplane" => chain::copy_workplane(args),
        "workplaneFromTagged" => chain::workplane_from_tagged(args),
        "transformed" => chain::transformed(args),
        "center" => chain::center(args),
        "tag" => chain::tag(args),
        "end" => chain::end(args),
        "first" => chain::item(args, Index::First),
        "last" => chain::item(args, Index::Last),
        "item" => chain::item(args, Index::At(args.count("i")?)),
        "add" => chain::add(args),
        "newObject" => Ok(Value::Node(args.on()?.next(args.objects("objlist")?))),
        "val" => Ok(Value::Object(args.on()?.first())),
        "vals" => Ok(Value::Objects(args.on()?.objects.clone())),
        "findSolid" => {
            let found = args
                .on()?
                .search(args.flag("searchStack")?, args.flag("searchParents")?)?;
            found
                .map(|solid| Value::Object(Object::shape(solid)))
                .ok_or_else(|| KernelError::refused("there is no solid in this chain"))
        }
        "faces" => chain::choose(args, Topology::Face),
        "edges" => chain::choose(args, Topology::Edge),
        "vertices" => chain::choose(args, Topology::Vertex),
        "wires" => chain::choose(args, Topology::Wire),
        "shells" => chain::choose(args, Topology::Shell),
        "solids" => chain::choose(args, Topology::Solid),
        "compounds" => chain::choose(args, Topology::Compound),
        "ancestors" => chain::ancestors(args),
        "siblings" => chain::siblings(args),
        "pushPoints" => each::push_points(args),
        "rarray" => each::rarray(args),
        "polarArray" => each::polar_array(args),
        "box" => each::cuboid(args),
        "cylinder" => each::cylinder(args),
        "sphere" => each::sphere(args),
        "wedge" => each::wedge(args),
        "extrude" => solid::extrude(args),
        "twistExtrude" => solid::twist(args),
        "revolve" => solid::revolve(args),
        "sweep" => solid::sweep(args),
        "loft" => solid::loft(args),
        "cutBlind" => solid::cut_blind(args),
        "cutThruAll" => solid::cut_through(args),
        "hole" => solid::hole(args),
        "cboreHole" => solid::cbore(args),
        "cskHole" => solid::csk(args),
        "fillet" => dress::fillet(args),
        "chamfer" => dress::chamfer(args),
        "shell" => dress::shell(args),
        "split" => dress::split(args),
        "section" => dress::section(args),
        "union" => combine::union(args),
        "cut" => combine::cut_call(args),
        "intersect" => combine::intersect(args),
        "combine" => combine::combine(args),
        "clean" => combine::clean(args),
        "rotate" => transform::rotate(args),
        "rotateAboutCenter" => transform::rotate_about_center(args),
        "translate" => transform::translate(args),
        "mirror" => transform::mirror(args),
        _ => on_drawing_or_port(args, short),
    }
}

fn on_drawing_or_port(args: &Args<'_>, short: &str) -> Result<Value> {
    match short {
        "moveTo" | "move" => draw::move_to(args),
        "lineTo" | "line" | "hLine" | "vLine" | "hLineTo" | "vLineTo" | "polarLine"
        | "polarLineTo" => draw::line(args, short),
        "polyline" => draw::polyline(args),
        "threePointArc" => draw::three_point_arc(args),
        "sagittaArc" => draw::sagitta_arc(args),
        "radiusArc" => draw::radius_arc(args),
        "tangentArcPoint" => draw::tangent_arc(args),
        "spline" => draw::spline(args),
        "bezier" => draw::bezier(args),
        "ellipseArc" => draw::ellipse_arc(args),
        "close" => draw::close(args),
        "wire" => draw::wire(args),
        "consolidateWires" => Ok(Value::Node(draw::consolidate(&args.on()?)?)),
        "toPending" => draw::to_pending(args),
        "mirrorX" => draw::mirror_in_plane(args, true),
        "mirrorY" => draw::mirror_in_plane(args, false),
        "offset2D" => draw::offset(args),
        "rect" => draw::rect(args),
        "circle" => draw::circle(args),
        "ellipse" => draw::ellipse(args),
        "polygon" => draw::polygon(args),
        "slot2D" => draw::slot(args),
        "outline" => draw::outline(args),
        "bore_port" => holes::bore(args),
        "shaft_port" => ports::shaft(args),
        "hole_with_port" => holes::hole(args),
        "cbore_hole_with_port" => holes::cbore(args),
        "csk_hole_with_port" => holes::csk(args),
        "tapped_hole_with_port" => holes::tapped(args),
        "face_port" => ports::face(args),
        "gear_mesh_port" => ports::gear(args),
        "snap_port" => ports::snap(args),
        "port" => ports::plain(args),
        "without_ports" => Ok(Value::Node(args.on()?.with_ports(Vec::new()))),
        "with_ports_of" => ports::of_other(args),
        _ => Err(shapes::unknown(&args.call.call)),
    }
}
