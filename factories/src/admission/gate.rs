//! The gate: a source is admitted only on evidence.
//!
//! Three layers. *Execution*: the source parses, declares what was asked for, and runs within the limits.
//! *Geometry*: the kernel makes one valid closed solid of positive volume. *Ports*: the expected ports are
//! there, and the solid shows every port that is declared. All of it at the defaults first, then at the ends
//! of the ranges, at their corners and between them ([`super::sets`]): a stage that fails is the last one.

use std::collections::BTreeMap;
use std::time::Duration;

use assemcad_geometry::Asker;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::ParamSpec;
use assemcad_script::{Evaluator, Factory};
use serde_json::json;

use super::agree;
use super::narrow::narrow;
use super::report::{Evidence, Finding, Layer, Report};
use super::request::Request;
use super::sets::{Origin, Set, differing, sets};
use super::stages::{Extent, Progress};
use super::trial::{Outcome, Trial};

/// Of the sets that are no defaults, at least this share must be made: else the ranges say what the
/// factory's own rules take back.
const LEAST_MADE: f64 = 0.25;

/// What the gate works with.
#[derive(Debug, Clone, Copy)]
pub struct Gate<'a> {
    /// Who answers for the solids.
    pub door: Asker<'a>,
    /// Who evaluates sources.
    pub evaluator: &'a Evaluator,
    /// After how long no further set is begun; the defaults always are.
    pub limit: Duration,
}

/// How a source is to be tried.
#[derive(Clone, Copy)]
pub struct Manner<'a> {
    /// At which sets.
    pub extent: Extent,
    /// Whether a source that works in a part of its ranges only is admitted for that part.
    pub narrowed: bool,
    /// Who is told after each set.
    pub watch: &'a (dyn Fn(Progress) + Sync),
}

/// A factory that passed.
#[derive(Debug)]
pub struct Admission {
    /// The factory, within the ranges for which it is admitted.
    pub factory: Factory,
    /// Those of its ranges that are narrower than declared: smallest and largest value.
    pub ranges: BTreeMap<String, [f64; 2]>,
    /// On what it is admitted.
    pub evidence: Evidence,
}

/// A set and what became of it.
pub(super) type Tried = (Origin, Set, Outcome);

impl Gate<'_> {
    /// Reads a source.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    async fn parse(&self, name: &str, source: &str) -> Result<Factory, Report> {
        self.evaluator.parse(name, source).await.map_err(|faults| {
            let of = |d| Finding::of(Layer::Execution, d);
            Report::refused(faults.into_iter().map(of).collect())
        })
    }

    /// Holds a source against a request: the whole of a round.
    ///
    /// Where it works at its defaults but not in all of its ranges, and the manner allows it, it is
    /// admitted for the ranges in which it was shown to work.
    ///
    /// # Errors
    /// Everything that is wrong with it; a report without findings where the limit was reached first.
    pub async fn judge(
        &self,
        name: &str,
        source: &str,
        request: &Request,
        manner: Manner<'_>,
    ) -> Result<Admission, Box<Report>> {
        let factory = self.parse(name, source).await?;
        let trial = Trial::new(*self, manner);
        let report = examine(&trial, &factory, request).await;
        if let Some(evidence) = report.evidence {
            return Ok(Admission {
                factory,
                ranges: BTreeMap::new(),
                evidence,
            });
        }
        let at_defaults = report.findings.iter().any(|f| f.at.is_empty());
        if manner.narrowed
            && !at_defaults
            && !report.findings.is_empty()
            && let Some((factory, evidence, ranges)) = narrow(&trial, &factory, request).await
        {
            return Ok(Admission {
                factory,
                ranges,
                evidence,
            });
        }
        Err(Box::new(report))
    }
}

/// Tries a factory at its sets of parameters, stage by stage, and reports everything that is wrong at the
/// first stage where anything is.
pub(super) async fn examine(trial: &Trial<'_>, factory: &Factory, request: &Request) -> Report {
    let all = sets(factory.params());
    let mut findings = agree::agree(factory, request);
    let mut tried: Vec<Tried> = Vec::new();
    let of = |stage: Origin| -> Vec<Set> {
        let own = all.iter().filter(|(origin, _)| *origin == stage);
        own.map(|(_, set)| set.clone()).collect()
    };
    let mut stages = trial.manner.extent.stages().iter().copied();
    let mut sound = true;
    for stage in stages.by_ref() {
        let sets = of(stage);
        let count = sets.len();
        let outcomes = trial.stage(factory, request, stage, sets).await;
        sound = outcomes.len() == count
            && !outcomes.iter().any(|(.., outcome)| match outcome {
                Outcome::Failed(_) => true,
                Outcome::Refused(_) => stage == Origin::Defaults,
                Outcome::Made(_) => false,
            });
        tried.extend(outcomes);
        if stage == Origin::End && sound {
            findings.extend(agree::without_effect(factory, request, &tried));
        }
        // What differs from the request is mended first: the other sets may be others then.
        sound = sound && findings.is_empty();
        if !sound {
            break;
        }
    }
    // Behind a stage that fails nothing is built; what the source itself says there is told all the same.
    let at_defaults = tried.iter().all(|(stage, ..)| *stage == Origin::Defaults);
    if !sound && !at_defaults && !trial.is_over() {
        for stage in stages {
            tried.extend(trial.scripts(factory, stage, of(stage)).await);
        }
    }
    findings.extend(folded(factory.params(), &tried));
    if sound {
        findings.extend(rules(factory, &tried));
    }
    let extent = trial.manner.extent;
    Report::of(findings, extent, &all, &tried, trial.is_over())
}

/// What fails alike at several sets is told once, at the first of them.
fn folded(specs: &[ParamSpec], tried: &[Tried]) -> Vec<Finding> {
    let mut told: Vec<Finding> = Vec::new();
    for (origin, set, outcome) in tried {
        let found = match outcome {
            Outcome::Made(_) => continue,
            Outcome::Failed(found) => found.clone(),
            Outcome::Refused(rules) if *origin == Origin::Defaults => rules
                .iter()
                .map(|d| Finding::of(Layer::Execution, refused_defaults(d)))
                .collect(),
            Outcome::Refused(_) => continue,
        };
        for mut finding in found {
            match told.iter_mut().find(|t| t.is_like(&finding)) {
                Some(known) => known.sets += 1,
                None => {
                    finding.sets = 1;
                    finding.at = differing(specs, set);
                    told.push(finding);
                }
            }
        }
    }
    told
}

fn refused_defaults(rule: &Diagnostic) -> Diagnostic {
    Diagnostic::error(
        Code::FactoryFailed,
        "params",
        format!(
            "the factory's own rules refuse its defaults: {}",
            rule.message
        ),
    )
    .hint("choose defaults that all require(...) allow, or mend the rule")
}

/// Rules that leave next to nothing of the ranges.
fn rules(factory: &Factory, tried: &[Tried]) -> Option<Finding> {
    let others = || tried.iter().filter(|(o, ..)| *o != Origin::Defaults);
    let refused: Vec<&Tried> = others()
        .filter(|(_, _, o)| matches!(o, Outcome::Refused(_)))
        .collect();
    let total = others().count();
    let allowed = (total - refused.len()) as f64;
    let (_, set, Outcome::Refused(rule)) = refused.first()? else {
        return None;
    };
    if allowed >= LEAST_MADE * total as f64 {
        return None;
    }
    let first = rule.first().map(|d| d.message.clone()).unwrap_or_default();
    let d = Diagnostic::error(
        Code::FactoryFailed,
        format!("factory {}", factory.name()),
        format!(
            "the factory's own rules refuse {} of {total} sets of parameters within its ranges; the first: \
             {first}",
            refused.len()
        ),
    )
    .expected(json!({"made_of_the_sets_at_least": LEAST_MADE}))
    .hint("narrow the ranges so that most sets within them are good, or take the values from each other");
    let mut finding = Finding::of(Layer::Execution, d);
    finding.sets = refused.len();
    finding.at = differing(factory.params(), set);
    Some(finding)
}
