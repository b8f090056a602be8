//! K-02: a prismatic joint slides only.

use super::Check;
use crate::facts::Facts;
use crate::joints::about;
use crate::verdict::{Status, Verdict};

/// A mate that cites it is left one translation and nothing else.
pub struct PrismaticFreedom;

impl Check for PrismaticFreedom {
    fn id(&self) -> &'static str {
        "prismatic_freedom"
    }

    fn axiom(&self) -> &'static str {
        "K-02"
    }

    fn run(&self, facts: &Facts) -> Vec<Verdict> {
        let mut out = Vec::new();
        for m in facts.mates.iter().filter(|m| m.cites(self.axiom())) {
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
            let holds = (j.turns, j.slides, j.screws) == (0, 1, 0);
            let message = format!(
                "'{}' is left {} turns, {} slides and {} screw motions; one slide is meant",
                m.id, j.turns, j.slides, j.screws
            );
            out.push(
                Verdict::held(self.axiom(), holds, about(m), message)
                    .value("turns", f64::from(j.turns))
                    .value("slides", f64::from(j.slides)),
            );
        }
        out
    }
}
