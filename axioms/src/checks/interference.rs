//! C-03: interference holds a press fit.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::{about, ends, is_cylinder, is_hole, reach, reach_along};
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;

/// The inner cylinder is as thick as the hole at least, and both have length in common.
pub struct Interference;

impl Check for Interference {
    fn id(&self) -> &'static str {
        "interference"
    }

    fn axiom(&self) -> &'static str {
        "C-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for m in facts
            .mates
            .iter()
            .filter(|m| m.mate_type == MateType::PressFit)
        {
            let Some((hole, shaft)) = ends(facts, m, is_hole, is_cylinder) else {
                continue;
            };
            let excess = shaft.port.value("diameter") - hole.port.value("diameter");
            let common = reach_along(&hole, &shaft).map(|(low, high)| {
                let (own_low, own_high) = reach(&hole);
                own_high.min(high) - own_low.max(low)
            });
            // Written so that an unknown diameter is no interference.
            if excess >= 0.0 && common.is_none() {
                out.push(Ruling::unplaced(self.axiom(), about(m)));
                continue;
            }
            let holds = excess >= 0.0 && common.is_none_or(|c| c > 0.0);
            let message = if holds {
                format!("'{}' is pressed into '{}'", shaft.part.id, hole.part.id)
            } else {
                format!(
                    "'{}' is {excess:.4} mm thicker than its hole in '{}', and they share {:.3} mm of length",
                    shaft.part.id,
                    hole.part.id,
                    common.unwrap_or(f64::NAN)
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, about(m), message)
                    .value("interference_mm", excess)
                    .value("common_length_mm", common.unwrap_or(f64::NAN)),
            );
        }
        out
    }
}
