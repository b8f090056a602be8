//! STEP files of assemblies.

use std::collections::BTreeMap;

use assemcad_factories::failure::diagnostic;
use assemcad_kernel::protocol::{Built, StepFacts, StepLeaf};
use assemcad_model::canonical::sha256;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::{Placement, Rows};
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
use assemcad_store::{export_of, file_of};

/// How far a volume may be from what it was when a STEP file is read back, relative.
const READ_BACK_TOLERANCE: f64 = 1e-6;

/// How far a centre, a corner of a box or a place may be off then, in mm.
const READ_BACK_MM: f64 = 1e-5;

/// How far a number of a rotation may be off then: a hundredth of a micrometre at the end of ten metres.
const READ_BACK_TURN: f64 = 1e-9;

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
    /// Exports an assembly as STEP (AP242) to a file beside its specification, or, where one is named, to a file in
    /// the assembly's own place for exports.
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
            Some(f) if f.ends_with(".step") || f.ends_with(".stp") => {
                export_of(id, f).map_err(one)?
            }
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
        // Held while the report is read and written again: what another wrote meanwhile is not lost.
        let _lock = self.store.lock(id).await.map_err(one)?;
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

    /// What was measured of all parts, and where they are; every part must have a place and be made.
    async fn ready(
        &self,
        id: &str,
        resolved: &Resolved,
        placements: &Placements,
    ) -> Result<Vec<(Built, Placement)>, Faults> {
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
                (Ok(b), Some(at)) => solids.push((b, at)),
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

/// Holds what was read back against what was made: of each product volume, centre, box and inertia in its own frame,
/// and of each part its pose. A part that is turned about its own centre is somewhere else.
fn check_read_back(
    resolved: &Resolved,
    solids: &[(Built, Placement)],
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
    let by_name: BTreeMap<&str, &StepLeaf> = facts
        .instances
        .iter()
        .map(|leaf| (leaf.name.as_str(), leaf))
        .collect();
    for (part, (built, at)) in resolved.parts.iter().zip(solids) {
        let Some(leaf) = by_name.get(part.id.as_str()) else {
            return Err(wrong(format!("no part '{}'", part.id)));
        };
        if let Some(what) = differing(leaf, built, at) {
            return Err(wrong(format!("part '{}' {what}", part.id)));
        }
    }
    Ok(())
}

/// How what was read back of a part is not what was made.
fn differing(leaf: &StepLeaf, built: &Built, at: &Placement) -> Option<String> {
    let off = |a: &[f64], b: &[f64]| -> f64 {
        let each = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        // A number that is none is off.
        each.fold(0.0, |most, d| if d <= most { most } else { d })
    };
    let within = |off: f64, most: f64| off <= most;
    let volume = (leaf.volume - built.volume).abs();
    if !within(volume, READ_BACK_TOLERANCE * built.volume) {
        return Some(format!(
            "has {} mm3 instead of {}",
            leaf.volume, built.volume
        ));
    }
    let centre = off(&leaf.centre, &built.centre);
    let corners = off(&leaf.bounds.0, &built.min).max(off(&leaf.bounds.1, &built.max));
    if !within(centre.max(corners), READ_BACK_MM) {
        return Some(format!(
            "is another solid: its centre is off by {centre} mm, its box by {corners} mm"
        ));
    }
    let (read, made) = (leaf.inertia.as_flattened(), built.inertia.as_flattened());
    let largest = made.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
    if !within(off(read, made), READ_BACK_TOLERANCE * largest) {
        return Some("is another solid: its moments of inertia differ".to_owned());
    }
    let (Rows(read), Rows(made)) = (leaf.placement, (*at).into());
    let axes = |rows: &[[f64; 4]; 3]| rows.map(|[x, y, z, _]| [x, y, z]);
    let place = |rows: &[[f64; 4]; 3]| rows.map(|[.., t]| t);
    let turned = off(axes(&read).as_flattened(), axes(&made).as_flattened());
    let moved = off(&place(&read), &place(&made));
    let placed = within(turned, READ_BACK_TURN) && within(moved, READ_BACK_MM);
    (!placed).then(|| format!("lies {moved} mm from its place, its axes off by {turned}"))
}

#[cfg(test)]
mod tests {
    use super::differing;
    use assemcad_kernel::protocol::{Built, Source, StepLeaf};
    use assemcad_model::frame::Placement;

    /// A cube of 10 mm about the origin of its frame.
    fn cube() -> Built {
        let moment = 1000.0 * 200.0 / 12.0;
        Built {
            recipe: String::new(),
            source: Source::Replayed,
            volume: 1000.0,
            area: 600.0,
            centre: [0.0; 3],
            inertia: [[moment, 0.0, 0.0], [0.0, moment, 0.0], [0.0, 0.0, moment]],
            min: [-5.0; 3],
            max: [5.0; 3],
            brep: String::new(),
            ports: Vec::new(),
        }
    }

    fn read(of: &Built, at: &Placement) -> StepLeaf {
        StepLeaf {
            name: "cube".to_owned(),
            product: "cube".to_owned(),
            volume: of.volume,
            centre: of.centre,
            inertia: of.inertia,
            bounds: (of.min, of.max),
            placement: (*at).into(),
        }
    }

    #[test]
    fn a_part_turned_about_its_own_centre_is_not_what_was_made() {
        let (cube, at) = (cube(), Placement::translation(1.0, 2.0, 3.0));
        assert_eq!(differing(&read(&cube, &at), &cube, &at), None);
        // Volume, centre and box are those of the cube in its place, whichever way it looks.
        let turned = at * Placement::rotation_z(90.0);
        let what = differing(&read(&cube, &turned), &cube, &at).unwrap();
        assert!(what.contains("its axes off by 1"), "{what}");
        let moved = Placement::translation(0.0, 0.0, 2e-5) * at;
        assert!(differing(&read(&cube, &moved), &cube, &at).is_some());
    }

    #[test]
    fn another_solid_of_the_same_volume_is_not_what_was_made() {
        let (cube, at) = (cube(), Placement::IDENTITY);
        let mut other = read(&cube, &at);
        other.bounds.1 = [5.0, 5.0, 5.1];
        assert!(differing(&other, &cube, &at).unwrap().contains("box"));
        let mut other = read(&cube, &at);
        other.inertia[0][0] *= 1.001;
        assert!(differing(&other, &cube, &at).unwrap().contains("inertia"));
        let mut other = read(&cube, &at);
        other.volume = f64::NAN;
        assert!(differing(&other, &cube, &at).is_some());
    }
}
