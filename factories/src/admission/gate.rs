//! The gate: a source is admitted only on evidence.
//!
//! Three layers. *Execution*: the source parses, declares what was asked for, and runs within the limits.
//! *Geometry*: the kernel makes one valid closed solid of positive volume. *Ports*: the expected ports are
//! there, and the solid shows every port that is declared. All of it at the defaults, at the ends and
//! corners of the ranges and between them ([`super::sets`]).

use std::collections::BTreeMap;

use assemcad_geometry::Asker;
use assemcad_kernel::protocol::{Built, FailureKind, Named};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::ParamSpec;
use assemcad_script::{Evaluated, Evaluator, Factory};
use futures::stream::{self, StreamExt};
use serde_json::json;

use super::narrow::narrow;
use super::report::{Evidence, Finding, Layer, Report};
use super::request::Request;
use super::sets::{Origin, Set, differing, sets};
use super::{agree, hints, ports};
use crate::failure;

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

/// A part as a set of parameters gives it.
#[derive(Debug)]
pub struct Made {
    /// Calls and lines.
    pub evaluated: Evaluated,
    /// The solid of the recipe.
    pub solid: Named,
    /// Measures and ports.
    pub built: Built,
}

/// What became of one set of parameters.
#[derive(Debug)]
pub(super) enum Outcome {
    /// The factory's own rules refuse it.
    Refused(Vec<Diagnostic>),
    /// Made, and nothing is wrong with it.
    Made(Box<Made>),
    /// What is wrong.
    Failed(Vec<Finding>),
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
    /// Where it works at its defaults but not in all of its ranges, and `narrowed` allows it, it is
    /// admitted for the ranges in which it was shown to work.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub async fn judge(
        &self,
        name: &str,
        source: &str,
        request: &Request,
        narrowed: bool,
    ) -> Result<Admission, Box<Report>> {
        let factory = self.parse(name, source).await?;
        let report = self.examine(&factory, request).await;
        if let Some(evidence) = report.evidence {
            return Ok(Admission {
                factory,
                ranges: BTreeMap::new(),
                evidence,
            });
        }
        let at_defaults = report.findings.iter().any(|f| f.at.is_empty());
        if narrowed
            && !at_defaults
            && let Some((factory, evidence, ranges)) = narrow(self, &factory, request).await
        {
            return Ok(Admission {
                factory,
                ranges,
                evidence,
            });
        }
        Err(Box::new(report))
    }

    /// Tries a factory at all its sets of parameters and reports everything that is wrong.
    pub(super) async fn examine(&self, factory: &Factory, request: &Request) -> Report {
        let mut findings = agree::agree(factory, request);
        let all = sets(factory.params());
        let count = all.len();
        let mut all = all.into_iter();
        let mut tried = Vec::new();
        if let Some(defaults) = all.next() {
            tried.push(self.try_set(factory, request, defaults).await);
        }
        // What differs from the request is mended first: the other sets may be others then.
        let sound = matches!(tried.first(), Some((_, _, Outcome::Made(_)))) && findings.is_empty();
        if sound {
            let each = all.map(|set| self.try_set(factory, request, set));
            // In their order, whichever is done first.
            let more = stream::iter(each).buffered(2 * self.door.processes());
            tried.extend(more.collect::<Vec<Tried>>().await);
        }
        findings.extend(folded(factory.params(), &tried));
        if sound {
            findings.extend(rules(factory, &tried));
            findings.extend(agree::without_effect(factory, request, &tried));
        }
        Report::of(findings, count, &tried)
    }

    async fn try_set(
        &self,
        factory: &Factory,
        request: &Request,
        (origin, set): (Origin, Set),
    ) -> Tried {
        let outcome = self.outcome(factory, request, &set).await;
        (origin, set, outcome)
    }

    /// What becomes of a set of parameters, in all three layers.
    pub(super) async fn outcome(&self, factory: &Factory, request: &Request, set: &Set) -> Outcome {
        let made = match self.make(factory, set).await {
            Ok(made) => made,
            Err(outcome) => return outcome,
        };
        let found = ports::examine(self, factory.name(), request, set, &made).await;
        if found.is_empty() {
            Outcome::Made(Box::new(made))
        } else {
            Outcome::Failed(found)
        }
    }

    /// Script and kernel at one set.
    async fn make(&self, factory: &Factory, set: &Set) -> Result<Made, Outcome> {
        let evaluated = self.evaluator.build(factory, set).await.map_err(|faults| {
            let own_rule = |d: &Diagnostic| d.code == Code::ParamInvalid && d.place == "params";
            if faults.iter().all(own_rule) {
                return Outcome::Refused(faults);
            }
            let of = |d| Finding::of(Layer::Execution, d);
            Outcome::Failed(faults.into_iter().map(of).collect())
        })?;
        let solid = Named::new(evaluated.recipe.clone());
        let failure = match self.door.build(&solid).await {
            Ok(built) => {
                return Ok(Made {
                    evaluated,
                    solid,
                    built,
                });
            }
            Err(failure) => failure,
        };
        // What the kernel says is about the shape; a limit or a crash is about the running.
        let layer = match failure.kind {
            FailureKind::Refused => Layer::Geometry,
            _ => Layer::Execution,
        };
        let d = failure::failed_in(&failure, None, factory.name(), &evaluated.lines);
        let mut finding = Finding::of(layer, hints::of_geometry(d, &failure, &evaluated.recipe));
        finding.line = failure::line(&failure, &evaluated.lines);
        Err(Outcome::Failed(vec![finding]))
    }
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
