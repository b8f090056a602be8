//! T-09: one screw is a pivot.

use assemcad_model::frame::Placement;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

use super::Check;
use crate::class::Class;
use crate::facts::{MateFacts, PartFacts};
use crate::geometry::collinear;
use crate::indexed::Indexed;
use crate::joints::about_part;
use crate::ruling::Ruling;

/// A structural part that fasteners hold has two of them, or something else that keeps it from turning.
pub struct AntiRotation;

impl Check for AntiRotation {
    fn id(&self) -> &'static str {
        "anti_rotation"
    }

    fn axiom(&self) -> &'static str {
        "T-09"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for part in &facts.parts {
            let flat = matches!(
                part.class(),
                Class::Plate | Class::Bracket | Class::Channel | Class::Flange
            );
            if flat && facts.root() != Some(&part.id) {
                out.extend(held(self.axiom(), facts, part));
            }
        }
        out
    }
}

/// Whether a port fixes an axis at right angles to which it lets nothing move.
fn is_axis(t: PortType) -> bool {
    !matches!(
        t,
        PortType::FlatFace | PortType::GearMesh | PortType::SnapFit
    )
}

fn held(axiom: &str, facts: &Indexed, part: &PartFacts) -> Option<Ruling> {
    // The axes seen from outside, as inverse frames; those without a place are each one of their own.
    let mut axes = 0;
    let mut known: Vec<Placement> = Vec::new();
    let mut mates: Vec<&MateFacts> = Vec::new();
    let mut screwed = false;
    for mate in facts.mates_of(&part.id) {
        let (own, other) = facts.seen_from(&part.id, mate)?;
        // A place that is pressed or given on a face is held against turning.
        if matches!(mate.mate_type, MateType::PressFit | MateType::SnapToFace) {
            return None;
        }
        if !is_axis(own.port.port_type) {
            continue;
        }
        screwed |= other.part.class().is_fastener();
        mates.push(mate);
        let at = own.world();
        let same = |own: Placement| known.iter().any(|a| collinear(&(*a * own)));
        if !at.is_some_and(same) {
            axes += 1;
            known.extend(at.map(|at| at.inverse()));
        }
    }
    if !screwed {
        return None;
    }
    if part.placement.is_none() {
        return Some(Ruling::unplaced(axiom, about_part(part, mates)));
    }
    let n = axes;
    let message = if n > 1 {
        format!("'{}' is held at {n} axes", part.id)
    } else {
        format!("'{}' can turn about its only fastener", part.id)
    };
    Some(Ruling::held(axiom, n > 1, about_part(part, mates), message).value("axes", f64::from(n)))
}
