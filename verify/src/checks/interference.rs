//! The check `interference`: no two parts have more in common than their mates mean.

use assemcad_geometry::{Asker, ENTERS};
use assemcad_kernel::protocol::CommonVolume;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::Frame;
use assemcad_model::ports::Port;
use assemcad_model::report::{Finding, Overlapping, PairFacts, Verdict, rounded};
use assemcad_model::spec::Assembly;
use assemcad_placing::solids::{BOX_MARGIN_MM, common_volume, near_pairs};
use assemcad_placing::{Assembled, Box3, Resolved, ResolvedMate};
use futures::future::join_all;
use serde_json::{Map, json};

use crate::results::Results;

mod beyond;
mod clash;
mod thread;

/// How many points the estimate takes that a boolean's volume is held against.
pub const SAMPLES: u32 = 1000;

/// Compares every pair of placed parts whose boxes meet.
pub(crate) async fn check(
    door: Asker<'_>,
    spec: &Assembly,
    assembled: &Assembled<'_>,
    tau: f64,
    results: &mut Results,
) -> Vec<PairFacts> {
    let (resolved, placements) = (assembled.resolved, assembled.placements);
    // Parts without a place are in no pair; connectivity reports them.
    let all = 0..resolved.parts.len();
    let there: Vec<usize> = all
        .clone()
        .filter(|i| placements.of(*i).is_some())
        .collect();
    let cases = there.len() * there.len().saturating_sub(1) / 2;
    let boxes: Vec<Option<Box3>> = all.map(|i| assembled.world_box(i)).collect();
    let near = near_pairs(&boxes, BOX_MARGIN_MM);
    let made = |i: usize| boxes.get(i).is_some_and(Option::is_some);
    let mut unknown: Vec<(usize, usize)> = Vec::new();
    for i in there.iter().filter(|i| !made(**i)) {
        let others = there.iter().filter(|j| *j != i && (made(**j) || i < *j));
        unknown.extend(others.map(|j| (*i.min(j), *i.max(j))));
    }
    unknown.sort_unstable();
    let mated = resolved.mates_by_pair();
    let common = join_all(near.iter().map(|&(i, j)| async move {
        match (assembled.solid(i), assembled.solid(j)) {
            (Some(a), Some(b)) => {
                let (name_a, name_b) = (resolved.name(i), resolved.name(j));
                common_volume(door, (a, b), SAMPLES, [&name_a, &name_b]).await
            }
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
    for ((i, j), common) in near.into_iter().zip(common) {
        let (a, b) = (resolved.name(i), resolved.name(j));
        let allowed = allowed_by(mated.get(&(i, j)).into_iter().flatten().copied());
        let place = common.as_ref().ok().and_then(|v| v.place);
        let mut found = judge(&a, &b, common, tau, &allowed);
        if found.class == Overlapping::Expected && found.verdict == Verdict::Pass {
            Box::pin(beyond::check(door, assembled, (i, j), &allowed, &mut found)).await;
        }
        if let (Overlapping::Clash, Some(finding)) = (found.class, &mut found.finding) {
            clashes += 1;
            let clash = clash::Clash {
                spec,
                assembled,
                pair: (i, j),
                common: place.map(|(min, max, _)| (min, max)),
                volume: found.volume.unwrap_or_default(),
                tau,
            };
            clash::tell(door, &clash, clashes <= clash::MOST_MOVED, finding).await;
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
        results.findings.extend(found.finding);
        facts.push(fact);
    }
    for (i, j) in unknown {
        verdict = verdict.and(Verdict::Indeterminate);
        let (a, b) = (resolved.name(i), resolved.name(j));
        let place = format!("parts '{a}' and '{b}'");
        let d = Diagnostic::error(
            Code::Indeterminate,
            place,
            "whether they overlap is not known: one of them could not be made",
        );
        results.find(
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
    results.check("interference", verdict, cases, &how);
    facts
}

/// So many points inside both solids are no misclassification.
const MANY: u32 = 10;

/// What is known of a pair after its common volume was asked for.
#[derive(Debug)]
pub struct Judged {
    /// Whether they have more or less in common than they may.
    pub verdict: Verdict,
    /// What sort of overlap that is.
    pub class: Overlapping,
    /// The common volume in mm3, where it is known.
    pub volume: Option<f64>,
    /// What is wrong, where anything is.
    pub finding: Option<Finding>,
}

/// What two parts may have in common by their mates.
#[derive(Debug, Default)]
pub struct Allowed {
    mates: Vec<String>,
    meant: Vec<Meant>,
    least_mm3: f64,
    most_mm3: f64,
    why: Vec<String>,
}

/// Where a mate means an overlap: about an axis of a part.
#[derive(Debug, Clone)]
struct Meant {
    part: usize,
    frame: Frame,
    radius_mm: f64,
}

/// The larger of the radii of a mate's two ports.
fn widest(m: &ResolvedMate) -> f64 {
    let of = |p: &Port| {
        let named = ["modelled_diameter", "diameter"];
        let values = named.iter().filter_map(|n| p.params.get(*n).copied());
        values.fold(0.0, f64::max) / 2.0
    };
    of(&m.base_port).max(of(&m.incoming_port))
}

/// How far an expected overlap may be from what its mates say, as a share of it.
const SHARE: f64 = 0.01;

/// The common volume above which two parts clash whose mates mean as much as `allowed`, in mm3.
#[must_use]
pub fn limit_mm3(allowed: f64, tau: f64) -> f64 {
    allowed * (1.0 + SHARE) + tau
}

/// Judges what two parts have in common by what their mates allow.
#[must_use]
pub fn judge(
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
    if v.volume <= tau && v.inside >= MANY && estimate > most {
        let about = rounded(estimate);
        let d = Diagnostic::error(
            Code::Clash,
            place,
            format!(
                "{} of {} points spread over their common box lie inside both, about {about} mm3, where the \
                 kernel's boolean finds {found} mm3",
                v.inside, v.samples
            ),
        )
        .found(about)
        .hint("change the parameters of one part, or the offsets of the mate that places it");
        return (Verdict::Fail, Overlapping::Clash, Some(d));
    }
    if !agrees(v, estimate, tau) {
        return unknown(open(format!(
            "the kernel finds a common volume of {found} mm3, but {} of {} points spread over their common \
             box lie inside both (about {} mm3)",
            v.inside,
            v.samples,
            rounded(estimate)
        )));
    }
    // Two measures that find nothing outweigh a warning; one that points contradict does not count.
    let nothing = v.volume <= tau && v.inside == 0 && v.warnings.iter().all(|w| w != ENTERS);
    if !v.warnings.is_empty() && !nothing {
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
#[must_use]
pub fn allowed(resolved: &Resolved, i: usize, j: usize) -> Allowed {
    allowed_by(resolved.between(i, j))
}

fn allowed_by<'a>(mates: impl Iterator<Item = &'a ResolvedMate>) -> Allowed {
    let mut out = Allowed::default();
    for m in mates {
        let overlap = m.mate.mate_type.kind().overlap(&m.joint());
        out.mates.push(m.mate.id.clone());
        if overlap.most_mm3 > 0.0 {
            out.meant.push(Meant {
                part: m.base,
                frame: m.base_port.frame,
                radius_mm: widest(m),
            });
        }
        out.least_mm3 += overlap.least_mm3;
        out.most_mm3 += overlap.most_mm3;
        if !overlap.why.is_empty() {
            out.why
                .push(format!("{} (mate '{}')", overlap.why, m.mate.id));
        }
    }
    out
}

#[cfg(test)]
mod tests;
