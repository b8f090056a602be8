//! An island in blocks: sets of units that have no more than one unit in common with the rest.
//!
//! What a block's links hold and leave is a matter of its units against each other, so that its motions and its
//! redundant constraints are its own: ranks, null spaces and finite steps add up over blocks. The blocks are the
//! biconnected components of the graph of units and links (Tarjan, *Depth-first search and linear graph
//! algorithms*, SIAM Journal on Computing 1, 1972).

use nalgebra::DVector;

use super::model::{Model, Tie, twist_of};

/// A block as a model of its own, in the island's scale.
#[derive(Debug)]
pub(super) struct Block {
    /// Its links and units, these by their place in `units`; its ground is the unit by which it hangs on the
    /// island's ground.
    pub(super) model: Model,
    /// Its ties by their index in the island.
    pub(super) ties: Vec<usize>,
    /// Its units but the one it hangs on, by their index in the island.
    pub(super) units: Vec<usize>,
    /// The unit it hangs on; none for the island's ground.
    root: Option<usize>,
}

/// The blocks of an island.
#[derive(Debug)]
pub(super) struct Blocks {
    pub(super) blocks: Vec<Block>,
    /// For each unit the block in which something carries it.
    home: Vec<usize>,
}

impl Blocks {
    pub(super) fn new(model: &Model) -> Self {
        let mut walk = Walk {
            model,
            found: vec![0; model.units + 1],
            low: vec![0; model.units + 1],
            count: 0,
            open: Vec::new(),
            blocks: Vec::new(),
        };
        walk.visit(None, None);
        // A link between bodies of one unit is a block without unknowns.
        let inner = |t: &Tie| t.base == t.incoming;
        let alone = model.ties.iter().enumerate().filter(|(_, t)| inner(t));
        let alone: Vec<(Option<usize>, Vec<usize>)> =
            alone.map(|(i, t)| (t.base, vec![i])).collect();
        walk.blocks.extend(alone);
        let blocks: Vec<Block> = walk
            .blocks
            .into_iter()
            .map(|(root, ties)| Block::new(model, root, ties))
            .collect();
        let home = |u: usize| blocks.iter().position(|b| b.units.contains(&u));
        Self {
            home: (0..model.units)
                .map(|u| home(u).unwrap_or(usize::MAX))
                .collect(),
            blocks,
        }
    }

    /// The unit of a block by which a unit of the island is carried along when the block moves, by its place in
    /// the block; none where it stands still.
    pub(super) fn carried(&self, block: usize, unit: Option<usize>) -> Option<usize> {
        let mut at = unit;
        // Each turn of the loop is one block nearer to the ground.
        for _ in 0..=self.home.len() {
            let home = *self.home.get(at?)?;
            let here = self.blocks.get(home)?;
            if home == block {
                return here.units.iter().position(|u| Some(*u) == at);
            }
            at = here.root;
        }
        None
    }

    /// The blocks that carry a unit, the nearest first.
    pub(super) fn above(&self, unit: Option<usize>) -> Vec<usize> {
        let mut out = Vec::new();
        let mut at = unit;
        while let Some(home) = at.and_then(|u| self.home.get(u)) {
            if out.contains(home) {
                break;
            }
            out.push(*home);
            at = self.blocks.get(*home).and_then(|b| b.root);
        }
        out
    }

    /// A motion of a block as one of the island.
    pub(super) fn lifted(&self, block: usize, motion: &DVector<f64>) -> DVector<f64> {
        let mut out = DVector::zeros(6 * self.home.len());
        for u in 0..self.home.len() {
            let twist = twist_of(motion, self.carried(block, Some(u)));
            out.fixed_rows_mut::<6>(6 * u).copy_from(&twist);
        }
        out
    }
}

impl Block {
    fn new(model: &Model, root: Option<usize>, mut ties: Vec<usize>) -> Self {
        ties.sort_unstable();
        let of = |i: &usize| model.ties.get(*i);
        let ends = ties
            .iter()
            .filter_map(of)
            .flat_map(|t| [t.base, t.incoming]);
        let mut units: Vec<usize> = ends.filter(|u| *u != root).flatten().collect();
        units.sort_unstable();
        units.dedup();
        let place = |u: Option<usize>| units.iter().position(|x| Some(*x) == u);
        let own = ties.iter().filter_map(of).map(|t| Tie {
            base: place(t.base),
            incoming: place(t.incoming),
            ..t.clone()
        });
        let spin = |u: &usize| model.spins.get(*u).copied().flatten();
        let own = Model {
            ties: own.collect(),
            glue: Vec::new(),
            members: Vec::new(),
            units: units.len(),
            spins: units.iter().map(spin).collect(),
            middle: model.middle,
            length: model.length,
        };
        Self {
            model: own,
            ties,
            units,
            root,
        }
    }

    /// The part that a motion of the island is of this block: its units against the one it hangs on.
    pub(super) fn share(&self, motion: &DVector<f64>) -> DVector<f64> {
        let mut out = DVector::zeros(6 * self.units.len());
        let root = twist_of(motion, self.root);
        for (k, u) in self.units.iter().enumerate() {
            let twist = twist_of(motion, Some(*u)) - root;
            out.fixed_rows_mut::<6>(6 * k).copy_from(&twist);
        }
        out
    }
}

/// A walk in depth over the units, the ground first.
struct Walk<'a> {
    model: &'a Model,
    /// When each unit was found, from 1; the ground is the last entry.
    found: Vec<usize>,
    /// The earliest found unit that links lead back to from it and from those found after it.
    low: Vec<usize>,
    count: usize,
    open: Vec<usize>,
    blocks: Vec<(Option<usize>, Vec<usize>)>,
}

impl Walk<'_> {
    fn slot(&self, unit: Option<usize>) -> usize {
        unit.unwrap_or(self.model.units)
    }

    fn time(&self, unit: Option<usize>) -> usize {
        self.found.get(self.slot(unit)).copied().unwrap_or_default()
    }

    fn lowest(&self, unit: Option<usize>) -> usize {
        self.low.get(self.slot(unit)).copied().unwrap_or_default()
    }

    fn lower(&mut self, unit: Option<usize>, to: usize) {
        let slot = self.slot(unit);
        if let Some(low) = self.low.get_mut(slot) {
            *low = (*low).min(to);
        }
    }

    fn visit(&mut self, here: Option<usize>, by: Option<usize>) {
        self.count += 1;
        let slot = self.slot(here);
        for list in [&mut self.found, &mut self.low] {
            if let Some(entry) = list.get_mut(slot) {
                *entry = self.count;
            }
        }
        for (i, tie) in self.model.ties.iter().enumerate() {
            let other = match (tie.base == here, tie.incoming == here) {
                (true, false) => tie.incoming,
                (false, true) => tie.base,
                _ => continue,
            };
            if Some(i) == by {
                continue;
            }
            if self.time(other) == 0 {
                let start = self.open.len();
                self.open.push(i);
                self.visit(other, Some(i));
                self.lower(here, self.lowest(other));
                if self.lowest(other) >= self.time(here) {
                    self.blocks.push((here, self.open.split_off(start)));
                }
            } else if self.time(other) < self.time(here) {
                self.open.push(i);
                self.lower(here, self.time(other));
            }
        }
    }
}
