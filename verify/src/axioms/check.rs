//! The check `axioms`: what the engineering axioms say of the placed and measured assembly.
//!
//! An axiom stated as MUST that is broken fails the assembly, and one that cannot be told leaves it
//! indeterminate. One stated as SHOULD warns. What was not checked is said with its reason.

use std::collections::BTreeMap;

use assemcad_axioms::axiom::{Axiom, Checking, Force, Need};
use assemcad_axioms::ruling::Ruling;
use assemcad_axioms::{Facts, Status, axioms, checks};
use assemcad_factories::Registry;
use assemcad_geometry::Asker;
use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::report::{
    AcceptedFact, AxiomFacts, AxiomRole, AxiomStatus, Axioms, Finding, Verdict,
};
use assemcad_model::spec::Assembly;
use assemcad_placing::Assembled;
use serde_json::json;

use super::facts::{self, Measurements};
use super::{accept, measure, mend, trace};
use crate::results::Results;

pub(super) const CHECK: &str = "axioms";

const NO_MOTION: &str = "it needs the motions that the mates leave, and those could not be told";
const NOT_WRITTEN: &str = "its check is not written yet";

/// Checks the axioms, after all other checks: a finding that one of those has made already is not made
/// again, but names the axiom.
pub(crate) async fn run(
    (door, registry): (Asker<'_>, &Registry),
    spec: &Assembly,
    assembled: &Assembled<'_>,
    measured: &Measurements<'_>,
    results: &mut Results,
) -> (Axioms, Vec<AcceptedFact>) {
    let mut accepted = accept::stated(spec, results);
    let facts = facts::facts(registry, spec, assembled, measured);
    let facts = measure::measure(door, assembled, facts).await;
    let mut told: BTreeMap<String, Vec<Ruling>> = BTreeMap::new();
    for v in checks::run_all_on(&facts) {
        told.entry(v.axiom.clone()).or_default().push(v);
    }
    let mut all = Axioms::default();
    let own = results.findings.iter().filter(|f| f.check == CHECK);
    let (mut verdict, mut cases) = (own.map(|f| f.verdict).fold(Verdict::Pass, Verdict::and), 0);
    for axiom in axioms() {
        let mut verdicts = told.remove(&axiom.id).unwrap_or_default();
        accept::take(axiom, &mut verdicts, &mut accepted, results);
        let taken = accepted
            .iter()
            .any(|a| a.axiom == axiom.id && a.findings > 0);
        let fact = judged(axiom, &facts, &verdicts, taken);
        cases += fact.cases;
        verdict = verdict.and(match fact.status {
            AxiomStatus::Fail => Verdict::Fail,
            AxiomStatus::Indeterminate => Verdict::Indeterminate,
            _ => Verdict::Pass,
        });
        if fact.status != AxiomStatus::NotChecked {
            for v in &verdicts {
                if matches!(v.status, Status::Fail | Status::Indeterminate) {
                    find(axiom, v, spec, results);
                }
            }
        }
        all.count(fact);
    }
    trace::cited(spec, results);
    let (checked, total) = (all.total - all.not_checked, all.total);
    let how = format!(
        "{checked} of {total} engineering axioms against specification, placed ports and measured solids; \
         {} held, {} apply to nothing here",
        all.passed, all.not_applicable
    );
    results.check(CHECK, verdict, cases, &how);
    (all, accepted)
}

/// What was not checked of the axioms, for the report's list.
pub(crate) fn not_checked(all: &Axioms) -> Vec<String> {
    let mut by_reason: Vec<(&str, Vec<&str>)> = Vec::new();
    for fact in all
        .each
        .iter()
        .filter(|f| f.status == AxiomStatus::NotChecked)
    {
        let why = fact.why.as_deref().unwrap_or_default();
        let why = if [NO_MOTION, NOT_WRITTEN].contains(&why) {
            why
        } else {
            "no machine can check it from a specification"
        };
        match by_reason.iter_mut().find(|(w, _)| *w == why) {
            Some((_, ids)) => ids.push(&fact.axiom),
            None => by_reason.push((why, vec![&fact.axiom])),
        }
    }
    by_reason
        .into_iter()
        .map(|(why, ids)| format!("axioms {}: {why}", ids.join(", ")))
        .collect()
}

/// What an axiom came to, by the worst of its cases.
fn judged(axiom: &Axiom, facts: &Facts, verdicts: &[Ruling], accepted: bool) -> AxiomFacts {
    let worst = verdicts.iter().map(|v| v.status).max();
    let (status, why) = match (&axiom.check, worst) {
        (Checking::None { why }, _) => (AxiomStatus::NotChecked, Some(why.clone())),
        // Broken, and accepted wherever it is.
        (_, None | Some(Status::Pass)) if accepted => (AxiomStatus::Warning, None),
        (Checking::Checked { .. }, None) => (AxiomStatus::NotChecked, Some(NOT_WRITTEN.to_owned())),
        (Checking::Checked { needs, .. }, Some(Status::Indeterminate))
            if needs.contains(&Need::Mobility) && facts.mobility.is_none() =>
        {
            (AxiomStatus::NotChecked, Some(NO_MOTION.to_owned()))
        }
        (_, Some(Status::NotApplicable)) => (AxiomStatus::NotApplicable, None),
        (_, Some(Status::Pass)) => (AxiomStatus::Pass, None),
        (_, Some(_)) if axiom.force == Force::Should => (AxiomStatus::Warning, None),
        (_, Some(Status::Indeterminate)) => (AxiomStatus::Indeterminate, None),
        (_, Some(Status::Fail)) => (AxiomStatus::Fail, None),
    };
    let open = matches!(status, AxiomStatus::NotApplicable | AxiomStatus::NotChecked);
    let mut assumptions: Vec<String> = verdicts
        .iter()
        .filter_map(|v| v.assumption.clone())
        .collect();
    assumptions.sort();
    assumptions.dedup();
    let citing = facts.mates.iter().filter(|m| m.cites(&axiom.id));
    AxiomFacts {
        axiom: axiom.id.clone(),
        statement: axiom.statement.clone(),
        status,
        cases: if open { 0 } else { verdicts.len() },
        cited_by: citing.map(|m| m.id.clone()).collect(),
        why,
        assumptions,
    }
}

/// Tells of a case that is not in order: in the finding that another check has made of the same, or else
/// in one of its own.
fn find(axiom: &Axiom, told: &Ruling, spec: &Assembly, results: &mut Results) {
    let broken = told.status == Status::Fail;
    let role = if broken {
        AxiomRole::Broken
    } else {
        AxiomRole::Open
    };
    if trace::in_another(axiom, told, role, results) {
        return;
    }
    let should = axiom.force == Force::Should;
    let verdict = match (should, broken) {
        (true, _) => Verdict::Pass,
        (false, true) => Verdict::Fail,
        (false, false) => Verdict::Indeterminate,
    };
    let mut values: serde_json::Map<_, _> = told.values.clone().into_iter().collect();
    if let Some(assumed) = &told.assumption {
        values.insert("assumption".to_owned(), json!(assumed));
    }
    let code = if broken {
        Code::AxiomBroken
    } else {
        Code::Indeterminate
    };
    let message = format!("{} ('{}'): {}", axiom.id, axiom.title, told.message);
    let mut d = Diagnostic::error(code, place(told), message);
    d.severity = match (should, broken) {
        (false, _) => Severity::Error,
        (true, true) => Severity::Warning,
        (true, false) => Severity::Note,
    };
    results.findings.push(Finding {
        verdict,
        check: CHECK.to_owned(),
        parts: told.about.parts.clone(),
        mates: told.about.mates.clone(),
        values,
        axioms: vec![trace::of(axiom, role)],
        diagnostic: mend::mended(axiom, told, spec, d),
    });
}

fn place(told: &Ruling) -> String {
    match (told.about.mates.as_slice(), told.about.parts.as_slice()) {
        ([mate], _) => format!("mate '{mate}'"),
        (_, []) => "assembly".to_owned(),
        (_, [part]) => format!("part '{part}'"),
        (_, parts) => {
            let names: Vec<String> = parts.iter().map(|p| format!("'{p}'")).collect();
            format!("parts {}", names.join(", "))
        }
    }
}
