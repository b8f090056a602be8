//! The check `clearance`: parts that do not touch are no nearer to each other than was asked for.

use std::collections::BTreeMap;

use assemcad_factories::failure::diagnostic;
use assemcad_geometry::Asker;
use assemcad_kernel::asked::Chosen;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Finding, NearMiss, Overlapping, PairFacts, Verdict, rounded};
use assemcad_placing::solids::near_pairs;
use assemcad_placing::{Assembled, Box3};
use futures::future::join_all;
use serde_json::{Map, json};

use crate::results::Results;

/// Up to this distance parts touch, in mm: what placing and the kernel's distance leave.
const TOUCH_MM: f64 = 1e-6;

/// Finds the pairs that are nearer to each other than `clearance_mm` and do not touch. Parts that a
/// mate joins are left out: how near they are is the mate's matter. A near miss is a warning: no
/// specification says how much clearance there has to be.
pub(crate) async fn check(
    door: Asker<'_>,
    assembled: &Assembled<'_>,
    pairs: &[PairFacts],
    clearance_mm: f64,
    results: &mut Results,
) -> Vec<NearMiss> {
    let resolved = assembled.resolved;
    let all = 0..resolved.parts.len();
    let boxes: Vec<Option<Box3>> = all.map(|i| assembled.world_box(i)).collect();
    let known = |i: usize| boxes.get(i).is_some_and(Option::is_some);
    let count = boxes.iter().flatten().count();
    let mated = resolved.mates_by_pair();
    let mated_too = mated
        .keys()
        .filter(|(i, j)| i != j && known(*i) && known(*j));
    let cases = count * count.saturating_sub(1) / 2 - mated_too.count();
    let mut near = near_pairs(&boxes, clearance_mm);
    near.retain(|pair| !mated.contains_key(pair));
    let by_names: BTreeMap<(&str, &str), &PairFacts> = pairs
        .iter()
        .rev()
        .map(|p| ((p.a.as_str(), p.b.as_str()), p))
        .collect();
    let by_names = &by_names;
    let asked = near.len();
    let found = join_all(near.into_iter().map(|(i, j)| async move {
        let (a, b) = (resolved.name(i), resolved.name(j));
        let pair = by_names.get(&(a.as_str(), b.as_str()));
        // What overlaps, or may, is told by the check of interference.
        if pair.is_some_and(|p| p.class != Overlapping::None) {
            return None;
        }
        let whole = |i: usize| {
            Some(Chosen {
                part: assembled.solid(i)?.into(),
                faces: None,
            })
        };
        let gap = door.distance(&whole(i)?, &whole(j)?).await;
        let gap = gap
            .map(|gap| gap.distance)
            .map_err(|f| diagnostic(&f, &format!("parts '{a}' and '{b}'")));
        Some((a, b, gap))
    }))
    .await;
    let (mut verdict, mut misses) = (Verdict::Pass, Vec::new());
    for (a, b, gap) in found.into_iter().flatten() {
        let parts = vec![a.clone(), b.clone()];
        match gap {
            Err(d) => {
                verdict = verdict.and(Verdict::Indeterminate);
                results.find(Verdict::Indeterminate, "clearance", parts, d);
            }
            Ok(gap) if gap > TOUCH_MM && gap < clearance_mm => {
                results.findings.push(warning(&a, &b, gap, clearance_mm));
                misses.push(NearMiss {
                    a,
                    b,
                    distance_mm: rounded(gap),
                });
            }
            Ok(_) => {}
        }
    }
    let how = format!(
        "smallest distance of the pairs that no mate joins, that do not touch and whose boxes are nearer \
         than {clearance_mm} mm ({asked} of {cases} looked at)"
    );
    results.check("clearance", verdict, cases, &how);
    misses
}

fn warning(a: &str, b: &str, gap: f64, clearance_mm: f64) -> Finding {
    let gap = rounded(gap);
    let d = Diagnostic::warning(
        Code::NearMiss,
        format!("parts '{a}' and '{b}'"),
        format!("they do not touch and are {gap} mm apart"),
    )
    .found(gap)
    .expected(format!("at least {clearance_mm} mm, as asked for, or contact"))
    .hint("change the parameters of one part or the offsets of the mate that places it, or ask for less");
    let mut values = Map::new();
    values.insert("distance_mm".to_owned(), json!(gap));
    Finding {
        verdict: Verdict::Pass,
        check: "clearance".to_owned(),
        parts: vec![a.to_owned(), b.to_owned()],
        mates: Vec::new(),
        values,
        axioms: Vec::new(),
        diagnostic: d,
    }
}
