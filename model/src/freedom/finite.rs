//! Small finite steps along the free motions.

use nalgebra::{DMatrix, DVector, SVD};

use super::Lasting;
use super::eliminate::eliminate;
use super::linear::{MOST_STEPS, Rank, rank};
use super::model::{Model, twist_of};
use super::motion::Basis;
use super::rigid::Rigid;
use super::sparse::Sparse;

/// The step, in radians or shares of the characteristic length. Ours: its square, by which a true motion
/// bends, is far below it, and its cube far above rounding.
const STEP: f64 = 1e-3;
/// The steps along one motion.
const SIZES: [f64; 3] = [STEP, -STEP, STEP / 4.0];
/// A true motion strays from its tangent by less than this share of the step.
const TRUE: f64 = 0.05;
/// An instantaneous one by more than this.
const INSTANTANEOUS: f64 = 0.2;
/// Residuals below this count as none.
const NONE: f64 = 1e-13;
/// Singular values below this share of the largest take no part in a correction.
const WEAK: f64 = 1e-8;
/// Corrections after which a step counts as lost.
const MOST_CORRECTIONS: usize = 60;

/// What came of a step.
struct Stepped {
    /// How far from its tangent it ended, as a share of the step.
    strayed: f64,
    /// How far from the start it ended, as a share of the step.
    went: f64,
    /// Free motions there; none where the rank cannot be told.
    freedom: Option<usize>,
}

/// The dimension of the set of poses about this one, by a basis of the motions; none where it cannot be told.
pub(super) fn dimension(model: &Model, basis: &Basis) -> Option<usize> {
    let d = basis.motions.len();
    if d == basis.idle {
        return Some(d);
    }
    if !known(model) {
        return None;
    }
    let dense = basis.motions.iter().map(|m| m.dense(model.columns()));
    let unit: Vec<DVector<f64>> = dense.map(|m| m.normalize()).collect();
    // A direction between all of them, in no simple ratio. Where as many motions are free beyond it, the
    // poses are a smooth set with all of them as tangents. Idle spins go on whatever the rest does: with them
    // a step would lead away from a pose that it only turns in itself.
    let mut mixed = DVector::zeros(model.columns());
    for (i, v) in unit.iter().enumerate().skip(basis.idle) {
        let golden = 0.618_033_988_749_895 * (i as f64 + 1.0);
        mixed += v * (0.5 + golden - libm::floor(golden));
    }
    let first = step(model, &mixed.normalize(), STEP);
    if first
        .as_ref()
        .is_some_and(|s| s.strayed < TRUE && s.freedom == Some(d))
    {
        return Some(d);
    }
    let mut steps = vec![first];
    for v in unit.iter().skip(basis.idle) {
        steps.extend(SIZES.map(|size| step(model, v, size)));
    }
    // Where a step led away from the start, the free motions there are those of a branch of the poses.
    let lost = |s: &Stepped| s.went > INSTANTANEOUS && s.freedom.is_none();
    if steps.iter().any(|s| s.as_ref().is_none_or(lost)) {
        return None;
    }
    let branches = steps.iter().flatten().filter(|s| s.went > INSTANTANEOUS);
    let widest = branches.filter_map(|s| s.freedom).max();
    Some(widest.unwrap_or(basis.idle))
}

/// Whether a motion goes on; standing still does.
pub(super) fn goes_on(model: &Model, motion: &Sparse) -> Lasting {
    if motion.amax() == 0.0 {
        return Lasting::True;
    }
    if !known(model) {
        return Lasting::Indeterminate;
    }
    let unit = motion.dense(model.columns()).normalize();
    let own = SIZES.map(|size| step(model, &unit, size));
    let all = |what: &dyn Fn(&Stepped) -> bool| own.iter().all(|s| s.as_ref().is_some_and(what));
    if all(&|s| s.strayed < TRUE) {
        Lasting::True
    } else if all(&|s| s.strayed > INSTANTANEOUS) {
        Lasting::Instantaneous
    } else {
        Lasting::Indeterminate
    }
}

/// Whether the links say what they allow away from the pose.
fn known(model: &Model) -> bool {
    model.ties.iter().all(|t| t.scaled.is_group())
}

/// A step along a motion, brought back onto the constraints; none where that does not come to an end.
fn step(model: &Model, along: &DVector<f64>, size: f64) -> Option<Stepped> {
    if !model.is_large() {
        return stepped(model, along, size, by_singular_values, rank_of);
    }
    let quick = stepped(model, along, size, by_elimination, rank_by_elimination);
    quick.or_else(|| {
        let few = model.columns() <= MOST_COLUMNS;
        few.then(|| stepped(model, along, size, by_singular_values, rank_of))?
    })
}

/// Up to so many unknowns a step that elimination loses is tried by singular values: some seconds of work.
const MOST_COLUMNS: usize = 300;

/// What brings units that have moved nearer to where the residual is nothing.
type Correction = fn(&Model, &[Rigid], &DVector<f64>) -> Option<DVector<f64>>;

fn stepped(
    model: &Model,
    along: &DVector<f64>,
    size: f64,
    correction: Correction,
    rank_at: fn(&Model, &[Rigid]) -> Option<Rank>,
) -> Option<Stepped> {
    let wanted = along * size;
    let bodies = || 0..model.units;
    let mut at: Vec<Rigid> = bodies()
        .map(|b| Rigid::exp(&twist_of(&wanted, Some(b))))
        .collect();
    for _ in 0..MOST_CORRECTIONS {
        let residual = model.residual(&at);
        if residual.iter().any(|r| !r.is_finite()) {
            return None;
        }
        if residual.amax() < NONE {
            let now = bodies()
                .zip(&at)
                .flat_map(|(_, r)| r.log().iter().copied().collect::<Vec<_>>());
            let now = DVector::from_iterator(model.columns(), now);
            return Some(Stepped {
                strayed: (&now - &wanted).norm() / size.abs(),
                went: now.norm() / size.abs(),
                freedom: rank_at(model, &at)
                    .filter(Rank::is_clear)
                    .map(|r| model.columns() - r.rank),
            });
        }
        let by = correction(model, &at, &residual)?;
        for (b, r) in bodies().zip(&mut at) {
            *r = Rigid::exp(&-twist_of(&by, Some(b))).after(r);
        }
    }
    None
}

fn by_singular_values(
    model: &Model,
    at: &[Rigid],
    residual: &DVector<f64>,
) -> Option<DVector<f64>> {
    solve(&model.jacobian(at), residual)
}

fn rank_of(model: &Model, at: &[Rigid]) -> Option<Rank> {
    rank(&model.jacobian(at))
}

/// A correction that meets the independent rows; where the others are not met by it, it leads nowhere.
fn by_elimination(model: &Model, at: &[Rigid], residual: &DVector<f64>) -> Option<DVector<f64>> {
    let mut rows = model.rows_at(at);
    for (row, r) in rows.iter_mut().zip(residual.iter()) {
        row.push(model.columns(), *r);
    }
    let found = eliminate(&rows, model.columns(), 6, false)?;
    Some(DVector::from_vec(found.solution()))
}

fn rank_by_elimination(model: &Model, at: &[Rigid]) -> Option<Rank> {
    Some(eliminate(&model.rows_at(at), model.columns(), 6, false)?.rank)
}

/// The smallest correction of all that lower the residual most.
pub(super) fn solve(matrix: &DMatrix<f64>, residual: &DVector<f64>) -> Option<DVector<f64>> {
    let svd = SVD::try_new(matrix.clone(), true, true, f64::EPSILON, MOST_STEPS)?;
    let least = WEAK * svd.singular_values.max();
    svd.solve(residual, least).ok()
}
