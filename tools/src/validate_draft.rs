//! `validate_draft`.

use assemcad_assembly::{Faults, Workshop};
use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::told::{MOST_TOLD, stands_for};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool};

pub(crate) struct ValidateDraft;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// The whole specification as YAML or JSON; or give 'file'.
    #[serde(default)]
    draft: Option<String>,
    /// A file below the server's root folder that holds the specification; or give 'draft'.
    #[serde(default)]
    file: Option<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// Whether nothing is wrong with it; warnings do not count.
    valid: bool,
    /// The draft's id.
    #[serde(skip_serializing_if = "Option::is_none")]
    draft: Option<String>,
    /// Which round this was for this id, from 1.
    round: usize,
    /// How many rounds there are before the decomposition counts as failed.
    rounds: usize,
    /// Everything that was found, in the order of the lines.
    diagnostics: Vec<Diagnostic>,
    /// How many errors there are.
    errors_total: usize,
    /// How many diagnostics are not shown; mend those that are first.
    not_shown: usize,
}

/// The text that is meant.
pub(crate) fn text(
    workshop: &Workshop,
    draft: Option<String>,
    file: Option<&str>,
) -> Result<String, Faults> {
    match (draft, file) {
        (Some(text), None) => Ok(text),
        (None, Some(file)) => workshop.store.read_text(file).map_err(|d| vec![d]),
        _ => Err(vec![Diagnostic::error(
            Code::ArgumentInvalid,
            "draft",
            "give either 'draft' (the text) or 'file' (a path below the root folder)",
        )]),
    }
}

impl Tool for ValidateDraft {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "validate_draft";
    const TITLE: &'static str = "Validate a draft";
    const DESCRIPTION: &'static str = "Checks a whole specification (YAML: assembly: {id, parts, mates}; \
        or JSON) and tells every error at once with its line: format, factories, parameters, ports, \
        mates, options, axioms, parts that nothing joins. Nothing is built and no assembly is changed. Mend all \
        of it and call again; after a few wrong rounds under one id the decomposition counts as failed. \
        When it is valid, call realize with the same text.";
    const EFFECT: Effect = Effect::Adds;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let text = text(workshop, a.draft, a.file.as_deref())?;
        let checked = workshop.validate_draft(&text).await?;
        let mut shown = checked.diagnostics;
        let total: usize = shown.iter().map(stands_for).sum();
        let errors = shown.iter().filter(|d| d.severity == Severity::Error);
        let errors_total = errors.map(stands_for).sum();
        // Those that only say how many more there are are counted, not shown.
        shown.retain(|d| d.code != Code::NotShown);
        if shown.len() > MOST_TOLD {
            // Errors before warnings; within them, the order of the lines.
            shown.sort_by_key(|d| d.severity);
            shown.truncate(MOST_TOLD);
        }
        Ok(Answer {
            valid: checked.assembly.is_some(),
            draft: checked.id,
            round: checked.round,
            rounds: workshop.draft_rounds,
            not_shown: total - shown.len(),
            diagnostics: shown,
            errors_total,
        })
    }
}
