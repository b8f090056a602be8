//! `realize`.

use assemcad_assembly::realize::Stage;
use assemcad_assembly::report_files::report_file;
use assemcad_assembly::state::State;
use assemcad_assembly::{Faults, Workshop};
use assemcad_model::report::Verdict;
use assemcad_verify::Terms;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::verify::default_tau;
use crate::{Effect, Tool, validate_draft};

pub(crate) struct Realize;

/// How many diagnostics and how many findings a stage tells at most.
const MOST: usize = 20;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// The whole specification as YAML or JSON; or give 'file'.
    #[serde(default)]
    draft: Option<String>,
    /// A file below the server's root folder that holds the specification; or give 'draft'.
    #[serde(default)]
    file: Option<String>,
    /// Common volume above which two parts clash, in mm3.
    #[serde(default = "default_tau")]
    #[schemars(range(min = 0.0, max = 1e6))]
    tau_mm3: f64,
    /// Tell of pairs of parts that do not touch and are nearer to each other than this, in mm; 0 for none.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 1e4))]
    clearance_mm: f64,
    /// Density of all parts in kg/m3; that of steel, 7850, where it is left out.
    #[serde(default)]
    #[schemars(range(min = 1.0, max = 3e4))]
    density_kg_m3: Option<f64>,
    /// Store and export the assembly even where its verification fails.
    #[serde(default)]
    keep_failed: bool,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// Whether the assembly is stored now; false leaves the one of this name as it was.
    realized: bool,
    /// The worst verdict of the stages.
    verdict: Verdict,
    /// The stages in their order; a stage that was not reached has no verdict.
    stages: Vec<Stage>,
    /// How many diagnostics and findings are not shown.
    not_shown: usize,
    /// Whether another assembly of this name was replaced.
    replaced: bool,
    /// The STEP file, below the server's root folder.
    #[serde(skip_serializing_if = "Option::is_none")]
    step_file: Option<String>,
    /// Its SHA-256.
    #[serde(skip_serializing_if = "Option::is_none")]
    step_sha256: Option<String>,
    /// The whole report, below the server's root folder; beside it report.md and report.html for people.
    #[serde(skip_serializing_if = "Option::is_none")]
    report_file: Option<String>,
    /// The assembly now.
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<State>,
}

impl Tool for Realize {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "realize";
    const TITLE: &'static str = "Realize a draft";
    const DESCRIPTION: &'static str = "The main road: turns a whole specification (YAML or JSON) into a \
        verified assembly and its STEP file in one call. Seven stages: validate, resolve_factories, \
        build_parts, check_ports, place, verify, export. All or nothing: when a stage fails, what it \
        found is told and the assembly of this name stays as it was. A valid one replaces it. \
        keep_failed stores it even where verification fails, to go on with the fine-grained tools.";
    const EFFECT: Effect = Effect::Removes;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let text = validate_draft::text(workshop, a.draft, a.file.as_deref())?;
        let terms = Terms {
            tau_mm3: a.tau_mm3,
            clearance_mm: a.clearance_mm,
            density_kg_m3: a.density_kg_m3,
        };
        let done = workshop.realize(&text, &terms, a.keep_failed).await?;
        let mut not_shown = 0;
        let mut stages = done.stages;
        for stage in &mut stages {
            stage.diagnostics.sort_by_key(|d| d.severity);
            not_shown += stage.diagnostics.len().saturating_sub(MOST);
            stage.diagnostics.truncate(MOST);
            not_shown += stage.findings.len().saturating_sub(MOST);
            stage.findings.truncate(MOST);
        }
        let verdict = stages
            .iter()
            .filter_map(|s| s.verdict)
            .fold(Verdict::Pass, Verdict::and);
        let kept = done.kept;
        Ok(Answer {
            realized: kept.is_some(),
            verdict,
            stages,
            not_shown,
            replaced: kept.as_ref().is_some_and(|k| k.replaced),
            step_file: kept.as_ref().map(|k| k.exported.file.clone()),
            step_sha256: kept.as_ref().map(|k| k.exported.sha256.clone()),
            report_file: kept.as_ref().map(|k| report_file(&k.state.assembly)),
            state: kept.map(|k| k.state),
        })
    }
}
