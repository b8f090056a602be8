//! Rank and null spaces, the same on every machine.

use nalgebra::{DMatrix, SVD};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Singular values below this share of the largest one count as 0. Ours: a thousandth of what a residual at
/// its limit (1e-6 mm on a part of 10 mm) would make, and far above the rounding of a chain of placements.
pub const RANK_TOLERANCE: f64 = 1e-7;

/// The largest singular value that counts as 0 must be this much smaller than the smallest that does not.
/// Nearer to each other they do not tell a rank. Ours.
pub const LARGEST_GAP: f64 = 1e-3;

/// Steps after which a decomposition counts as failed.
pub(super) const MOST_STEPS: usize = 100_000;

/// A rank and how clearly it stands out. Of blocks of more than twenty bodies pivots stand for singular values.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Rank {
    /// How many rows are independent.
    pub rank: usize,
    /// The largest singular value that counts as 0, as a share of the largest of all.
    pub largest_zero: f64,
    /// The smallest singular value that does not, as a share of the largest of all; 1 where there is none.
    pub smallest_counted: f64,
}

impl Rank {
    /// Whether the gap between the two is wide enough to tell the rank.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        self.largest_zero <= LARGEST_GAP * self.smallest_counted
    }
}

impl Rank {
    /// As it is reported: the last digits of singular values depend on the processor.
    pub(super) fn reported(self) -> Self {
        let digits = |x: f64| format!("{x:.2e}").parse().unwrap_or(x);
        Self {
            largest_zero: if self.largest_zero < 1e-12 {
                0.0
            } else {
                digits(self.largest_zero)
            },
            smallest_counted: digits(self.smallest_counted),
            ..self
        }
    }
}

/// Beyond so many columns a wide matrix is made square first, which keeps its singular values.
const WIDE: usize = 64;

/// The rank; none where a number is not finite or the decomposition does not end.
pub(super) fn rank(a: &DMatrix<f64>) -> Option<Rank> {
    let mut found = Rank {
        rank: 0,
        largest_zero: 0.0,
        smallest_counted: 1.0,
    };
    if a.is_empty() {
        return Some(found);
    }
    if a.iter().any(|x| !x.is_finite()) {
        return None;
    }
    let (m, n) = a.shape();
    let a = if n > WIDE && n > 4 * m {
        a.transpose().qr().r()
    } else {
        a.clone()
    };
    let values = SVD::try_new(a, false, false, f64::EPSILON, MOST_STEPS)?.singular_values;
    let largest = values.max();
    if largest == 0.0 {
        return Some(found);
    }
    for share in values.iter().map(|v| v / largest) {
        if share > RANK_TOLERANCE {
            found.rank += 1;
            found.smallest_counted = found.smallest_counted.min(share);
        } else {
            found.largest_zero = found.largest_zero.max(share);
        }
    }
    Some(found)
}

/// The rank of a matrix whose entries are about 1 or mere rounding: a 1 of its own beside it keeps the latter
/// from being counted.
pub(super) fn rank_above(a: &DMatrix<f64>) -> usize {
    let (m, n) = a.shape();
    let mut beside = DMatrix::zeros(m + 1, n + 1);
    beside.view_mut((0, 0), (m, n)).copy_from(a);
    set(&mut beside, m, n, 1.0);
    rank(&beside).map_or(n, |r| r.rank.saturating_sub(1))
}

/// A basis of what a matrix of known rank takes to 0, as columns: elimination with the largest entry left as
/// pivot (the first of equals), then one column for each unknown that was no pivot, in their order.
pub(super) fn null_space(a: &DMatrix<f64>, rank: usize) -> DMatrix<f64> {
    null_space_by(a, rank).1
}

/// The same, and which unknown is 1 in each column and 0 in the others.
pub(super) fn null_space_by(a: &DMatrix<f64>, rank: usize) -> (Vec<usize>, DMatrix<f64>) {
    let (mut a, n) = (a.clone(), a.ncols());
    let rank = rank.min(a.nrows()).min(n);
    let mut columns: Vec<usize> = (0..n).collect();
    for k in 0..rank {
        let (mut row, mut col, mut most) = (k, k, -1.0);
        for (j, column) in a.column_iter().enumerate().skip(k) {
            for (i, entry) in column.iter().enumerate().skip(k) {
                // The margin keeps rounding from choosing between equals.
                if entry.abs() > most * (1.0 + 1e-9) {
                    (row, col, most) = (i, j, entry.abs());
                }
            }
        }
        a.swap_rows(k, row);
        a.swap_columns(k, col);
        columns.swap(k, col);
        let pivot = a.row(k) / at(&a, k, k);
        a.set_row(k, &pivot);
        for i in (0..a.nrows()).filter(|i| *i != k) {
            let by = at(&a, i, k);
            if by != 0.0 {
                let mut row = a.row_mut(i);
                row -= &pivot * by;
            }
        }
    }
    let mut free: Vec<(usize, usize)> = columns.iter().copied().zip(0..n).skip(rank).collect();
    free.sort_unstable();
    let mut out = DMatrix::zeros(n, n - rank);
    for (c, (unknown, column)) in free.iter().enumerate() {
        set(&mut out, *unknown, c, 1.0);
        for (k, pivot) in columns.iter().take(rank).enumerate() {
            set(&mut out, *pivot, c, -at(&a, k, *column));
        }
    }
    (free.into_iter().map(|(unknown, _)| unknown).collect(), out)
}

/// An entry; what is outside the matrix is no number.
pub(super) fn at(a: &DMatrix<f64>, row: usize, column: usize) -> f64 {
    a.get((row, column)).copied().unwrap_or(f64::NAN)
}

pub(super) fn set(a: &mut DMatrix<f64>, row: usize, column: usize, value: f64) {
    if let Some(entry) = a.get_mut((row, column)) {
        *entry = value;
    }
}

/// The orthogonal complement of some vectors, as orthonormal rows: of the unit vectors, again and again the
/// one that stands out most (the first of equals).
pub(super) fn complement(span: &[nalgebra::Vector6<f64>]) -> Vec<nalgebra::Vector6<f64>> {
    let mut basis: Vec<nalgebra::Vector6<f64>> = Vec::new();
    for v in span {
        let left = without(v, &basis);
        if left.norm() > RANK_TOLERANCE * v.norm() {
            basis.push(left.normalize());
        }
    }
    let mut out = Vec::new();
    while basis.len() < 6 {
        let (mut best, mut most) = (nalgebra::Vector6::zeros(), 0.0);
        for i in 0..6 {
            let left = without(&nalgebra::Vector6::ith(i, 1.0), &basis);
            if left.norm() > most * (1.0 + 1e-9) {
                (best, most) = (left, left.norm());
            }
        }
        // Some unit vector is always left while the basis is not full; a vector that is no number is not.
        if most == 0.0 {
            break;
        }
        let unit = best / most;
        basis.push(unit);
        out.push(unit);
    }
    out
}

/// What is left of a vector beside an orthonormal basis. Done twice, which takes the rounding out.
pub(super) fn without(
    v: &nalgebra::Vector6<f64>,
    basis: &[nalgebra::Vector6<f64>],
) -> nalgebra::Vector6<f64> {
    let mut left = *v;
    for _ in 0..2 {
        for b in basis {
            left -= b * b.dot(&left);
        }
    }
    left
}
