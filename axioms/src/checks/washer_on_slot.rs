//! T-07: a washer covers a slot or a wide hole.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::{about, ends};
use crate::ruling::Ruling;
use crate::tables::clearance;
use assemcad_model::ports::PortType;

/// No head or nut sits directly on a hole that is wider than the coarse series of ISO 273.
pub struct WasherOnSlot;

impl Check for WasherOnSlot {
    fn id(&self) -> &'static str {
        "washer_on_slot"
    }

    fn axiom(&self) -> &'static str {
        "T-07"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for mate in &facts.mates {
            let seat = |t| matches!(t, PortType::BoltSeat | PortType::FlatFace);
            let hole = |t| t == PortType::ClearanceHole;
            let Some((seat, hole)) = ends(facts, mate, seat, hole) else {
                continue;
            };
            let Some(series) = clearance(hole.port.value("bolt_diameter")) else {
                continue;
            };
            let wide = hole.port.value("diameter");
            if wide <= series.coarse + 1e-6 {
                continue;
            }
            let holds = seat.part.class() == Class::Washer;
            let message = if holds {
                format!(
                    "the washer '{}' covers the wide hole of '{}'",
                    seat.part.id, hole.part.id
                )
            } else {
                format!(
                    "'{}' sits without a washer on a hole of '{}' that is {wide} mm wide; {} mm is the widest standard clearance",
                    seat.part.id, hole.part.id, series.coarse
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, about(mate), message)
                    .value("hole_mm", wide)
                    .value("coarse_mm", series.coarse),
            );
        }
        out
    }
}
