//! Parts that friction or a bond makes one body.

use assemcad_geometry::narrow::meet::{Kind, Meeting, TOUCH_MM};
use nalgebra::Vector3;

use std::collections::{BTreeMap, BTreeSet};

use crate::clamp::Presses;
use crate::hold::{Placed, Thread};
use crate::union::Union;

/// Why two parts move as one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// One is pressed into the other.
    Pressed,
    /// One is screwed into the other.
    Screwed,
    /// They lie in the grip of a screw.
    Clamped,
    /// They are welded, glued or soldered.
    Bonded,
}

/// How far the axes of ports may be off the axis of the faces about them, in mm and as a sine.
const ON_AXIS: (f64, f64) = (1e-3, 1e-6);

/// Two threads that are screwed into each other.
#[derive(Debug, Clone)]
pub(crate) struct Engaged {
    pub(crate) screw: usize,
    pub(crate) nut: usize,
    /// The way in which the screw goes in: out of its end.
    pub(crate) way: Vector3<f64>,
    pub(crate) point: Vector3<f64>,
    /// Nominal diameter in mm.
    pub(crate) diameter: f64,
    /// Pitch in mm, negative of a left-hand thread.
    pub(crate) lead: f64,
    /// Whether it stays where it is by its own friction.
    pub(crate) stays: bool,
}

/// The threads that are screwed into each other, by the cylinders that overlap there.
pub(crate) fn engaged(of: &Placed<'_>) -> Vec<Engaged> {
    let mut out: Vec<Engaged> = Vec::new();
    let mut threads: BTreeMap<usize, Vec<&Thread>> = BTreeMap::new();
    for thread in of.threads {
        threads.entry(thread.part).or_default().push(thread);
    }
    for pair in of.pairs {
        for meeting in &pair.meetings {
            let (Kind::Cylinder, Some(about)) = (meeting.kind, &meeting.about) else {
                continue;
            };
            let (nut, screw) = match about.first_has_hole {
                true => (pair.a, pair.b),
                false => (pair.b, pair.a),
            };
            let (point, axis) = (Vector3::from(about.point), Vector3::from(about.direction));
            let on_axis = |t: &&Thread| {
                let arm = t.point - point;
                (arm - axis * arm.dot(&axis)).norm() <= ON_AXIS.0
                    && t.direction.cross(&axis).norm() <= ON_AXIS.1
            };
            let find = |part: usize, external: bool, radius: f64| {
                let own = threads.get(&part).into_iter().flatten().copied();
                own.filter(|t| t.external == external)
                    .filter(on_axis)
                    .find(|t| (t.modelled_mm / 2.0 - radius).abs() <= ON_AXIS.0)
            };
            let (Some(inside), Some(outside)) = (
                find(nut, false, about.hole_mm),
                find(screw, true, about.inner_mm),
            ) else {
                continue;
            };
            let same = (inside.diameter_mm - outside.diameter_mm).abs() <= 1e-9
                && (inside.lead_mm - outside.lead_mm).abs() <= 1e-9;
            let known = out
                .iter()
                .rev()
                .take(1)
                .any(|e: &Engaged| (e.screw, e.nut) == (screw, nut));
            if same && meeting.gap_mm <= TOUCH_MM && long(meeting, SCREWED_IN) && !known {
                out.push(Engaged {
                    screw,
                    nut,
                    way: outside.direction,
                    point: outside.point,
                    diameter: outside.diameter_mm,
                    lead: outside.lead_mm,
                    stays: !of.driven.contains(&(screw, nut)) && !of.driven.contains(&(nut, screw)),
                });
            }
        }
    }
    out
}

/// The pairs whose threads are in each other, the lesser part first.
pub(crate) fn threaded(engaged: &[Engaged]) -> BTreeSet<(usize, usize)> {
    let pair = |e: &Engaged| (e.screw.min(e.nut), e.screw.max(e.nut));
    engaged.iter().map(pair).collect()
}

/// A bond holds over at least this share of the smaller part's size, its volume to the power of two thirds. Ours.
const BONDED: f64 = 0.01;

/// The widest play on the diameter that glue fills, in mm: retaining compounds are made for up to 0.25 mm.
const FILLED_MM: f64 = 0.2;

/// A pressed fit holds from this much interference on the radius on, in mm.
const PRESSED_MM: f64 = 1e-4;

/// It holds where it closes around at least this share of the circle.
const CLOSED: f64 = 0.5;

/// The least common length of a press fit and of a thread that holds, as shares of the diameter. Ours: half of a thin
/// nut, and less than any seat.
const SEATED: f64 = 0.2;
const SCREWED_IN: f64 = 0.25;

/// Whether a round contact is at least so many diameters long.
fn long(meeting: &Meeting, share: f64) -> bool {
    meeting.about.as_ref().is_some_and(|about| {
        let [from, to] = about.range;
        to - from >= share * 2.0 * about.hole_mm.abs().min(about.inner_mm.abs())
    })
}

fn pressed(meeting: &Meeting, stated: bool) -> bool {
    let most = if stated { TOUCH_MM } else { -PRESSED_MM };
    let about = meeting.about.as_ref();
    matches!(meeting.kind, Kind::Cylinder | Kind::Cone)
        && meeting.gap_mm <= most
        && about.is_some_and(|a| a.share >= CLOSED)
        && long(meeting, SEATED)
}

/// Joins what moves as one.
pub(crate) fn join(
    of: &Placed<'_>,
    engaged: &[Engaged],
    grips: &[BTreeSet<usize>],
) -> (Union, Vec<(usize, usize, Reason)>) {
    let mut union = Union::new(of.parts);
    let mut why = Vec::new();
    let mut take = |a: usize, b: usize, reason: Reason| {
        union.join(a, b);
        why.push((a, b, reason));
    };
    let threaded = threaded(engaged);
    for pair in of.pairs {
        let (a, b) = (pair.a, pair.b);
        let stated = of.pressed.contains(&(a, b)) || of.pressed.contains(&(b, a));
        if !threaded.contains(&(a.min(b), a.max(b)))
            && pair.meetings.iter().any(|m| pressed(m, stated))
        {
            take(a, b, Reason::Pressed);
        }
        let bonded = of.bonded.contains(&(a, b)) || of.bonded.contains(&(b, a));
        let least = BONDED * of.volume(a).min(of.volume(b));
        let touches = |m: &Meeting| {
            // Retaining compounds fill the play of a round joint; elsewhere a gap is one.
            let near = m.touches() || (m.kind == Kind::Cylinder && 2.0 * m.gap_mm <= FILLED_MM);
            near && m.area_mm2 > least
        };
        if bonded && pair.meetings.iter().any(touches) {
            take(a, b, Reason::Bonded);
        }
    }
    for (e, grip) in engaged.iter().zip(grips).filter(|(e, _)| e.stays) {
        take(e.screw, e.nut, Reason::Screwed);
        for part in grip {
            take(e.screw, *part, Reason::Clamped);
        }
    }
    (union, why)
}

/// What lies in the grip of each screw.
pub(crate) fn grips(of: &Placed<'_>, engaged: &[Engaged]) -> Vec<BTreeSet<usize>> {
    let mut presses = Presses::new(of);
    engaged.iter().map(|e| presses.grip(engaged, e)).collect()
}
