//! Evaluation in processes of its own: what is asked, what is answered, and the process that answers.
//!
//! The limits of an evaluation ([`crate::Limits`]) cannot see everything that the interpreter does in
//! one step. What they miss meets the limits of the process.

mod client;
mod wire;

use std::io;

use assemcad_model::diagnostic::Diagnostic;
use assemcad_workers::{Handler, Keeps, Limits, Refusal, Tell, Work};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::factory::{Evaluated, Factory, script};
pub use client::{Config, Evaluator, LIMITS};
pub use wire::Declared;

/// The kind of work: evaluating sources.
#[derive(Debug)]
pub struct ScriptWork;

impl Work for ScriptWork {
    type Job = Job;
    type Reply = Reply;
    const SUBCOMMAND: &'static str = "script-worker";
    fn name(job: &Job) -> &'static str {
        match job {
            Job::Declare { .. } => "reading the source",
            Job::Build { .. } => "build(p)",
            Job::Plain { .. } => "the script",
            Job::Expressions { .. } => "the expressions",
        }
    }
}

/// A piece of work.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Job {
    /// Read a factory's source, which declares its parameters.
    Declare {
        /// Name of the factory.
        name: String,
        /// Its source.
        source: String,
    },
    /// Evaluate `build(p)` of a factory.
    Build {
        /// Name of the factory.
        name: String,
        /// Its source.
        source: String,
        /// The parameters that are given.
        params: Map<String, Value>,
    },
    /// Evaluate a plain script.
    Plain {
        /// Its name.
        name: String,
        /// Its source.
        source: String,
    },
    /// Evaluate expressions over parameters.
    Expressions {
        /// The names that they may use.
        params: Map<String, Value>,
        /// The expressions.
        expressions: Vec<String>,
    },
}

/// The answer to a job, or what is wrong.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reply {
    /// Of [`Job::Declare`].
    Declared(Declared),
    /// Of [`Job::Build`] and [`Job::Plain`].
    Evaluated(Evaluated),
    /// Of [`Job::Expressions`]: one answer each, in order.
    Numbers(Vec<Result<f64, Diagnostic>>),
    /// Of any but the last: what is wrong with the source or its parameters.
    Faults(Vec<Diagnostic>),
}

/// Serves jobs from the socket that is this process's standard input, until it closes.
///
/// # Errors
/// When the limits cannot be set or the socket breaks.
pub fn run(limits: Limits) -> io::Result<()> {
    // It keeps nothing: all that it needs comes with the job.
    assemcad_workers::serve::<ScriptWork>(limits, &Keeps::default(), Desk)
}

/// Evaluates in this process.
struct Desk;

impl Handler<ScriptWork> for Desk {
    fn work(&mut self, job: &Job, _tell: Tell<'_>) -> Result<(Reply, Vec<u8>), Refusal> {
        Ok((answer(job), Vec::new()))
    }

    fn is_fit(&self) -> bool {
        crate::thread::is_fit()
    }
}

fn answer(job: &Job) -> Reply {
    let answer = match job {
        Job::Declare { name, source } => {
            Factory::parse(name, source).map(|f| Reply::Declared(Declared::of(&f)))
        }
        Job::Build {
            name,
            source,
            params,
        } => Factory::parse(name, source)
            .and_then(|f| f.build(params))
            .map(Reply::Evaluated),
        Job::Plain { name, source } => script(name, source).map(Reply::Evaluated),
        Job::Expressions {
            params,
            expressions,
        } => Ok(Reply::Numbers(crate::expressions(params, expressions))),
    };
    answer.unwrap_or_else(Reply::Faults)
}
