//! Constraints that say again what others say.
//!
//! Weights on the rows that add up to nothing (the left null space) are states of stress without a load. A mate
//! takes part where some of its rows have a weight. With `N` those weights and `N_m` their part on the `n` rows
//! of mate `m`, leaving the mate out lowers the rank by `n - rank N_m`: by none where `N_m` has full rank.

use nalgebra::DMatrix;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::System;
use super::island::{Island, Model};
use super::linear::{null_space, rank};

/// A loop of links, or loops that share some, with more constraints than independent ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Redundant {
    /// How many constraints are redundant.
    pub count: usize,
    /// The mates among which they are, by name.
    pub mates: Vec<String>,
    /// How many constraints of each of them something else holds as well, in the same order.
    pub repeated: Vec<usize>,
    /// Those of them that could be left out, each alone, without anything coming free.
    pub dispensable: Vec<String>,
}

/// Weights below this share of the largest one are none.
const NO_WEIGHT: f64 = 1e-9;

pub(super) fn find(
    island: &Island,
    system: &System,
    model: &Model,
    matrix: &DMatrix<f64>,
    of_rank: usize,
) -> Vec<Redundant> {
    let stresses = null_space(&matrix.transpose(), of_rank);
    let name = |l: &usize| system.links.get(*l).map_or("", |l| l.name.as_str());
    // For each link: its name, which stresses it takes part in, whether it can be left out.
    let mut links = Vec::new();
    let mut row = 0;
    for (index, (_, _, link)) in island.links.iter().zip(&model.links) {
        let rows = link.rows();
        let part = stresses.rows(row, rows).into_owned();
        row += rows;
        let taken: Vec<usize> = (0..part.ncols())
            .filter(|c| part.column(*c).amax() > NO_WEIGHT * stresses.column(*c).amax())
            .collect();
        let repeated = rank(&part).map_or(0, |r| r.rank);
        let spare = rows > 0 && repeated == rows;
        links.push((name(index), taken, spare, repeated));
    }
    let mut left: Vec<usize> = (0..stresses.ncols()).collect();
    let mut out = Vec::new();
    while let Some(first) = left.first().copied() {
        let mut group = vec![first];
        loop {
            let before = group.len();
            for (_, taken, _, _) in &links {
                if taken.iter().any(|s| group.contains(s)) {
                    group.extend(
                        taken
                            .iter()
                            .filter(|s| !group.contains(s))
                            .collect::<Vec<_>>(),
                    );
                }
            }
            if group.len() == before {
                break;
            }
        }
        left.retain(|s| !group.contains(s));
        let members = || {
            links
                .iter()
                .filter(|(_, taken, _, _)| taken.iter().any(|s| group.contains(s)))
        };
        out.push(Redundant {
            count: group.len(),
            mates: members().map(|(n, _, _, _)| (*n).to_owned()).collect(),
            repeated: members().map(|(_, _, _, repeated)| *repeated).collect(),
            dispensable: members()
                .filter(|(_, _, spare, _)| *spare)
                .map(|(n, _, _, _)| (*n).to_owned())
                .collect(),
        });
    }
    out.sort_by(|a, b| a.mates.cmp(&b.mates));
    out
}
