//! C-05: no constraint twice without a reason.

use super::Check;
use crate::facts::Facts;
use crate::joints::about;
use crate::verdict::{About, Status, Verdict};

/// What is constrained twice has a note.
pub struct NoRedundantConstraint;

impl Check for NoRedundantConstraint {
    fn id(&self) -> &'static str {
        "no_redundant_constraint"
    }

    fn axiom(&self) -> &'static str {
        "C-05"
    }

    fn run(&self, facts: &Facts) -> Vec<Verdict> {
        let Some(mobility) = &facts.mobility else {
            let message = "the motion of the assembly was not analysed";
            return vec![Verdict::new(
                self.axiom(),
                Status::Indeterminate,
                About::assembly(),
                message,
            )];
        };
        if mobility.redundant.is_empty() {
            let message = "no freedom is taken twice";
            return vec![Verdict::held(
                self.axiom(),
                true,
                About::assembly(),
                message,
            )];
        }
        let mut out = Vec::new();
        for r in &mobility.redundant {
            let mate = facts.mates.iter().find(|m| m.id == r.mate);
            let reason = mate.is_some_and(|m| m.has_notes);
            let message = if reason {
                format!(
                    "'{}' takes {} freedoms again, and has a note",
                    r.mate, r.count
                )
            } else {
                format!(
                    "'{}' takes {} freedoms again, without a note that gives the reason",
                    r.mate, r.count
                )
            };
            out.push(
                Verdict::held(
                    self.axiom(),
                    reason,
                    mate.map(about).unwrap_or_default(),
                    message,
                )
                .value("redundant", f64::from(r.count)),
            );
        }
        out
    }
}
