//! H-03: the pin is retained both ways.

use super::Check;
use crate::hinges::hinges;
use crate::indexed::Indexed;
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;

/// The pin is pressed into a leaf, or two things hold it.
pub struct PinRetention;

impl Check for PinRetention {
    fn id(&self) -> &'static str {
        "pin_retention"
    }

    fn axiom(&self) -> &'static str {
        "H-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for h in hinges(facts) {
            let pressed = h.knuckles.iter().any(|k| k.pressed());
            let stops = facts
                .mates_of(&h.pin.id)
                .filter(|m| {
                    matches!(
                        m.mate_type,
                        MateType::CoaxialFace | MateType::FaceToFace | MateType::ThreadEngage
                    )
                })
                .count();
            let holds = pressed || stops >= 2;
            let message = if pressed {
                format!("'{}' is pressed in", h.pin.id)
            } else {
                format!(
                    "'{}' is held along its axis by {stops} stops; two are needed",
                    h.pin.id
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, h.about(), message).value("stops", stops as f64),
            );
        }
        out
    }
}
