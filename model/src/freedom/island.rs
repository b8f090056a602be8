//! Connected sets of bodies: each is analysed alone.

use nalgebra::{DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::blocks::{Block, Blocks};
use super::joints::{self, JointMotion};
use super::linear::{Rank, null_space, rank};
use super::model::Model;
use super::motion;
use super::redundant::{self, Redundant};
use super::rigid::Rigid;
use super::words::{self, Motion};
use super::{Lasting, System, finite};
use crate::report::rounded;

/// Bodies that links join, in the order of their names, and their links, likewise.
#[derive(Debug)]
pub(super) struct Island {
    /// The first one stands still: the root, or in an island without it the first by name.
    pub(super) bodies: Vec<usize>,
    pub(super) links: Vec<usize>,
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
            floating: system.root != Some(start),
        });
    }
    out
}

impl Island {
    /// `merge`: see [`Model::new`].
    pub(super) fn analyse(&self, system: &System, merge: bool) -> Found {
        let model = Model::new(self, system, merge);
        let blocks = Blocks::new(&model);
        let solved: Option<Vec<Solved>> = blocks.blocks.iter().map(Solved::new).collect();
        let clear = solved
            .as_ref()
            .filter(|s| s.iter().all(|b| b.rank.is_clear()));
        let inner = clear.map(|s| s.iter().map(|b| b.free.ncols()).sum::<usize>());
        let mut names: Vec<String> = self
            .bodies
            .iter()
            .filter_map(|b| system.bodies.get(*b))
            .map(|b| b.name.clone())
            .collect();
        names.sort_unstable();
        let glued = 6 * model.glue.len();
        let facts = IslandFacts {
            bodies: names,
            floating: self.floating,
            mobility: inner.map(|d| if self.floating { d + 6 } else { d }),
            constraints: model.rows() + glued,
            rank: solved.as_ref().map(|s| together(s, glued).reported()),
            characteristic_length_mm: rounded(model.length),
        };
        let Some(solved) = clear else {
            return Found {
                facts,
                motions: Vec::new(),
                redundant: Vec::new(),
                joints: Vec::new(),
                lasting: None,
            };
        };
        let columns: Vec<DVector<f64>> = solved
            .iter()
            .enumerate()
            .flat_map(|(k, s)| s.free.column_iter().map(move |c| (k, c.into_owned())))
            .map(|(k, c)| blocks.lifted(k, &c))
            .collect();
        let free = columns_of(model.columns(), &columns);
        let matrix = model.jacobian(&vec![Rigid::IDENTITY; model.units]);
        let basis = motion::basis(&model, &matrix, &free);
        // Without redundant rows the poses are a smooth set as wide as its tangents.
        let mut lasting = Some(0);
        let mut each = vec![Lasting::True; basis.motions.len()];
        for (block, s) in blocks.blocks.iter().zip(solved) {
            let d = s.free.ncols();
            let wide = if s.matrix.nrows() == s.rank.rank {
                Some(d)
            } else {
                let own = motion::basis(&block.model, &s.matrix, &s.free);
                finite::dimension(&block.model, &own)
            };
            lasting = lasting.zip(wide).map(|(sum, more)| sum + more);
            if wide != Some(d) {
                for (motion, told) in basis.motions.iter().zip(&mut each).skip(basis.idle) {
                    *told = told.and(finite::goes_on(&block.model, &block.share(motion)));
                }
            }
        }
        Found {
            motions: words::named(self, &model, system, &basis, &each),
            facts,
            redundant: redundant::find(self, system, &model, &stresses(&model, &blocks, solved)),
            joints: joints::find(self, system, &model, &columns),
            lasting,
        }
    }
}

/// A block's rows, their rank, and what they leave free.
struct Solved {
    matrix: DMatrix<f64>,
    rank: Rank,
    free: DMatrix<f64>,
}

impl Solved {
    /// None where the rank cannot be computed.
    fn new(block: &Block) -> Option<Self> {
        let matrix = block
            .model
            .jacobian(&vec![Rigid::IDENTITY; block.model.units]);
        let rank = rank(&matrix)?;
        Some(Self {
            free: null_space(&matrix, rank.rank),
            rank,
            matrix,
        })
    }
}

/// The ranks of all blocks and of what glues units as one.
fn together(solved: &[Solved], glued: usize) -> Rank {
    let mut out = Rank {
        rank: glued,
        largest_zero: 0.0,
        smallest_counted: 1.0,
    };
    for s in solved {
        out.rank += s.rank.rank;
        out.largest_zero = out.largest_zero.max(s.rank.largest_zero);
        out.smallest_counted = out.smallest_counted.min(s.rank.smallest_counted);
    }
    out
}

/// The stresses without a load of all blocks, as weights on the rows of all ties.
fn stresses(model: &Model, blocks: &Blocks, solved: &[Solved]) -> DMatrix<f64> {
    let mut first = Vec::new();
    let mut rows = 0;
    for tie in &model.ties {
        first.push(rows);
        rows += tie.scaled.rows();
    }
    let mut columns = Vec::new();
    for (block, s) in blocks.blocks.iter().zip(solved) {
        for weights in null_space(&s.matrix.transpose(), s.rank.rank).column_iter() {
            let mut column = DVector::zeros(rows);
            let mut own = 0;
            for (at, n) in block.ties.iter().filter_map(|t| {
                let rows = model.ties.get(*t)?.scaled.rows();
                Some((*first.get(*t)?, rows))
            }) {
                column.rows_mut(at, n).copy_from(&weights.rows(own, n));
                own += n;
            }
            columns.push(column);
        }
    }
    columns_of(rows, &columns)
}

/// Columns as a matrix, also where there are none.
fn columns_of(rows: usize, columns: &[DVector<f64>]) -> DMatrix<f64> {
    let mut out = DMatrix::zeros(rows, columns.len());
    for (k, column) in columns.iter().enumerate() {
        out.set_column(k, column);
    }
    out
}
