//! Connected sets of bodies: each is analysed alone.

use nalgebra::DMatrix;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::blocks::{Block, Blocks};
use super::eliminate::eliminate;
use super::joints::{self, JointMotion};
use super::linear::{Rank, null_space, rank};
use super::model::Model;
use super::motion;
use super::redundant::{self, Redundant};
use super::rigid::Rigid;
use super::sparse::Sparse;
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
    // The links of each body, in the order of their names.
    let mut of: Vec<Vec<(usize, usize)>> = vec![Vec::new(); system.bodies.len()];
    for l in &links {
        let Some(link) = system.links.get(*l) else {
            continue;
        };
        for (one, other) in [(link.base, link.incoming), (link.incoming, link.base)] {
            if other < system.bodies.len()
                && one != other
                && let Some(list) = of.get_mut(one)
            {
                list.push((*l, other));
            }
        }
    }
    let mut island_of: Vec<Option<usize>> = vec![None; system.bodies.len()];
    let mut out: Vec<Island> = Vec::new();
    for start in order {
        if island_of.get(start).copied().flatten().is_some() {
            continue;
        }
        let mut bodies = vec![start];
        let mut found = |body: usize| {
            let slot = island_of.get_mut(body);
            slot.is_some_and(|s| s.replace(out.len()).is_none())
        };
        found(start);
        let mut at = 0;
        while let Some(here) = bodies.get(at).copied() {
            at += 1;
            for (_, other) in of.get(here).map(Vec::as_slice).unwrap_or_default() {
                if found(*other) {
                    bodies.push(*other);
                }
            }
        }
        out.push(Island {
            links: Vec::new(),
            // Breadth first from the ground, as they were found: near bodies come first.
            bodies,
            floating: system.root != Some(start),
        });
    }
    for l in links {
        let Some(link) = system.links.get(l).filter(|l| l.base != l.incoming) else {
            continue;
        };
        let at = |body: usize| island_of.get(body).copied().flatten();
        if let (Some(a), Some(b)) = (at(link.base), at(link.incoming))
            && a == b
            && let Some(island) = out.get_mut(a)
        {
            island.links.push(l);
        }
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
        let inner = clear.map(|s| s.iter().map(|b| b.free.len()).sum::<usize>());
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
        let lifted: Vec<Sparse> = solved
            .iter()
            .enumerate()
            .flat_map(|(k, s)| s.free.iter().map(move |c| (k, c)))
            .map(|(k, c)| blocks.lifted(k, c))
            .collect();
        let basis = motion::basis(&model, &lifted);
        // Without redundant rows the poses are a smooth set as wide as its tangents.
        let mut lasting = Some(0);
        let mut each = vec![Lasting::True; basis.motions.len()];
        for (block, s) in blocks.blocks.iter().zip(solved) {
            let d = s.free.len();
            let wide = if s.stresses.is_empty() {
                Some(d)
            } else {
                finite::dimension(&block.model, &motion::basis(&block.model, &s.free))
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
            joints: joints::find(self, system, &model, &blocks, &free_of(solved)),
            lasting,
        }
    }
}

/// What each block's rows leave free.
fn free_of(solved: &[Solved]) -> Vec<&[Sparse]> {
    solved.iter().map(|s| s.free.as_slice()).collect()
}

/// A block's rank, what its rows leave free, and how they add up to nothing.
struct Solved {
    rank: Rank,
    free: Vec<Sparse>,
    stresses: Vec<Sparse>,
}

impl Solved {
    /// None where the rank cannot be computed.
    fn new(block: &Block) -> Option<Self> {
        let at = vec![Rigid::IDENTITY; block.model.units];
        if block.model.is_large() {
            let rows = block.model.rows_at(&at);
            let found = eliminate(&rows, block.model.columns(), 6, true)?;
            return Some(Self {
                free: found.null_space(&rows)?,
                stresses: found.stresses(&rows)?,
                rank: found.rank,
            });
        }
        let matrix = block.model.jacobian(&at);
        let rank = rank(&matrix)?;
        let columns = |m: DMatrix<f64>| {
            let all = m.column_iter().map(|c| Sparse::of(c.iter().copied()));
            all.collect()
        };
        Some(Self {
            free: columns(null_space(&matrix, rank.rank)),
            stresses: columns(null_space(&matrix.transpose(), rank.rank)),
            rank,
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
fn stresses(model: &Model, blocks: &Blocks, solved: &[Solved]) -> Vec<Sparse> {
    let mut first = Vec::new();
    let mut rows = 0;
    for tie in &model.ties {
        first.push(rows);
        rows += tie.scaled.rows();
    }
    let mut out = Vec::new();
    for (block, s) in blocks.blocks.iter().zip(solved) {
        // Where each of the block's rows is among all.
        let mut place = Vec::new();
        for t in &block.ties {
            if let (Some(tie), Some(at)) = (model.ties.get(*t), first.get(*t)) {
                place.extend(*at..*at + tie.scaled.rows());
            }
        }
        for weights in &s.stresses {
            let moved = |(own, x): &(usize, f64)| Some((*place.get(*own)?, *x));
            out.push(Sparse::new(weights.entries().iter().filter_map(moved)));
        }
    }
    out
}
