//! Who has sources evaluated, here or elsewhere.

use std::path::PathBuf;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_workers::{Failure, FailureKind, Limits, Pool};
use serde_json::{Map, Value, json};

use super::{Job, Reply, ScriptWork};
use crate::factory::{Evaluated, Factory, script, size};

/// What one request to a worker process may use. The evaluation's own limit on time is shorter, so
/// that what only takes long is told with its line.
pub const LIMITS: Limits = Limits {
    memory_mb: 1024,
    cpu_s: 20,
    wall_s: 30,
};

/// How worker processes are started.
#[derive(Debug, Clone)]
pub struct Config {
    /// The program; it is called as `program script-worker --memory-mb N --cpu-s N`.
    pub program: PathBuf,
    /// How many processes, at least one.
    pub workers: usize,
    /// What one request may use.
    pub limits: Limits,
}

/// Evaluates sources.
#[derive(Debug)]
pub struct Evaluator {
    /// None where it is done in this process.
    pool: Option<Pool<ScriptWork>>,
}

impl Evaluator {
    /// Evaluates in this process, and blocks meanwhile: for sources of our own, which mean no harm.
    #[must_use]
    pub fn here() -> Self {
        Self { pool: None }
    }

    /// Evaluates in worker processes, for sources of others.
    #[must_use]
    pub fn processes(config: Config) -> Self {
        Self {
            pool: Some(Pool::new(assemcad_workers::Config {
                program: config.program,
                arguments: Vec::new(),
                workers: config.workers,
                limits: config.limits,
            })),
        }
    }

    /// Reads a factory's source, as [`Factory::parse`].
    ///
    /// # Errors
    /// One diagnostic for each fault found; one where the source breaks a limit of the process.
    pub async fn parse(&self, name: &str, source: &str) -> Result<Factory, Vec<Diagnostic>> {
        let Some(pool) = &self.pool else {
            return Factory::parse(name, source);
        };
        size(name, source)?;
        let job = Job::Declare {
            name: name.to_owned(),
            source: source.to_owned(),
        };
        match pool.run(&job).await {
            Ok((Reply::Declared(declared), _)) => Ok(declared.factory(name, source)),
            other => Err(faults(other, &place(name), pool)),
        }
    }

    /// Evaluates `build(p)` with the given parameters and defaults for the rest, as [`Factory::build`].
    ///
    /// # Errors
    /// As [`Factory::build`]; one diagnostic where the source breaks a limit of the process.
    pub async fn build(
        &self,
        factory: &Factory,
        params: &Map<String, Value>,
    ) -> Result<Evaluated, Vec<Diagnostic>> {
        let Some(pool) = &self.pool else {
            return factory.build(params);
        };
        let job = Job::Build {
            name: factory.name().to_owned(),
            source: factory.source().to_owned(),
            params: factory.check(params)?,
        };
        match pool.run(&job).await {
            Ok((Reply::Evaluated(evaluated), _)) => Ok(evaluated),
            other => Err(faults(other, &place(factory.name()), pool)),
        }
    }

    /// Evaluates a plain script, as [`script`].
    ///
    /// # Errors
    /// As [`script`]; one diagnostic where the source breaks a limit of the process.
    pub async fn script(&self, name: &str, source: &str) -> Result<Evaluated, Vec<Diagnostic>> {
        let Some(pool) = &self.pool else {
            return script(name, source);
        };
        size(name, source)?;
        let job = Job::Plain {
            name: name.to_owned(),
            source: source.to_owned(),
        };
        match pool.run(&job).await {
            Ok((Reply::Evaluated(evaluated), _)) => Ok(evaluated),
            other => Err(faults(other, &place(name), pool)),
        }
    }

    /// The values of expressions over parameters, as [`crate::expressions`].
    ///
    /// # Errors
    /// One diagnostic where they break a limit of the process.
    pub async fn expressions(
        &self,
        params: &Map<String, Value>,
        texts: &[String],
    ) -> Result<Vec<Result<f64, Diagnostic>>, Vec<Diagnostic>> {
        let Some(pool) = &self.pool else {
            return Ok(crate::expressions(params, texts));
        };
        let job = Job::Expressions {
            params: params.clone(),
            expressions: texts.to_vec(),
        };
        match pool.run(&job).await {
            Ok((Reply::Numbers(found), _)) if found.len() == texts.len() => Ok(found),
            other => Err(faults(other, "expressions", pool)),
        }
    }
}

fn place(name: &str) -> String {
    crate::fault::place(name, None)
}

/// What is wrong, where the answer is not the one that was asked for.
fn faults(
    answer: Result<(Reply, Vec<u8>), Failure>,
    place: &str,
    pool: &Pool<ScriptWork>,
) -> Vec<Diagnostic> {
    match answer {
        Ok((Reply::Faults(faults), _)) if !faults.is_empty() => faults,
        Ok(_) => vec![Diagnostic::error(
            Code::Internal,
            place,
            "the worker answered another question",
        )],
        Err(failure) => vec![failed(&failure, place, pool.limits())],
    }
}

/// A worker that did not survive its job, as a diagnostic.
fn failed(failure: &Failure, place: &str, limits: Limits) -> Diagnostic {
    const SMALLER: &str =
        "keep lists and texts short and flat, and compare or print no list of lists";
    const SHORTER: &str = "do less work in loops, and compare or print no list of lists";
    let (code, limit, hint) = match failure.kind {
        FailureKind::Memory => (
            Code::WorkerMemoryLimit,
            Some(json!({"memory_mb": limits.memory_mb})),
            SMALLER,
        ),
        FailureKind::Cpu => (
            Code::WorkerCpuLimit,
            Some(json!({"cpu_s": limits.cpu_s})),
            SHORTER,
        ),
        FailureKind::Wall => (
            Code::WorkerTimeout,
            Some(json!({"wall_s": limits.wall_s})),
            SHORTER,
        ),
        FailureKind::Crash => (
            Code::WorkerCrashed,
            None,
            "the worker was replaced and nothing was lost; if it happens again, write the source in a \
             simpler way",
        ),
        FailureKind::Refused | FailureKind::Worker => (
            Code::WorkerFailed,
            None,
            "nothing is wrong with the source as far as is known; try again",
        ),
    };
    let doing = failure.doing.as_ref();
    let doing = doing.map(|d| format!("in {d}: ")).unwrap_or_default();
    let message = format!("{doing}{}", failure.message);
    let d = Diagnostic::error(code, place, message).hint(hint);
    match limit {
        Some(limit) => d.expected(limit),
        None => d,
    }
}
