//! Verification: what the placed parts are, measured, and what that says.
//!
//! Every check fails closed: pass, fail, or indeterminate with the reason. What was not checked is said.

use assemcad_kernel::protocol::{Built, CommonVolume, Job, Placed as PlacedSolid, Reply};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{
    Check, FORMAT, Finding, MateFacts, PairFacts, PartFacts, Report, Verdict, rounded,
};
use assemcad_model::spec::Assembly;
use futures::future::join_all;
use petgraph::graph::{NodeIndex, UnGraph};
use petgraph::visit::Bfs;
use serde_json::{Map, Value, json};

use crate::build::{diagnostic, unexpected};
use crate::place::{self, Placed};
use crate::resolve::{self, Resolved};
use crate::state::hash;
use crate::store::file_of;
use crate::{Faults, Workshop};

/// Common volume above which two parts clash where the caller states none, in mm3.
pub const DEFAULT_TAU_MM3: f64 = 0.001;

/// How many points the estimate takes that a boolean's "no common volume" is held against.
const SAMPLES: u32 = 1000;

/// How much the boxes of solids are widened before they count as apart, in mm. Wider than any
/// tolerance that the kernel leaves on a valid solid.
const BOX_MARGIN_MM: f64 = 1e-3;

/// What this version does not check.
const NOT_CHECKED: [&str; 5] = [
    "contact: that mated parts touch where their mate promises it (only their positions are checked)",
    "port evidence: that the solid has at each port what the port's type promises",
    "freedom: which motions the mates leave, and whether they are intended",
    "motion: collisions away from the pose in which the assembly was built",
    "engineering rules: strength, fits, bearing arrangement, and whether the machine can be put together",
];

impl Workshop {
    /// Verifies an assembly and leaves the report beside its specification.
    ///
    /// # Errors
    /// When there is no assembly to verify. What is wrong *with* it is in the report.
    pub async fn verify(&self, id: &str, tau_mm3: f64) -> Result<Report, Faults> {
        let spec = self.store.load(id).map_err(|d| vec![d])?;
        let report = self.verify_specification(&spec, tau_mm3).await?;
        self.store
            .write_json(&report_file(id), &report)
            .map_err(|d| vec![d])?;
        Ok(report)
    }

    /// Verifies a specification, which need not be on disk. Nothing is written.
    ///
    /// # Errors
    /// As [`Workshop::verify`].
    pub async fn verify_specification(
        &self,
        spec: &Assembly,
        tau_mm3: f64,
    ) -> Result<Report, Faults> {
        let id = spec.id.as_str();
        let resolved = resolve::assembly(&self.registry, spec)?;
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
        let mut run = Run {
            findings: Vec::new(),
            checks: Vec::new(),
        };
        let (built, parts) = self.check_parts(&resolved, &placed, &mut run).await;
        let mates = check_mates(&resolved, &placed, &mut run);
        let pairs = self
            .check_pairs(&resolved, &placed, &built, tau_mm3, &mut run)
            .await;
        check_connectivity(spec, &resolved, &mut run);
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
            kernel: assemcad_kernel::version(),
            verdict,
            findings: run.findings,
            checks: run.checks,
            not_checked: NOT_CHECKED.map(str::to_owned).to_vec(),
            root: spec.root().map(str::to_owned),
            tau_mm3,
            parts,
            mates,
            pairs,
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
                centre_mm: None,
                placement: placement.map(Into::into),
            };
            match result {
                Ok(b) => {
                    fact.recipe_sha256 = Some(b.recipe.clone());
                    fact.volume_mm3 = Some(rounded(b.volume));
                    fact.centre_mm = placement.map(|p| p.point(b.centre).map(rounded));
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

    async fn check_pairs(
        &self,
        resolved: &Resolved,
        placed: &Placed,
        built: &[Option<Built>],
        tau: f64,
        run: &mut Run,
    ) -> Vec<PairFacts> {
        let names = |i: usize| {
            resolved
                .parts
                .get(i)
                .map(|p| p.id.clone())
                .unwrap_or_default()
        };
        let mut near = Vec::new();
        let mut cases = 0;
        let mut unknown = Vec::new();
        for i in 0..resolved.parts.len() {
            for j in i + 1..resolved.parts.len() {
                // Parts without a place are in no pair; connectivity reports them.
                let (Some(_), Some(_)) = (placed.of(i), placed.of(j)) else {
                    continue;
                };
                cases += 1;
                match (world_box(built, placed, i), world_box(built, placed, j)) {
                    (Some(a), Some(b)) if apart(&a, &b) => {}
                    (Some(_), Some(_)) => near.push((i, j)),
                    _ => unknown.push((i, j)),
                }
            }
        }
        let solid = |i: usize| {
            let (part, placement) = (resolved.parts.get(i)?, placed.of(i)?);
            Some(PlacedSolid {
                recipe: part.made.recipe.clone(),
                placement: placement.into(),
            })
        };
        let results = join_all(near.iter().map(|&(i, j)| async move {
            match (solid(i), solid(j)) {
                (Some(a), Some(b)) => self.common_volume(a, b, &names(i), &names(j)).await,
                _ => Err(Diagnostic::error(
                    Code::Internal,
                    "pairs",
                    "a part lost its place",
                )),
            }
        }))
        .await;
        let mut facts = Vec::new();
        let mut verdict = Verdict::Pass;
        for ((i, j), result) in near.into_iter().zip(results) {
            let (a, b) = (names(i), names(j));
            let found = judge(&a, &b, result, tau, &joining(resolved, i, j));
            let fact = PairFacts {
                verdict: found.verdict,
                common_volume_mm3: found.volume.map(rounded),
                a,
                b,
            };
            verdict = verdict.and(fact.verdict);
            run.findings.extend(found.finding);
            facts.push(fact);
        }
        for (i, j) in unknown {
            verdict = verdict.and(Verdict::Indeterminate);
            let (a, b) = (names(i), names(j));
            let place = format!("parts '{a}' and '{b}'");
            let d = Diagnostic::error(
                Code::Indeterminate,
                place,
                "whether they overlap is not known: one of them could not be made",
            );
            run.find(
                Verdict::Indeterminate,
                "interference",
                vec![a.clone(), b.clone()],
                d,
            );
            facts.push(PairFacts {
                a,
                b,
                verdict: Verdict::Indeterminate,
                common_volume_mm3: None,
            });
        }
        let how = format!(
            "common volume of every pair of placed parts whose boxes meet ({} of {cases}) above {tau} mm3, \
             held against {SAMPLES} points classified in both solids",
            facts.len()
        );
        run.check("interference", verdict, cases, &how);
        facts
    }

    async fn common_volume(
        &self,
        a: PlacedSolid,
        b: PlacedSolid,
        name_a: &str,
        name_b: &str,
    ) -> Result<CommonVolume, Diagnostic> {
        let job = Job::CommonVolume {
            a: Box::new(a),
            b: Box::new(b),
            samples: SAMPLES,
        };
        match self.pool.run(&job).await {
            Ok((Reply::CommonVolume(v), _)) => Ok(v),
            Ok(_) => Err(unexpected(&job)),
            Err(f) => Err(diagnostic(&f, &format!("parts '{name_a}' and '{name_b}'"))),
        }
    }
}

/// The file of an assembly's report, below the root.
#[must_use]
pub fn report_file(id: &str) -> String {
    file_of(id, "report.json")
}

/// Findings and checks as they come in.
struct Run {
    findings: Vec<Finding>,
    checks: Vec<Check>,
}

impl Run {
    fn find(&mut self, verdict: Verdict, check: &str, parts: Vec<String>, diagnostic: Diagnostic) {
        self.findings.push(Finding {
            verdict,
            check: check.to_owned(),
            parts,
            mates: Vec::new(),
            values: Map::new(),
            diagnostic,
        });
    }

    fn check(&mut self, check: &str, verdict: Verdict, cases: usize, how: &str) {
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
    let mut joined = resolved.root.map(&mut reach).unwrap_or_default();
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

/// What is known of a pair after its common volume was asked for.
struct Judged {
    verdict: Verdict,
    volume: Option<f64>,
    finding: Option<Finding>,
}

fn judge(
    a: &str,
    b: &str,
    result: Result<CommonVolume, Diagnostic>,
    tau: f64,
    mates: &[String],
) -> Judged {
    let place = format!("parts '{a}' and '{b}'");
    let (verdict, volume, values, d) = match result {
        Err(d) => (Verdict::Indeterminate, None, Map::new(), d),
        Ok(v) => {
            let estimate = v.sampled_volume * f64::from(v.inside) / f64::from(v.samples.max(1));
            let mut values = Map::new();
            values.insert("common_volume_mm3".to_owned(), json!(rounded(v.volume)));
            values.insert("estimate_mm3".to_owned(), json!(rounded(estimate)));
            if let Some((min, max, centre)) = v.place {
                values.insert("centre_mm".to_owned(), json!(centre.map(rounded)));
                values.insert("box_min_mm".to_owned(), json!(min.map(rounded)));
                values.insert("box_max_mm".to_owned(), json!(max.map(rounded)));
            }
            if v.volume > tau {
                let d = Diagnostic::error(
                    Code::Clash,
                    place,
                    format!("they overlap by {} mm3", rounded(v.volume)),
                )
                .found(rounded(v.volume))
                .expected(format!("at most {tau} mm3"))
                .hint(
                    "change the parameters of one part, or the offsets of the mate that places it",
                );
                (Verdict::Fail, Some(v.volume), values, d)
            // A volume that is no number passes no comparison, and lands here.
            } else if v.volume <= tau && estimate <= tau && v.warnings.is_empty() {
                return Judged {
                    verdict: Verdict::Pass,
                    volume: Some(v.volume),
                    finding: None,
                };
            } else if v.volume <= tau && estimate <= tau {
                let d = Diagnostic::error(
                    Code::Indeterminate,
                    place,
                    format!(
                        "the kernel finds no overlap, but warns: {}",
                        v.warnings.join("; ")
                    ),
                );
                (Verdict::Indeterminate, Some(v.volume), values, d)
            } else {
                let d = Diagnostic::error(
                    Code::Indeterminate,
                    place,
                    format!(
                        "the kernel finds a common volume of {} mm3, but {} of {} points spread over their \
                         common box lie inside both (about {} mm3)",
                        rounded(v.volume), v.inside, v.samples, rounded(estimate)
                    ),
                )
                .hint("treat it as an overlap, or change the parameters slightly and verify again");
                (Verdict::Indeterminate, Some(v.volume), values, d)
            }
        }
    };
    let finding = Finding {
        verdict,
        check: "interference".to_owned(),
        parts: vec![a.to_owned(), b.to_owned()],
        mates: mates.to_vec(),
        values,
        diagnostic: d,
    };
    Judged {
        verdict,
        volume,
        finding: Some(finding),
    }
}

/// The names of the mates between two parts.
fn joining(resolved: &Resolved, i: usize, j: usize) -> Vec<String> {
    let between = |m: &&resolve::ResolvedMate| {
        (m.base, m.incoming) == (i, j) || (m.base, m.incoming) == (j, i)
    };
    resolved
        .mates
        .iter()
        .filter(between)
        .map(|m| m.mate.id.clone())
        .collect()
}

type Box3 = ([f64; 3], [f64; 3]);

/// A box in the world around a placed part: the box of its own box's corners.
fn world_box(built: &[Option<Built>], placed: &Placed, i: usize) -> Option<Box3> {
    let (b, p) = (built.get(i)?.as_ref()?, placed.of(i)?);
    let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for x in [b.min[0], b.max[0]] {
        for y in [b.min[1], b.max[1]] {
            for z in [b.min[2], b.max[2]] {
                for (k, v) in p.point([x, y, z]).into_iter().enumerate() {
                    if let (Some(lo), Some(hi)) = (min.get_mut(k), max.get_mut(k)) {
                        *lo = lo.min(v);
                        *hi = hi.max(v);
                    }
                }
            }
        }
    }
    Some((min, max))
}

fn apart((a_min, a_max): &Box3, (b_min, b_max): &Box3) -> bool {
    let gap = |min: &[f64; 3], max: &[f64; 3]| {
        min.iter()
            .zip(max)
            .any(|(lo, hi)| *lo > *hi + BOX_MARGIN_MM)
    };
    gap(a_min, b_max) || gap(b_min, a_max)
}

#[cfg(test)]
mod tests {
    use super::{apart, judge};
    use assemcad_kernel::protocol::CommonVolume;
    use assemcad_model::diagnostic::{Code, Diagnostic};
    use assemcad_model::report::Verdict;

    fn verdict(volume: f64, inside: u32) -> Verdict {
        warned(volume, inside, Vec::new())
    }

    fn warned(volume: f64, inside: u32, warnings: Vec<String>) -> Verdict {
        let v = CommonVolume {
            volume,
            place: None,
            warnings,
            samples: 1000,
            inside,
            sampled_volume: 500.0,
        };
        judge("a", "b", Ok(v), 0.001, &[]).verdict
    }

    #[test]
    fn a_boolean_is_not_believed_alone() {
        assert_eq!(verdict(0.0, 0), Verdict::Pass);
        assert_eq!(verdict(0.0011, 0), Verdict::Fail);
        // The boolean says nothing, 30 of 1000 points say 15 mm3.
        assert_eq!(verdict(0.0, 30), Verdict::Indeterminate);
        assert_eq!(verdict(f64::NAN, 0), Verdict::Indeterminate);
        assert_eq!(
            warned(0.0, 0, vec!["bad face".to_owned()]),
            Verdict::Indeterminate
        );
        let lost = Diagnostic::error(Code::WorkerCrashed, "", "");
        assert_eq!(
            judge("a", "b", Err(lost), 0.001, &[]).verdict,
            Verdict::Indeterminate
        );
    }

    #[test]
    fn boxes_that_touch_are_not_apart() {
        let a = ([0.0; 3], [1.0; 3]);
        assert!(!apart(&a, &([1.0, 0.0, 0.0], [2.0, 1.0, 1.0])));
        assert!(!apart(&a, &([0.2; 3], [0.8; 3])));
        assert!(apart(&a, &([0.0, 0.0, 1.01], [1.0, 1.0, 2.0])));
        assert!(apart(&([0.0, 0.0, 1.01], [1.0, 1.0, 2.0]), &a));
        // A box that is no number is apart from nothing.
        assert!(!apart(&([f64::NAN; 3], [f64::NAN; 3]), &a));
    }
}
