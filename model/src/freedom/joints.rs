//! What is left between the two bodies of each link in the whole system.

use nalgebra::{DMatrix, DVector, Vector3, Vector6};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::System;
use super::island::Island;
use super::linear::rank_above;
use super::model::{Model, Tie, twist_of};
use super::rigid::{angular, linear};

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

pub(super) fn find(
    island: &Island,
    system: &System,
    model: &Model,
    free: &[DVector<f64>],
) -> Vec<JointMotion> {
    let left = island.links.iter().filter_map(|l| {
        let name = &system.links.get(*l)?.name;
        let tie = model.ties.iter().find(|t| t.link == *l);
        Some(tie.map_or_else(|| none(name), |tie| motion_in(name, tie, free)))
    });
    left.collect()
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

fn motion_in(mate: &str, tie: &Tie, free: &[DVector<f64>]) -> JointMotion {
    let relative = free
        .iter()
        .map(|motion| twist_of(motion, tie.incoming) - twist_of(motion, tie.base));
    let relative: Vec<Vector6<f64>> = relative.filter(|t| t.amax() > 0.0).collect();
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
