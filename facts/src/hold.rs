//! What holds the parts of an assembly, and what moves.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_geometry::narrow::meet::{Kind, Meeting, Spot};
use nalgebra::{DMatrix, DVector, Vector3, Vector6};
use petgraph::unionfind::UnionFind;

use crate::cone::{Cone, Row, cone, farthest};
use crate::groups::{Engaged, Reason, engaged, grips, join, threaded};
use crate::rows::Rows;
use crate::stops::stops;

type V = Vector3<f64>;

/// How two parts meet, in the world and seen from the first.
#[derive(Debug, Clone)]
pub struct PairMeetings {
    /// The first part.
    pub a: usize,
    /// The second part.
    pub b: usize,
    /// Where they meet.
    pub meetings: Vec<Meeting>,
}

/// A thread of a part, in the world.
#[derive(Debug, Clone)]
pub struct Thread {
    /// The part.
    pub part: usize,
    /// Whether it is a screw's.
    pub external: bool,
    /// A point of its axis, in mm.
    pub point: V,
    /// Out of the screw's end, or out of the hole's mouth.
    pub direction: V,
    /// Nominal diameter in mm.
    pub diameter_mm: f64,
    /// Pitch in mm, negative of a left-hand thread.
    pub lead_mm: f64,
    /// Diameter of the plain cylinder that stands for it, in mm.
    pub modelled_mm: f64,
}

/// Two toothed parts whose flanks meet: at a point they have one speed along a direction.
#[derive(Debug, Clone)]
pub struct Coupled {
    /// The first part.
    pub a: usize,
    /// The second part.
    pub b: usize,
    /// The point, in mm.
    pub at: V,
    /// The direction.
    pub direction: V,
}

/// Placed parts and how they meet.
#[derive(Debug, Clone, Copy)]
pub struct Placed<'a> {
    /// How many parts there are.
    pub parts: usize,
    /// The parts that stand still.
    pub ground: &'a [usize],
    /// The pairs that meet.
    pub pairs: &'a [PairMeetings],
    /// The threads.
    pub threads: &'a [Thread],
    /// Pairs of parts of which a press fit is stated: equal diameters hold there.
    pub pressed: &'a BTreeSet<(usize, usize)>,
    /// Pairs of parts of which a bond is stated: it holds where they touch.
    pub bonded: &'a BTreeSet<(usize, usize)>,
    /// Pairs of parts whose threads are stated to turn in each other.
    pub driven: &'a BTreeSet<(usize, usize)>,
    /// Teeth that mesh.
    pub coupled: &'a [Coupled],
    /// The volumes of the parts, in mm3; 0 where they are not known.
    pub volumes: &'a [f64],
}

impl Placed<'_> {
    /// The size of a part as an area: its volume to the power of two thirds.
    pub(crate) fn volume(&self, part: usize) -> f64 {
        let volume = self.volumes.get(part).copied().unwrap_or_default();
        let edge = libm::cbrt(volume);
        edge * edge
    }
}

/// What holds what.
#[derive(Debug, Clone)]
pub struct Held {
    /// The bodies: parts that move as one. The first is what stands still.
    pub bodies: Vec<Vec<usize>>,
    /// Why parts move as one.
    pub why: Vec<(usize, usize, Reason)>,
    /// What moves, apart from each other.
    pub free: Vec<Free>,
    /// Whether some contacts between bodies are known by triangles alone: their directions are not exact.
    pub approximate: bool,
    /// Screws that go through parts which they do not press.
    pub idle_screws: Vec<IdleScrew>,
    /// Cylinders that are thicker than the hole that they are in and are no threads.
    pub tight: Vec<Tight>,
}

/// A screw that goes through parts which it does not press, though they stand with what it is screwed into.
#[derive(Debug, Clone)]
pub struct IdleScrew {
    /// The screw.
    pub screw: usize,
    /// What it is screwed into.
    pub nut: usize,
    /// The parts that it goes through and does not press.
    pub through: Vec<usize>,
}

/// A cylinder in a hole that is narrower.
#[derive(Debug, Clone)]
pub struct Tight {
    /// The part with the hole.
    pub hole: usize,
    /// The part in it.
    pub inner: usize,
    /// The diameter of the hole, in mm.
    pub hole_mm: f64,
    /// The diameter of what is in it, in mm.
    pub inner_mm: f64,
    /// A point of the axis, in mm.
    pub at: [f64; 3],
}

/// Bodies that meet each other, and what they may do.
#[derive(Debug, Clone)]
pub struct Free {
    /// Indices of the bodies.
    pub bodies: Vec<usize>,
    /// The scale of their twists.
    pub scale: Rows,
    /// The span of their motions: six numbers a body, angular part then linear part in the scale's length; none
    /// where it could not be told.
    pub basis: Option<DMatrix<f64>>,
    /// One motion that opens every contact that can open; none where none can.
    pub opening: Option<DVector<f64>>,
    rows: Vec<Row>,
    ways: Vec<Vec<Way>>,
}

/// A simple motion of one body.
#[derive(Debug, Clone, Copy)]
pub enum Way {
    /// Along a direction.
    Slide(V),
    /// About a line: a point and a direction.
    Turn(V, V),
}

impl Free {
    /// Whether a body meets anything at all.
    #[must_use]
    pub fn meets(&self, body: usize) -> bool {
        let own = |r: &Row| r.first == Some(body) || r.second == Some(body);
        self.rows.iter().any(own)
    }

    /// The twist of a simple motion.
    #[must_use]
    pub fn twist(&self, way: &Way) -> Vector6<f64> {
        match way {
            Way::Slide(along) => Rows::slide(along),
            Way::Turn(point, along) => self.scale.turn(point, along),
        }
    }

    /// The bodies that a simple motion of one body takes along: those that it pushes, and those that these push;
    /// none where what stands still stops it.
    #[must_use]
    pub fn pushed(&self, body: usize, twist: &Vector6<f64>) -> Option<Vec<usize>> {
        let mut set = vec![body];
        loop {
            let goes = |b: Option<usize>| b.is_some_and(|b| set.contains(&b));
            let stopped = self.rows.iter().find(|row| {
                let speed = match (goes(row.first), goes(row.second)) {
                    (false, true) => row.row.dot(twist),
                    (true, false) => -row.row.dot(twist),
                    _ => return false,
                };
                speed < -STILL || (row.both_ways && speed > STILL)
            });
            let Some(row) = stopped else {
                set.sort_unstable();
                return Some(set);
            };
            set.push(if goes(row.first) {
                row.second?
            } else {
                row.first?
            });
        }
    }

    /// The simple motions of one body, slides first.
    pub fn ways(&self, body: usize) -> impl Iterator<Item = (Way, Vector6<f64>)> {
        let ways = self.ways.get(body).into_iter().flatten();
        ways.map(|way| (*way, self.twist(way)))
    }
}

impl Free {
    /// How far a body can turn about an axis against another one before contacts stop it, both ways together, in
    /// radians; none where it could not be told. None stands for what stands still.
    #[must_use]
    pub fn turn_play_between(
        &self,
        first: Option<usize>,
        second: Option<usize>,
        axis: &V,
    ) -> Option<f64> {
        let about = Rows::about(axis) / self.scale.length;
        let row = |sign: f64| Row {
            first,
            second,
            row: about * sign,
            both_ways: false,
            gap_mm: 0.0,
        };
        let bodies = self.bodies.len();
        let one = farthest(bodies, &self.rows, &row(1.0))?;
        Some(one + farthest(bodies, &self.rows, &row(-1.0))?)
    }
}

/// Speeds at a contact below this are none: twists are about 1.
const STILL: f64 = 1e-6;

/// What holds the parts.
#[must_use]
pub fn held(of: &Placed<'_>) -> Held {
    let engaged = engaged(of);
    let grips = grips(of, &engaged);
    let (mut union, why) = join(of, &engaged, &grips);
    for pair in of.ground.windows(2) {
        if let [a, b] = pair {
            union.join(*a, *b);
        }
    }
    let still = of.ground.first().map(|g| union.of(*g));
    let mut bodies = union.sets();
    let of_still = |set: &Vec<usize>| set.first().copied() == still;
    bodies.sort_by_key(|set| !of_still(set));
    let mut body_of = vec![0; of.parts];
    for (index, set) in bodies.iter().enumerate() {
        for part in set {
            if let Some(slot) = body_of.get_mut(*part) {
                *slot = index;
            }
        }
    }
    let has_still = still.is_some();
    let contacts = contacts(of, &engaged, &body_of);
    let free = islands(bodies.len(), has_still, &contacts);
    let free = free
        .into_iter()
        .map(|members| free_of(&members, &contacts, has_still));
    let approximate = contacts.iter().any(|c| c.rough);
    Held {
        free: free.collect(),
        approximate,
        idle_screws: idle_screws(of, &engaged, &grips, &body_of),
        tight: tight(of, &engaged),
        bodies,
        why,
    }
}

fn idle_screws(
    of: &Placed<'_>,
    engaged: &[Engaged],
    grips: &[BTreeSet<usize>],
    body_of: &[usize],
) -> Vec<IdleScrew> {
    let mut out = Vec::new();
    let mut of_part: BTreeMap<usize, Vec<&PairMeetings>> = BTreeMap::new();
    for pair in of.pairs {
        of_part.entry(pair.a).or_default().push(pair);
        of_part.entry(pair.b).or_default().push(pair);
    }
    for (e, grip) in engaged.iter().zip(grips).filter(|(e, _)| e.stays) {
        let body = |part: usize| body_of.get(part);
        let mut through: Vec<usize> = Vec::new();
        for pair in of_part.get(&e.screw).into_iter().flatten() {
            let other = if pair.a == e.screw { pair.b } else { pair.a };
            let around = |m: &Meeting| {
                m.about.as_ref().is_some_and(|about| {
                    let along = V::from(about.direction).cross(&e.way).norm();
                    let has_hole = about.first_has_hole == (pair.a == other);
                    has_hole && about.share > 0.5 && along <= 1e-3
                })
            };
            let threads = |p: usize| engaged.iter().any(|x| x.screw == e.screw && x.nut == p);
            if !threads(other)
                && !grip.contains(&other)
                && body(other) == body(e.nut)
                && pair.meetings.iter().any(around)
            {
                through.push(other);
            }
        }
        if !through.is_empty() {
            out.push(IdleScrew {
                screw: e.screw,
                nut: e.nut,
                through,
            });
        }
    }
    out
}

fn tight(of: &Placed<'_>, engaged: &[Engaged]) -> Vec<Tight> {
    let mut out = Vec::new();
    let threaded = threaded(engaged);
    for pair in of.pairs {
        if threaded.contains(&(pair.a.min(pair.b), pair.a.max(pair.b))) {
            continue;
        }
        for m in &pair.meetings {
            let Some(about) = m.about.as_ref().filter(|_| m.kind == Kind::Cylinder) else {
                continue;
            };
            if m.gap_mm < 0.0 {
                let (hole, inner) = match about.first_has_hole {
                    true => (pair.a, pair.b),
                    false => (pair.b, pair.a),
                };
                out.push(Tight {
                    hole,
                    inner,
                    hole_mm: 2.0 * about.hole_mm,
                    inner_mm: 2.0 * about.inner_mm,
                    at: about.point,
                });
            }
        }
    }
    out
}

/// A condition between two bodies, in the world.
struct Contact {
    first: usize,
    second: usize,
    hold: Hold,
    /// Known by triangles alone.
    rough: bool,
}

enum Hold {
    Spot(Spot),
    Both { at: V, direction: V },
    Screw { point: V, axis: V, lead: f64 },
    Axis { point: V, axis: V },
}

fn contacts(of: &Placed<'_>, engaged: &[Engaged], body_of: &[usize]) -> Vec<Contact> {
    let mut out = Vec::new();
    let mut add = |a: usize, b: usize, rough: bool, hold: Hold| {
        let (Some(first), Some(second)) = (body_of.get(a), body_of.get(b)) else {
            return;
        };
        if first != second {
            out.push(Contact {
                first: *first,
                second: *second,
                hold,
                rough,
            });
        }
    };
    let coupled: BTreeSet<(usize, usize)> = of
        .coupled
        .iter()
        .flat_map(|c| [(c.a, c.b), (c.b, c.a)])
        .collect();
    for pair in of.pairs {
        let teeth = coupled.contains(&(pair.a, pair.b));
        let count = |kind: Kind| pair.meetings.iter().filter(|m| m.kind == kind).count();
        // Flanks may be made of arcs, which meet along lines nearly where the true flanks do.
        let rough = count(Kind::Free) > 0 || count(Kind::Line) > 2;
        for meeting in pair.meetings.iter().filter(|m| stops(m)) {
            // Of wheels whose teeth are known to mesh the flanks are one condition, stated below.
            if teeth && matches!(meeting.kind, Kind::Free | Kind::Line | Kind::Point) {
                continue;
            }
            for spot in &meeting.spots {
                let inexact = matches!(meeting.kind, Kind::Free | Kind::Line);
                add(pair.a, pair.b, rough && inexact, Hold::Spot(*spot));
            }
            if let Some(about) = &meeting.about {
                let (point, axis) = (V::from(about.point), V::from(about.direction));
                add(pair.a, pair.b, false, Hold::Axis { point, axis });
            }
        }
    }
    for c in of.coupled {
        let (at, direction) = (c.at, c.direction);
        add(c.a, c.b, false, Hold::Both { at, direction });
    }
    for e in engaged {
        let (point, axis, lead) = (e.point, e.way, e.lead);
        add(e.nut, e.screw, false, Hold::Screw { point, axis, lead });
    }
    out
}

/// Bodies that meet each other, what stands still left out.
fn islands(bodies: usize, has_still: bool, contacts: &[Contact]) -> Vec<Vec<usize>> {
    let mut sets = UnionFind::<usize>::new(bodies);
    let still = |body: usize| has_still && body == 0;
    for c in contacts {
        if !still(c.first) && !still(c.second) {
            sets.union(c.first, c.second);
        }
    }
    let mut out: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for body in (0..bodies).filter(|b| !still(*b)) {
        out.entry(sets.find(body)).or_default().push(body);
    }
    let mut out: Vec<Vec<usize>> = out.into_values().collect();
    out.sort();
    out
}

fn free_of(members: &[usize], contacts: &[Contact], has_still: bool) -> Free {
    let index: BTreeMap<usize, usize> = members.iter().enumerate().map(|(i, b)| (*b, i)).collect();
    let own = |c: &&Contact| index.contains_key(&c.first) || index.contains_key(&c.second);
    let own: Vec<&Contact> = contacts.iter().filter(own).collect();
    let place = |c: &&Contact| match &c.hold {
        Hold::Spot(spot) => V::from(spot.at),
        Hold::Both { at, .. } => *at,
        Hold::Screw { point, .. } | Hold::Axis { point, .. } => *point,
    };
    let spots = |c: &&&Contact| matches!(c.hold, Hold::Spot(_) | Hold::Both { .. });
    let places: Vec<V> = own.iter().filter(spots).map(place).collect();
    let middle = places.iter().sum::<V>() / (places.len().max(1) as f64);
    let length = places
        .iter()
        .map(|p| (p - middle).norm())
        .fold(1.0, f64::max);
    let scale = Rows { middle, length };
    let body = |b: usize| {
        let still = has_still && b == 0;
        (!still).then(|| index.get(&b).copied()).flatten()
    };
    let mut rows = Vec::new();
    let mut ways: Vec<Vec<Way>> = members.iter().map(|_| Vec::new()).collect();
    let mut note = |b: Option<usize>, way: Way| {
        if let Some(list) = b.and_then(|b| ways.get_mut(b)) {
            offer(list, way);
        }
    };
    for way in [V::x(), V::y(), V::z()] {
        for sign in [1.0, -1.0] {
            for b in 0..members.len() {
                note(Some(b), Way::Slide(way * sign));
            }
        }
    }
    for c in &own {
        let (first, second) = (body(c.first), body(c.second));
        let gap_mm = match &c.hold {
            Hold::Spot(spot) => spot.gap_mm.max(0.0),
            _ => 0.0,
        };
        let (row, both_ways) = match &c.hold {
            Hold::Spot(spot) => {
                let (at, normal) = (V::from(spot.at), V::from(spot.normal));
                for (b, sign) in [(first, -1.0), (second, 1.0)] {
                    note(b, Way::Slide(normal * sign));
                }
                (scale.along(&at, &normal), false)
            }
            Hold::Both { at, direction } => (scale.along(at, direction), true),
            Hold::Screw { point, axis, lead } => {
                let turn = Rows::about(axis) * (lead / core::f64::consts::TAU / length);
                (scale.along(point, axis) - turn, true)
            }
            Hold::Axis { point, axis } => {
                for b in [first, second] {
                    for sign in [1.0, -1.0] {
                        note(b, Way::Slide(axis * sign));
                        note(b, Way::Turn(*point, axis * sign));
                    }
                }
                continue;
            }
        };
        rows.push(Row {
            first,
            second,
            row,
            both_ways,
            gap_mm,
        });
    }
    for (b, list) in ways.iter_mut().enumerate() {
        let near = rows
            .iter()
            .zip(own.iter().filter(|c| !matches!(c.hold, Hold::Axis { .. })));
        let own: Vec<V> = near
            .filter(|(r, _)| r.first == Some(b) || r.second == Some(b))
            .map(|(_, c)| place(c))
            .collect();
        let centre = own.iter().sum::<V>() / (own.len().max(1) as f64);
        for way in [V::x(), V::y(), V::z()] {
            for sign in [1.0, -1.0] {
                offer(list, Way::Turn(centre, way * sign));
            }
        }
        list.sort_by_key(|w| matches!(w, Way::Turn(..)));
    }
    let found: Option<Cone> = cone(members.len(), &rows);
    let opening = found
        .as_ref()
        .filter(|c| c.opens)
        .map(|c| c.opening.clone());
    Free {
        bodies: members.to_vec(),
        scale,
        basis: found.map(|c| c.basis),
        opening,
        rows,
        ways,
    }
}

/// The most simple motions that are tried of one body.
const MOST_WAYS: usize = 60;

fn offer(list: &mut Vec<Way>, way: Way) {
    let same = |other: &Way| match (other, &way) {
        (Way::Slide(a), Way::Slide(b)) => (a - b).norm() <= 1e-6,
        (Way::Turn(p, a), Way::Turn(q, b)) => {
            (a - b).norm() <= 1e-6 && (p - q).cross(a).norm() <= 1e-4
        }
        _ => false,
    };
    if list.len() < MOST_WAYS && !list.iter().any(same) {
        list.push(way);
    }
}
