//! What is left between the two bodies of each link in the whole system.

use nalgebra::{DMatrix, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::System;
use super::island::{Island, Model, twist_of};
use super::linear::rank_above;
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
    free: &DMatrix<f64>,
) -> Vec<JointMotion> {
    let links = island.links.iter().filter_map(|l| system.links.get(*l));
    let left = links.zip(&model.links).map(|(link, (base, incoming, _))| {
        let relative: Vec<_> = free
            .column_iter()
            .map(|c| {
                let motion = c.into_owned();
                twist_of(&motion, *incoming) - twist_of(&motion, *base)
            })
            .collect();
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
            mate: link.name.clone(),
            turns: rotations - screws,
            slides,
            screws,
        }
    });
    left.collect()
}
