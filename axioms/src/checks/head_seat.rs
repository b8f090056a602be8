//! T-10: a head sits square on material.

use super::Check;
use crate::geometry::{NEAR_DEG, NEAR_MM, off_axis_mm, z_angle_deg};
use crate::indexed::Indexed;
use crate::joints::{about, ends};
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

/// The seat is square to the face under it and wider than the hole that it spans.
pub struct HeadSeat;

impl Check for HeadSeat {
    fn id(&self) -> &'static str {
        "head_seat"
    }

    fn axiom(&self) -> &'static str {
        "T-10"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for mate in &facts.mates {
            if mate.mate_type != MateType::CoaxialFace {
                continue;
            }
            let under = |t| t != PortType::BoltSeat;
            let Some((seat, under)) = ends(facts, mate, |t| t == PortType::BoltSeat, under) else {
                continue;
            };
            let hole = match under.port.port_type {
                PortType::CboreSeat | PortType::FlatFace => under.port.value("hole_diameter"),
                _ => under.port.value("diameter"),
            };
            // A face without a hole states none.
            let hole = if hole.is_nan() { 0.0 } else { hole };
            let wide = seat.port.value("outer_diameter");
            let mut wrong = Vec::new();
            let mut v_off = None;
            if let Some(seen) = under.sees(&seat) {
                let (off, askew) = (off_axis_mm(&seen), 180.0 - z_angle_deg(&seen));
                v_off = Some((off, askew));
                if askew > NEAR_DEG {
                    wrong.push(format!("it stands {askew:.3} degrees askew"));
                }
                if off > NEAR_MM {
                    wrong.push(format!("it sits {off:.3} mm off the axis"));
                }
            }
            // Written so that an unknown width covers nothing.
            let covers = wide > hole;
            if !covers {
                wrong.push(format!("its {wide} mm do not span the hole of {hole} mm"));
            }
            if wrong.is_empty() && v_off.is_none() {
                out.push(Ruling::unplaced(self.axiom(), about(mate)));
                continue;
            }
            let message = if wrong.is_empty() {
                format!("'{}' sits square on '{}'", seat.part.id, under.part.id)
            } else {
                format!(
                    "'{}' does not sit on '{}': {}",
                    seat.part.id,
                    under.part.id,
                    wrong.join(", ")
                )
            };
            let mut v = Ruling::held(self.axiom(), wrong.is_empty(), about(mate), message)
                .value("seat_mm", wide)
                .value("hole_mm", hole);
            if let Some((off, askew)) = v_off {
                v = v.value("off_axis_mm", off).value("askew_deg", askew);
            }
            out.push(v);
        }
        out
    }
}
