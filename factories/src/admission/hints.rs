//! What would mend a fault, in plain words: found by asking the solid again with the usual slips undone.

use assemcad_geometry::Asker;
use assemcad_kernel::protocol::{Built, Failure, Named};
use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::ports::{Port, PortType};
use assemcad_model::recipe::Recipe;
use assemcad_model::report::rounded;

use crate::evidence;

/// Named planes whose normal looks along a negative axis, where a positive length goes the other way
/// than one thinks.
const BACKWARDS: [(&str, &str); 6] = [
    ("XZ", "-Y"),
    ("YX", "-Z"),
    ("ZY", "-X"),
    ("back", "-Z"),
    ("left", "-X"),
    ("bottom", "-Y"),
];

/// A geometry fault with the trap that may be behind it: the planes that led to the failing call.
pub(super) fn of_geometry(d: Diagnostic, failure: &Failure, recipe: &Recipe) -> Diagnostic {
    let Some(step) = failure.doing.as_ref().and_then(|doing| doing.step) else {
        return d;
    };
    let traps = backwards(recipe, step);
    if traps.is_empty() {
        return d;
    }
    let told: Vec<String> = traps
        .iter()
        .map(|(plane, way)| format!("on the {plane} plane extrude goes towards {way}"))
        .collect();
    let hint = format!(
        "{}: where the other side is meant, give a negative length",
        told.join(", ")
    );
    let hint = match &d.hint {
        Some(own) => format!("{own}; {hint}"),
        None => hint,
    };
    d.hint(hint)
}

/// The backward planes among the calls that a call rests on, in the table's order.
fn backwards(recipe: &Recipe, step: usize) -> Vec<(&'static str, &'static str)> {
    let mut seen = vec![false; recipe.calls.len()];
    let mut rest = vec![step];
    let mut planes: Vec<&str> = Vec::new();
    while let Some(index) = rest.pop() {
        match seen.get_mut(index) {
            Some(new) if !*new => *new = true,
            _ => continue,
        }
        let Some(call) = recipe.calls.get(index) else {
            continue;
        };
        planes.extend(call.args.get("inPlane").and_then(|v| v.as_str()));
        rest.extend(
            call.inputs()
                .into_iter()
                .filter_map(|i| usize::try_from(i).ok()),
        );
    }
    BACKWARDS
        .into_iter()
        .filter(|(plane, _)| planes.contains(plane))
        .collect()
}

/// A slip: what it is undone by, and the port as it would be then.
struct Slip {
    words: String,
    port: Port,
}

/// What a port without evidence probably means.
pub(super) async fn of_port(
    door: Asker<'_>,
    solid: &Named,
    recipe: &Recipe,
    port: &Port,
    built: &Built,
) -> String {
    for slip in slips(port) {
        let shown = match evidence::ask(door, solid, [&slip.port]).await {
            Ok(asked) => asked
                .iter()
                .all(|(_, answers)| answers.iter().all(|(_, a)| a.held)),
            Err(_) => false,
        };
        if shown {
            return format!("the solid shows this port where {}", slip.words);
        }
    }
    plain(recipe, port, built)
}

/// The same without asking the solid anything.
pub(super) fn plain(recipe: &Recipe, port: &Port, built: &Built) -> String {
    let (min, max) = (built.min, built.max);
    let outside = port
        .frame
        .origin
        .iter()
        .zip(min.iter().zip(max))
        .any(|(x, (low, high))| *x < low - 1e-6 || *x > high + 1e-6);
    let spans = format!("from {:?} to {:?}", min.map(rounded), max.map(rounded));
    if outside {
        let traps = backwards(recipe, usize::try_from(recipe.result).unwrap_or(0));
        let trap: String = traps
            .iter()
            .map(|(plane, way)| format!("; on the {plane} plane extrude goes towards {way}"))
            .collect();
        return format!(
            "the port's origin {:?} lies outside of the part, which reaches {spans}{trap}",
            port.frame.origin.map(rounded)
        );
    }
    format!(
        "the feature is missing there, or has another size: make it with the method that makes geometry \
         and port in one, such as {}; the part reaches {spans}",
        method_for(port.port_type)
    )
}

fn method_for(port_type: PortType) -> &'static str {
    match port_type {
        PortType::Bore => "bore_port",
        PortType::Shaft | PortType::PressFit => "shaft_port",
        PortType::Hole | PortType::ClearanceHole => "hole_with_port",
        PortType::CboreSeat => "cbore_hole_with_port",
        PortType::ThreadInternal => "tapped_hole_with_port",
        PortType::GearMesh => "gear_mesh_port",
        PortType::SnapFit => "snap_port",
        PortType::FlatFace | PortType::BoltSeat | PortType::ThreadExternal => "face_port",
    }
}

/// The usual slips, the commonest first.
fn slips(port: &Port) -> Vec<Slip> {
    let mut all = Vec::new();
    let mut with = |words: String, change: &dyn Fn(&mut Port)| {
        let mut changed = port.clone();
        change(&mut changed);
        all.push(Slip {
            words,
            port: changed,
        });
    };
    let [zx, zy, zz] = port.frame.z;
    let turned = [-zx, -zy, -zz].map(|v| v + 0.0);
    with(
        format!(
            "z looks the other way: give the plane the normal {:?}",
            turned.map(rounded)
        ),
        &|p| p.frame.z = turned,
    );
    let along: Vec<f64> = ["length", "depth", "width"]
        .iter()
        .filter_map(|name| port.params.get(*name).copied())
        .collect();
    for length in along {
        for (share, side) in [(0.5, 1.0), (0.5, -1.0), (1.0, 1.0), (1.0, -1.0)] {
            let moved = shifted(port, side * share * length);
            let words = format!(
                "its origin is at {:?}, {} mm further along its axis",
                moved.map(rounded),
                rounded(side * share * length)
            );
            with(words, &|p| p.frame.origin = moved);
            let words = format!(
                "its origin is at {:?} and z looks the other way, along {:?}",
                moved.map(rounded),
                turned.map(rounded)
            );
            with(words, &|p| {
                p.frame.origin = moved;
                p.frame.z = turned;
            });
        }
    }
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let mirrored = |v: [f64; 3]| {
            let mut v = v;
            if let Some(c) = v.get_mut(axis) {
                *c = -*c + 0.0;
            }
            v
        };
        let origin = mirrored(port.frame.origin);
        if origin != port.frame.origin {
            with(
                format!(
                    "its origin is on the other side, at {name} = {}",
                    rounded(origin.get(axis).copied().unwrap_or(0.0))
                ),
                &|p| p.frame.origin = origin,
            );
            with(
                format!(
                    "it is on the other side, its origin at {:?} and z along {:?}",
                    origin.map(rounded),
                    mirrored(port.frame.z).map(rounded)
                ),
                &|p| {
                    p.frame.origin = origin;
                    p.frame.z = mirrored(p.frame.z);
                },
            );
        }
    }
    if let Some(diameter) = port.params.get("diameter").copied() {
        for (factor, what) in [(0.5, "half"), (2.0, "twice")] {
            let words = format!(
                "its diameter is {} mm, {what} of what is stated (radius for diameter?)",
                rounded(factor * diameter)
            );
            with(words, &|p| {
                p.params.insert("diameter".to_owned(), factor * diameter);
            });
        }
    }
    all
}

/// The origin moved along z.
fn shifted(port: &Port, by: f64) -> [f64; 3] {
    let mut moved = port.frame.origin;
    for (x, z) in moved.iter_mut().zip(port.frame.z) {
        *x = *x + by * z + 0.0;
    }
    moved
}
