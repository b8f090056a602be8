//! The check `interference`: no two parts have more in common than their mates mean.

use std::collections::BTreeMap;

use assemcad_kernel::protocol::{Built, CommonVolume, Job, Placed as PlacedSolid, Reply};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Finding, Overlapping, PairFacts, Verdict, rounded};
use assemcad_model::spec::Assembly;
use futures::future::join_all;
use serde_json::{Map, json};

use crate::Workshop;
use crate::build::{Box3, box_of, diagnostic, unexpected};
use crate::place::Placed;
use crate::resolve::{Resolved, ResolvedMate};
use crate::verify::Run;

mod clash;
mod thread;

/// How many points the estimate takes that a boolean's volume is held against.
const SAMPLES: u32 = 1000;

/// How much the boxes of solids are widened before they count as apart, in mm. Wider than any
/// tolerance that the kernel leaves on a valid solid.
pub(crate) const BOX_MARGIN_MM: f64 = 1e-3;

impl Workshop {
    pub(crate) async fn check_pairs(
        &self,
        spec: &Assembly,
        (resolved, placed): (&Resolved, &Placed),
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
        // Parts without a place are in no pair; connectivity reports them.
        let there = (0..resolved.parts.len()).filter(|i| placed.of(*i).is_some());
        let there: Vec<usize> = there.collect();
        let cases = there.len() * there.len().saturating_sub(1) / 2;
        let boxes: Vec<Option<Box3>> = (0..resolved.parts.len())
            .map(|i| world_box(built, placed, i))
            .collect();
        let near = near_pairs(&boxes, BOX_MARGIN_MM);
        let made = |i: usize| boxes.get(i).is_some_and(Option::is_some);
        let mut unknown: Vec<(usize, usize)> = Vec::new();
        for i in there.iter().filter(|i| !made(**i)) {
            let others = there.iter().filter(|j| *j != i && (made(**j) || i < *j));
            unknown.extend(others.map(|j| (*i.min(j), *i.max(j))));
        }
        unknown.sort_unstable();
        let mated = by_pair(resolved);
        let results = join_all(near.iter().map(|&(i, j)| async move {
            match (solid(resolved, placed, i), solid(resolved, placed, j)) {
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
        let mut clashes = 0;
        for ((i, j), result) in near.into_iter().zip(results) {
            let (a, b) = (names(i), names(j));
            let mates = mated.get(&(i, j)).into_iter().flatten();
            let allowed = allowed_by(mates.filter_map(|m| resolved.mates.get(*m)));
            let place = result.as_ref().ok().and_then(|v| v.place);
            let mut found = judge(&a, &b, result, tau, &allowed);
            if let (Overlapping::Clash, Some(finding)) = (found.class, &mut found.finding) {
                clashes += 1;
                let clash = clash::Clash {
                    spec,
                    resolved,
                    placed,
                    built,
                    pair: (i, j),
                    common: place.map(|(min, max, _)| (min, max)),
                    volume: found.volume.unwrap_or_default(),
                    tau,
                };
                self.tell_clash(&clash, clashes <= clash::MOST_MOVED, finding)
                    .await;
            }
            let fact = PairFacts {
                verdict: found.verdict,
                class: found.class,
                common_volume_mm3: found.volume.map(rounded),
                allowed_mm3: (!allowed.why.is_empty()).then(|| rounded(allowed.most_mm3)),
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
                class: Overlapping::Unknown,
                common_volume_mm3: None,
                allowed_mm3: None,
            });
        }
        let how = format!(
            "common volume of every pair of placed parts whose boxes meet ({} of {cases}) above {tau} mm3, \
             held against {SAMPLES} points classified in both solids; an overlap that a mate means is compared \
             with the mate's, within 1 percent",
            facts.len()
        );
        run.check("interference", verdict, cases, &how);
        facts
    }

    pub(crate) async fn common_volume(
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

/// What is known of a pair after its common volume was asked for.
pub(crate) struct Judged {
    pub(crate) verdict: Verdict,
    class: Overlapping,
    pub(crate) volume: Option<f64>,
    pub(crate) finding: Option<Finding>,
}

/// What two parts may have in common by their mates.
#[derive(Debug, Default)]
pub(crate) struct Allowed {
    mates: Vec<String>,
    least_mm3: f64,
    most_mm3: f64,
    why: Vec<String>,
}

/// How far an expected overlap may be from what its mates say, as a share of it.
const SHARE: f64 = 0.01;

/// The common volume above which two parts clash whose mates mean as much as `allowed`, in mm3.
pub(crate) fn limit_mm3(allowed: f64, tau: f64) -> f64 {
    allowed * (1.0 + SHARE) + tau
}

pub(crate) fn judge(
    a: &str,
    b: &str,
    result: Result<CommonVolume, Diagnostic>,
    tau: f64,
    allowed: &Allowed,
) -> Judged {
    let place = format!("parts '{a}' and '{b}'");
    let mut values = Map::new();
    let (verdict, class, volume, d) = match result {
        Err(d) => (Verdict::Indeterminate, Overlapping::Unknown, None, Some(d)),
        Ok(v) => {
            let estimate = v.sampled_volume * f64::from(v.inside) / f64::from(v.samples.max(1));
            values.insert("common_volume_mm3".to_owned(), json!(rounded(v.volume)));
            values.insert("estimate_mm3".to_owned(), json!(rounded(estimate)));
            if !allowed.why.is_empty() {
                values.insert("allowed_mm3".to_owned(), json!(rounded(allowed.most_mm3)));
                values.insert("allowed_for".to_owned(), json!(allowed.why));
            }
            if let Some((min, max, centre)) = v.place {
                values.insert("centre_mm".to_owned(), json!(centre.map(rounded)));
                values.insert("box_min_mm".to_owned(), json!(min.map(rounded)));
                values.insert("box_max_mm".to_owned(), json!(max.map(rounded)));
            }
            let (verdict, class, d) = weigh(&place, &v, estimate, tau, allowed);
            (verdict, class, Some(v.volume), d)
        }
    };
    let finding = d.map(|diagnostic| Finding {
        verdict,
        check: "interference".to_owned(),
        parts: vec![a.to_owned(), b.to_owned()],
        mates: allowed.mates.clone(),
        values,
        axioms: Vec::new(),
        diagnostic,
    });
    Judged {
        verdict,
        class,
        volume,
        finding,
    }
}

fn weigh(
    place: &str,
    v: &CommonVolume,
    estimate: f64,
    tau: f64,
    allowed: &Allowed,
) -> (Verdict, Overlapping, Option<Diagnostic>) {
    let most = limit_mm3(allowed.most_mm3, tau);
    let least = allowed.least_mm3 * (1.0 - SHARE) - tau;
    let found = rounded(v.volume);
    if v.volume > most {
        let d = Diagnostic::error(Code::Clash, place, format!("they overlap by {found} mm3"))
            .found(found)
            .hint("change the parameters of one part, or the offsets of the mate that places it");
        let d = if allowed.why.is_empty() {
            d.expected(format!("at most {tau} mm3"))
        } else {
            let of = allowed.why.join(", ");
            d.expected(format!("at most {} mm3: {of}", rounded(most)))
        };
        return (Verdict::Fail, Overlapping::Clash, Some(d));
    }
    let open = |message: String| {
        Diagnostic::error(Code::Indeterminate, place, message)
            .hint("treat it as an overlap, or change the parameters slightly and verify again")
    };
    let unknown = |d| (Verdict::Indeterminate, Overlapping::Unknown, Some(d));
    if !agrees(v, estimate, tau) {
        return unknown(open(format!(
            "the kernel finds a common volume of {found} mm3, but {} of {} points spread over their common \
             box lie inside both (about {} mm3)",
            v.inside,
            v.samples,
            rounded(estimate)
        )));
    }
    if !v.warnings.is_empty() {
        let warned = v.warnings.join("; ");
        let message = format!("the kernel finds {found} mm3 in common, but warns: {warned}");
        return unknown(open(message));
    }
    if v.volume < least {
        let d = Diagnostic::error(
            Code::ContactMissing,
            place,
            format!("they overlap by {found} mm3, and their mates mean more"),
        )
        .found(found)
        .expected(format!(
            "at least {} mm3: {}",
            rounded(least),
            allowed.why.join(", ")
        ))
        .hint("state the ports' lengths as those of the cylinders alone, without chamfers and grooves");
        return (Verdict::Fail, Overlapping::Expected, Some(d));
    }
    let class = if v.volume > tau {
        Overlapping::Expected
    } else {
        Overlapping::None
    };
    (Verdict::Pass, class, None)
}

/// Whether the sampled points agree with the boolean's volume. Where that is next to nothing, no point may
/// be inside both. Otherwise their number may be off by five standard deviations of a count, and five.
fn agrees(v: &CommonVolume, estimate: f64, tau: f64) -> bool {
    if v.volume <= tau {
        return estimate <= tau;
    }
    let expected = v.volume / v.sampled_volume * f64::from(v.samples);
    let off = (f64::from(v.inside) - expected).abs();
    off <= 5.0 * expected.sqrt() + 5.0
}

/// What the mates between two parts allow, taken together.
pub(crate) fn allowed(resolved: &Resolved, i: usize, j: usize) -> Allowed {
    let joins = |m: &&ResolvedMate| [(i, j), (j, i)].contains(&(m.base, m.incoming));
    allowed_by(resolved.mates.iter().filter(joins))
}

/// The mates between each two parts, the earlier part first.
pub(crate) fn by_pair(resolved: &Resolved) -> BTreeMap<(usize, usize), Vec<usize>> {
    let mut out: BTreeMap<(usize, usize), Vec<usize>> = BTreeMap::new();
    for (n, m) in resolved.mates.iter().enumerate() {
        let pair = (m.base.min(m.incoming), m.base.max(m.incoming));
        out.entry(pair).or_default().push(n);
    }
    out
}

fn allowed_by<'a>(mates: impl Iterator<Item = &'a ResolvedMate>) -> Allowed {
    let mut out = Allowed::default();
    for m in mates {
        let overlap = m.mate.mate_type.kind().overlap(&m.joint());
        out.mates.push(m.mate.id.clone());
        out.least_mm3 += overlap.least_mm3;
        out.most_mm3 += overlap.most_mm3;
        if !overlap.why.is_empty() {
            out.why
                .push(format!("{} (mate '{}')", overlap.why, m.mate.id));
        }
    }
    out
}

/// A part's solid in its place.
pub(crate) fn solid(resolved: &Resolved, placed: &Placed, i: usize) -> Option<PlacedSolid> {
    let (part, placement) = (resolved.parts.get(i)?, placed.of(i)?);
    Some(PlacedSolid {
        recipe: part.made.recipe.clone(),
        placement: placement.into(),
    })
}

pub(crate) fn world_box(built: &[Option<Built>], placed: &Placed, i: usize) -> Option<Box3> {
    Some(box_of(built.get(i)?.as_ref()?, &placed.of(i)?))
}

/// The pairs of boxes that are not further apart than the margin, in order. Swept along the axis along which they
/// are spread the most.
pub(crate) fn near_pairs(boxes: &[Option<Box3>], margin_mm: f64) -> Vec<(usize, usize)> {
    let known = boxes.iter().enumerate();
    let known = known.filter_map(|(i, b)| Some((i, b.as_ref()?)));
    let number = |(_, b): &(usize, &Box3)| b.0.iter().chain(&b.1).all(|x| x.is_finite());
    // A box that is no number is apart from nothing, and has no place in a row.
    let (mut row, odd): (Vec<_>, Vec<_>) = known.partition(number);
    let at = |p: &[f64; 3], axis: usize| p.get(axis).copied().unwrap_or_default();
    let spread = |axis: usize| {
        let lows = row.iter().map(|(_, b)| at(&b.0, axis));
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = lows.fold(ends, |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    let axis = (0..3).fold(0, |a, b| if spread(b) > spread(a) { b } else { a });
    row.sort_by(|(i, a), (j, b)| {
        let order = at(&a.0, axis).total_cmp(&at(&b.0, axis));
        order.then(i.cmp(j))
    });
    let mut out = Vec::new();
    for (n, (i, a)) in row.iter().enumerate() {
        let beside = row.iter().skip(n + 1);
        let beside = beside.take_while(|(_, b)| at(&b.0, axis) <= at(&a.1, axis) + margin_mm);
        let near = beside.filter(|(_, b)| !apart(a, b, margin_mm));
        out.extend(near.map(|(j, _)| (*i.min(j), *i.max(j))));
    }
    for (n, (i, a)) in odd.iter().enumerate() {
        let others = row.iter().chain(odd.iter().skip(n + 1));
        let near = others.filter(|(_, b)| !apart(a, b, margin_mm));
        out.extend(near.map(|(j, _)| (*i.min(j), *i.max(j))));
    }
    out.sort_unstable();
    out
}

/// Whether two boxes are further apart than the margin.
pub(crate) fn apart((a_min, a_max): &Box3, (b_min, b_max): &Box3, margin_mm: f64) -> bool {
    let gap =
        |min: &[f64; 3], max: &[f64; 3]| min.iter().zip(max).any(|(lo, hi)| *lo > *hi + margin_mm);
    gap(a_min, b_max) || gap(b_min, a_max)
}

#[cfg(test)]
mod tests;
