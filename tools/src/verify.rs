//! `verify`.

use assemcad_assembly::report_files::{report_file, report_html, report_markdown};
use assemcad_assembly::{Faults, Verified, Workshop};
use assemcad_model::report::{
    Axioms, BillLine, Finding, Mass, MateFacts, NearMiss, PairFacts, PartFacts, StepFile, Verdict,
};
use assemcad_verify::{DEFAULT_TAU_MM3, Terms};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool};

pub(crate) struct Verify;

/// How many findings a concise answer holds at most; the report's file holds all.
const MOST_FINDINGS: usize = 10;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
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
    /// How much is told; 'full' adds all findings with their values and axioms, and what was measured of
    /// every part, mate and pair.
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
    /// What is wrong or could not be told, worst first; at most 10, in short, unless detail is 'full'.
    findings: Vec<Finding>,
    /// How many findings there are.
    findings_total: usize,
    /// The checks that were made.
    checks: Vec<Counted>,
    /// What was not checked, and why.
    not_checked: Vec<String>,
    /// What the engineering axioms came to, counted; one by one with detail 'full'.
    axioms: Axioms,
    /// The mass of all parts in kg, where all could be made.
    #[serde(skip_serializing_if = "Option::is_none")]
    mass_kg: Option<f64>,
    /// The whole report, below the server's root folder; absent where it could not be written.
    #[serde(skip_serializing_if = "Option::is_none")]
    report_file: Option<String>,
    /// The report for people to read, as Markdown and as a page for browsers.
    #[serde(skip_serializing_if = "Option::is_none")]
    report_pages: Option<[String; 2]>,
    /// What could not be kept on disk; the answer holds all the same.
    #[serde(skip_serializing_if = "Option::is_none")]
    not_kept: Option<String>,
    /// SHA-256 of the specification that was verified.
    specification_sha256: String,
    /// What was measured; with detail 'full' only.
    #[serde(skip_serializing_if = "Option::is_none")]
    measured: Option<Measured>,
}

/// A kind of check.
#[derive(Debug, Serialize, JsonSchema)]
struct Counted {
    /// Name.
    check: String,
    /// The worst verdict of its cases.
    verdict: Verdict,
    /// How many cases there were.
    cases: usize,
    /// How many findings it made, warnings counted in.
    findings: usize,
    /// How it was checked; with detail 'full' only.
    #[serde(skip_serializing_if = "Option::is_none")]
    how: Option<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct Measured {
    /// The parts.
    parts: Vec<PartFacts>,
    /// The mates.
    mates: Vec<MateFacts>,
    /// The pairs of parts whose boxes meet.
    pairs: Vec<PairFacts>,
    /// The pairs that are nearer to each other than was asked for.
    near_misses: Vec<NearMiss>,
    /// What the assembly weighs.
    mass: Mass,
    /// The parts, equal ones counted together.
    bill_of_materials: Vec<BillLine>,
    /// The STEP file of this very specification, where it was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    step: Option<StepFile>,
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
        what was not checked, in short; the whole report, with masses and bill of materials, is left as \
        JSON, Markdown and HTML. Findings with verdict pass are warnings. Call it before export_step.";
    const EFFECT: Effect = Effect::Adds;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let terms = Terms {
            tau_mm3: a.tau_mm3,
            clearance_mm: a.clearance_mm,
            density_kg_m3: a.density_kg_m3,
        };
        let verified = workshop.verify(&a.assembly, &terms).await?;
        Ok(answer(verified, a.detail == Detail::Full))
    }
}

fn answer(verified: Verified, full: bool) -> Answer {
    let Verified { report, not_kept } = verified;
    let findings_total = report.findings.len();
    let of = |check: &str| report.findings.iter().filter(|f| f.check == check).count();
    let checks = report
        .checks
        .into_iter()
        .map(|c| Counted {
            findings: of(&c.check),
            check: c.check,
            verdict: c.verdict,
            cases: c.cases,
            how: full.then_some(c.how),
        })
        .collect();
    let id = report.assembly.as_str();
    let files = not_kept
        .is_none()
        .then(|| (report_file(id), [report_markdown(id), report_html(id)]));
    let (report_file, report_pages) = files.unzip();
    let (mut findings, mut axioms) = (report.findings, report.axioms);
    if !full {
        axioms.each.clear();
        findings.truncate(MOST_FINDINGS);
        findings.iter_mut().for_each(shorten);
    }
    Answer {
        verdict: report.verdict,
        findings,
        findings_total,
        checks,
        not_checked: report.not_checked,
        axioms,
        mass_kg: report.mass.total_kg,
        report_file,
        report_pages,
        not_kept: not_kept.map(|d| d.to_string()),
        specification_sha256: report.specification_sha256,
        measured: full.then_some(Measured {
            parts: report.parts,
            mates: report.mates,
            pairs: report.pairs,
            near_misses: report.near_misses,
            mass: report.mass,
            bill_of_materials: report.bill_of_materials,
            step: report.step,
        }),
    }
}

/// Leaves what an agent needs to go on: code, message, parts, mates, advice and the next call.
fn shorten(finding: &mut Finding) {
    finding.values.clear();
    finding.axioms.clear();
    finding.diagnostic.found = None;
    finding.diagnostic.expected = None;
}
