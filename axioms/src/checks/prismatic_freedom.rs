//! K-02: a prismatic joint slides only.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::about;
use crate::left::at_each;
use crate::ruling::Ruling;

/// A mate that cites it is left one translation and nothing else.
pub struct PrismaticFreedom;

impl Check for PrismaticFreedom {
    fn id(&self) -> &'static str {
        "prismatic_freedom"
    }

    fn axiom(&self) -> &'static str {
        "K-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        at_each(
            facts,
            self.axiom(),
            |m| m.cites(self.axiom()),
            |m, j| {
                let holds = (j.turns, j.slides, j.screws) == (0, 1, 0);
                let message = format!(
                    "'{}' is left {} turns, {} slides and {} screw motions; one slide is meant",
                    m.id, j.turns, j.slides, j.screws
                );
                Ruling::held(self.axiom(), holds, about(m), message)
                    .value("turns", f64::from(j.turns))
                    .value("slides", f64::from(j.slides))
            },
        )
    }
}
