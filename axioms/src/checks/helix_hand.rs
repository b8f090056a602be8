//! G-03: helical gears on parallel axes have matching hands.

use super::Check;
use crate::gearing::pairs;
use crate::indexed::Indexed;
use crate::ruling::Ruling;

/// Equal and opposite helix angles outside, equal ones where one gear is a ring.
pub struct HelixHand;

impl Check for HelixHand {
    fn id(&self) -> &'static str {
        "helix_hand"
    }

    fn axiom(&self) -> &'static str {
        "G-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for p in pairs(facts) {
            if (p.a.straight() && p.b.straight()) || p.parallel() == Some(false) {
                continue;
            }
            let sign = if p.inside() { 1.0 } else { -1.0 };
            let wanted = sign * p.a.helix_deg;
            let holds = (p.b.helix_deg - wanted).abs() <= 1e-9;
            if p.seen.is_none() {
                // On crossed axes another rule holds.
                out.push(Ruling::unplaced(self.axiom(), p.about()));
                continue;
            }
            let message = if holds {
                format!("the helices of {} match", p.names())
            } else {
                format!(
                    "'{}' has a helix of {} degrees, and {wanted} degrees go with '{}'",
                    p.incoming.part.id, p.b.helix_deg, p.base.part.id
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, p.about(), message)
                    .value("helix_base_deg", p.a.helix_deg)
                    .value("helix_incoming_deg", p.b.helix_deg),
            );
        }
        out
    }
}
