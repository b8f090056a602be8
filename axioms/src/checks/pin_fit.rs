//! H-05: the pin is fast in one leaf at most.

use super::Check;
use crate::hinges::hinges;
use crate::indexed::Indexed;
use crate::ruling::Ruling;

/// At least one leaf is not pressed on the pin.
pub struct PinFit;

impl Check for PinFit {
    fn id(&self) -> &'static str {
        "pin_fit"
    }

    fn axiom(&self) -> &'static str {
        "H-05"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for h in hinges(facts) {
            let leaves = h.leaves();
            let free = |leaf: &&&str| {
                let own = |k: &&crate::hinges::Knuckle<'_>| k.hole.part.id == **leaf;
                !h.knuckles.iter().filter(own).any(|k| k.pressed())
            };
            let turning = leaves.iter().filter(free).count();
            let message = format!(
                "'{}' turns with play in {turning} of its {} leaves",
                h.pin.id,
                leaves.len()
            );
            out.push(
                Ruling::held(self.axiom(), turning > 0, h.about(), message)
                    .value("leaves", leaves.len() as f64)
                    .value("turning_in", turning as f64),
            );
        }
        out
    }
}
