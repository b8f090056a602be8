//! Constraints that say again what others say.
//!
//! Weights on the rows that add up to nothing (the left null space) are states of stress without a load. A mate
//! takes part where some of its rows have a weight. With `N` those weights and `N_m` their part on the `n` rows
//! of mate `m`, leaving the mate out lowers the rank by `n - rank N_m`: by none where `N_m` has full rank.

use nalgebra::DMatrix;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::System;
use super::island::Island;
use super::linear::rank;
use super::model::Model;
use super::rigid::Rigid;

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
    stresses: &DMatrix<f64>,
) -> Vec<Redundant> {
    let name = |l: &usize| system.links.get(*l).map_or("", |l| l.name.as_str());
    // For each link: its name, which stresses it takes part in, whether it can be left out.
    let mut links = Vec::new();
    let mut parts: Vec<(usize, DMatrix<f64>)> = in_glue(system, model, stresses);
    let mut row = 0;
    for tie in &model.ties {
        let rows = tie.scaled.rows();
        parts.push((tie.link, stresses.rows(row, rows).into_owned()));
        row += rows;
    }
    parts.sort_by_key(|(link, _)| island.links.iter().position(|l| l == link));
    for (index, part) in &parts {
        let rows = part.nrows();
        let taken: Vec<usize> = (0..part.ncols())
            .filter(|c| part.column(*c).amax() > NO_WEIGHT * stresses.column(*c).amax())
            .collect();
        let repeated = rank(part).map_or(0, |r| r.rank);
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

/// The wrenches that the links inside units carry in each stress: what they have to so that each body is in
/// balance. They make trees, so that balance alone tells it, from the leaves inward.
fn in_glue(system: &System, model: &Model, stresses: &DMatrix<f64>) -> Vec<(usize, DMatrix<f64>)> {
    let none = || DMatrix::<f64>::zeros(6, stresses.ncols());
    // What the ties do on each body.
    let mut load: Vec<DMatrix<f64>> = system.bodies.iter().map(|_| none()).collect();
    let mut row = 0;
    for tie in &model.ties {
        let Some(link) = system.links.get(tie.link) else {
            continue;
        };
        let still = Rigid::IDENTITY;
        for w in tie.scaled.jacobian(&still, &still) {
            let on = w * stresses.row(row);
            if let Some(l) = load.get_mut(link.incoming) {
                *l += &on;
            }
            if let Some(l) = load.get_mut(link.base) {
                *l -= &on;
            }
            row += 1;
        }
    }
    let ends = |l: &usize| system.links.get(*l).map(|l| [l.base, l.incoming]);
    let mut left = model.glue.clone();
    let mut out = Vec::new();
    while !left.is_empty() {
        let mut uses = vec![0usize; system.bodies.len()];
        for body in left.iter().filter_map(ends).flatten() {
            if let Some(n) = uses.get_mut(body) {
                *n += 1;
            }
        }
        // The ground takes any load, and is never the leaf.
        let leaf = |l: &usize| {
            let mut two = ends(l)?.into_iter();
            two.find(|b| uses.get(*b) == Some(&1) && model.members.iter().any(|(m, _)| m == b))
        };
        let found = left
            .iter()
            .enumerate()
            .find_map(|(i, l)| Some((i, *l, leaf(l)?, ends(l)?)));
        let Some((i, link, leaf, ends)) = found else {
            break;
        };
        left.remove(i);
        let on = load.get(leaf).cloned().unwrap_or_else(none);
        for other in ends.into_iter().filter(|b| *b != leaf) {
            if let Some(l) = load.get_mut(other) {
                *l += &on;
            }
        }
        out.push((link, on));
    }
    out
}
