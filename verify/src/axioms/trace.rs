//! From findings to axioms: those that a finding breaks, and those that the mates between its parts cite.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_axioms::knowledge::axiom;
use assemcad_axioms::ruling::Ruling;
use assemcad_axioms::{Axiom, Status};
use assemcad_model::diagnostic::Code;
use assemcad_model::report::{AxiomRole, AxiomTrace, Finding, Verdict};
use assemcad_model::spec::Assembly;

use crate::results::Results;

/// An axiom in a finding.
pub(super) fn of(axiom: &Axiom, role: AxiomRole) -> AxiomTrace {
    AxiomTrace {
        axiom: axiom.id.clone(),
        statement: axiom.statement.clone(),
        role,
    }
}

/// Notes an axiom in the findings that other checks have made of the same thing. Says whether there are any.
pub(super) fn in_another(
    axiom: &Axiom,
    told: &Ruling,
    role: AxiomRole,
    results: &mut Results,
) -> bool {
    let mut found = false;
    for finding in &mut results.findings {
        if same(axiom, told, finding) {
            found = true;
            if finding.axioms.iter().all(|a| a.axiom != axiom.id) {
                finding.axioms.push(of(axiom, role));
            }
        }
    }
    found
}

/// Whether a finding of another check says what an axiom's case says.
fn same(axiom: &Axiom, told: &Ruling, finding: &Finding) -> bool {
    let mate = || {
        let own = &told.about.mates;
        !own.is_empty() && own.iter().all(|m| finding.mates.contains(m))
    };
    let parts = || {
        let own = &told.about.parts;
        !own.is_empty() && own.iter().all(|p| finding.parts.contains(p))
    };
    let failed = told.status == Status::Fail && finding.verdict == Verdict::Fail;
    let open = told.status == Status::Indeterminate && finding.verdict == Verdict::Indeterminate;
    match (axiom.id.as_str(), finding.check.as_str()) {
        ("F-01" | "N-01", "connectivity") => failed && parts(),
        // Of a part without a place little can be told.
        (_, "connectivity") => told.status == Status::Indeterminate && parts(),
        ("F-04", "interference") => (failed || open) && parts(),
        ("F-05", "contact") => (failed || open) && mate(),
        ("C-01" | "C-02", "mates") if failed => mate(),
        ("K-03", "freedom") => failed && finding.diagnostic.code == Code::MobilityDiffers,
        // Without a place nothing can be told of a mate, whatever it is about.
        (_, "mates") => open && mate(),
        _ => false,
    }
}

/// Notes in every finding the axioms that the mates between its parts cite.
pub(super) fn cited(spec: &Assembly, results: &mut Results) {
    let mut on: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    let mut by_id: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (i, m) in spec.mates.iter().enumerate() {
        by_id.entry(&m.id).or_default().push(i);
        on.entry(&m.base.part).or_default().push(i);
    }
    for finding in &mut results.findings {
        let named = finding.mates.iter().filter_map(|m| by_id.get(m.as_str()));
        let mut about: BTreeSet<usize> = named.flatten().copied().collect();
        if finding.parts.len() > 1 {
            let parts: BTreeSet<&str> = finding.parts.iter().map(String::as_str).collect();
            let bases = parts.iter().filter_map(|p| on.get(p)).flatten();
            about.extend(bases.filter(|i| {
                let mate = spec.mates.get(**i);
                mate.is_some_and(|m| parts.contains(m.incoming.part.as_str()))
            }));
        }
        let mates = about.into_iter().filter_map(|i| spec.mates.get(i));
        let mut ids: Vec<&str> = mates
            .flat_map(|m| m.axioms.iter().map(String::as_str))
            .collect();
        ids.sort_unstable();
        ids.dedup();
        let new: Vec<AxiomTrace> = ids
            .into_iter()
            .filter(|id| finding.axioms.iter().all(|a| a.axiom != *id))
            .filter_map(axiom)
            .map(|a| of(a, AxiomRole::Cited))
            .collect();
        finding.axioms.extend(new);
    }
}
