//! A basis of the free motions in which each has a name.
//!
//! The basis is the null space's reduced echelon form over these coordinates, in this order: the spins of bodies
//! about their own axes; the rates of the links along what they leave free, links nearest to the ground first,
//! then by name; the bodies' twists. Each motion then has one coordinate, its driver, at 1, at which all others
//! stand still: a chain of joints comes out joint by joint, a mechanism as driven by its joint at the ground.

use nalgebra::{DMatrix, DVector};

use super::linear::{null_space, rank_above};
use super::model::{Model, Tie, twist_of};
use super::rigid::angular;

/// Free motions as twists of all moving bodies, in the island's units.
pub(super) struct Basis {
    pub(super) motions: Vec<DVector<f64>>,
    /// How many of them, the first ones, are idle spins.
    pub(super) idle: usize,
    /// Of each motion the coordinate that is 1 in it and 0 in all others.
    pub(super) drivers: Vec<Driver>,
}

/// A coordinate that stands for a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Driver {
    /// The spin of a unit about its own axis.
    Spin(usize),
    /// The rate of a tie, by its index, along one of its free twists.
    Joint(usize, usize),
    /// A component of a unit's twist.
    Entry(usize),
}

impl Driver {
    /// Whether it is a travel.
    pub(super) fn travels(self, model: &Model) -> bool {
        match self {
            Self::Spin(_) => false,
            Self::Joint(tie, k) => {
                let tie = model.ties.get(tie);
                let twist = tie.and_then(|t| t.scaled.free().get(k));
                twist.is_some_and(|t| angular(t).norm() == 0.0)
            }
            Self::Entry(row) => row % 6 >= 3,
        }
    }
}

/// A driver's rate below this share of the fastest coordinate leads to another choice of driver.
const SLOW: f64 = 1e-3;
/// Below this share of the largest component a body stands still.
pub(super) const STILL: f64 = 1e-7;

pub(super) fn basis(model: &Model, matrix: &DMatrix<f64>, free: &DMatrix<f64>) -> Basis {
    let mut left: Vec<DVector<f64>> = free
        .column_iter()
        .map(|c| c.into_owned() / c.amax().max(f64::MIN_POSITIVE))
        .collect();
    let mut out = Basis {
        motions: idle(model, matrix),
        idle: 0,
        drivers: Vec::new(),
    };
    out.idle = out.motions.len();
    for k in 0..out.idle {
        let Some(mut v) = out.motions.get(k).cloned() else {
            break;
        };
        let pivot = v.iamax();
        v /= entry(&v, pivot);
        out.drivers.push(Driver::Spin(pivot / 6));
        let others = out.motions.iter_mut().enumerate().filter(|(i, _)| *i != k);
        for other in others.map(|(_, o)| o).chain(&mut left) {
            let by = entry(other, pivot);
            *other -= &v * by;
        }
        if let Some(slot) = out.motions.get_mut(k) {
            *slot = v;
        }
    }
    let with_rates = |v: DVector<f64>| (coordinates(model, &v), v);
    let mut left: Vec<(DVector<f64>, DVector<f64>)> = left.into_iter().map(with_rates).collect();
    let mut chosen: Vec<(DVector<f64>, DVector<f64>)> = Vec::new();
    for slow in [SLOW, STILL] {
        let mut row = 0;
        while out.idle + chosen.len() < free.ncols() {
            if left.iter().all(|(rates, _)| row >= rates.len()) {
                break;
            }
            let mut best: Option<(usize, f64)> = None;
            for (i, (rates, v)) in left.iter().enumerate() {
                let rate = entry(rates, row).abs();
                let most = best.map_or(0.0, |(_, b)| b);
                if rate > most * (1.0 + 1e-9) && rate > slow * rates.amax() && v.amax() > STILL {
                    best = Some((i, rate));
                }
            }
            if let Some((i, _)) = best {
                let (rates, v) = left.remove(i);
                let by = entry(&rates, row);
                let (rates, v) = (rates / by, v / by);
                for (other_rates, other) in left.iter_mut().chain(&mut chosen) {
                    let by = entry(other_rates, row);
                    *other -= &v * by;
                    *other_rates -= &rates * by;
                }
                out.drivers.push(driver(model, row));
                chosen.push((rates, v));
            }
            row += 1;
        }
    }
    out.motions.extend(chosen.into_iter().map(|(_, v)| v));
    out
}

/// Motions in which bodies turn about axes of their own and nothing else moves.
fn idle(model: &Model, matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    let mut spins = Vec::new();
    for (i, spin) in model.spins.iter().enumerate() {
        if let Some(spin) = spin {
            let mut v = DVector::zeros(model.columns());
            v.fixed_rows_mut::<6>(6 * i).copy_from(spin);
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

/// The ties and their indices, by their farther body as found from the ground, then by name.
fn order(model: &Model) -> Vec<(usize, &Tie)> {
    let mut order: Vec<(usize, &Tie)> = model.ties.iter().enumerate().collect();
    order.sort_by_key(|(_, t)| t.far);
    order
}

/// The coordinates of a motion, in the order in which they are chosen as drivers.
fn coordinates(model: &Model, motion: &DVector<f64>) -> DVector<f64> {
    let mut out = Vec::new();
    for (_, tie) in order(model) {
        let relative = twist_of(motion, tie.incoming) - twist_of(motion, tie.base);
        out.extend(tie.scaled.rates(&relative));
    }
    out.extend(motion.iter());
    DVector::from_vec(out)
}

fn entry(v: &DVector<f64>, i: usize) -> f64 {
    v.get(i).copied().unwrap_or(f64::NAN)
}

/// What a coordinate is, by its place among them.
fn driver(model: &Model, mut row: usize) -> Driver {
    for (index, tie) in order(model) {
        let free = tie.scaled.free().len();
        if row < free {
            return Driver::Joint(index, row);
        }
        row -= free;
    }
    Driver::Entry(row)
}
