//! Which motion drives a part, and how the others are held.

use super::{DriveKind, NoDrive};
use crate::freedom::blocks::{Block, Blocks};
use crate::freedom::island::Island;
use crate::freedom::linear::{Rank, null_space, rank};
use crate::freedom::model::Model;
use crate::freedom::motion::{self, Basis, Driver, STILL};
use crate::freedom::rigid::{Rigid, angular, linear};
use crate::freedom::sparse::Sparse;

/// What carries a part and in which of its motions it goes.
pub(super) struct Choice {
    pub(super) body: usize,
    pub(super) block: usize,
    pub(super) basis: Basis,
    pub(super) motion: usize,
    pub(super) unit: usize,
    pub(super) kind: DriveKind,
}

/// A coordinate that is held by its rate.
#[derive(Debug, Clone, Copy)]
pub(super) enum Held {
    /// A tie, by its index, along one of its free twists.
    Joint(usize, usize),
    /// The spin of a unit about its own axis.
    Spin(usize),
    /// A component of the units' twists.
    Entry(usize),
}

/// The nearest motion that moves a body so: of the first block above it that has one, the one that moves the
/// fewest units; turning before sliding, where nothing is said.
pub(super) fn choose(
    model: &Model,
    blocks: &Blocks,
    body: usize,
    kind: Option<DriveKind>,
) -> Result<Option<Choice>, NoDrive> {
    let unit = model.members.iter().find(|(b, _)| *b == body);
    let unit = unit.and_then(|(_, u)| *u);
    for index in blocks.above(unit) {
        let (Some(block), Some(own)) = (blocks.blocks.get(index), blocks.carried(index, unit))
        else {
            continue;
        };
        let basis = basis_of(block).ok_or(NoDrive::Unknown)?;
        let moves = |motion: &Sparse| {
            let twist = motion.twist(Some(own));
            let most = STILL * motion.amax();
            let found = if angular(&twist).norm() > most {
                DriveKind::Rotate
            } else if linear(&twist).norm() > most {
                DriveKind::Slide
            } else {
                return None;
            };
            let units = motion.groups(6).into_iter();
            let moving = units.filter(|u| motion.twist(Some(*u)).amax() > most);
            kind.is_none_or(|k| k == found)
                .then_some((found, moving.count()))
        };
        let candidates = basis.motions.iter().enumerate();
        let best = candidates
            .filter_map(|(k, m)| moves(m).map(|(found, n)| (found, n, k)))
            .min_by_key(|(found, n, k)| (*found == DriveKind::Slide, *n, *k));
        if let Some((kind, _, motion)) = best {
            return Ok(Some(Choice {
                body,
                block: index,
                unit: own,
                basis,
                motion,
                kind,
            }));
        }
    }
    Ok(None)
}

/// The motions of a block by name; none where their number cannot be told.
fn basis_of(block: &Block) -> Option<Basis> {
    let matrix = block
        .model
        .jacobian(&vec![Rigid::IDENTITY; block.model.units]);
    let rank = rank(&matrix).filter(Rank::is_clear)?;
    let free = null_space(&matrix, rank.rank);
    let free = free.column_iter().map(|c| Sparse::of(c.iter().copied()));
    Some(motion::basis(&block.model, &free.collect::<Vec<_>>()))
}

/// The bodies that any motion moves.
pub(super) fn movable(island: &Island, model: &Model, blocks: &Blocks) -> Vec<usize> {
    let moves = |body: usize| matches!(choose(model, blocks, body, None), Ok(Some(_)));
    let mut out: Vec<usize> = island
        .bodies
        .iter()
        .copied()
        .filter(|b| moves(*b))
        .collect();
    out.sort_unstable();
    out
}

/// A model in which all motions but one are held, by locking their joints; and what is held by its rate, since
/// it is no joint's or the joint cannot be locked so.
pub(super) fn locked(model: &Model, basis: &Basis, keep: usize) -> (Model, Vec<Held>) {
    let (mut out, mut held) = (model.clone(), Vec::new());
    let drivers = basis.drivers.iter().enumerate();
    let drivers: Vec<Driver> = drivers
        .filter(|(k, _)| *k != keep)
        .map(|(_, d)| *d)
        .collect();
    for (index, tie) in out.ties.iter_mut().enumerate() {
        let of = |d: &Driver| match d {
            Driver::Joint(t, twist) if *t == index => Some(*twist),
            _ => None,
        };
        let twists: Vec<usize> = drivers.iter().filter_map(of).collect();
        if twists.is_empty() {
            continue;
        }
        match tie.scaled.locked(&twists) {
            Some(locked) => tie.scaled = locked,
            None => held.extend(twists.into_iter().map(|t| Held::Joint(index, t))),
        }
    }
    held.extend(drivers.iter().filter_map(|d| match d {
        Driver::Joint(..) => None,
        Driver::Spin(unit) => Some(Held::Spin(*unit)),
        Driver::Entry(column) => Some(Held::Entry(*column)),
    }));
    (out, held)
}
