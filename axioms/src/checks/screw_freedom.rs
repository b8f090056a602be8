//! K-05: a drive screw keeps its screw motion.

use super::Check;
use crate::facts::Facts;
use crate::joints::about;
use crate::verdict::{Status, Verdict};

/// A thread that is left free has one screw motion in the whole assembly.
pub struct ScrewFreedom;

impl Check for ScrewFreedom {
    fn id(&self) -> &'static str {
        "screw_freedom"
    }

    fn axiom(&self) -> &'static str {
        "K-05"
    }

    fn run(&self, facts: &Facts) -> Vec<Verdict> {
        let mut out = Vec::new();
        for m in facts.mates.iter().filter(|m| m.flag("free")) {
            let motion = facts
                .mobility
                .as_ref()
                .and_then(|all| all.joints.iter().find(|j| j.mate == m.id));
            let Some(j) = motion else {
                let message = format!("the motion at '{}' was not analysed", m.id);
                out.push(Verdict::new(
                    self.axiom(),
                    Status::Indeterminate,
                    about(m),
                    message,
                ));
                continue;
            };
            let holds = (j.turns, j.slides, j.screws) == (0, 0, 1);
            let message = format!(
                "the drive '{}' is left {} screw motions, {} turns and {} slides; one screw motion is meant",
                m.id, j.screws, j.turns, j.slides
            );
            out.push(
                Verdict::held(self.axiom(), holds, about(m), message)
                    .value("screws", f64::from(j.screws)),
            );
        }
        out
    }
}
