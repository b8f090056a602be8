//! The check `ports`: every solid shows what its ports promise.

use assemcad_factories::evidence::{self, Asked, Unasked};
use assemcad_geometry::Asker;
use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::ports::Port;
use assemcad_model::probe::{Answer, Probe};
use assemcad_model::report::{Finding, Verdict};
use assemcad_placing::solids::once_per_recipe;
use assemcad_placing::{Resolved, ResolvedPart};
use serde_json::Map;

use crate::results::Results;

/// Checks the ports of all parts. Parts of one recipe are asked once.
pub async fn check(
    door: Asker<'_>,
    resolved: &Resolved,
    built: &[Option<Built>],
    results: &mut Results,
) {
    let answers = once_per_recipe(resolved, built, |part, _| ask(door, part)).await;
    let (mut verdict, mut cases) = (Verdict::Pass, 0);
    for (part, answers) in resolved.parts.iter().zip(answers) {
        cases += part.ports().len();
        let found = match answers.as_deref() {
            Some(Ok(asked)) => asked
                .iter()
                .filter_map(|(port, answers)| judge(part, port, answers))
                .collect(),
            Some(Err(d)) => vec![open(part, d.clone())],
            // The check of the parts has said why there is no solid.
            None if part.ports().is_empty() => Vec::new(),
            None => vec![open(
                part,
                Diagnostic::error(
                    Code::Indeterminate,
                    format!("part '{}'", part.id),
                    "its ports cannot be checked: it could not be made",
                ),
            )],
        };
        for finding in found {
            verdict = verdict.and(finding.verdict);
            results.findings.push(finding);
        }
    }
    results.check(
        "ports",
        verdict,
        cases,
        "what each port's type demands of the solid: points in and out of the material, plane faces \
         within 0.0001 mm and 0.001 rad, cylinder faces of the stated radius and side",
    );
}

/// The probes of a part's ports and their answers.
async fn ask<'a>(door: Asker<'_>, part: &'a ResolvedPart) -> Result<Vec<Asked<'a>>, Diagnostic> {
    evidence::ask(door, &part.made.solid, part.ports())
        .await
        .map_err(|why| match why {
            Unasked::Port(port, faults) => {
                let place = format!("part '{}', port '{port}'", part.id);
                Diagnostic::error(Code::PortEvidence, place, faults.join("; "))
            }
            Unasked::Kernel(failure) => part.failed(&failure),
        })
}

/// A finding where the solid does not show a port.
fn judge(part: &ResolvedPart, port: &Port, answers: &[(Probe, Answer)]) -> Option<Finding> {
    let (d, values) = evidence::missing(port, answers, &format!("part '{}'", part.id))?;
    let d = d.hint(format!(
        "in the factory {} either the feature is missing or has another place or size, or the port's \
         frame or parameters are wrong",
        part.factory
    ));
    Some(Finding {
        verdict: Verdict::Fail,
        check: "ports".to_owned(),
        parts: vec![part.id.clone()],
        mates: Vec::new(),
        values,
        axioms: Vec::new(),
        diagnostic: d,
    })
}

fn open(part: &ResolvedPart, d: Diagnostic) -> Finding {
    let verdict = match d.code {
        Code::PortEvidence => Verdict::Fail,
        _ => Verdict::Indeterminate,
    };
    Finding {
        verdict,
        check: "ports".to_owned(),
        parts: vec![part.id.clone()],
        mates: Vec::new(),
        values: Map::new(),
        axioms: Vec::new(),
        diagnostic: d,
    }
}
