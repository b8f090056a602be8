//! What is left between the two bodies of each link in the whole system.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, Vector3, Vector6};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::System;
use super::blocks::Blocks;
use super::island::Island;
use super::linear::rank_above;
use super::model::Model;
use super::rigid::{angular, linear};
use super::sparse::{Sparse, Touching};

/// The motion that is left between the two parts of a mate. Two or more rotations are told as turns.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct JointMotion {
    /// The mate.
    pub mate: String,
    /// Independent rotations without travel.
    pub turns: usize,
    /// Independent translations.
    pub slides: usize,
    /// Independent screw motions.
    pub screws: usize,
}

/// Travel by turn below this share of the characteristic length is none.
const NO_PITCH: f64 = 1e-6;

/// `free`: what each block's rows leave free.
pub(super) fn find(
    island: &Island,
    system: &System,
    model: &Model,
    blocks: &Blocks,
    free: &[&[Sparse]],
) -> Vec<JointMotion> {
    let name = |link: usize| system.links.get(link).map_or("", |l| l.name.as_str());
    let mut moving: BTreeMap<usize, JointMotion> = BTreeMap::new();
    for (block, free) in blocks.blocks.iter().zip(free) {
        let mut touching = Touching::new(block.model.units, 6, free);
        for tie in block.ties.iter().filter_map(|t| model.ties.get(*t)) {
            let (base, incoming) = (block.place(tie.base), block.place(tie.incoming));
            let mut both: Vec<usize> = [base, incoming]
                .into_iter()
                .flatten()
                .flat_map(|u| touching.of(u))
                .collect();
            both.sort_unstable();
            both.dedup();
            let motions = both.into_iter().filter_map(|k| free.get(k));
            let relative = motions.map(|m| m.twist(incoming) - m.twist(base));
            let relative: Vec<Vector6<f64>> = relative.filter(|t| t.amax() > 0.0).collect();
            if !relative.is_empty() {
                moving.insert(tie.link, motion_in(name(tie.link), &relative));
            }
        }
    }
    let each = island.links.iter();
    each.map(|l| moving.remove(l).unwrap_or_else(|| none(name(*l))))
        .collect()
}

/// What nothing lets move.
fn none(mate: &str) -> JointMotion {
    JointMotion {
        mate: mate.to_owned(),
        turns: 0,
        slides: 0,
        screws: 0,
    }
}

fn motion_in(mate: &str, relative: &[Vector6<f64>]) -> JointMotion {
    let matrix = |rows: usize| {
        DMatrix::from_fn(rows, relative.len(), |i, j| {
            let entry = relative.get(j).and_then(|t| t.get(i));
            entry.copied().unwrap_or_default()
        })
    };
    let (all, rotations) = (rank_above(&matrix(6)), rank_above(&matrix(3)));
    let slides = all.saturating_sub(rotations);
    // One rotation is a screw where nothing slides along it alone and it travels.
    let travels = relative.iter().any(|t| {
        let (turn, slide): (Vector3<f64>, Vector3<f64>) = (angular(t), linear(t));
        turn.dot(&slide).abs() > NO_PITCH * turn.norm_squared().max(NO_PITCH)
    });
    let screws = usize::from(rotations == 1 && slides == 0 && travels);
    JointMotion {
        turns: rotations - screws,
        slides,
        screws,
        ..none(mate)
    }
}
