//! An island as unknowns and rows: bodies that nothing lets move against each other are one unit.

use nalgebra::{DMatrix, DVector, Vector3, Vector6};

use super::island::Island;
use super::linear::{RANK_TOLERANCE, at as at_entry, set};
use super::link::Scaled;
use super::rigid::{Rigid, stack};
use super::sparse::Sparse;
use super::{Hold, Link, System};

/// Beyond so many unknowns or rows a model is large. Ours: below, singular values take less than a tenth of a second.
const LARGE_COLUMNS: usize = 120;
const LARGE_ROWS: usize = 240;

/// A link between two units; no unit is the ground.
#[derive(Debug, Clone)]
pub(super) struct Tie {
    /// Its index in the system.
    pub(super) link: usize,
    pub(super) base: Option<usize>,
    pub(super) incoming: Option<usize>,
    pub(super) scaled: Scaled,
    /// How far from the ground its farther body is, in the order in which bodies are found from there.
    pub(super) far: Option<usize>,
}

/// An island's links in its own units, and which unknowns belong to which body.
#[derive(Debug, Clone)]
pub(super) struct Model {
    /// The links that do not join the bodies of a unit.
    pub(super) ties: Vec<Tie>,
    /// The links that make units of bodies, by their index in the system: no loop of them, six constraints
    /// each, all independent.
    pub(super) glue: Vec<usize>,
    /// The bodies but the ground, by their index in the system, and the unit of each.
    pub(super) members: Vec<(usize, Option<usize>)>,
    /// The bodies of each unit, by their place among the members and their index in the system.
    pub(super) bodies: Vec<Vec<(usize, usize)>>,
    /// How many units can move.
    pub(super) units: usize,
    /// The turn of each unit about an axis of its own that is no motion of the machine.
    pub(super) spins: Vec<Option<Vector6<f64>>>,
    pub(super) middle: Vector3<f64>,
    pub(super) length: f64,
}

impl Model {
    /// `merge`: whether rigidly joined bodies are one unit; else each body is one.
    pub(super) fn new(island: &Island, system: &System, merge: bool) -> Self {
        let links = || {
            let found = |l: &usize| Some((*l, system.links.get(*l)?));
            island.links.iter().filter_map(found)
        };
        let mut places = vec![None; system.bodies.len()];
        for (p, b) in island.bodies.iter().enumerate() {
            if let Some(slot) = places.get_mut(*b) {
                *slot = Some(p);
            }
        }
        let place = |b: usize| places.get(b).copied().flatten();
        // Which group each body is in, by the first of its bodies.
        let mut group = Groups((0..island.bodies.len()).collect());
        let mut glue = Vec::new();
        for (index, link) in links().filter(|(_, l)| merge && holds_all(l)) {
            let (Some(a), Some(b)) = (place(link.base), place(link.incoming)) else {
                continue;
            };
            if group.join(a, b) {
                glue.push(index);
            }
        }
        // The ground is first among the bodies.
        let mut units = 0;
        let mut unit_of: Vec<Option<usize>> = Vec::new();
        for p in 0..island.bodies.len() {
            let first = group.first(p);
            let unit = if first == 0 {
                None
            } else if first == p {
                units += 1;
                Some(units - 1)
            } else {
                unit_of.get(first).copied().flatten()
            };
            unit_of.push(unit);
        }
        let unit = |p: usize| unit_of.get(p).copied().flatten();
        let members: Vec<(usize, Option<usize>)> = island
            .bodies
            .iter()
            .enumerate()
            .skip(1)
            .map(|(p, b)| (*b, unit(p)))
            .collect();
        let mut bodies = vec![Vec::new(); units];
        for (place, (body, unit)) in members.iter().enumerate() {
            if let Some(list) = unit.and_then(|u| bodies.get_mut(u)) {
                list.push((place, *body));
            }
        }
        let (middle, length) = scale(island, system);
        let mut glued = glue.iter().peekable();
        // Both are in the order of the island's links.
        let ties = links()
            .filter(|(i, _)| glued.next_if_eq(&i).is_none())
            .map(|(link, l)| Tie {
                link,
                base: place(l.base).and_then(unit),
                incoming: place(l.incoming).and_then(unit),
                scaled: Scaled::new(l, &middle, length),
                far: place(l.base).max(place(l.incoming)),
            })
            .collect();
        let mut out = Self {
            ties,
            glue,
            members,
            bodies,
            units,
            spins: Vec::new(),
            middle,
            length,
        };
        out.spins = out.spins(system);
        out
    }

    /// A unit spins idly where all its bodies do, about one axis.
    fn spins(&self, system: &System) -> Vec<Option<Vector6<f64>>> {
        let mut first: Vec<Option<Vector6<f64>>> = vec![None; self.units];
        let mut off = vec![false; self.units];
        for (body, unit) in &self.members {
            let Some((first, off)) = unit.and_then(|u| first.get_mut(u).zip(off.get_mut(u))) else {
                continue;
            };
            let Some(axis) = system.bodies.get(*body).and_then(|b| b.spin) else {
                *off = true;
                continue;
            };
            let (p, d) = (Vector3::from(axis.point), Vector3::from(axis.direction));
            let p = (p - self.middle) / self.length;
            let spin = stack(&d, &p.cross(&d));
            let known = *first.get_or_insert(spin);
            *off |= (spin - known).norm().min((spin + known).norm()) > RANK_TOLERANCE;
        }
        let each = first.into_iter().zip(off);
        each.map(|(spin, off)| spin.filter(|_| !off)).collect()
    }

    /// Whether singular values would take long: it is solved by elimination.
    pub(super) fn is_large(&self) -> bool {
        self.columns() > LARGE_COLUMNS || self.rows() > LARGE_ROWS
    }

    pub(super) fn columns(&self) -> usize {
        6 * self.units
    }

    pub(super) fn rows(&self) -> usize {
        self.ties.iter().map(|t| t.scaled.rows()).sum()
    }

    /// The constraint matrix after the units moved.
    pub(super) fn jacobian(&self, at: &[Rigid]) -> DMatrix<f64> {
        let mut out = DMatrix::zeros(self.rows(), self.columns());
        let mut row = 0;
        for tie in &self.ties {
            let (base, incoming) = (moved(at, tie.base), moved(at, tie.incoming));
            for w in tie.scaled.jacobian(&base, &incoming) {
                for (unit, sign) in [(tie.base, -1.0), (tie.incoming, 1.0)] {
                    for (i, entry) in w.iter().enumerate() {
                        if let Some(u) = unit {
                            let was = at_entry(&out, row, 6 * u + i);
                            set(&mut out, row, 6 * u + i, was + sign * entry);
                        }
                    }
                }
                row += 1;
            }
        }
        out
    }

    /// The rows of the constraint matrix after the units moved.
    pub(super) fn rows_at(&self, at: &[Rigid]) -> Vec<Sparse> {
        let mut out = Vec::new();
        for tie in &self.ties {
            let (base, incoming) = (moved(at, tie.base), moved(at, tie.incoming));
            let ends = [(tie.base, -1.0), (tie.incoming, 1.0)];
            for w in tie.scaled.jacobian(&base, &incoming) {
                let mut row = Sparse::default();
                if tie.base != tie.incoming {
                    let mut ends = ends;
                    ends.sort_by_key(|(unit, _)| *unit);
                    for (unit, sign) in ends {
                        if let Some(u) = unit {
                            row.push_twist(u, &(w * sign));
                        }
                    }
                }
                out.push(row);
            }
        }
        out
    }

    /// How far each constraint is from holding after the units moved.
    pub(super) fn residual(&self, at: &[Rigid]) -> DVector<f64> {
        let all = self.ties.iter().flat_map(|tie| {
            tie.scaled
                .residual(&moved(at, tie.base), &moved(at, tie.incoming))
        });
        DVector::from_iterator(self.rows(), all)
    }
}

/// Bodies in groups, each by the first of its bodies.
struct Groups(Vec<usize>);

impl Groups {
    fn first(&mut self, of: usize) -> usize {
        let mut first = of;
        while let Some(up) = self.0.get(first).filter(|up| **up != first) {
            first = *up;
        }
        // The next search is shorter.
        let mut at = of;
        while let Some(up) = self.0.get_mut(at).filter(|up| **up != first) {
            at = core::mem::replace(up, first);
        }
        first
    }

    /// Makes the groups of two bodies one; says whether they were two.
    fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.first(a), self.first(b));
        if let Some(slot) = self.0.get_mut(a.max(b)) {
            *slot = a.min(b);
        }
        a != b
    }
}

/// Whether a link leaves nothing free.
fn holds_all(link: &Link) -> bool {
    matches!(&link.hold, Hold::Free(free) if free.is_empty())
}

/// The middle of the joints, and how far the farthest joint or body is from it.
fn scale(island: &Island, system: &System) -> (Vector3<f64>, f64) {
    let links = island.links.iter().filter_map(|l| system.links.get(*l));
    let joints: Vec<Vector3<f64>> = links.map(|l| l.frame.origin()).collect();
    let middle = joints.iter().sum::<Vector3<f64>>() / (joints.len().max(1) as f64);
    let bodies = island.bodies.iter().filter_map(|b| system.bodies.get(*b));
    let bodies = bodies.map(|b| Vector3::from(b.at));
    let spread = |far: f64, p: Vector3<f64>| far.max((p - middle).norm());
    let length = joints.iter().copied().chain(bodies).fold(0.0, spread);
    // One joint, and everything in it: any length will do.
    (middle, if length > 0.0 { length } else { 1.0 })
}

/// Where a unit is; the ground has not moved.
pub(super) fn moved(at: &[Rigid], unit: Option<usize>) -> Rigid {
    unit.and_then(|u| at.get(u))
        .copied()
        .unwrap_or(Rigid::IDENTITY)
}

/// The twist of a unit in a motion of all units; the ground has none.
pub(super) fn twist_of(motion: &DVector<f64>, unit: Option<usize>) -> Vector6<f64> {
    unit.map_or_else(Vector6::zeros, |u| {
        motion.fixed_rows::<6>(6 * u).into_owned()
    })
}
