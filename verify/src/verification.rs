//! All checks, one after the other, and the report on them.

use assemcad_factories::Registry;
use assemcad_geometry::Asker;
use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Check, FORMAT, Report, Verdict};
use assemcad_model::spec::Assembly;
use assemcad_placing::{Assembled, Placements, Resolved};

use crate::axioms::{self, Measurements};
use crate::bill;
use crate::checks::{
    clearance, connectivity, contact, freedom, holding, interference, mates, parts, port_use, ports,
};
use crate::results::Results;
use crate::terms::{DEFAULT_TAU_MM3, Terms};

/// What is not checked where no clearance is asked for.
const NO_CLEARANCE: &str =
    "clearance: the distances of parts that do not touch (clearance_mm asks for it)";

/// What this version does not check.
const NOT_CHECKED: [&str; 2] = [
    "motion: collisions away from the pose in which the assembly was built (sweep drives one motion)",
    "strength: loads, stresses and life of parts and joints",
];

/// What is verified, and who is asked about it.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Who answers for the solids.
    pub door: Asker<'a>,
    /// The factories, which know the parameters' defaults.
    pub registry: &'a Registry,
    /// What is claimed.
    pub spec: &'a Assembly,
    /// Its parts and mates, resolved: at least one part.
    pub resolved: &'a Resolved,
    /// Where the parts are.
    pub placements: &'a Placements,
}

/// Verifies an assembly. Nothing is written, and no STEP file is named. `ports` is what
/// [`crate::checks::ports::check`] found where that was asked already.
///
/// # Errors
/// When the specification or a recipe has no hash: a fault of the server. What is wrong with the assembly
/// is in the report.
pub async fn verify(
    of: Subject<'_>,
    terms: &Terms,
    ports: Option<Results>,
) -> Result<Report, Diagnostic> {
    let Subject {
        door,
        registry,
        spec,
        resolved,
        placements,
    } = of;
    // A threshold above the server's own reports nothing greener.
    let tau_mm3 = terms.tau_mm3.min(DEFAULT_TAU_MM3);
    let mut results = Results::default();
    let (built, mut parts) = parts::check(door, resolved, placements, &mut results).await;
    for part in elastic_blocks(spec, resolved, &built) {
        let d = Diagnostic::error(
            Code::SpecificationInvalid,
            format!("part '{part}'"),
            "it is stated as elastic and fills most of its box: no ring, clip or seal does",
        )
        .hint("leave elastic out, or make the part as slender as what springs is");
        results.find(Verdict::Fail, "stated", vec![part], d);
    }
    for d in spec.stated_faults() {
        results.find(Verdict::Fail, "stated", Vec::new(), d);
    }
    match ports {
        Some(known) => {
            results.findings.extend(known.findings);
            results.checks.extend(known.checks);
        }
        None => ports::check(door, resolved, &built, &mut results).await,
    }
    let assembled = Assembled {
        resolved,
        placements,
        built: &built,
    };
    let mut mates = mates::check(resolved, placements, &mut results);
    let pairs = interference::check(door, spec, &assembled, tau_mm3, &mut results).await;
    let clearance_mm = (terms.clearance_mm > 0.0).then_some(terms.clearance_mm);
    let near_misses = match clearance_mm {
        Some(mm) => clearance::check(door, &assembled, &pairs, mm, &mut results).await,
        None => Vec::new(),
    };
    let placed = (resolved, placements);
    contact::check(door, placed, &pairs, &mut mates, tau_mm3, &mut results).await;
    connectivity::check(spec, resolved, &mut results);
    // On the heap: one future of all checks would be too large for a thread of the server.
    let moves = Box::pin(holding::check(door, spec, &assembled, &mates, &mut results)).await;
    port_use::check(spec, resolved, &mut results);
    let freedom = freedom::check(spec, resolved, placements, moves.as_ref(), &mut results);
    let measured = Measurements {
        parts: &parts,
        mates: &mates,
        pairs: &pairs,
        tau_mm3,
        freedom: freedom.as_ref(),
        motions: freedom
            .as_ref()
            .and_then(|f| freedom::independent(f, moves.as_ref(), spec)),
    };
    let asked = (door, registry);
    let (axioms, accepted) = axioms::run(asked, spec, &assembled, &measured, &mut results).await;
    let mut not_checked = NOT_CHECKED.map(str::to_owned).to_vec();
    if clearance_mm.is_none() {
        not_checked.push(NO_CLEARANCE.to_owned());
    }
    if terms.tau_mm3 > tau_mm3 {
        not_checked.push(format!(
            "overlaps up to {} mm3: tau_mm3 above {tau_mm3} lets nothing pass",
            terms.tau_mm3
        ));
    }
    not_checked.extend(axioms::not_checked(&axioms));
    let mass = bill::mass(&assembled, terms.density_kg_m3, &mut parts);
    let bill_of_materials = bill::lines(resolved, &parts)?;
    let Results {
        mut findings,
        mut checks,
    } = results;
    if findings.iter().any(|f| f.check == "stated") {
        checks.push(Check {
            check: "stated".to_owned(),
            verdict: Verdict::Fail,
            cases: spec.parts.iter().filter(|p| p.elastic).count()
                + spec.intended_motions.len()
                + spec.free.len()
                + spec.accept.len(),
            how: "what is stated beside parts and mates names parts and rules that there are"
                .to_owned(),
        });
    }
    // Stable: within a verdict, the order of the checks and of the specification.
    findings.sort_by_key(|f| core::cmp::Reverse(f.verdict));
    // Never better than any check or any finding says.
    let checked = checks.iter().map(|c| c.verdict);
    let said = checked.chain(findings.iter().map(|f| f.verdict));
    let verdict = said.fold(Verdict::Pass, Verdict::and);
    Ok(Report {
        format: FORMAT,
        assembly: spec.id.clone(),
        specification_sha256: spec.sha256()?,
        step: None,
        kernel: assemcad_kernel::version(),
        verdict,
        accepted,
        findings,
        checks,
        not_checked,
        axioms,
        root: spec.root().map(str::to_owned),
        tau_mm3,
        parts,
        mates,
        pairs,
        clearance_mm,
        near_misses,
        mass,
        bill_of_materials,
        freedom,
    })
}

/// A part that springs fills no more than this share of its box. Ours.
const SLENDER: f64 = 0.6;

/// The parts that are stated as elastic and are blocks.
fn elastic_blocks(spec: &Assembly, resolved: &Resolved, built: &[Option<Built>]) -> Vec<String> {
    let stated = |id: &str| spec.part(id).is_some_and(|p| p.elastic);
    let block = |b: &Built| {
        let size = b.min.iter().zip(b.max).map(|(lo, hi)| hi - lo);
        b.volume > SLENDER * size.product::<f64>()
    };
    let parts = resolved.parts.iter().zip(built);
    parts
        .filter(|(p, b)| stated(&p.id) && b.as_ref().is_some_and(block))
        .map(|(p, _)| p.id.clone())
        .collect()
}
