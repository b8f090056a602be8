//! Verification of an assembly on disk, or of a specification that is on its way there.

use assemcad_model::report::Report;
use assemcad_model::spec::Assembly;
use assemcad_placing::partial::no_parts;
use assemcad_placing::place;
use assemcad_verify::{Results, Subject, Terms, verify};

use crate::resolve;
use crate::{Faults, Workshop};

impl Workshop {
    /// Verifies an assembly and leaves the report beside its specification.
    ///
    /// # Errors
    /// When there is no assembly to verify. What is wrong *with* it is in the report.
    pub async fn verify(&self, id: &str, terms: &Terms) -> Result<Report, Faults> {
        let spec = self.store.load(id).map_err(|d| vec![d])?;
        let mut report = self.verify_specification(&spec, terms, None).await?;
        report.step = self.known_step(&report);
        self.write_report(&report).map_err(|d| vec![d])?;
        Ok(report)
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
        let placements = place::assembly(&resolved).map_err(|d| vec![d])?;
        let subject = Subject {
            door: self.door.asker(),
            registry: &self.registry,
            spec,
            resolved: &resolved,
            placements: &placements,
        };
        verify(subject, terms, ports).await.map_err(|d| vec![d])
    }
}
