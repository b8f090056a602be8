//! Verification of an assembly on disk, or of a specification that is on its way there.

use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::report::Report;
use assemcad_model::spec::Assembly;
use assemcad_placing::partial::no_parts;
use assemcad_placing::place;
use assemcad_verify::{Results, Subject, Terms, verify};

use crate::report_files::report_file;
use crate::reports::Reports;
use crate::resolve;
use crate::{Faults, Workshop};

/// A verification.
#[derive(Debug)]
pub struct Verified {
    /// What was found.
    pub report: Report,
    /// Why the report is not on disk, where it is not.
    pub not_kept: Option<Diagnostic>,
}

/// What an answer says of something that could not be written, where it holds without that.
pub(crate) fn not_kept(d: Diagnostic) -> Diagnostic {
    let message = format!("this could not be kept on disk: {}", d.message);
    Diagnostic {
        severity: Severity::Warning,
        message,
        ..d
    }
}

impl Workshop {
    /// Verifies an assembly and leaves the report beside its specification, where that can be written and is still
    /// the one that was verified.
    ///
    /// # Errors
    /// When there is no assembly to verify. What is wrong *with* it is in the report.
    pub async fn verify(&self, id: &str, terms: &Terms) -> Result<Verified, Faults> {
        let spec = self.store.load(id).map_err(|d| vec![d])?;
        let mut report = self.verify_specification(&spec, terms, None).await?;
        let not_kept = self.keep_report(&mut report).await.err().map(not_kept);
        Ok(Verified { report, not_kept })
    }

    /// Writes a report while nobody else changes the assembly.
    async fn keep_report(&self, report: &mut Report) -> Result<(), Diagnostic> {
        let id = report.assembly.clone();
        let _lock = self.store.lock(&id).await?;
        let now = self.store.load(&id)?.sha256()?;
        report.step = self.known_step(report);
        if now != report.specification_sha256 {
            return Err(Diagnostic::error(
                Code::FileFailed,
                report_file(&id),
                "the assembly was changed while it was verified",
            )
            .hint("verify it again"));
        }
        self.write_report(report)
    }

    /// Verifies a specification, which need not be on disk. Nothing is written. `ports` is what the check
    /// of ports found where that was asked already.
    ///
    /// # Errors
    /// As [`Workshop::verify`].
    pub(crate) async fn verify_specification(
        &self,
        spec: &Assembly,
        terms: &Terms,
        ports: Option<Results>,
    ) -> Result<Report, Faults> {
        let resolved = resolve::assembly(self, spec).await?;
        if resolved.parts.is_empty() {
            return Err(vec![no_parts(&spec.id)]);
        }
        let key = Reports::key(spec, &resolved, terms).map_err(|d| vec![d])?;
        if let Some(known) = self.reports.get(&key) {
            return Ok(known);
        }
        let failed = self.door.counts().failed;
        let placements = place::assembly(&resolved).map_err(|d| vec![d])?;
        let subject = Subject {
            door: self.door.asker(),
            registry: &self.registry,
            spec,
            resolved: &resolved,
            placements: &placements,
        };
        let report = verify(subject, terms, ports).await.map_err(|d| vec![d])?;
        if self.door.counts().failed == failed {
            self.reports.put(key, &report);
        }
        Ok(report)
    }
}
