//! K-05: a drive screw keeps its screw motion.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::about;
use crate::left::at_each;
use crate::ruling::Ruling;

/// A thread that is left free has one screw motion in the whole assembly.
pub struct ScrewFreedom;

impl Check for ScrewFreedom {
    fn id(&self) -> &'static str {
        "screw_freedom"
    }

    fn axiom(&self) -> &'static str {
        "K-05"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        at_each(
            facts,
            self.axiom(),
            |m| m.flag("free"),
            |m, j| {
                let holds = (j.turns, j.slides, j.screws) == (0, 0, 1);
                let message = format!(
                    "the drive '{}' is left {} screw motions, {} turns and {} slides; one screw motion is meant",
                    m.id, j.screws, j.turns, j.slides
                );
                Ruling::held(self.axiom(), holds, about(m), message)
                    .value("screws", f64::from(j.screws))
            },
        )
    }
}
