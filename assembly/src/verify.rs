//! Verification: what the placed parts are, measured, and what that says.
//!
//! Every check fails closed: pass, fail, or indeterminate with the reason. What was not checked is said.

use std::collections::BTreeSet;

use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{
    Check, FORMAT, Finding, MateFacts, PartFacts, Report, Verdict, rounded,
};
use assemcad_model::spec::Assembly;
use futures::future::join_all;
use petgraph::graph::{NodeIndex, UnGraph};
use petgraph::visit::Bfs;
use serde_json::{Map, Value, json};

use crate::axioms::{self, Measurements};
use crate::build::{box_of, reported};
use crate::freedom_check::check_freedom;
use crate::place::{self, Placed};
use crate::resolve::{self, Resolved};
use crate::state::hash;
use crate::{Faults, Workshop, bill, port_use};

/// Common volume above which two parts clash where the caller states none, in mm3.
pub const DEFAULT_TAU_MM3: f64 = 0.001;

/// What a caller of a verification may choose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terms {
    /// Common volume above which two parts clash, in mm3.
    pub tau_mm3: f64,
    /// Distance below which parts that do not touch are told of, in mm; 0 asks for none.
    pub clearance_mm: f64,
    /// Density of all parts in kg/m3; [`crate::measure::DEFAULT_DENSITY`] where it is not stated.
    pub density_kg_m3: Option<f64>,
}

impl Default for Terms {
    fn default() -> Self {
        Self {
            tau_mm3: DEFAULT_TAU_MM3,
            clearance_mm: 0.0,
            density_kg_m3: None,
        }
    }
}

/// What is not checked where no clearance is asked for.
const NO_CLEARANCE: &str =
    "clearance: the distances of parts that do not touch (clearance_mm asks for it)";

/// What this version does not check.
const NOT_CHECKED: [&str; 2] = [
    "motion: collisions away from the pose in which the assembly was built (sweep drives one motion)",
    "strength: loads, stresses and life of parts and joints",
];

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

    /// Verifies a specification, which need not be on disk. Nothing is written. `ports` is what
    /// [`Workshop::check_ports`] found where that was asked already.
    ///
    /// # Errors
    /// As [`Workshop::verify`].
    pub(crate) async fn verify_specification(
        &self,
        spec: &Assembly,
        terms: &Terms,
        ports: Option<Run>,
    ) -> Result<Report, Faults> {
        let id = spec.id.as_str();
        let resolved = resolve::assembly(self, spec).await?;
        if resolved.parts.is_empty() {
            return Err(vec![
                Diagnostic::error(
                    Code::AssemblyEmpty,
                    "assembly",
                    format!("'{id}' has no parts"),
                )
                .next("list_factories", json!({})),
            ]);
        }
        let placed = place::assembly(&resolved).map_err(|d| vec![d])?;
        let tau_mm3 = terms.tau_mm3;
        let mut run = Run::default();
        let (built, mut parts) = self.check_parts(&resolved, &placed, &mut run).await;
        match ports {
            Some(known) => {
                run.findings.extend(known.findings);
                run.checks.extend(known.checks);
            }
            None => self.check_ports(&resolved, &built, &mut run).await,
        }
        let mut mates = check_mates(&resolved, &placed, &mut run);
        let pairs = self
            .check_pairs(spec, (&resolved, &placed), &built, tau_mm3, &mut run)
            .await;
        let clearance_mm = (terms.clearance_mm > 0.0).then_some(terms.clearance_mm);
        let near_misses = match clearance_mm {
            Some(mm) => {
                self.check_clearance(&resolved, &placed, &built, &pairs, mm, &mut run)
                    .await
            }
            None => Vec::new(),
        };
        self.check_contact(&resolved, &placed, &pairs, &mut mates, tau_mm3, &mut run)
            .await;
        check_connectivity(spec, &resolved, &mut run);
        port_use::check(spec, &resolved, &mut run);
        let freedom = check_freedom(spec, &resolved, &placed, &mut run);
        let measured = Measurements {
            built: &built,
            parts: &parts,
            mates: &mates,
            pairs: &pairs,
            tau_mm3,
            freedom: freedom.as_ref(),
        };
        let axioms = axioms::run(self, spec, &resolved, &placed, &measured, &mut run).await;
        let mut not_checked = NOT_CHECKED.map(str::to_owned).to_vec();
        if clearance_mm.is_none() {
            not_checked.push(NO_CLEARANCE.to_owned());
        }
        not_checked.extend(axioms::not_checked(&axioms));
        let mass = bill::mass(&placed, &built, terms.density_kg_m3, &mut parts);
        let bill_of_materials = bill::lines(&resolved, &parts).map_err(|d| vec![d])?;
        // Stable: within a verdict, the order of the checks and of the specification.
        run.findings.sort_by_key(|f| core::cmp::Reverse(f.verdict));
        let verdict = run
            .checks
            .iter()
            .fold(Verdict::Pass, |v, c| v.and(c.verdict));
        Ok(Report {
            format: FORMAT,
            assembly: id.to_owned(),
            specification_sha256: hash(spec).map_err(|d| vec![d])?,
            step: None,
            kernel: assemcad_kernel::version(),
            verdict,
            findings: run.findings,
            checks: run.checks,
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

    async fn check_parts(
        &self,
        resolved: &Resolved,
        placed: &Placed,
        run: &mut Run,
    ) -> (Vec<Option<Built>>, Vec<PartFacts>) {
        let results = join_all(resolved.parts.iter().map(|p| self.build(p))).await;
        let mut built = Vec::new();
        let mut facts = Vec::new();
        let mut verdict = Verdict::Pass;
        for (i, (part, result)) in resolved.parts.iter().zip(results).enumerate() {
            let placement = placed.of(i);
            let mut fact = PartFacts {
                part: part.id.clone(),
                factory: part.factory.clone(),
                recipe_sha256: None,
                verdict: Verdict::Pass,
                volume_mm3: None,
                mass_kg: None,
                centre_mm: None,
                box_mm: None,
                placement: placement.map(Into::into),
            };
            match result {
                Ok(b) => {
                    fact.recipe_sha256 = Some(b.recipe.clone());
                    fact.volume_mm3 = Some(rounded(b.volume));
                    fact.centre_mm = placement.map(|p| p.point(b.centre).map(rounded));
                    fact.box_mm = placement.map(|p| reported(&box_of(&b, &p)));
                    built.push(Some(b));
                }
                Err(d) => {
                    // A refused geometry is wrong; a worker that was lost leaves the question open.
                    fact.verdict = match d.code {
                        Code::KernelFailed => Verdict::Fail,
                        _ => Verdict::Indeterminate,
                    };
                    run.find(fact.verdict, "parts", vec![part.id.clone()], d);
                    built.push(None);
                }
            }
            verdict = verdict.and(fact.verdict);
            facts.push(fact);
        }
        run.check(
            "parts",
            verdict,
            facts.len(),
            "each part replayed to one valid closed solid of positive volume",
        );
        (built, facts)
    }
}

/// Findings and checks as they come in.
#[derive(Debug, Default)]
pub(crate) struct Run {
    pub(crate) findings: Vec<Finding>,
    pub(crate) checks: Vec<Check>,
}

impl Run {
    pub(crate) fn find(
        &mut self,
        verdict: Verdict,
        check: &str,
        parts: Vec<String>,
        diagnostic: Diagnostic,
    ) {
        self.findings.push(Finding {
            verdict,
            check: check.to_owned(),
            parts,
            mates: Vec::new(),
            values: Map::new(),
            axioms: Vec::new(),
            diagnostic,
        });
    }

    pub(crate) fn check(&mut self, check: &str, verdict: Verdict, cases: usize, how: &str) {
        self.checks.push(Check {
            check: check.to_owned(),
            verdict,
            cases,
            how: how.to_owned(),
        });
    }
}

fn check_mates(resolved: &Resolved, placed: &Placed, run: &mut Run) -> Vec<MateFacts> {
    let mut verdict = Verdict::Pass;
    let mut facts = Vec::new();
    for m in &resolved.mates {
        let (residual, held) = match placed.residual(m) {
            Ok(Some(r)) => (
                Some(r),
                if r.holds() {
                    Verdict::Pass
                } else {
                    Verdict::Fail
                },
            ),
            Ok(None) | Err(_) => (None, Verdict::Indeterminate),
        };
        let parts = vec![m.mate.base.part.clone(), m.mate.incoming.part.clone()];
        let place = format!("mate '{}'", m.mate.id);
        let (d, values) = match residual {
            Some(r) => (
                Diagnostic::error(
                    Code::MateResidual,
                    place,
                    format!(
                        "'{}' and '{}' are {} mm and {} degrees from where the mate has them",
                        m.mate.base,
                        m.mate.incoming,
                        rounded(r.distance_mm),
                        rounded(r.angle_deg)
                    ),
                )
                .hint("change the options of the mates that placed these parts"),
                json!({"distance_mm": rounded(r.distance_mm), "angle_deg": rounded(r.angle_deg)}),
            ),
            None => (
                Diagnostic::error(
                    Code::Indeterminate,
                    place,
                    "it cannot be checked: its parts have no place yet",
                )
                .hint("join one of its parts to a part that has a place"),
                Value::Null,
            ),
        };
        if held != Verdict::Pass {
            run.findings.push(Finding {
                verdict: held,
                check: "mates".to_owned(),
                parts,
                mates: vec![m.mate.id.clone()],
                values: values.as_object().cloned().unwrap_or_default(),
                axioms: Vec::new(),
                diagnostic: d,
            });
        }
        verdict = verdict.and(held);
        facts.push(MateFacts {
            mate: m.mate.id.clone(),
            mate_type: m.mate.mate_type,
            base: m.mate.base.to_string(),
            incoming: m.mate.incoming.to_string(),
            axioms: m.mate.axioms.clone(),
            verdict: held,
            contact: None,
            contact_area_mm2: None,
            radial_play_mm: m.mate.mate_type.kind().radial_play(&m.joint()).map(rounded),
            residual: residual.map(|r| assemcad_model::mates::Residual {
                distance_mm: rounded(r.distance_mm),
                angle_deg: rounded(r.angle_deg),
            }),
        });
    }
    run.check(
        "mates",
        verdict,
        facts.len(),
        "residual of every mate in the directions that it constrains",
    );
    facts
}

/// Parts that no chain of mates joins to the root, one finding for each island.
fn check_connectivity(spec: &Assembly, resolved: &Resolved, run: &mut Run) {
    let mut graph = UnGraph::<(), ()>::new_undirected();
    let nodes: Vec<NodeIndex> = resolved.parts.iter().map(|_| graph.add_node(())).collect();
    for m in &resolved.mates {
        if let (Some(a), Some(b)) = (nodes.get(m.base), nodes.get(m.incoming)) {
            graph.add_edge(*a, *b, ());
        }
    }
    let mut seen = vec![false; nodes.len()];
    let mut reach = |from: usize| -> Vec<usize> {
        let mut island = Vec::new();
        if let Some(start) = nodes.get(from) {
            let mut walk = Bfs::new(&graph, *start);
            while let Some(node) = walk.next(&graph) {
                if let Some(s) = seen.get_mut(node.index()) {
                    *s = true;
                }
                island.push(node.index());
            }
        }
        island.sort_unstable();
        island
    };
    let mut islands = Vec::new();
    let mut joined: BTreeSet<usize> = resolved
        .root
        .map(&mut reach)
        .into_iter()
        .flatten()
        .collect();
    for i in 0..nodes.len() {
        if !joined.contains(&i) {
            let island = reach(i);
            joined.extend(&island);
            islands.push(island);
        }
    }
    let verdict = if islands.is_empty() {
        Verdict::Pass
    } else {
        Verdict::Fail
    };
    let root = spec.root().unwrap_or_default();
    for island in islands {
        let names: Vec<String> = island
            .iter()
            .filter_map(|i| resolved.parts.get(*i))
            .map(|p| p.id.clone())
            .collect();
        let listed = names
            .iter()
            .map(|n| format!("'{n}'"))
            .collect::<Vec<_>>()
            .join(", ");
        let d = Diagnostic::error(
            Code::Unconnected,
            format!("part {listed}"),
            format!("no mate joins {listed} to the root '{root}'"),
        )
        .hint("join it with the mate tool, or take it away with the remove tool");
        run.find(Verdict::Fail, "connectivity", names, d);
    }
    run.check(
        "connectivity",
        verdict,
        nodes.len(),
        "every part reached from the root over mates",
    );
}
