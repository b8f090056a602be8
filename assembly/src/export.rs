//! STEP files of assemblies.

use assemcad_factories::failure::diagnostic;
use assemcad_kernel::protocol::StepFacts;
use assemcad_model::canonical::sha256;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Report, StepFile, Verdict};
use assemcad_model::spec::Assembly;
use assemcad_placing::partial::no_parts;
use assemcad_placing::products::products;
use assemcad_placing::solids::build_all;
use assemcad_placing::{Placements, Resolved, ResolvedPart, place};

use crate::report_files::{self, report_file};
use crate::resolve;
use crate::step_header::of_specification;
use crate::{Faults, Workshop};
use assemcad_store::file_of;

/// How far a volume may be from what it was when a STEP file is read back, relative.
const READ_BACK_TOLERANCE: f64 = 1e-6;

/// How far a centre of mass may be from its place then, in mm.
const READ_BACK_MM: f64 = 1e-5;

/// An exported file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exported {
    /// Its path below the root.
    pub file: String,
    /// Its length.
    pub bytes: usize,
    /// Its SHA-256.
    pub sha256: String,
    /// SHA-256 of the specification, as in the file's header.
    pub specification_sha256: String,
    /// How many distinct solids it holds.
    pub products: usize,
    /// How many parts it holds.
    pub instances: usize,
    /// The verdict of the report on this very specification; none where there is no such report.
    pub verdict: Option<Verdict>,
}

/// A STEP file that is not written yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// The file.
    pub bytes: Vec<u8>,
    /// SHA-256 of the specification, as in the file's header.
    pub specification_sha256: String,
    /// How many distinct solids it holds.
    pub products: usize,
    /// How many parts it holds.
    pub instances: usize,
}

impl Step {
    /// The file, as a report names it.
    #[must_use]
    pub fn file(&self, file: &str) -> StepFile {
        StepFile {
            file: file.to_owned(),
            bytes: self.bytes.len(),
            sha256: sha256(&self.bytes),
        }
    }

    /// What there is to say of it once it is a file.
    #[must_use]
    pub fn exported(self, file: String, verdict: Option<Verdict>) -> Exported {
        Exported {
            file,
            bytes: self.bytes.len(),
            sha256: sha256(&self.bytes),
            specification_sha256: self.specification_sha256,
            products: self.products,
            instances: self.instances,
            verdict,
        }
    }
}

impl Workshop {
    /// Exports an assembly as STEP (AP242) to a file below the root.
    ///
    /// The file is read back before it is written: names, count and volumes must be what they are in
    /// the assembly.
    ///
    /// # Errors
    /// When parts have no place or cannot be made, or the file cannot be written.
    pub async fn export_step(&self, id: &str, file: Option<&str>) -> Result<Exported, Faults> {
        let one = |d: Diagnostic| vec![d];
        let file = match file {
            None => file_of(id, &format!("{id}.step")),
            Some(f) if f.ends_with(".step") || f.ends_with(".stp") => f.to_owned(),
            Some(f) => {
                return Err(one(Diagnostic::error(
                    Code::PathInvalid,
                    "file",
                    "the name of a STEP file ends in .step or .stp",
                )
                .found(f)));
            }
        };
        let spec = self.store.load(id).map_err(one)?;
        let step = self.step(&spec).await?;
        let report: Option<Report> = self.store.read_json(&report_file(id));
        let report = report.filter(|r| r.specification_sha256 == step.specification_sha256);
        let verdict = report.as_ref().map(|r| r.verdict);
        let mut files = vec![(file.clone(), step.bytes.clone())];
        if let Some(report) = report {
            // From now on the report names the file, as the file names the specification.
            let report = Report {
                step: Some(step.file(&file)),
                ..report
            };
            files.extend(report_files::files(&report).map_err(one)?);
        }
        let all: Vec<(&str, &[u8])> = files
            .iter()
            .map(|(p, b)| (p.as_str(), b.as_slice()))
            .collect();
        self.store.write_all(&all).map_err(one)?;
        Ok(step.exported(file, verdict))
    }

    /// The STEP file of a specification, which need not be on disk. Nothing is written.
    ///
    /// # Errors
    /// When parts have no place or cannot be made, or the file does not read back as what it is.
    pub async fn step(&self, spec: &Assembly) -> Result<Step, Faults> {
        let one = |d: Diagnostic| vec![d];
        let id = spec.id.as_str();
        let resolved = resolve::assembly(self, spec).await?;
        let placements = place::assembly(&resolved).map_err(one)?;
        let measured = self.ready(id, &resolved, &placements).await?;
        let specification_sha256 = spec.sha256().map_err(one)?;
        let (solids, instances) = products(&resolved, &placements);
        let mut description = vec![
            "assemcad assembly".to_owned(),
            of_specification(&specification_sha256),
        ];
        for solid in &solids {
            let hash = solid.recipe.hash();
            description.push(format!("recipe sha256 {hash} of {}", solid.name));
        }
        let (products, parts) = (solids.len(), instances.len());
        let step = self
            .door
            .asker()
            .step(id, description, solids, instances)
            .await;
        let (facts, bytes) = step.map_err(|f| one(diagnostic(&f, "export_step")))?;
        check_read_back(&resolved, &measured, &facts).map_err(one)?;
        Ok(Step {
            bytes,
            specification_sha256,
            products,
            instances: parts,
        })
    }

    /// Volume and centre in the world of all parts; every part must have a place and be made.
    async fn ready(
        &self,
        id: &str,
        resolved: &Resolved,
        placements: &Placements,
    ) -> Result<Vec<(f64, [f64; 3])>, Faults> {
        if resolved.parts.is_empty() {
            return Err(vec![no_parts(id)]);
        }
        let lost = |(i, p): (usize, &ResolvedPart)| {
            placements.of(i).is_none().then(|| {
                Diagnostic::error(
                    Code::Unconnected,
                    format!("part '{}'", p.id),
                    format!("'{}' has no place: no mate joins it to the root", p.id),
                )
                .hint("join it with the mate tool, or take it away with the remove tool")
            })
        };
        let mut faults: Faults = resolved.parts.iter().enumerate().filter_map(lost).collect();
        let mut solids = Vec::new();
        let built = build_all(self.door.asker(), resolved).await;
        for (i, built) in built.into_iter().enumerate() {
            match (built, placements.of(i)) {
                (Ok(b), Some(at)) => solids.push((b.volume, at.point(b.centre))),
                (Ok(_), None) => {}
                (Err(d), _) => faults.push(d),
            }
        }
        if faults.is_empty() {
            Ok(solids)
        } else {
            Err(faults)
        }
    }
}

fn check_read_back(
    resolved: &Resolved,
    solids: &[(f64, [f64; 3])],
    facts: &StepFacts,
) -> Result<(), Diagnostic> {
    let wrong = |what: String| {
        Diagnostic::error(
            Code::KernelFailed,
            "export_step",
            format!(
                "the STEP file does not hold what the assembly is: {what}; nothing was written"
            ),
        )
    };
    if facts.instances.len() != resolved.parts.len() {
        return Err(wrong(format!(
            "{} parts instead of {}",
            facts.instances.len(),
            resolved.parts.len()
        )));
    }
    for (part, (volume, centre)) in resolved.parts.iter().zip(solids) {
        let Some(leaf) = facts.instances.iter().find(|leaf| leaf.name == part.id) else {
            return Err(wrong(format!("no part '{}'", part.id)));
        };
        let near = (leaf.volume - volume).abs() <= READ_BACK_TOLERANCE * volume;
        if !near {
            let read = leaf.volume;
            return Err(wrong(format!(
                "part '{}' has {read} mm3 instead of {volume}",
                part.id
            )));
        }
        let off = leaf
            .centre
            .iter()
            .zip(centre)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        let near = off <= READ_BACK_MM;
        if !near {
            return Err(wrong(format!(
                "part '{}' lies {off} mm from its place",
                part.id
            )));
        }
    }
    Ok(())
}
