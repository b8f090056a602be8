//! A basis of the free motions in which each has a name.
//!
//! The basis is the null space's reduced echelon form over these coordinates, in this order: the spins of bodies
//! about their own axes; the rates of the links along what they leave free, links nearest to the ground first,
//! then by name; the bodies' twists. Each motion then has one coordinate, its driver, at 1, at which all others
//! stand still: a chain of joints comes out joint by joint, a mechanism as driven by its joint at the ground.

use nalgebra::{DMatrix, DVector, Vector3};

use super::System;
use super::island::{Model, twist_of};
use super::linear::{null_space, rank_above};
use super::rigid::{angular, stack};

/// Free motions as twists of all moving bodies, in the island's units.
pub(super) struct Basis {
    pub(super) motions: Vec<DVector<f64>>,
    /// How many of them, the first ones, are idle spins.
    pub(super) idle: usize,
    /// Whether a motion's driver is a travel.
    pub(super) travels: Vec<bool>,
}

/// A driver's rate below this share of the fastest coordinate leads to another choice of driver.
const SLOW: f64 = 1e-3;
/// Below this share of the largest component a body stands still.
pub(super) const STILL: f64 = 1e-7;

pub(super) fn basis(
    model: &Model,
    system: &System,
    matrix: &DMatrix<f64>,
    free: &DMatrix<f64>,
) -> Basis {
    let mut left: Vec<DVector<f64>> = free
        .column_iter()
        .map(|c| c.into_owned() / c.amax().max(f64::MIN_POSITIVE))
        .collect();
    let mut out = Basis {
        motions: idle(model, system, matrix),
        idle: 0,
        travels: Vec::new(),
    };
    out.idle = out.motions.len();
    out.travels = vec![false; out.idle];
    for k in 0..out.idle {
        let Some(mut v) = out.motions.get(k).cloned() else {
            break;
        };
        let pivot = v.iamax();
        v /= entry(&v, pivot);
        let others = out.motions.iter_mut().enumerate().filter(|(i, _)| *i != k);
        for other in others.map(|(_, o)| o).chain(&mut left) {
            let by = entry(other, pivot);
            *other -= &v * by;
        }
        if let Some(slot) = out.motions.get_mut(k) {
            *slot = v;
        }
    }
    for slow in [SLOW, STILL] {
        let mut row = 0;
        while out.motions.len() < free.ncols() {
            let rates: Vec<DVector<f64>> = left.iter().map(|v| coordinates(model, v)).collect();
            if rates.iter().all(|r| row >= r.len()) {
                break;
            }
            let mut best: Option<(usize, f64)> = None;
            for (i, (rate, v)) in rates.iter().zip(&left).enumerate() {
                let fast = entry(rate, row).abs() > slow * rate.amax() && v.amax() > STILL;
                let most = best.map_or(0.0, |(_, b)| b);
                if fast && entry(rate, row).abs() > most * (1.0 + 1e-9) {
                    best = Some((i, entry(rate, row).abs()));
                }
            }
            if let Some((i, _)) = best {
                let by = rates.get(i).map_or(1.0, |r| entry(r, row));
                let v = left.remove(i) / by;
                let own = entry(&coordinates(model, &v), row);
                let clear = |other: &mut DVector<f64>| {
                    let by = entry(&coordinates(model, other), row) / own;
                    *other -= &v * by;
                };
                left.iter_mut().for_each(clear);
                out.motions.iter_mut().skip(out.idle).for_each(clear);
                out.travels.push(travel(model, row));
                out.motions.push(v);
            }
            row += 1;
        }
    }
    out
}

/// Motions in which bodies turn about axes of their own and nothing else moves.
fn idle(model: &Model, system: &System, matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    let mut spins = Vec::new();
    for (i, body) in model.moving.iter().enumerate() {
        if let Some(axis) = system.bodies.get(*body).and_then(|b| b.spin) {
            let (p, d) = (Vector3::from(axis.point), Vector3::from(axis.direction));
            let p = (p - model.middle) / model.length;
            let mut v = DVector::zeros(model.columns());
            v.fixed_rows_mut::<6>(6 * i)
                .copy_from(&stack(&d, &p.cross(&d)));
            spins.push(v);
        }
    }
    if spins.is_empty() {
        return spins;
    }
    let spins = DMatrix::from_columns(&spins);
    let work = matrix * &spins;
    let held = rank_above(&work);
    let free = spins * null_space(&work, held);
    free.column_iter().map(|c| c.into_owned()).collect()
}

/// The order of the links: by their farther body as found from the ground, then by name.
fn order(model: &Model) -> Vec<usize> {
    let mut order: Vec<usize> = (0..model.links.len()).collect();
    order.sort_by_key(|l| model.links.get(*l).map(|(a, b, _)| (*a).max(*b)));
    order
}

/// The coordinates of a motion, in the order in which they are chosen as drivers.
fn coordinates(model: &Model, motion: &DVector<f64>) -> DVector<f64> {
    let mut out = Vec::new();
    for l in order(model) {
        if let Some((base, incoming, link)) = model.links.get(l) {
            out.extend(link.rates(&(twist_of(motion, *incoming) - twist_of(motion, *base))));
        }
    }
    out.extend(motion.iter());
    DVector::from_vec(out)
}

fn entry(v: &DVector<f64>, i: usize) -> f64 {
    v.get(i).copied().unwrap_or(f64::NAN)
}

/// Whether a coordinate is a travel.
fn travel(model: &Model, mut row: usize) -> bool {
    for l in order(model) {
        if let Some((_, _, link)) = model.links.get(l) {
            let free = link.free();
            match free.get(row) {
                Some(t) => return angular(t).norm() == 0.0,
                None => row -= free.len(),
            }
        }
    }
    row % 6 >= 3
}
