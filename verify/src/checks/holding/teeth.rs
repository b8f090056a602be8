//! Wheels whose teeth reach into each other and that no mate couples.

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::MateType;
use assemcad_model::ports::{Port, PortType};
use assemcad_model::report::{Finding, Verdict};
use assemcad_placing::Assembled;
use nalgebra::Vector3;
use serde_json::Map;

type V = Vector3<f64>;

/// Axes that differ by no more than this sine are parallel.
const PARALLEL: f64 = 1e-3;

/// A wheel with outside teeth in its place.
struct Wheel<'a> {
    part: usize,
    port: &'a Port,
    middle: V,
    axis: V,
    tip_mm: f64,
}

pub(super) fn told(assembled: &Assembled<'_>) -> Vec<Finding> {
    let resolved = assembled.resolved;
    let mut wheels = Vec::new();
    for (part, of) in resolved.parts.iter().enumerate() {
        let Some(at) = assembled.placements.of(part) else {
            continue;
        };
        let toothed = of
            .ports()
            .iter()
            .filter(|p| p.port_type == PortType::GearMesh && p.value("internal") == 0.0);
        wheels.extend(toothed.map(|port| {
            let frame = at.frame(&port.frame);
            // The addendum is one module (ISO 53), moved by the profile shift.
            let half = port.value("teeth") / 2.0 + 1.0 + port.value("profile_shift");
            Wheel {
                part,
                port,
                middle: frame.origin.into(),
                axis: frame.z.into(),
                tip_mm: port.value("module") * half,
            }
        }));
    }
    let mut out = Vec::new();
    for (i, a) in wheels.iter().enumerate() {
        for b in wheels.iter().skip(i + 1) {
            if a.part != b.part && reach(a, b) && !coupled(assembled, a, b) {
                out.push(finding(assembled, a, b));
            }
        }
    }
    out
}

/// Whether the tip circles of two wheels on parallel axes overlap, over some of both widths.
fn reach(a: &Wheel<'_>, b: &Wheel<'_>) -> bool {
    if a.axis.cross(&b.axis).norm() > PARALLEL {
        return false;
    }
    let arm = b.middle - a.middle;
    let along = arm.dot(&a.axis);
    let across = (arm - a.axis * along).norm();
    let widths = (a.port.value("width") + b.port.value("width")) / 2.0;
    // On one axis they stand beside or in each other, and no tooth is in a gap.
    across > 1e-3 && across < a.tip_mm + b.tip_mm && along.abs() < widths
}

fn coupled(assembled: &Assembled<'_>, a: &Wheel<'_>, b: &Wheel<'_>) -> bool {
    let (one, two) = (a.part, b.part);
    let mut between = assembled.resolved.between(one.min(two), one.max(two));
    between.any(|m| m.mate.mate_type == MateType::GearMesh)
}

fn finding(assembled: &Assembled<'_>, a: &Wheel<'_>, b: &Wheel<'_>) -> Finding {
    let (one, two) = (
        assembled.resolved.name(a.part),
        assembled.resolved.name(b.part),
    );
    let d = Diagnostic::error(
        Code::NotHeld,
        format!("parts '{one}' and '{two}'"),
        format!(
            "the teeth of '{one}:{}' and '{two}:{}' reach into each other, and no mate couples them",
            a.port.name, b.port.name
        ),
    )
    .hint("join them with gear_mesh, which holds their distance and phase against the teeth, or set them apart");
    Finding {
        verdict: Verdict::Fail,
        check: super::CHECK.to_owned(),
        parts: vec![one, two],
        mates: Vec::new(),
        values: Map::new(),
        axioms: Vec::new(),
        diagnostic: d,
    }
}
