//! An island as unknowns and rows: bodies that nothing lets move against each other are one unit.

use nalgebra::{DMatrix, DVector, Vector3, Vector6};

use super::island::Island;
use super::linear::{RANK_TOLERANCE, at as at_entry, set};
use super::link::Scaled;
use super::rigid::{Rigid, stack};
use super::{Hold, Link, System};

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
        let place = |b: usize| island.bodies.iter().position(|m| *m == b);
        // Which group each body is in, by the first of its bodies.
        let mut group: Vec<usize> = (0..island.bodies.len()).collect();
        let mut glue = Vec::new();
        for (index, link) in links().filter(|(_, l)| merge && holds_all(l)) {
            let of = |b: usize| place(b).and_then(|p| group.get(p)).copied();
            let (Some(a), Some(b)) = (of(link.base), of(link.incoming)) else {
                continue;
            };
            if a != b {
                glue.push(index);
                let (keep, gone) = (a.min(b), a.max(b));
                group
                    .iter_mut()
                    .filter(|g| **g == gone)
                    .for_each(|g| *g = keep);
            }
        }
        // The ground is first among the bodies.
        let mut firsts: Vec<usize> = group.iter().copied().filter(|g| *g != 0).collect();
        firsts.sort_unstable();
        firsts.dedup();
        let unit = |p: usize| {
            let first = group.get(p)?;
            firsts.iter().position(|f| f == first)
        };
        let members: Vec<(usize, Option<usize>)> = island
            .bodies
            .iter()
            .enumerate()
            .skip(1)
            .map(|(p, b)| (*b, unit(p)))
            .collect();
        let (middle, length) = scale(island, system);
        let ties = links()
            .filter(|(i, _)| !glue.contains(i))
            .map(|(link, l)| Tie {
                link,
                base: place(l.base).and_then(unit),
                incoming: place(l.incoming).and_then(unit),
                scaled: Scaled::new(l, &middle, length),
                far: place(l.base).max(place(l.incoming)),
            });
        let mut out = Self {
            ties: ties.collect(),
            glue,
            members,
            units: firsts.len(),
            spins: Vec::new(),
            middle,
            length,
        };
        out.spins = (0..out.units).map(|u| out.spin(u, system)).collect();
        out
    }

    /// A unit spins idly where all its bodies do, about one axis.
    fn spin(&self, unit: usize, system: &System) -> Option<Vector6<f64>> {
        let mut found: Option<Vector6<f64>> = None;
        for (body, _) in self.members.iter().filter(|(_, u)| *u == Some(unit)) {
            let axis = system.bodies.get(*body)?.spin?;
            let (p, d) = (Vector3::from(axis.point), Vector3::from(axis.direction));
            let p = (p - self.middle) / self.length;
            let spin = stack(&d, &p.cross(&d));
            let first = *found.get_or_insert(spin);
            let off = (spin - first).norm().min((spin + first).norm());
            if off > RANK_TOLERANCE {
                return None;
            }
        }
        found
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

    /// How far each constraint is from holding after the units moved.
    pub(super) fn residual(&self, at: &[Rigid]) -> DVector<f64> {
        let all = self.ties.iter().flat_map(|tie| {
            tie.scaled
                .residual(&moved(at, tie.base), &moved(at, tie.incoming))
        });
        DVector::from_iterator(self.rows(), all)
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
