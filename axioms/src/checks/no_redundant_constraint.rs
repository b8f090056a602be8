//! C-05: no constraint twice without a reason.

use std::collections::BTreeSet;

use super::Check;
use crate::facts::{Mobility, Redundant};
use crate::indexed::Indexed;
use crate::reasons::reasons;
use crate::ruling::{About, Ruling, Status};

/// What is constrained twice is accepted, or belongs to a pattern of joints that other axioms demand.
pub struct NoRedundantConstraint;

impl Check for NoRedundantConstraint {
    fn id(&self) -> &'static str {
        "no_redundant_constraint"
    }

    fn axiom(&self) -> &'static str {
        "C-05"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let Some(mobility) = &facts.mobility else {
            let message = "the motion of the assembly was not analysed";
            return vec![Ruling::new(
                self.axiom(),
                Status::Indeterminate,
                About::assembly(),
                message,
            )];
        };
        if mobility.redundant.is_empty() {
            let message = "no freedom is taken twice";
            return vec![Ruling::held(self.axiom(), true, About::assembly(), message)];
        }
        // One verdict: in a loop every mate repeats what the others hold, and to name each of them alone
        // would say the same over and over.
        let noted = |mate: &str| facts.mate(mate).is_some_and(|m| m.reason_stated);
        // Without the second analysis nothing is explained.
        let left = mobility.unexplained.as_ref().unwrap_or(&mobility.redundant);
        let bare: Vec<_> = left.iter().filter(|r| !noted(&r.mate)).collect();
        let names = |all: &[&Redundant]| {
            let names: Vec<&str> = all.iter().map(|r| r.mate.as_str()).collect();
            names.join(", ")
        };
        let all: Vec<&Redundant> = mobility.redundant.iter().collect();
        let message = if !bare.is_empty() {
            format!(
                "freedoms are taken again at {}, and no pattern of joints gives the reason",
                names(&bare)
            )
        } else if left.is_empty() {
            format!(
                "freedoms are taken again at {}, as recognised patterns of joints want it",
                names(&all)
            )
        } else {
            format!(
                "freedoms are taken again at {}, as accepted or as recognised patterns of joints want it",
                names(&all)
            )
        };
        let held = bare.is_empty();
        let told = if held { all } else { bare };
        let count = told
            .iter()
            .fold(0_u32, |sum, r| sum.saturating_add(r.count));
        let about = About {
            parts: Vec::new(),
            mates: told.iter().map(|r| r.mate.clone()).collect(),
        };
        let verdict =
            Ruling::held(self.axiom(), held, about, message).value("redundant", f64::from(count));
        match taken_for_reasons(facts, mobility) {
            Some(reasons) => vec![verdict.assuming(reasons)],
            None => vec![verdict],
        }
    }
}

/// The patterns that were taken for reasons, each once; none where there are none among what is repeated.
fn taken_for_reasons(facts: &Indexed, mobility: &Mobility) -> Option<String> {
    mobility.unexplained.as_ref()?;
    let repeated: BTreeSet<&str> = mobility.redundant.iter().map(|r| r.mate.as_str()).collect();
    let mut why: Vec<String> = reasons(facts)
        .into_iter()
        .filter(|r| repeated.contains(r.mate))
        .map(|r| r.why)
        .collect();
    why.sort();
    why.dedup();
    (!why.is_empty()).then(|| format!("taken for reasons: {}", why.join("; ")))
}
