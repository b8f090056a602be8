//! An island in blocks: sets of units that have no more than one unit in common with the rest.
//!
//! What a block's links hold and leave is a matter of its units against each other, so that its motions and its
//! redundant constraints are its own: ranks, null spaces and finite steps add up over blocks. The blocks are the
//! biconnected components of the graph of units and links (Tarjan, *Depth-first search and linear graph
//! algorithms*, SIAM Journal on Computing 1, 1972).

use super::model::{Model, Tie};
use super::sparse::Sparse;

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
    /// For each unit the blocks that hang on it.
    hanging: Vec<Vec<usize>>,
}

impl Blocks {
    pub(super) fn new(model: &Model) -> Self {
        let mut walk = Walk::new(model);
        walk.go();
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
        let mut home = vec![usize::MAX; model.units];
        let mut hanging = vec![Vec::new(); model.units];
        for (k, block) in blocks.iter().enumerate() {
            for u in &block.units {
                if let Some(slot) = home.get_mut(*u) {
                    *slot = k;
                }
            }
            if let Some(list) = block.root.and_then(|u| hanging.get_mut(u)) {
                list.push(k);
            }
        }
        Self {
            home,
            hanging,
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
                return here.place(at);
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
    pub(super) fn lifted(&self, block: usize, motion: &Sparse) -> Sparse {
        let mut moved = Vec::new();
        let units = self.blocks.get(block).map(|b| b.units.as_slice());
        for place in motion.groups(6) {
            let Some(unit) = units.and_then(|u| u.get(place)) else {
                continue;
            };
            let twist = motion.twist(Some(place));
            // The unit, and all that hangs on it, and so on.
            let mut carried = vec![*unit];
            while let Some(unit) = carried.pop() {
                moved.push((unit, twist));
                let hanging = self.hanging.get(unit).into_iter().flatten();
                let blocks = hanging.filter_map(|k| self.blocks.get(*k));
                carried.extend(blocks.flat_map(|b| &b.units));
            }
        }
        moved.sort_by_key(|(unit, _)| *unit);
        let mut out = Sparse::default();
        for (unit, twist) in &moved {
            out.push_twist(*unit, twist);
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
        let place = |u: Option<usize>| units.binary_search(&u?).ok();
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
            bodies: Vec::new(),
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

    /// Where a unit of the island is among the units; none for the one that it hangs on.
    pub(super) fn place(&self, unit: Option<usize>) -> Option<usize> {
        self.units.binary_search(&unit?).ok()
    }

    /// The part that a motion of the island is of this block: its units against the one it hangs on.
    pub(super) fn share(&self, motion: &Sparse) -> Sparse {
        let mut out = Sparse::default();
        let root = motion.twist(self.root);
        for (k, u) in self.units.iter().enumerate() {
            out.push_twist(k, &(motion.twist(Some(*u)) - root));
        }
        out
    }
}

/// A walk in depth over the units, the ground first.
struct Walk {
    /// For each unit, the ground last, its ties and the units at their other ends.
    of: Vec<Vec<(usize, usize)>>,
    /// When each unit was found, from 1.
    found: Vec<usize>,
    /// The earliest found unit that links lead back to from it and from those found after it.
    low: Vec<usize>,
    count: usize,
    open: Vec<usize>,
    blocks: Vec<(Option<usize>, Vec<usize>)>,
}

/// A unit on the way: which of its ties comes next, by which tie it was found, and how many ties were open then.
struct Step {
    unit: usize,
    next: usize,
    by: Option<usize>,
    open: usize,
}

impl Walk {
    fn new(model: &Model) -> Self {
        let n = model.units + 1;
        let mut of = vec![Vec::new(); n];
        for (i, tie) in model.ties.iter().enumerate() {
            let [a, b] = [tie.base, tie.incoming].map(|u| u.unwrap_or(model.units));
            for (one, other) in [(a, b), (b, a)] {
                if a != b
                    && let Some(list) = of.get_mut(one)
                {
                    list.push((i, other));
                }
            }
        }
        Self {
            of,
            found: vec![0; n],
            low: vec![0; n],
            count: 0,
            open: Vec::new(),
            blocks: Vec::new(),
        }
    }

    fn time(&self, unit: usize) -> usize {
        self.found.get(unit).copied().unwrap_or_default()
    }

    fn lowest(&self, unit: usize) -> usize {
        self.low.get(unit).copied().unwrap_or_default()
    }

    fn lower(&mut self, unit: usize, to: usize) {
        if let Some(low) = self.low.get_mut(unit) {
            *low = (*low).min(to);
        }
    }

    fn find(&mut self, unit: usize, by: Option<usize>, open: usize) -> Step {
        self.count += 1;
        for list in [&mut self.found, &mut self.low] {
            if let Some(entry) = list.get_mut(unit) {
                *entry = self.count;
            }
        }
        Step {
            unit,
            next: 0,
            by,
            open,
        }
    }

    /// All of it, without a call for each unit on the way: chains may be long.
    fn go(&mut self) {
        let ground = self.of.len() - 1;
        let mut way = vec![self.find(ground, None, 0)];
        while let Some(step) = way.last_mut() {
            let (here, by) = (step.unit, step.by);
            let next = self.of.get(here).and_then(|l| l.get(step.next)).copied();
            step.next += 1;
            match next {
                Some((tie, _)) if Some(tie) == by => {}
                Some((tie, other)) if self.time(other) == 0 => {
                    let start = self.open.len();
                    self.open.push(tie);
                    let found = self.find(other, Some(tie), start);
                    way.push(found);
                }
                Some((tie, other)) if self.time(other) < self.time(here) => {
                    self.open.push(tie);
                    self.lower(here, self.time(other));
                }
                Some(_) => {}
                None => {
                    let start = step.open;
                    way.pop();
                    if let Some(above) = way.last().map(|s| s.unit) {
                        self.lower(above, self.lowest(here));
                        if self.lowest(here) >= self.time(above) {
                            let root = (above != ground).then_some(above);
                            self.blocks.push((root, self.open.split_off(start)));
                        }
                    }
                }
            }
        }
    }
}
