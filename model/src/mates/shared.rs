//! What the mate types share.

use nalgebra::Vector3;

use super::{Condition, Freedom, Joint, Overlap, Twist};
use crate::angle::between_deg;
use crate::frame::Placement;
use crate::param::{ParamKind, ParamSpec};
use crate::ports::Port;

/// Whether a value is known to be at most another. What is no number is not.
pub(super) fn at_most(value: f64, most: f64) -> bool {
    value <= most
}

/// Whether a value is known to be over another. What is no number is not.
pub(super) fn over(value: f64, less: f64) -> bool {
    value > less
}

/// An offset along the base port's z and a turn, z axes opposed or the same way.
pub(super) fn along_axis(j: &Joint<'_>, offset_mm: f64) -> Placement {
    let flip = if j.same() {
        Placement::IDENTITY
    } else {
        Placement::rotation_x(180.0)
    };
    Placement::translation(0.0, 0.0, offset_mm)
        * flip
        * Placement::rotation_z(j.number("alpha_deg"))
}

/// How far an origin is from the base port's axis.
pub(super) fn off_axis_mm(actual: &Placement) -> f64 {
    let o = actual.origin();
    libm::hypot(o.x, o.y)
}

/// How far an origin is from a height on the base port's axis.
pub(super) fn distance_mm(actual: &Placement, height_mm: f64) -> f64 {
    libm::hypot(off_axis_mm(actual), actual.origin().z - height_mm)
}

/// The angle between the z axes where they must be opposed.
pub(super) fn opposed_residual_deg(actual: &Placement) -> f64 {
    let [_, _, z] = actual.axes();
    between_deg(&z, &-Vector3::z())
}

/// The angle between the z axes where the option `direction` says how they look.
pub(super) fn axial_residual_deg(j: &Joint<'_>, actual: &Placement) -> f64 {
    let [_, _, z] = actual.axes();
    let wanted = if j.same() {
        Vector3::z()
    } else {
        -Vector3::z()
    };
    between_deg(&z, &wanted)
}

/// Where a cylindrical port lies along its own z: a hole behind its mouth, a shaft about its middle.
fn reach(port: &Port) -> (f64, f64) {
    if port.params.contains_key("depth") {
        return (-port.value("depth"), 0.0);
    }
    let half = port.value("length") / 2.0;
    (-half, half)
}

/// The length that two cylindrical ports have in common, the incoming origin at a height on the base
/// port's z; below 0 where they are apart.
pub(super) fn common_length(j: &Joint<'_>, height_mm: f64) -> f64 {
    let (low, high) = reach(j.incoming);
    let (low, high) = if j.same() { (low, high) } else { (-high, -low) };
    let (base_low, base_high) = reach(j.base);
    base_high.min(height_mm + high) - base_low.max(height_mm + low)
}

pub(super) fn no_conditions(_: &Joint<'_>) -> Vec<Condition> {
    Vec::new()
}

pub(super) fn no_overlap(_: &Joint<'_>) -> Overlap {
    Overlap::none()
}

pub(super) fn no_play(_: &Joint<'_>) -> Option<f64> {
    None
}

pub(super) fn millimetres(name: &str, doc: &str) -> ParamSpec {
    within(name, doc, "mm", -1e5, 1e5)
}

pub(super) fn degrees(name: &str, doc: &str) -> ParamSpec {
    within(name, doc, "deg", -360.0, 360.0)
}

pub(super) fn within(name: &str, doc: &str, unit: &str, min: f64, max: f64) -> ParamSpec {
    ParamSpec {
        name: name.to_owned(),
        doc: doc.to_owned(),
        kind: ParamKind::Number {
            unit: unit.to_owned(),
            min,
            max,
            default: 0.0,
        },
    }
}

pub(super) fn direction() -> ParamSpec {
    ParamSpec {
        name: "direction".to_owned(),
        doc: "whether the ports' z axes look against each other or the same way".to_owned(),
        kind: ParamKind::Choice {
            choices: vec!["opposed".to_owned(), "same".to_owned()],
            default: "opposed".to_owned(),
        },
    }
}

/// How two parts are joined for good where their faces touch. A claim: it holds nothing where they do not.
pub(super) fn bond() -> ParamSpec {
    ParamSpec {
        name: "bond".to_owned(),
        doc: "what joins the two for good where they touch; nothing is left free then".to_owned(),
        kind: ParamKind::Choice {
            choices: ["none", "welded", "brazed", "soldered", "glued", "magnetic"]
                .map(str::to_owned)
                .to_vec(),
            default: "none".to_owned(),
        },
    }
}

/// The freedom that a mate leaves where it states no bond.
pub(super) fn unless_bonded(j: &Joint<'_>, free: &[Twist]) -> Freedom {
    Freedom::of(if j.bonded() { &[] } else { free })
}
