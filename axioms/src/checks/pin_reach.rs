//! H-02: the pin passes all knuckles.

use super::Check;
use crate::geometry::NEAR_MM;
use crate::hinges::hinges;
use crate::indexed::Indexed;
use crate::joints::reach;
use crate::ruling::Ruling;

/// Every knuckle lies within the length of the pin.
pub struct PinReach;

impl Check for PinReach {
    fn id(&self) -> &'static str {
        "pin_reach"
    }

    fn axiom(&self) -> &'static str {
        "H-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for h in hinges(facts) {
            let (Some(along), Some(first)) = (h.along(), h.knuckles.first()) else {
                out.push(Ruling::unplaced(self.axiom(), h.about()));
                continue;
            };
            let (low, high) = reach(&first.pin);
            let lacking = along
                .iter()
                .map(|(a, b, _)| (low - a).max(b - high))
                .fold(f64::NEG_INFINITY, f64::max);
            let holds = lacking <= NEAR_MM;
            let message = if holds {
                format!("'{}' passes all of its knuckles", h.pin.id)
            } else {
                format!(
                    "'{}' is {lacking:.3} mm too short for its knuckles",
                    h.pin.id
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, h.about(), message)
                    .value("lacking_mm", lacking.max(0.0)),
            );
        }
        out
    }
}
