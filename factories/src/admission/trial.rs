//! Sets of parameters tried: evaluated, built, probed, by all workers at once and each once.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use assemcad_kernel::protocol::{Built, Failure, FailureKind, Named};
use assemcad_model::canonical;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::recipe::Recipe;
use assemcad_script::{Evaluated, Factory};
use futures::lock;
use futures::stream::{self, StreamExt};

use super::gate::{Gate, Manner, Tried};
use super::report::{Finding, Layer};
use super::request::Request;
use super::sets::{Origin, Set};
use super::stages::Progress;
use super::{hints, ports};
use crate::failure;

/// What became of one set of parameters.
#[derive(Debug, Clone)]
pub(super) enum Outcome {
    /// The factory's own rules refuse it.
    Refused(Vec<Diagnostic>),
    /// Made, and nothing is wrong with it.
    Made(Arc<Solid>),
    /// What is wrong.
    Failed(Vec<Finding>),
}

/// A recipe's solid.
#[derive(Debug)]
pub(super) struct Solid {
    /// Measures and ports.
    pub(super) built: Built,
    /// What is wrong with its ports whatever the request asks for.
    pub(super) found: Vec<Finding>,
}

/// What the kernel made of a recipe, once it is known.
type Known = Arc<lock::Mutex<Option<Result<Arc<Solid>, Failure>>>>;

/// One source on trial: what was made of it is not made again.
pub(super) struct Trial<'a> {
    pub(super) gate: Gate<'a>,
    pub(super) manner: Manner<'a>,
    began: Instant,
    over: AtomicBool,
    /// By the recipe's hash.
    solids: Mutex<BTreeMap<String, Known>>,
    /// By the set's canonical JSON.
    outcomes: Mutex<BTreeMap<Vec<u8>, Outcome>>,
}

impl<'a> Trial<'a> {
    pub(super) fn new(gate: Gate<'a>, manner: Manner<'a>) -> Self {
        Self {
            gate,
            manner,
            began: Instant::now(),
            over: AtomicBool::new(false),
            solids: Mutex::default(),
            outcomes: Mutex::default(),
        }
    }

    /// Whether a set was left because of the limit.
    pub(super) fn is_over(&self) -> bool {
        self.over.load(Ordering::Relaxed)
    }

    /// Whether nothing more is to be begun; what asks for it has left something.
    pub(super) fn expired(&self) -> bool {
        let expired = self.began.elapsed() >= self.gate.limit;
        if expired {
            self.over.store(true, Ordering::Relaxed);
        }
        expired
    }

    /// Tries sets of one stage, as many at once as there are workers; fewer come back where the limit was
    /// reached.
    pub(super) async fn stage(
        &self,
        factory: &Factory,
        request: &Request,
        stage: Origin,
        sets: Vec<Set>,
    ) -> Vec<Tried> {
        let (of, done) = (sets.len(), AtomicUsize::new(0));
        let each = sets.into_iter().map(|set| {
            let done = &done;
            async move {
                // The defaults are what everybody wants to know first.
                if stage != Origin::Defaults && self.expired() {
                    return None;
                }
                let outcome = self.outcome(factory, request, &set).await;
                let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                (self.manner.watch)(Progress { stage, done, of });
                Some((stage, set, outcome))
            }
        });
        // In their order, whichever is done first.
        let tried = stream::iter(each).buffered(2 * self.gate.door.processes());
        tried.filter_map(|t| async { t }).collect().await
    }

    /// What becomes of a set of parameters, in all three layers.
    pub(super) async fn outcome(&self, factory: &Factory, request: &Request, set: &Set) -> Outcome {
        let key = canonical::to_bytes(set).unwrap_or_default();
        let known = self.outcomes().get(&key).cloned();
        if let Some(known) = known {
            return known;
        }
        let outcome = self.tried(factory, request, set).await;
        self.outcomes().insert(key, outcome.clone());
        outcome
    }

    fn outcomes(&self) -> MutexGuard<'_, BTreeMap<Vec<u8>, Outcome>> {
        // Nothing leaves the map half changed.
        self.outcomes.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs the source alone at sets of one stage, which costs next to nothing, and gives those at which it
    /// fails.
    pub(super) async fn scripts(
        &self,
        factory: &Factory,
        stage: Origin,
        sets: Vec<Set>,
    ) -> Vec<Tried> {
        let each = sets.into_iter().map(|set| async move {
            match self.evaluated(factory, &set).await {
                Err(failed @ Outcome::Failed(_)) => Some((stage, set, failed)),
                _ => None,
            }
        });
        let failed = stream::iter(each).buffered(2 * self.gate.door.processes());
        failed.filter_map(|t| async { t }).collect().await
    }

    /// What the source gives at a set; what becomes of the set where it gives nothing.
    async fn evaluated(&self, factory: &Factory, set: &Set) -> Result<Evaluated, Outcome> {
        self.gate
            .evaluator
            .build(factory, set)
            .await
            .map_err(|faults| {
                let own_rule = |d: &Diagnostic| d.code == Code::ParamInvalid && d.place == "params";
                if faults.iter().all(own_rule) {
                    return Outcome::Refused(faults);
                }
                let of = |d| Finding::of(Layer::Execution, d);
                Outcome::Failed(faults.into_iter().map(of).collect())
            })
    }

    async fn tried(&self, factory: &Factory, request: &Request, set: &Set) -> Outcome {
        let evaluated = match self.evaluated(factory, set).await {
            Ok(evaluated) => evaluated,
            Err(outcome) => return outcome,
        };
        let solid = match self.solid(factory.name(), &evaluated.recipe).await {
            Ok(solid) => solid,
            Err(failure) => {
                return Outcome::Failed(vec![unmade(&failure, factory.name(), &evaluated)]);
            }
        };
        let mut found =
            ports::expected(&self.gate, factory.name(), request, set, &solid.built.ports).await;
        found.extend(solid.found.iter().cloned());
        if found.is_empty() {
            Outcome::Made(solid)
        } else {
            Outcome::Failed(found)
        }
    }

    /// The solid of a recipe, built and probed once, whoever asks for it meanwhile.
    async fn solid(&self, name: &str, recipe: &Recipe) -> Result<Arc<Solid>, Failure> {
        // Without a hash it is its own, and the kernel says what is wrong with it.
        let hash = recipe.hash().unwrap_or_default();
        let slot = {
            let mut solids = self.solids.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::clone(solids.entry(hash).or_default())
        };
        let mut slot = slot.lock().await;
        if let Some(known) = slot.as_ref() {
            return known.clone();
        }
        let made = self.made(name, recipe).await;
        *slot = Some(made.clone());
        made
    }

    async fn made(&self, name: &str, recipe: &Recipe) -> Result<Arc<Solid>, Failure> {
        let named = Named::new(recipe.clone());
        let built = self.gate.door.build(&named).await?;
        let found = ports::shown(self.gate.door, name, (&named, recipe), &built).await;
        Ok(Arc::new(Solid { built, found }))
    }
}

/// What the kernel says of the shape is about the geometry; a limit or a crash is about the running.
fn unmade(failure: &Failure, name: &str, evaluated: &Evaluated) -> Finding {
    let layer = match failure.kind {
        FailureKind::Refused => Layer::Geometry,
        _ => Layer::Execution,
    };
    let d = failure::failed_in(failure, None, name, &evaluated.lines);
    let mut finding = Finding::of(layer, hints::of_geometry(d, failure, &evaluated.recipe));
    finding.line = failure::line(failure, &evaluated.lines);
    finding
}
