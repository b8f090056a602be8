//! Walking through the range.

use assemcad_model::diagnostic::Code;
use assemcad_model::frame::Placement;
use assemcad_model::freedom::{DriveKind, Pose, Stuck};
use assemcad_model::report::{Verdict, rounded};
use assemcad_placing::Placements;
use assemcad_placing::solids::{BOX_MARGIN_MM, apart, box_of, common_volume};
use assemcad_verify::checks::interference::{Judged, SAMPLES, allowed, judge};
use futures::future::join_all;
use serde_json::Value;

use crate::answer::{Collision, Open, Pairs, Proof, Proven, Stop, Sweep, shown};
use crate::mechanism::Mechanism;
use crate::pairs::Pair;
use crate::request::{Range, Request};

/// How often the kernel is asked for a common volume at most.
const MOST_ASKED: usize = 2000;

/// How near the last free value is brought to the first collision: radians or mm.
const TOLERANCE_RAD: f64 = 0.01 * core::f64::consts::PI / 180.0;
const TOLERANCE_MM: f64 = 1e-3;

/// A walk of a mechanism through a range.
pub(crate) struct Walk<'a> {
    pub(crate) mechanism: &'a Mechanism<'a>,
    pub(crate) range: Range,
    pub(crate) tau: f64,
}

/// What was found on the way.
#[derive(Default)]
struct Found {
    asked: usize,
    /// Whether the range was entered at all.
    looked: bool,
    proven: Vec<Proven>,
    open: Vec<Open>,
    collision: Option<Collision>,
    stopped: Option<(f64, Verdict, String)>,
}

/// A pair at a pose.
type Looked = (Pair, Judged);

impl Walk<'_> {
    pub(crate) async fn run(&self, request: &Request) -> Sweep {
        let (mut pairs, asked) = self.mechanism.pairs().await;
        let moving = pairs.len();
        let mut found = Found {
            asked,
            ..Found::default()
        };
        // The rings of these are apart whatever the pose.
        let (rings, rest) = pairs
            .into_iter()
            .partition(|p| p.proof == Some(Proof::Rings));
        pairs = rest;
        found.proven = self.proven(&rings);
        let mut free: Option<Pose> = None;
        let mut at = self.mechanism.drive.start();
        for value in self.range.values() {
            match self.mechanism.drive.advance(&at, value - at.value) {
                Ok(next) => at = next,
                Err((last, why)) => {
                    at = last;
                    found.stopped = Some(self.stuck(at.value, why));
                }
            }
            // Before the range's beginning nothing is looked at.
            if found.stopped.is_some() && free.is_none() {
                break;
            }
            if let Some(mate) = self.open_mate(&at) {
                let why = format!("the mate '{mate}' does not hold any more");
                found.stopped = Some((at.value, Verdict::Indeterminate, why));
                break;
            }
            found.looked = true;
            let looked = self.look(&at, &pairs, &mut found).await;
            let hits: Vec<Looked> = looked.into_iter().filter(hit).collect();
            if !hits.is_empty() {
                found.collision = self
                    .narrowed(free.as_ref(), at.clone(), hits, &mut found)
                    .await;
                break;
            }
            if free.is_none() {
                // One pose tells all others.
                let open = |p: &Pair| found.open.iter().any(|o| o.parts == self.names(p));
                let (round, rest) = pairs
                    .into_iter()
                    .partition(|p| p.proof.is_some() && !open(p));
                pairs = rest;
                found.proven.extend(self.proven(&round));
            }
            free = Some(at.clone());
            if found.stopped.is_some() {
                break;
            }
        }
        self.answer(request, &at, moving, found)
    }

    fn proven(&self, pairs: &[Pair]) -> Vec<Proven> {
        let of = |p: &Pair| {
            Some(Proven {
                parts: self.names(p),
                by: p.proof?,
            })
        };
        pairs.iter().filter_map(of).collect()
    }

    fn stuck(&self, at: f64, why: Stuck) -> (f64, Verdict, String) {
        let (verdict, why) = match why {
            Stuck::Limit => (
                Verdict::Fail,
                "blocked: its mates let it go no further (an end of travel or a dead centre)",
            ),
            Stuck::Branches => (
                Verdict::Indeterminate,
                "singular: more than one motion goes on from here, and the mates do not say which",
            ),
            Stuck::Unclear => (
                Verdict::Indeterminate,
                "whether the motion goes on from here could not be told",
            ),
        };
        (at, verdict, why.to_owned())
    }

    fn names(&self, pair: &Pair) -> [String; 2] {
        [pair.a, pair.b].map(|i| self.mechanism.assembled.resolved.name(i))
    }

    /// A mate that does not hold in a pose: a check of the walk that knows nothing of how it is walked.
    fn open_mate(&self, pose: &Pose) -> Option<&str> {
        let assembled = &self.mechanism.assembled;
        let parts = 0..assembled.resolved.parts.len();
        let placements = Placements {
            parts: parts.map(|i| self.mechanism.place(pose, i)).collect(),
            placed_by: assembled.placements.placed_by.clone(),
        };
        // A mate whose parts have no place cannot come open.
        let open = assembled
            .resolved
            .mates
            .iter()
            .find(|m| match placements.residual(m) {
                Ok(residual) => residual.is_some_and(|r| !r.holds()),
                Err(_) => true,
            });
        open.map(|m| m.mate.id.as_str())
    }

    /// The pairs whose boxes meet in a pose, and what they have in common.
    async fn look(&self, pose: &Pose, pairs: &[Pair], found: &mut Found) -> Vec<Looked> {
        let mut jobs = Vec::new();
        for pair in pairs {
            let of = |i: usize| {
                let solid = self.mechanism.assembled.built(i)?;
                Some((solid, self.mechanism.place(pose, i)?))
            };
            let (Some((solid_a, at_a)), Some((solid_b, at_b))) = (of(pair.a), of(pair.b)) else {
                self.leave_open(found, pair, pose.value, "a solid could not be made");
                continue;
            };
            if apart(
                &box_of(solid_a, &at_a),
                &box_of(solid_b, &at_b),
                BOX_MARGIN_MM,
            ) {
                continue;
            }
            if found.asked >= MOST_ASKED {
                let why = format!(
                    "not tried: the kernel was asked {MOST_ASKED} times; take a larger step"
                );
                self.leave_open(found, pair, pose.value, &why);
                continue;
            }
            found.asked += 1;
            jobs.push((*pair, at_a, at_b));
        }
        let judged =
            join_all(jobs.into_iter().map(|(pair, at_a, at_b)| async move {
                (pair, self.judged(&pair, at_a, at_b).await)
            }))
            .await;
        for (pair, j) in &judged {
            if j.verdict == Verdict::Indeterminate {
                let why = j
                    .finding
                    .as_ref()
                    .map_or("", |f| f.diagnostic.message.as_str());
                self.leave_open(found, pair, pose.value, why);
            }
        }
        judged
    }

    async fn judged(&self, pair: &Pair, at_a: Placement, at_b: Placement) -> Judged {
        let [a, b] = self.names(pair);
        let resolved = self.mechanism.assembled.resolved;
        let solid = |i: usize, at: Placement| resolved.parts.get(i).map(|p| p.solid_at(&at));
        let allowed = allowed(resolved, pair.a, pair.b);
        let common = match (solid(pair.a, at_a), solid(pair.b, at_b)) {
            (Some(one), Some(other)) => {
                common_volume(self.mechanism.door, (one, other), SAMPLES, [&a, &b]).await
            }
            _ => Err(assemcad_model::diagnostic::Diagnostic::error(
                Code::Internal,
                "pairs",
                "a part is lost",
            )),
        };
        judge(&a, &b, common, self.tau, &allowed)
    }

    fn leave_open(&self, found: &mut Found, pair: &Pair, at: f64, why: &str) {
        let parts = self.names(pair);
        if found.open.iter().all(|o| o.parts != parts) {
            found.open.push(Open {
                parts,
                at: shown(self.mechanism.drive.kind, at),
                why: why.to_owned(),
            });
        }
    }

    /// The collision of some pairs, brought near to the last free pose by halving.
    async fn narrowed(
        &self,
        free: Option<&Pose>,
        mut hit_at: Pose,
        mut hits: Vec<Looked>,
        found: &mut Found,
    ) -> Option<Collision> {
        let kind = self.mechanism.drive.kind;
        let tolerance = match kind {
            DriveKind::Rotate => TOLERANCE_RAD,
            DriveKind::Slide => TOLERANCE_MM,
        };
        let mut low = free.cloned();
        while let Some(free_at) = &low {
            let width = hit_at.value - free_at.value;
            if width.abs() <= tolerance {
                break;
            }
            let Ok(middle) = self.mechanism.drive.advance(free_at, width / 2.0) else {
                break;
            };
            let pairs: Vec<Pair> = hits.iter().map(|(p, _)| *p).collect();
            let looked = self.look(&middle, &pairs, found).await;
            let open = looked
                .iter()
                .any(|(_, j)| j.verdict == Verdict::Indeterminate);
            let there: Vec<Looked> = looked.into_iter().filter(hit).collect();
            if !there.is_empty() {
                (hit_at, hits) = (middle, there);
            } else if open {
                break;
            } else {
                low = Some(middle);
            }
        }
        let (pair, judged) = hits.into_iter().next()?;
        let finding = judged.finding?;
        let centre = finding.values.get("centre_mm").and_then(Value::as_array);
        let centre = centre.and_then(|c| match c.as_slice() {
            [x, y, z] => Some([x.as_f64()?, y.as_f64()?, z.as_f64()?]),
            _ => None,
        });
        let width = low.as_ref().map_or(0.0, |l| (hit_at.value - l.value).abs());
        Some(Collision {
            at: shown(kind, hit_at.value),
            free_until: low.map(|l| shown(kind, l.value)),
            tolerance: shown(kind, width),
            parts: self.names(&pair),
            mates: finding.mates,
            common_volume_mm3: rounded(judged.volume?),
            centre_mm: centre,
        })
    }

    fn answer(&self, request: &Request, at: &Pose, moving: usize, found: Found) -> Sweep {
        let kind = self.mechanism.drive.kind;
        let show = |v: f64| shown(kind, v);
        let stopped = found.stopped.as_ref();
        let verdict = if found.collision.is_some() {
            Verdict::Fail
        } else {
            let open = if found.open.is_empty() {
                Verdict::Pass
            } else {
                Verdict::Indeterminate
            };
            open.and(stopped.map_or(Verdict::Pass, |(_, v, _)| *v))
        };
        let unit = match kind {
            DriveKind::Rotate => "deg",
            DriveKind::Slide => "mm",
        };
        let told = found.proven.len() + found.open.len();
        let sampled = if found.looked {
            moving.saturating_sub(told)
        } else {
            0
        };
        let mut result = match (&found.collision, stopped) {
            (Some(c), _) => format!(
                "'{}' and '{}' collide at {} {unit}",
                c.parts[0], c.parts[1], c.at
            ),
            (None, Some((at, _, why))) => {
                format!("no collision up to {} {unit}; there {why}", show(*at))
            }
            (None, None) => format!(
                "no collision from {} to {} {unit}",
                show(self.range.from),
                show(self.range.to)
            ),
        };
        if found.collision.is_none() && sampled > 0 {
            let step = show(self.range.step);
            result.push_str(&format!(
                "; {sampled} of {moving} pairs only sampled every {step} {unit}"
            ));
        }
        if !found.looked {
            result.push_str("; the range was not reached, and nothing was compared");
        }
        let placements = self.mechanism.assembled.placements;
        let without = placements.parts.iter().filter(|p| p.is_none()).count();
        if without > 0 {
            result.push_str(&format!("; {without} parts without a place were left out"));
        }
        if !found.open.is_empty() {
            result.push_str(&format!("; {} pairs could not be told", found.open.len()));
        }
        let reached = found.collision.as_ref().map_or(show(at.value), |c| c.at);
        Sweep {
            verdict,
            result: format!("'{}': {result}", request.part),
            motion: self.mechanism.drive.name.clone(),
            direction: self.mechanism.drive.part.direction,
            held_still: self.mechanism.drive.still.clone(),
            unit: kind.into(),
            from: show(self.range.from),
            to: show(self.range.to),
            step: show(self.range.step),
            reached,
            stopped: found.stopped.map(|(at, _, why)| Stop { at: show(at), why }),
            collision: found.collision,
            pairs: Pairs {
                moving,
                proven: found.proven,
                sampled,
                indeterminate: found.open,
            },
            kernel_asked: found.asked,
        }
    }
}

/// Whether two parts have more in common than they may. Less than their mates mean is no collision.
fn hit((_, judged): &Looked) -> bool {
    let clash = |f: &assemcad_model::report::Finding| f.diagnostic.code == Code::Clash;
    judged.verdict == Verdict::Fail && judged.finding.as_ref().is_some_and(clash)
}
