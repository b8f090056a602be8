//! From a draft to a verified assembly in one step: seven stages, and either all of it or nothing.

use std::time::Instant;

use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::report::{Finding, Report, Verdict};
use assemcad_model::spec::Assembly;
use assemcad_placing::solids::build_all;
use assemcad_placing::{Resolved, place};
use assemcad_verify::checks::ports::check;
use assemcad_verify::{Results, Terms};
use schemars::JsonSchema;
use serde::Serialize;

use crate::export::{Exported, Step};
use crate::resolve;
use crate::state::State;
use crate::{Faults, Workshop, report_files};
use assemcad_store::{file_of, specification, yaml_bytes};

/// The stages, in order.
pub const STAGES: [&str; 7] = [
    "validate",
    "resolve_factories",
    "build_parts",
    "check_ports",
    "place",
    "verify",
    "export",
];

/// One stage of a realisation.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Stage {
    /// Its name.
    pub stage: &'static str,
    /// What it came to; absent where an earlier stage stopped the realisation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub verdict: Option<Verdict>,
    /// How long it took, in milliseconds. Told here and stored nowhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub elapsed_ms: Option<u64>,
    /// What it did, in a few words.
    pub summary: String,
    /// What it found.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub diagnostics: Vec<Diagnostic>,
    /// What the checks of ports and of the whole found.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub findings: Vec<Finding>,
}

/// A realisation.
#[derive(Debug)]
pub struct Realized {
    /// Name of the draft, where it has one.
    pub id: Option<String>,
    /// The seven stages.
    pub stages: Vec<Stage>,
    /// What is on disk now; none where everything was left as it was.
    pub kept: Option<Stored>,
}

/// What a realisation left on disk.
#[derive(Debug)]
pub struct Stored {
    /// The assembly now.
    pub state: State,
    /// Its STEP file.
    pub exported: Exported,
    /// Whether another assembly of this name was there before.
    pub replaced: bool,
}

/// Stages as they come in, and the time at which the present one began.
struct Progress {
    stages: Vec<Stage>,
    began: Instant,
}

impl Progress {
    fn end(&mut self, verdict: Verdict, summary: String, diagnostics: Vec<Diagnostic>) {
        let stage = STAGES.get(self.stages.len()).copied().unwrap_or_default();
        let ms = self.began.elapsed().as_millis();
        self.stages.push(Stage {
            stage,
            verdict: Some(verdict),
            elapsed_ms: Some(u64::try_from(ms).unwrap_or(u64::MAX)),
            summary,
            diagnostics,
            findings: Vec::new(),
        });
        self.began = Instant::now();
    }

    /// The stages, those that were not reached marked so.
    fn all(mut self) -> Vec<Stage> {
        for stage in STAGES.iter().skip(self.stages.len()) {
            self.stages.push(Stage {
                stage,
                verdict: None,
                elapsed_ms: None,
                summary: "not run".to_owned(),
                diagnostics: Vec::new(),
                findings: Vec::new(),
            });
        }
        self.stages
    }
}

/// A stage stopped the realisation; its record is made.
struct Stopped;

impl Workshop {
    /// Realises a draft: validates, resolves, builds, checks, places, verifies and exports it. The
    /// assembly of its name is replaced when every stage went through, and is as it was otherwise.
    ///
    /// # Errors
    /// When the draft's rounds are used up, or the result cannot be written. What is wrong with the
    /// draft is in its stages.
    pub async fn realize(
        &self,
        text: &str,
        terms: &Terms,
        keep_failed: bool,
    ) -> Result<Realized, Faults> {
        let mut progress = Progress {
            stages: Vec::new(),
            began: Instant::now(),
        };
        let checked = self.validate_draft(text).await?;
        let id = checked.id;
        let Some(spec) = checked.assembly else {
            let errors = |d: &&Diagnostic| d.severity == Severity::Error;
            if checked.diagnostics.iter().filter(errors).all(of_kernel) {
                // The draft is in order and every part has a recipe: it is the solids that fail.
                progress.end(Verdict::Pass, "the form is in order".to_owned(), Vec::new());
                progress.end(
                    Verdict::Pass,
                    "every part has a recipe".to_owned(),
                    Vec::new(),
                );
                let verdict = verdict_of(&checked.diagnostics);
                progress.end(verdict, String::new(), checked.diagnostics);
                return Ok(Realized {
                    id,
                    stages: progress.all(),
                    kept: None,
                });
            }
            let summary = format!("round {} of {}", checked.round, self.draft_rounds);
            progress.end(Verdict::Fail, summary, checked.diagnostics);
            return Ok(Realized {
                id,
                stages: progress.all(),
                kept: None,
            });
        };
        let summary = format!("{} parts, {} mates", spec.parts.len(), spec.mates.len());
        progress.end(Verdict::Pass, summary, checked.diagnostics);
        let kept = match self.stages(&spec, terms, keep_failed, &mut progress).await {
            Ok((resolved, report, step)) => Some(self.keep(&spec, &resolved, report, step).await?),
            Err(Stopped) => None,
        };
        Ok(Realized {
            id,
            stages: progress.all(),
            kept,
        })
    }

    async fn stages(
        &self,
        spec: &Assembly,
        terms: &Terms,
        keep_failed: bool,
        progress: &mut Progress,
    ) -> Result<(Resolved, Report, Step), Stopped> {
        let stop = |progress: &mut Progress, verdict, faults: Faults| {
            progress.end(verdict, String::new(), faults);
            Stopped
        };
        let resolved = match resolve::assembly(self, spec).await {
            Ok(resolved) => resolved,
            Err(faults) => {
                // What the kernel could not make had a recipe: that is the next stage's failure.
                if faults.iter().all(of_kernel) {
                    progress.end(
                        Verdict::Pass,
                        "every part has a recipe".to_owned(),
                        Vec::new(),
                    );
                }
                return Err(stop(progress, verdict_of(&faults), faults));
            }
        };
        progress.end(Verdict::Pass, recipes(&resolved), Vec::new());

        let mut built: Vec<Option<Built>> = Vec::new();
        let mut faults = Vec::new();
        for result in build_all(self.door.asker(), &resolved).await {
            match result {
                Ok(b) => built.push(Some(b)),
                Err(d) => faults.push(d),
            }
        }
        if !faults.is_empty() {
            return Err(stop(progress, verdict_of(&faults), faults));
        }
        let summary = format!("{} valid solids", built.len());
        progress.end(Verdict::Pass, summary, Vec::new());

        let ports = self.port_stage(&resolved, &built, progress).await;
        let failed = progress.stages.last().and_then(|s| s.verdict) == Some(Verdict::Fail);
        if failed && !keep_failed {
            return Err(Stopped);
        }

        let placements =
            place::assembly(&resolved).map_err(|d| stop(progress, Verdict::Fail, vec![d]))?;
        let n = placements.parts.iter().flatten().count();
        progress.end(Verdict::Pass, format!("{n} parts placed"), Vec::new());

        let report = match self.verify_specification(spec, terms, Some(ports)).await {
            Ok(report) => report,
            Err(faults) => return Err(stop(progress, verdict_of(&faults), faults)),
        };
        let summary = format!(
            "{} checks, {} findings",
            report.checks.len(),
            report.findings.len()
        );
        progress.end(report.verdict, summary, Vec::new());
        if let Some(stage) = progress.stages.last_mut() {
            stage.findings.clone_from(&report.findings);
        }
        if report.verdict == Verdict::Fail && !keep_failed {
            return Err(Stopped);
        }

        let step = match self.step(spec).await {
            Ok(step) => step,
            Err(faults) => return Err(stop(progress, verdict_of(&faults), faults)),
        };
        let summary = format!("{} parts, {} bytes", step.instances, step.bytes.len());
        progress.end(Verdict::Pass, summary, Vec::new());
        Ok((resolved, report, step))
    }

    /// Whether every solid has at each port what the port's type promises. What was found goes on to
    /// the verification, which has the same to say of ports.
    async fn port_stage(
        &self,
        resolved: &Resolved,
        built: &[Option<Built>],
        progress: &mut Progress,
    ) -> Results {
        let mut ports = Results::default();
        check(self.door.asker(), resolved, built, &mut ports).await;
        let cases: usize = ports.checks.iter().map(|c| c.cases).sum();
        let verdicts = ports.checks.iter().map(|c| c.verdict);
        // A check that did not take place has passed nothing.
        let verdict = verdicts.reduce(Verdict::and);
        progress.end(
            verdict.unwrap_or(Verdict::Indeterminate),
            format!("{cases} ports, {} findings", ports.findings.len()),
            Vec::new(),
        );
        if let Some(stage) = progress.stages.last_mut() {
            stage.findings.clone_from(&ports.findings);
        }
        ports
    }

    /// Puts specification, reports and STEP file on disk as one step.
    async fn keep(
        &self,
        spec: &Assembly,
        resolved: &Resolved,
        mut report: Report,
        step: Step,
    ) -> Result<Stored, Faults> {
        let one = |d: Diagnostic| vec![d];
        let id = spec.id.as_str();
        let mut state = State::of(spec, resolved).map_err(one)?;
        let step_file = file_of(id, &format!("{id}.step"));
        report.step = Some(step.file(&step_file));
        let yaml = yaml_bytes(spec).map_err(one)?;
        let reports = report_files::files(&report).map_err(one)?;
        self.store.make_folder(id).map_err(one)?;
        let _lock = self.store.lock(id).await.map_err(one)?;
        let replaced = self.store.exists(id) && self.store.load(id).ok().as_ref() != Some(spec);
        state.warnings = self.store.lost_by_writing(id);
        // The specification last: until it is there, the assembly is the one that it was.
        let specification = specification(id);
        let mut files: Vec<(&str, &[u8])> = vec![(&step_file, &step.bytes)];
        files.extend(reports.iter().map(|(p, b)| (p.as_str(), b.as_slice())));
        files.push((&specification, &yaml));
        self.store.write_all(&files).map_err(one)?;
        Ok(Stored {
            state,
            exported: step.exported(step_file, Some(report.verdict)),
            replaced,
        })
    }
}

fn recipes(resolved: &Resolved) -> String {
    let mut factories: Vec<&str> = resolved.parts.iter().map(|p| p.factory.as_str()).collect();
    factories.sort_unstable();
    factories.dedup();
    format!("{} factories: {}", factories.len(), factories.join(", "))
}

/// Whether the kernel or its worker said this, and not the specification's own check.
fn of_kernel(d: &Diagnostic) -> bool {
    matches!(
        d.code,
        Code::KernelFailed
            | Code::WorkerCrashed
            | Code::WorkerTimeout
            | Code::WorkerCpuLimit
            | Code::WorkerMemoryLimit
            | Code::WorkerFailed
    )
}

/// A refused geometry is wrong; a worker that was lost leaves the question open.
fn verdict_of(faults: &[Diagnostic]) -> Verdict {
    let lost = |d: &Diagnostic| {
        matches!(
            d.code,
            Code::WorkerCrashed
                | Code::WorkerTimeout
                | Code::WorkerCpuLimit
                | Code::WorkerMemoryLimit
                | Code::WorkerFailed
                | Code::Indeterminate
        )
    };
    let errors = |d: &&Diagnostic| d.severity == Severity::Error;
    if faults.iter().filter(errors).all(lost) {
        Verdict::Indeterminate
    } else {
        Verdict::Fail
    }
}
