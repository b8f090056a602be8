//! A factory: a checked source, its parameters, and what it makes of them.

use std::sync::Arc;

use assemcad_model::canonical::sha256;
use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::param::{ParamSpec, check_all, object_schema};
use assemcad_model::recipe::Recipe;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::fault::Fault;
use crate::limits::Limits;
use crate::run::Job;

/// A source whose top level has been evaluated: it declares its parameters and defines `build(p)`.
#[derive(Debug, Clone)]
pub struct Factory {
    name: String,
    source: Arc<str>,
    limits: Limits,
    doc: String,
    params: Vec<ParamSpec>,
}

/// What a factory makes of its parameters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Evaluated {
    /// The calls that were made, and which of them gives the part.
    pub recipe: Recipe,
    /// The line (1-based) of each call. Beside the recipe and not in it,
    /// so that a moved line does not change the recipe's hash.
    pub lines: Vec<u32>,
    /// The parameters as they were used: checked, with defaults filled in.
    pub params: Map<String, Value>,
    /// The part's designation by a standard, where its source defines `designation(p)` and states one.
    #[serde(default)]
    pub designation: Option<String>,
}

/// Evaluates a plain script: statements as of CadQuery that leave the part in `result`, or give it to
/// `show_object`.
///
/// # Errors
/// One diagnostic for each fault found, at `factory NAME, line LINE`.
pub fn script(name: &str, source: &str) -> Result<Evaluated, Vec<Diagnostic>> {
    script_within(name, source, Limits::default())
}

/// As [`script`], within other limits.
///
/// # Errors
/// As [`script`].
pub fn script_within(
    name: &str,
    source: &str,
    limits: Limits,
) -> Result<Evaluated, Vec<Diagnostic>> {
    let (recipe, lines) = job(name, source, limits)?.script()?;
    Ok(Evaluated {
        recipe,
        lines,
        params: Map::new(),
        designation: None,
    })
}

fn job(name: &str, source: &str, limits: Limits) -> Result<Job, Vec<Diagnostic>> {
    size_within(name, source, &limits)?;
    Ok(Job {
        name: name.to_owned(),
        source: Arc::from(source),
        limits,
    })
}

/// Looks at a source's length alone, before anything is done with it.
pub(crate) fn size(name: &str, source: &str) -> Result<(), Vec<Diagnostic>> {
    size_within(name, source, &Limits::default())
}

fn size_within(name: &str, source: &str, limits: &Limits) -> Result<(), Vec<Diagnostic>> {
    if source.len() <= limits.source_bytes {
        return Ok(());
    }
    let fault = Fault::new(format!(
        "the source has {} bytes, more than {} (limit source_bytes)",
        source.len(),
        limits.source_bytes
    ))
    .hint("split it into several factories");
    Err(vec![fault.diagnostic(name, None)])
}

impl Factory {
    /// Reads a source under the default [`Limits`].
    ///
    /// # Errors
    /// As [`Factory::parse_within`].
    pub fn parse(name: &str, source: &str) -> Result<Self, Vec<Diagnostic>> {
        Self::parse_within(name, source, Limits::default())
    }

    /// Reads a source: evaluates its top level, which calls `factory(doc = ..., params = ...)` once
    /// and defines `def build(p)`.
    ///
    /// # Errors
    /// One diagnostic for each fault found, at `factory NAME, line LINE`.
    pub fn parse_within(name: &str, source: &str, limits: Limits) -> Result<Self, Vec<Diagnostic>> {
        let job = job(name, source, limits)?;
        let declaration = job.clone().declare()?;
        let Job {
            name,
            source,
            limits,
        } = job;
        Ok(Self {
            name,
            source,
            limits,
            doc: declaration.doc,
            params: declaration.params,
        })
    }

    /// The same factory with other ranges of its parameters.
    #[must_use]
    pub fn within(self, params: Vec<ParamSpec>) -> Self {
        Self { params, ..self }
    }

    /// The factory of a source whose declaration is known from another process.
    pub(crate) fn declared(name: &str, source: &str, doc: String, params: Vec<ParamSpec>) -> Self {
        Self {
            name: name.to_owned(),
            source: Arc::from(source),
            limits: Limits::default(),
            doc,
            params,
        }
    }

    /// The factory's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the factory makes, its frame and its ports, in the words of its author.
    #[must_use]
    pub fn doc(&self) -> &str {
        &self.doc
    }

    /// The declared parameters, in order of declaration.
    #[must_use]
    pub fn params(&self) -> &[ParamSpec] {
        &self.params
    }

    /// The JSON Schema of the parameters.
    #[must_use]
    pub fn schema(&self) -> Value {
        object_schema(&self.params)
    }

    /// The source text.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// SHA-256 of the source text, in hexadecimal.
    #[must_use]
    pub fn source_sha256(&self) -> String {
        sha256(self.source.as_bytes())
    }

    /// Checks parameters and fills in defaults, without evaluating anything.
    ///
    /// # Errors
    /// One diagnostic for every unknown name and every value out of type or range, under `params`.
    pub fn check(
        &self,
        params: &Map<String, Value>,
    ) -> Result<Map<String, Value>, Vec<Diagnostic>> {
        check_all(&self.params, params, "params")
    }

    /// Evaluates `build(p)` with the given parameters and defaults for the rest.
    ///
    /// # Errors
    /// Parameters out of type or range, rules between them that do not hold (both under `params`), or
    /// the script's own faults at `factory NAME, line LINE`.
    pub fn build(&self, params: &Map<String, Value>) -> Result<Evaluated, Vec<Diagnostic>> {
        let params = self.check(params)?;
        let job = Job {
            name: self.name.clone(),
            source: Arc::clone(&self.source),
            limits: self.limits.clone(),
        };
        let ((recipe, lines), designation) = job.build(self.params.clone(), params.clone())?;
        Ok(Evaluated {
            recipe,
            lines,
            params,
            designation,
        })
    }
}
