//! Connected sets of bodies: each is analysed alone.

use nalgebra::{DMatrix, Vector3, Vector6};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::joints::{self, JointMotion};
use super::linear::{Rank, at as at_entry, null_space, rank, set};
use super::link::Scaled;
use super::motion;
use super::redundant::{self, Redundant};
use super::rigid::Rigid;
use super::words::{self, Motion};
use super::{System, finite};
use crate::report::rounded;

/// Bodies that links join, in the order of their names, and their links, likewise.
#[derive(Debug)]
pub(super) struct Island {
    pub(super) bodies: Vec<usize>,
    pub(super) links: Vec<usize>,
    /// The body that stands still: the root, or in an island without it the first.
    pub(super) ground: usize,
    pub(super) floating: bool,
}

/// What was counted in an island.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct IslandFacts {
    /// Its bodies, by name.
    pub bodies: Vec<String>,
    /// Whether nothing joins it to the root: then it has the six motions of a rigid body besides.
    pub floating: bool,
    /// Independent motions; none where the rank cannot be told.
    pub mobility: Option<usize>,
    /// Constraints that the links state.
    pub constraints: usize,
    /// How many of them are independent, and how clearly.
    pub rank: Option<Rank>,
    /// The length that makes turns and slides compare, in mm.
    pub characteristic_length_mm: f64,
}

/// Everything that was found in an island.
pub(super) struct Found {
    pub(super) facts: IslandFacts,
    pub(super) motions: Vec<Motion>,
    pub(super) redundant: Vec<Redundant>,
    pub(super) joints: Vec<JointMotion>,
    pub(super) lasting: Option<usize>,
}

/// The islands of a system, the root's first, the others by their first body's name.
pub(super) fn split(system: &System) -> Vec<Island> {
    let name = |i: &usize| system.bodies.get(*i).map(|b| b.name.as_str());
    let mut order: Vec<usize> = (0..system.bodies.len()).collect();
    order.sort_by(|a, b| name(a).cmp(&name(b)));
    if let Some(at) = order.iter().position(|i| Some(*i) == system.root) {
        let root = order.remove(at);
        order.insert(0, root);
    }
    let mut links: Vec<usize> = (0..system.links.len()).collect();
    let link_name = |i: &usize| system.links.get(*i).map(|l| l.name.as_str());
    links.sort_by(|a, b| link_name(a).cmp(&link_name(b)));
    let ends = |l: &usize| system.links.get(*l).map(|l| (l.base, l.incoming));
    let mut seen: Vec<usize> = Vec::new();
    let mut out = Vec::new();
    for start in order {
        if seen.contains(&start) {
            continue;
        }
        let mut bodies = vec![start];
        let mut at = 0;
        while let Some(here) = bodies.get(at).copied() {
            at += 1;
            for (a, b) in links.iter().filter_map(ends) {
                for (one, other) in [(a, b), (b, a)] {
                    if one == here && !bodies.contains(&other) && other < system.bodies.len() {
                        bodies.push(other);
                    }
                }
            }
        }
        seen.extend(&bodies);
        let held = |l: &usize| {
            ends(l).is_some_and(|(a, b)| bodies.contains(&a) && bodies.contains(&b) && a != b)
        };
        out.push(Island {
            links: links.iter().copied().filter(held).collect(),
            // Breadth first from the ground, as they were found: near bodies come first.
            bodies,
            ground: start,
            floating: system.root != Some(start),
        });
    }
    out
}

/// An island's links in its own units, and which unknowns belong to which body.
#[derive(Debug)]
pub(super) struct Model {
    pub(super) links: Vec<(Option<usize>, Option<usize>, Scaled)>,
    /// The bodies that can move, by their index in the system.
    pub(super) moving: Vec<usize>,
    pub(super) middle: Vector3<f64>,
    pub(super) length: f64,
}

impl Model {
    fn new(island: &Island, system: &System) -> Self {
        let moving: Vec<usize> = island
            .bodies
            .iter()
            .copied()
            .filter(|b| *b != island.ground)
            .collect();
        let place = |b: usize| moving.iter().position(|m| *m == b);
        let links = || island.links.iter().filter_map(|l| system.links.get(*l));
        let joints: Vec<Vector3<f64>> = links().map(|l| l.frame.origin()).collect();
        let middle = joints.iter().sum::<Vector3<f64>>() / (joints.len().max(1) as f64);
        let bodies = island.bodies.iter().filter_map(|b| system.bodies.get(*b));
        let bodies = bodies.map(|b| Vector3::from(b.at));
        let spread = |far: f64, p: Vector3<f64>| far.max((p - middle).norm());
        let length = joints.iter().copied().chain(bodies).fold(0.0, spread);
        // One joint, and everything in it: any length will do.
        let length = if length > 0.0 { length } else { 1.0 };
        Self {
            links: links()
                .map(|l| {
                    let scaled = Scaled::new(l, &middle, length);
                    (place(l.base), place(l.incoming), scaled)
                })
                .collect(),
            moving,
            middle,
            length,
        }
    }

    pub(super) fn columns(&self) -> usize {
        6 * self.moving.len()
    }

    pub(super) fn rows(&self) -> usize {
        self.links.iter().map(|(_, _, l)| l.rows()).sum()
    }

    /// The constraint matrix after the bodies moved.
    pub(super) fn jacobian(&self, at: &[Rigid]) -> DMatrix<f64> {
        let mut out = DMatrix::zeros(self.rows(), self.columns());
        let mut row = 0;
        for (base, incoming, link) in &self.links {
            for w in link.jacobian(&moved(at, *base), &moved(at, *incoming)) {
                for (body, sign) in [(base, -1.0), (incoming, 1.0)] {
                    for (i, entry) in w.iter().enumerate() {
                        if let Some(b) = body {
                            let was = at_entry(&out, row, 6 * b + i);
                            set(&mut out, row, 6 * b + i, was + sign * entry);
                        }
                    }
                }
                row += 1;
            }
        }
        out
    }

    /// How far each constraint is from holding after the bodies moved.
    pub(super) fn residual(&self, at: &[Rigid]) -> nalgebra::DVector<f64> {
        let all = self.links.iter().flat_map(|(base, incoming, link)| {
            link.residual(&moved(at, *base), &moved(at, *incoming))
        });
        nalgebra::DVector::from_iterator(self.rows(), all)
    }
}

fn moved(at: &[Rigid], body: Option<usize>) -> Rigid {
    body.and_then(|b| at.get(b))
        .copied()
        .unwrap_or(Rigid::IDENTITY)
}

/// The twist of a body in a motion of all bodies; the ground has none.
pub(super) fn twist_of(motion: &nalgebra::DVector<f64>, body: Option<usize>) -> Vector6<f64> {
    body.map_or_else(Vector6::zeros, |b| {
        motion.fixed_rows::<6>(6 * b).into_owned()
    })
}

impl Island {
    pub(super) fn analyse(&self, system: &System) -> Found {
        let model = Model::new(self, system);
        let here = vec![Rigid::IDENTITY; model.moving.len()];
        let matrix = model.jacobian(&here);
        let rank = rank(&matrix);
        let clear = rank.filter(Rank::is_clear);
        let inner = clear.map(|r| model.columns() - r.rank);
        let mut names: Vec<String> = self
            .bodies
            .iter()
            .filter_map(|b| system.bodies.get(*b))
            .map(|b| b.name.clone())
            .collect();
        names.sort_unstable();
        let facts = IslandFacts {
            bodies: names,
            floating: self.floating,
            mobility: inner.map(|d| if self.floating { d + 6 } else { d }),
            constraints: model.rows(),
            rank: rank.map(Rank::reported),
            characteristic_length_mm: rounded(model.length),
        };
        let Some(rank) = clear else {
            return Found {
                facts,
                motions: Vec::new(),
                redundant: Vec::new(),
                joints: Vec::new(),
                lasting: None,
            };
        };
        let redundant = redundant::find(self, system, &model, &matrix, rank.rank);
        let free = null_space(&matrix, rank.rank);
        let basis = motion::basis(&model, system, &matrix, &free);
        // Without redundant rows the poses are a smooth set as wide as its tangents.
        let (lasting, each) = if matrix.nrows() == rank.rank {
            (Some(basis.motions.len()), None)
        } else {
            let (lasting, each) = finite::test(&model, &basis);
            (lasting, Some(each))
        };
        Found {
            motions: words::named(self, &model, system, &basis, each.as_deref()),
            facts,
            redundant,
            joints: joints::find(self, system, &model, &free),
            lasting,
        }
    }
}
