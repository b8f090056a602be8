//! G-07: tips stay clear of roots.

use super::Check;
use crate::gearing::{BASIC_RACK, pairs};
use crate::indexed::Indexed;
use crate::ruling::Ruling;

/// Both tips of a pair stay clear of the roots that they face.
pub struct TipClearance;

/// The least clearance in modules. Ours: less than half of the 0.25 that the basic rack of ISO 53 gives, so
/// that it finds what is wrong and leaves room for closer designs.
const SHARE: f64 = 0.1;

impl Check for TipClearance {
    fn id(&self) -> &'static str {
        "tip_clearance"
    }

    fn axiom(&self) -> &'static str {
        "G-07"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for p in pairs(facts) {
            if p.seen.is_none() {
                out.push(Ruling::unplaced(self.axiom(), p.about()));
                continue;
            }
            let Some(a) = p.distance() else { continue };
            let (g, h) = p.ring_last();
            let (first, second) = if h.internal {
                (
                    h.root_radius() - a - g.tip_radius(),
                    h.tip_radius() - a - g.root_radius(),
                )
            } else {
                (
                    a - g.tip_radius() - h.root_radius(),
                    a - h.tip_radius() - g.root_radius(),
                )
            };
            let least = SHARE * g.module;
            // Written so that an unknown value is no clearance.
            let holds = first >= least && second >= least;
            let message = format!(
                "tips of {} have {:.3} mm of clearance; {least:.3} mm is the least",
                p.names(),
                first.min(second)
            );
            out.push(
                Ruling::held(self.axiom(), holds, p.about(), message)
                    .value("clearance_mm", first.min(second))
                    .value("least_mm", least)
                    .assuming(BASIC_RACK),
            );
        }
        out
    }
}
