//! Rules of experience that an author breaks knowingly: shown first, counted, and for named parts only.

use assemcad_axioms::ruling::Ruling;
use assemcad_axioms::{Axiom, Status, axioms};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name::{listed, nearest};
use assemcad_model::report::{AcceptedFact, AxiomRole, Finding, Verdict};
use assemcad_model::spec::Assembly;
use serde_json::{Map, json};

use super::{check, trace};
use crate::results::Results;

/// Rules that say what is so, not what experience wants: whether parts are there, touch, fit into each other, move
/// and can be put together. Nobody can accept that they are broken.
const FACTS: [&str; 12] = [
    "B-01", "B-03", "G-01", "G-02", "G-03", "G-04", "G-09", "H-02", "N-01", "S-01", "T-01", "T-02",
];

fn acceptable(axiom: &str) -> bool {
    let whole = ["F-", "C-0", "K-"];
    axiom == "C-05"
        || !(FACTS.contains(&axiom) || whole.iter().any(|start| axiom.starts_with(start)))
}

/// What is wrong with what is accepted: rules that there are not, and rules that nobody can accept as broken. Places are
/// those of the specification.
#[must_use]
pub fn faults(spec: &Assembly) -> Vec<Diagnostic> {
    let each = spec.accept.iter().enumerate();
    each.filter_map(|(i, a)| {
        let place = format!("accept[{i}].axiom");
        let d = if !axioms().iter().any(|x| x.id == a.axiom) {
            let ids = axioms().iter().map(|x| x.id.as_str());
            let near = nearest(&a.axiom, ids, 1);
            let d = Diagnostic::error(Code::AxiomUnknown, place, "there is no such axiom");
            match near.first() {
                Some(near) => d.hint(format!("did you mean '{near}'?")),
                None => d,
            }
        } else if acceptable(&a.axiom) {
            return None;
        } else {
            let can = axioms().iter().map(|x| x.id.as_str()).filter(|id| acceptable(id));
            Diagnostic::error(
                Code::SpecificationInvalid,
                place,
                "this rule says what is so and is no matter of experience: it cannot be accepted as broken",
            )
            .expected(json!(can.collect::<Vec<_>>()))
            .hint("mend what its findings name")
        };
        Some(d.found(a.axiom.as_str()))
    })
    .collect()
}

/// What is stated as accepted. What cannot be is a finding.
pub(super) fn stated(spec: &Assembly, results: &mut Results) -> Vec<AcceptedFact> {
    for d in faults(spec) {
        results.find(Verdict::Fail, check::CHECK, Vec::new(), d);
    }
    let good = spec.accept.iter().filter(|a| acceptable(&a.axiom));
    good.map(|a| AcceptedFact {
        axiom: a.axiom.clone(),
        parts: a.parts.clone(),
        reason: a.reason.clone(),
        findings: 0,
    })
    .collect()
}

/// Takes the broken cases out of an axiom's that are accepted, and tells each.
pub(super) fn take(
    axiom: &Axiom,
    verdicts: &mut Vec<Ruling>,
    accepted: &mut [AcceptedFact],
    results: &mut Results,
) {
    let broken = |v: &Ruling| matches!(v.status, Status::Fail | Status::Indeterminate);
    verdicts.retain_mut(|v| {
        if !broken(v) {
            return true;
        }
        let about = |a: &&mut AcceptedFact| {
            a.axiom == axiom.id
                && (v.about.parts.is_empty() && !v.about.mates.is_empty()
                    || !v.about.parts.is_empty())
                && v.about.parts.iter().all(|p| a.parts.contains(p))
        };
        let Some(by) = accepted.iter_mut().find(about) else {
            return true;
        };
        by.findings += 1;
        let message = format!("{} ('{}'): {}", axiom.id, axiom.title, v.message);
        let mut d = Diagnostic::warning(
            Code::AxiomBroken,
            format!("part {}", listed(&by.parts, 4)),
            format!("accepted, since {}: {message}", by.reason),
        );
        d.severity = assemcad_model::diagnostic::Severity::Note;
        let mut values: Map<_, _> = v.values.clone().into_iter().collect();
        values.insert("accepted".to_owned(), json!(true));
        results.findings.push(Finding {
            verdict: Verdict::Pass,
            check: check::CHECK.to_owned(),
            parts: v.about.parts.clone(),
            mates: v.about.mates.clone(),
            values,
            axioms: vec![trace::of(axiom, AxiomRole::Broken)],
            diagnostic: d,
        });
        false
    });
}
