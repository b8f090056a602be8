//! Constraints that say again what others say.
//!
//! Weights on the rows that add up to nothing (the left null space) are states of stress without a load. A mate
//! takes part where some of its rows have a weight. With `N` those weights and `N_m` their part on the `n` rows
//! of mate `m`, leaving the mate out lowers the rank by `n - rank N_m`: by none where `N_m` has full rank.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, Vector6};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::System;
use super::island::Island;
use super::linear::rank;
use super::model::Model;
use super::rigid::Rigid;
use super::sparse::Sparse;

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

/// The parts that stresses have on links: by link, which stress, and its weights or its wrench.
type Parts = BTreeMap<usize, Vec<(usize, Vec<f64>)>>;

pub(super) fn find(
    island: &Island,
    system: &System,
    model: &Model,
    stresses: &[Sparse],
) -> Vec<Redundant> {
    let name = |l: usize| system.links.get(l).map_or("", |l| l.name.as_str());
    let most: Vec<f64> = stresses.iter().map(Sparse::amax).collect();
    let mut parts = in_ties(model, stresses);
    parts.extend(in_glue(island, system, model, stresses, &most));
    // Stresses that some link takes part in together.
    let mut groups: Vec<usize> = (0..stresses.len()).collect();
    let mut links = Vec::new();
    for link in &island.links {
        let Some(part) = parts.remove(link) else {
            continue;
        };
        let weighs = |(s, on): &&(usize, Vec<f64>)| {
            let least = NO_WEIGHT * most.get(*s).copied().unwrap_or_default();
            on.iter().any(|x| x.abs() > least)
        };
        let taken: Vec<usize> = part.iter().filter(weighs).map(|(s, _)| *s).collect();
        let Some(first) = taken.first().copied() else {
            continue;
        };
        for s in taken {
            let (a, b) = (root(&groups, first), root(&groups, s));
            for of in [a.max(b), s] {
                if let Some(slot) = groups.get_mut(of) {
                    *slot = a.min(b);
                }
            }
        }
        let rows = part.first().map_or(0, |(_, on)| on.len());
        let matrix =
            DMatrix::from_iterator(rows, part.len(), part.iter().flat_map(|p| &p.1).copied());
        let repeated = rank(&matrix).map_or(0, |r| r.rank);
        links.push((name(*link), first, rows > 0 && repeated == rows, repeated));
    }
    let mut found: BTreeMap<usize, Redundant> = BTreeMap::new();
    for s in 0..stresses.len() {
        let group = found.entry(root(&groups, s)).or_insert_with(|| Redundant {
            count: 0,
            mates: Vec::new(),
            repeated: Vec::new(),
            dispensable: Vec::new(),
        });
        group.count += 1;
    }
    for (name, stress, spare, repeated) in links {
        if let Some(group) = found.get_mut(&root(&groups, stress)) {
            group.mates.push(name.to_owned());
            group.repeated.push(repeated);
            if spare {
                group.dispensable.push(name.to_owned());
            }
        }
    }
    let mut out: Vec<Redundant> = found.into_values().collect();
    out.sort_by(|a, b| a.mates.cmp(&b.mates));
    out
}

/// The first of the stresses that go together with one.
fn root(groups: &[usize], of: usize) -> usize {
    let mut at = of;
    while let Some(up) = groups.get(at).filter(|up| **up != at) {
        at = *up;
    }
    at
}

/// The weights on the rows of each tie.
fn in_ties(model: &Model, stresses: &[Sparse]) -> Parts {
    let mut place = Vec::new();
    for (tie, t) in model.ties.iter().enumerate() {
        place.extend((0..t.scaled.rows()).map(|k| (tie, k)));
    }
    let mut out = Parts::new();
    for (s, stress) in stresses.iter().enumerate() {
        for (row, x) in stress.entries() {
            let at = place.get(*row);
            let Some((tie, k)) = at.and_then(|(t, k)| Some((model.ties.get(*t)?, *k))) else {
                continue;
            };
            let of = out.entry(tie.link).or_default();
            if of.last().is_none_or(|(last, _)| *last != s) {
                of.push((s, vec![0.0; tie.scaled.rows()]));
            }
            if let Some(slot) = of.last_mut().and_then(|(_, on)| on.get_mut(k)) {
                *slot = *x;
            }
        }
    }
    out
}

/// The wrenches that the links inside units carry in each stress: what they have to so that each body is in
/// balance. They make trees, so that balance alone tells it, from the leaves inward.
fn in_glue(
    island: &Island,
    system: &System,
    model: &Model,
    stresses: &[Sparse],
    most: &[f64],
) -> Parts {
    let mut out = Parts::new();
    if model.glue.is_empty() || stresses.is_empty() {
        return out;
    }
    let trees = Trees::new(island, system, model);
    // What each row does on the tie's two bodies.
    let still = Rigid::IDENTITY;
    let mut rows = Vec::new();
    for tie in &model.ties {
        let ends = system.links.get(tie.link).map(|l| (l.base, l.incoming));
        let wrenches = tie.scaled.jacobian(&still, &still);
        rows.extend(wrenches.into_iter().map(|w| (ends, w)));
    }
    for (s, (stress, most)) in stresses.iter().zip(most).enumerate() {
        // The loads on bodies, those that are farthest from the tree's root last.
        let mut load: BTreeMap<(usize, usize), Vector6<f64>> = BTreeMap::new();
        for (row, x) in stress.entries() {
            let Some((Some((base, incoming)), w)) = rows.get(*row) else {
                continue;
            };
            for (body, on) in [(*incoming, w * *x), (*base, -w * *x)] {
                let depth = trees.depth.get(body).copied().unwrap_or_default();
                *load.entry((depth, body)).or_default() += on;
            }
        }
        while let Some(((depth, body), on)) = load.pop_last() {
            let up = trees.up.get(body).copied().flatten();
            let Some((link, above)) = up.filter(|_| on.amax() > NO_LOAD * most) else {
                continue;
            };
            *load.entry((depth.saturating_sub(1), above)).or_default() += on;
            let part = out.entry(link).or_default();
            part.push((s, on.iter().copied().collect()));
        }
    }
    out
}

/// Loads below this share of a stress' largest weight are rounding.
const NO_LOAD: f64 = 1e-12;

/// The trees that the links inside units make of bodies.
struct Trees {
    /// How far each body is from its tree's root.
    depth: Vec<usize>,
    /// The link towards it, and the body there; none for the root. The ground, which takes any load, is one.
    up: Vec<Option<(usize, usize)>>,
}

impl Trees {
    fn new(island: &Island, system: &System, model: &Model) -> Self {
        let n = system.bodies.len();
        let mut of: Vec<Vec<(usize, usize)>> = vec![Vec::new(); n];
        for (index, link) in model
            .glue
            .iter()
            .filter_map(|l| Some((*l, system.links.get(*l)?)))
        {
            for (one, other) in [(link.base, link.incoming), (link.incoming, link.base)] {
                if let Some(list) = of.get_mut(one) {
                    list.push((index, other));
                }
            }
        }
        let (mut depth, mut up) = (vec![0; n], vec![None; n]);
        let mut seen = vec![false; n];
        for start in &island.bodies {
            let mut open = vec![*start];
            match seen.get_mut(*start) {
                Some(s) if !*s => *s = true,
                _ => continue,
            }
            while let Some(here) = open.pop() {
                let far = depth.get(here).copied().unwrap_or_default() + 1;
                for (link, other) in of.get(here).into_iter().flatten() {
                    match seen.get_mut(*other) {
                        Some(s) if !*s => *s = true,
                        _ => continue,
                    }
                    if let (Some(d), Some(u)) = (depth.get_mut(*other), up.get_mut(*other)) {
                        (*d, *u) = (far, Some((*link, here)));
                    }
                    open.push(*other);
                }
            }
        }
        Self { depth, up }
    }
}
