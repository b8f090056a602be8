//! H-04: knuckles interleave with play.

use super::Check;
use crate::geometry::NEAR_MM;
use crate::hinges::hinges;
use crate::indexed::Indexed;
use crate::ruling::Ruling;

/// Neighbours along the pin are of different leaves, without overlap and with play in sum.
pub struct KnucklePlay;

impl Check for KnucklePlay {
    fn id(&self) -> &'static str {
        "knuckle_play"
    }

    fn axiom(&self) -> &'static str {
        "H-04"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for h in hinges(facts) {
            let Some(along) = h.along() else {
                out.push(Ruling::unplaced(self.axiom(), h.about()));
                continue;
            };
            if along.len() < 2 {
                continue;
            }
            let mut wrong = Vec::new();
            let mut play = 0.0;
            for pair in along.windows(2) {
                let [(_, end, a), (begin, _, b)] = pair else {
                    continue;
                };
                let gap = begin - end;
                play += gap;
                if gap < -NEAR_MM {
                    wrong.push(format!(
                        "{} and {} overlap by {:.3} mm",
                        a.hole.port.name, b.hole.port.name, -gap
                    ));
                }
                if a.hole.part.id == b.hole.part.id {
                    wrong.push(format!(
                        "two knuckles of '{}' are neighbours",
                        a.hole.part.id
                    ));
                }
            }
            if wrong.is_empty() && play <= NEAR_MM {
                wrong.push("they have no play along the pin".to_owned());
            }
            let message = if wrong.is_empty() {
                format!(
                    "the knuckles on '{}' interleave with {play:.3} mm of play",
                    h.pin.id
                )
            } else {
                format!(
                    "the knuckles on '{}' do not interleave: {}",
                    h.pin.id,
                    wrong.join(", ")
                )
            };
            out.push(
                Ruling::held(self.axiom(), wrong.is_empty(), h.about(), message)
                    .value("play_mm", play),
            );
        }
        out
    }
}
