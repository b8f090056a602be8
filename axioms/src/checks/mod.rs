//! The checks: one file each, which reads facts and yields verdicts.
//!
//! A check says nothing of what it does not apply to; where it cannot tell, it says so and why; what it
//! takes for granted stands in the verdict.

use crate::axiom::Axiom;
use crate::facts::Facts;
use crate::knowledge::axioms;
use crate::verdict::{About, Status, Verdict};

mod tooth_system;

/// A check of one axiom.
pub trait Check: Sync {
    /// The name, as the axiom's data have it.
    fn id(&self) -> &'static str;
    /// The id of the axiom.
    fn axiom(&self) -> &'static str;
    /// The verdicts, one for each subject; none where there is nothing to check.
    fn run(&self, facts: &Facts) -> Vec<Verdict>;
}

/// Every check that is written, sorted by name.
pub static ALL: [&dyn Check; 1] = [&tooth_system::ToothSystem];

/// The written check of an axiom.
#[must_use]
pub fn of(axiom: &Axiom) -> Option<&'static dyn Check> {
    let id = axiom.check.id()?;
    ALL.iter().find(|c| c.id() == id).copied()
}

/// The verdicts of all checks, in the order of the axioms' ids. A check that has nothing to check says
/// `not_applicable` once; an axiom whose check is not written says nothing.
#[must_use]
pub fn run_all(facts: &Facts) -> Vec<Verdict> {
    let mut out = Vec::new();
    for axiom in axioms() {
        let Some(check) = of(axiom) else { continue };
        let verdicts = check.run(facts);
        if verdicts.is_empty() {
            out.push(Verdict::new(
                &axiom.id,
                Status::NotApplicable,
                About::assembly(),
                "nothing here that it is about",
            ));
        }
        out.extend(verdicts);
    }
    out
}

/// The axioms that could be checked but whose check is not written: a report names them as not checked.
pub fn not_written() -> impl Iterator<Item = &'static Axiom> {
    axioms()
        .iter()
        .filter(|a| a.check.id().is_some() && of(a).is_none())
}
