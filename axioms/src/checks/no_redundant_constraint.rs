//! C-05: no constraint twice without a reason.

use super::Check;
use crate::facts::Facts;
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
        // One verdict: in a loop every mate repeats what the others hold, and to name each of them alone
        // would say the same over and over.
        let noted = |mate: &str| facts.mates.iter().any(|m| m.id == mate && m.has_notes);
        let bare: Vec<_> = mobility
            .redundant
            .iter()
            .filter(|r| !noted(&r.mate))
            .collect();
        let (held, told) = if bare.is_empty() {
            (true, mobility.redundant.iter().collect())
        } else {
            (false, bare)
        };
        let names: Vec<&str> = told.iter().map(|r| r.mate.as_str()).collect();
        let message = if held {
            format!(
                "freedoms are taken again at {}, with notes",
                names.join(", ")
            )
        } else {
            format!(
                "freedoms are taken again at {}, without a note that gives the reason",
                names.join(", ")
            )
        };
        let count = told
            .iter()
            .fold(0_u32, |sum, r| sum.saturating_add(r.count));
        let about = About {
            parts: Vec::new(),
            mates: told.iter().map(|r| r.mate.clone()).collect(),
        };
        vec![Verdict::held(self.axiom(), held, about, message).value("redundant", f64::from(count))]
    }
}
