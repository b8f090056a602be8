//! T-02: threads match.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::screwed;
use crate::ruling::Ruling;

/// Equal nominal diameter, pitch and hand.
pub struct ThreadMatch;

impl Check for ThreadMatch {
    fn id(&self) -> &'static str {
        "thread_match"
    }

    fn axiom(&self) -> &'static str {
        "T-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        screwed(facts)
            .iter()
            .map(|s| {
                let differ: Vec<&str> = ["diameter", "pitch", "hand"]
                    .into_iter()
                    // Written so that an unknown value is equal to nothing.
                    .filter(|n| {
                        let same = (s.screw.port.value(n) - s.hole.port.value(n)).abs() <= 1e-9;
                        !same
                    })
                    .collect();
                let message = if differ.is_empty() {
                    format!(
                        "the threads of '{}' and '{}' match",
                        s.screw.part.id, s.hole.part.id
                    )
                } else {
                    format!(
                        "the threads of '{}' and '{}' differ in {}",
                        s.screw.part.id,
                        s.hole.part.id,
                        differ.join(", ")
                    )
                };
                Ruling::held(self.axiom(), differ.is_empty(), s.about(), message)
                    .value("screw_diameter_mm", s.screw.port.value("diameter"))
                    .value("screw_pitch_mm", s.screw.port.value("pitch"))
                    .value("hole_diameter_mm", s.hole.port.value("diameter"))
                    .value("hole_pitch_mm", s.hole.port.value("pitch"))
            })
            .collect()
    }
}
