//! `verify`.

use assemcad_assembly::verify::{DEFAULT_TAU_MM3, report_file};
use assemcad_assembly::{Faults, Workshop};
use assemcad_model::report::{Axioms, Check, Finding, MateFacts, PairFacts, PartFacts, Verdict};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool};

pub(crate) struct Verify;

/// How many findings an answer holds at most; the report's file holds all.
const MOST_FINDINGS: usize = 20;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// Common volume above which two parts clash, in mm3.
    #[serde(default = "default_tau")]
    #[schemars(range(min = 0.0, max = 1e6))]
    tau_mm3: f64,
    /// How much is told; 'full' adds what was measured of every part, mate and pair.
    #[serde(default)]
    detail: Detail,
}

pub(crate) fn default_tau() -> f64 {
    DEFAULT_TAU_MM3
}

/// How much is told.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Detail {
    #[default]
    Concise,
    Full,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The worst verdict of all checks.
    verdict: Verdict,
    /// What is wrong or could not be told, worst first.
    findings: Vec<Finding>,
    /// How many findings there are.
    findings_total: usize,
    /// The checks that were made.
    checks: Vec<Check>,
    /// What was not checked, and why.
    not_checked: Vec<String>,
    /// What the engineering axioms came to, counted; one by one with detail 'full'.
    axioms: Axioms,
    /// The whole report, below the server's root folder.
    report_file: String,
    /// SHA-256 of the specification that was verified.
    specification_sha256: String,
    /// What was measured; with detail 'full' only.
    #[serde(skip_serializing_if = "Option::is_none")]
    measured: Option<Measured>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct Measured {
    /// The parts.
    parts: Vec<PartFacts>,
    /// The mates.
    mates: Vec<MateFacts>,
    /// The pairs of parts whose boxes meet.
    pairs: Vec<PairFacts>,
}

impl Tool for Verify {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "verify";
    const TITLE: &'static str = "Verify an assembly";
    const DESCRIPTION: &'static str = "Checks an assembly: every part one valid solid that shows \
        its ports, every mate holding and touching where it promises contact, no two parts \
        overlapping by more than their mates mean and tau, every part joined to the root, and the \
        engineering axioms (find_axioms). Answers pass, fail or indeterminate with what was found and \
        what was not checked, and leaves the whole report as a file. Findings with verdict pass are \
        warnings. Call it before export_step. 'full' is long.";
    const EFFECT: Effect = Effect::Adds;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let report = workshop.verify(&a.assembly, a.tau_mm3).await?;
        let findings_total = report.findings.len();
        let mut axioms = report.axioms;
        if a.detail == Detail::Concise {
            axioms.each.clear();
        }
        let measured = (a.detail == Detail::Full).then_some(Measured {
            parts: report.parts,
            mates: report.mates,
            pairs: report.pairs,
        });
        Ok(Answer {
            verdict: report.verdict,
            findings: report.findings.into_iter().take(MOST_FINDINGS).collect(),
            findings_total,
            checks: report.checks,
            not_checked: report.not_checked,
            axioms,
            report_file: report_file(&a.assembly),
            specification_sha256: report.specification_sha256,
            measured,
        })
    }
}
