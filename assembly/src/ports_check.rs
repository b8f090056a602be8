//! The check `ports`: every solid shows what its ports promise.

use std::collections::BTreeMap;

use assemcad_kernel::protocol::{Built, Job, Reply};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::ports::Port;
use assemcad_model::probe::{Answer, Probe};
use assemcad_model::report::{Finding, Verdict, rounded};
use futures::future::join_all;
use serde_json::{Map, json};

use crate::Workshop;
use crate::build::{part_failure, unexpected};
use crate::resolve::{Resolved, ResolvedPart};
use crate::verify::Run;

/// How many probes a finding tells of; it counts them all.
const MOST_TOLD: usize = 3;

/// A port and the answers to its probes.
type Asked<'a> = (&'a Port, Vec<(Probe, Answer)>);

impl Workshop {
    /// Checks the ports of all parts. Parts of one recipe are asked once.
    pub(crate) async fn check_ports(
        &self,
        resolved: &Resolved,
        built: &[Option<Built>],
        run: &mut Run,
    ) {
        let mut distinct: BTreeMap<&str, &ResolvedPart> = BTreeMap::new();
        for (part, built) in resolved.parts.iter().zip(built) {
            if let Some(b) = built {
                distinct.entry(&b.recipe).or_insert(part);
            }
        }
        let answers = join_all(distinct.values().map(|p| self.ask(p))).await;
        let answers: BTreeMap<&str, _> = distinct.keys().copied().zip(answers).collect();
        let (mut verdict, mut cases) = (Verdict::Pass, 0);
        for (part, built) in resolved.parts.iter().zip(built) {
            cases += part.ports().len();
            let found = match built.as_ref().map(|b| answers.get(b.recipe.as_str())) {
                Some(Some(Ok(asked))) => asked
                    .iter()
                    .filter_map(|(port, answers)| judge(part, port, answers))
                    .collect(),
                Some(Some(Err(d))) => vec![open(part, d.clone())],
                // The check of the parts has said why there is no solid.
                _ if part.ports().is_empty() => Vec::new(),
                _ => vec![open(
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
                run.findings.push(finding);
            }
        }
        run.check(
            "ports",
            verdict,
            cases,
            "what each port's type demands of the solid: points in and out of the material, plane faces \
             within 0.0001 mm and 0.001 rad, cylinder faces of the stated radius and side",
        );
    }

    /// The probes of a part's ports and their answers.
    ///
    /// # Errors
    /// When the kernel does not answer, or a port is not well formed.
    pub async fn ask<'a>(&self, part: &'a ResolvedPart) -> Result<Vec<Asked<'a>>, Diagnostic> {
        let mut ports = Vec::new();
        let mut probes = Vec::new();
        for port in part.ports() {
            let own = port.evidence().map_err(|faults| {
                let place = format!("part '{}', port '{}'", part.id, port.name);
                Diagnostic::error(Code::PortEvidence, place, faults.join("; "))
            })?;
            ports.push((port, own.len()));
            probes.extend(own);
        }
        if ports.is_empty() {
            return Ok(Vec::new());
        }
        let job = Job::Probe {
            recipe: part.made.recipe.clone(),
            probes: probes.clone(),
        };
        let answers = match self.pool.run(&job).await {
            Ok((Reply::Probed(answers), _)) if answers.len() == probes.len() => answers,
            Ok(_) => return Err(unexpected(&job)),
            Err(f) => return Err(part_failure(&f, part)),
        };
        let mut pairs = probes.into_iter().zip(answers);
        Ok(ports
            .into_iter()
            .map(|(port, n)| (port, pairs.by_ref().take(n).collect()))
            .collect())
    }
}

/// A finding where the solid does not show a port.
fn judge(part: &ResolvedPart, port: &Port, answers: &[(Probe, Answer)]) -> Option<Finding> {
    let failed: Vec<_> = answers.iter().filter(|(_, a)| !a.held).collect();
    let (probe, answer) = failed.first()?;
    let kind = port.port_type.kind();
    let mut values = Map::new();
    values.insert("port".to_owned(), json!(port.name));
    values.insert("probes".to_owned(), json!(answers.len()));
    values.insert("failed".to_owned(), json!(failed.len()));
    let told: Vec<_> = failed
        .iter()
        .take(MOST_TOLD)
        .map(|(p, a)| json!({"shows": p.shows, "at_mm": a.at.map(rounded), "found": a.found}))
        .collect();
    values.insert("first_failed".to_owned(), json!(told));
    let at = answer.at.map(rounded);
    let d = Diagnostic::error(
        Code::PortEvidence,
        format!("part '{}', port '{}'", part.id, port.name),
        format!(
            "the solid does not show this {} port: {} is missing at {at:?} in the part's frame ({} of {} \
             probes fail): {}",
            kind.name,
            probe.shows,
            failed.len(),
            answers.len(),
            answer.found
        ),
    )
    .found(json!({"frame": port.frame, "params": port.params}))
    .expected(kind.doc)
    .hint(format!(
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
