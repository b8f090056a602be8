//! Following the curve of poses.

use nalgebra::{DMatrix, DVector, RowDVector, Vector3};

use super::choose::Held;
use super::{Drive, DriveKind, Pose, Stuck};
use crate::freedom::finite::solve;
use crate::freedom::linear::{Rank, null_space, rank};
use crate::freedom::model::{Model, moved, twist_of};
use crate::freedom::motion::STILL;
use crate::freedom::rigid::Rigid;

/// The longest step at once, in radians or shares of the characteristic length. Ours: curves of a mechanism bend
/// little within it.
const LONGEST: f64 = 0.06;
/// Shorter steps are not tried: the drive has come to its limit.
const SHORTEST: f64 = 1e-9;
/// How far a step may stray from its tangent, as a share of the step.
const STRAY: f64 = 0.2;
/// Residuals below this, in radians or shares of the characteristic length, count as none.
const NONE: f64 = 1e-13;
/// Corrections after which a step counts as lost.
const MOST_CORRECTIONS: usize = 25;
/// The smallest singular value below this share of the largest so far may be on its way to 0.
const WEAK: f64 = 0.1;
/// One that comes below this share is 0 in the step: another curve of poses crosses there.
const CROSSED: f64 = 1e-5;

impl Drive {
    /// The pose in which the coordinate is this much further.
    ///
    /// # Errors
    /// How far it came, and why no further.
    pub fn advance(&self, from: &Pose, by: f64) -> Result<Pose, (Pose, Stuck)> {
        let scale = match self.kind {
            DriveKind::Rotate => 1.0,
            DriveKind::Slide => self.model.length,
        };
        let mut here = from.clone();
        let (mut left, mut size) = (by / scale, LONGEST);
        while left != 0.0 {
            let step = left.abs().min(size).copysign(left);
            match self.step(&here, step) {
                Ok(mut next) => {
                    // The last step ends where it was to end, without the rounding of a sum.
                    left = if step == left { 0.0 } else { left - step };
                    next.value = if left == 0.0 {
                        from.value + by
                    } else {
                        here.value + step * scale
                    };
                    here = next;
                    size = (size * 2.0).min(LONGEST);
                }
                Err(Stuck::Limit) if step.abs() / 2.0 >= SHORTEST => size = step.abs() / 2.0,
                Err(why) => return Err((here, why)),
            }
        }
        Ok(here)
    }

    /// One step; a limit where it does not come to an end near its tangent.
    fn step(&self, from: &Pose, size: f64) -> Result<Pose, Stuck> {
        let here = self.rebased(&from.at);
        let along = match &from.along {
            Some(known) => known.clone(),
            None => self.tangent(&here)?.0,
        };
        let next = self.corrected(&here, from, &along, size)?;
        let weaker = from.strength.min(next.strength);
        if weaker < WEAK * next.strongest {
            // Over a zero it goes down and up again in straight lines, so that the middle lies below the mean of
            // the ends by as much as the lower of them.
            let middle = self.corrected(&here, from, &along, size / 2.0)?.strength;
            if (from.strength + next.strength) / 2.0 - middle > weaker / 2.0 {
                self.crosses(&here, from, &along, size)?;
            }
        }
        Ok(next)
    }

    /// The step along a tangent, brought back onto the constraints.
    fn corrected(
        &self,
        here: &Model,
        from: &Pose,
        along: &DVector<f64>,
        size: f64,
    ) -> Result<Pose, Stuck> {
        let wanted = along * size;
        let units = || 0..self.model.units;
        let mut by: Vec<Rigid> = units()
            .map(|u| Rigid::exp(&twist_of(&wanted, Some(u))))
            .collect();
        for _ in 0..MOST_CORRECTIONS {
            let off = self.coordinate(from, &by) - size;
            let residual = here.residual(&by);
            if !off.is_finite() || residual.iter().any(|r| !r.is_finite()) {
                return Err(Stuck::Limit);
            }
            if residual.amax().max(off.abs()) < NONE {
                return self.arrived(from, &by, &wanted);
            }
            let matrix = self.matrix(here, &by);
            let rows = matrix.nrows();
            let mut all = matrix.insert_row(rows, 0.0);
            all.set_row(rows, &self.driver(from, &by));
            let mut open = DVector::zeros(rows + 1);
            open.rows_mut(0, residual.len()).copy_from(&residual);
            if let Some(last) = open.get_mut(rows) {
                *last = off;
            }
            // Square and quick while steps are long; near an end of travel by singular values.
            let quick = (size.abs() > LONGEST / 64.0)
                .then(|| by_squares(&all, &open))
                .flatten();
            let back = quick.or_else(|| solve(&all, &open)).ok_or(Stuck::Unclear)?;
            for (u, r) in units().zip(&mut by) {
                *r = Rigid::exp(&-twist_of(&back, Some(u))).after(r);
            }
        }
        Err(Stuck::Limit)
    }

    fn arrived(&self, from: &Pose, by: &[Rigid], wanted: &DVector<f64>) -> Result<Pose, Stuck> {
        let went = by
            .iter()
            .flat_map(|r| r.log().iter().copied().collect::<Vec<_>>());
        let went = DVector::from_iterator(wanted.len(), went);
        if (went - wanted).norm() > STRAY * wanted.norm() {
            return Err(Stuck::Limit);
        }
        let at: Vec<Rigid> = by.iter().zip(&from.at).map(|(b, a)| b.after(a)).collect();
        let (along, strength) = self.tangent(&self.rebased(&at))?;
        Ok(Pose {
            value: from.value,
            at,
            along: Some(along),
            strength,
            strongest: from.strongest.max(strength),
        })
    }

    /// Whether another curve of poses crosses within a step: the constraints' smallest singular value is 0 there,
    /// which a step would pass over. It falls and rises again once within so small a step: golden section.
    fn crosses(
        &self,
        here: &Model,
        from: &Pose,
        along: &DVector<f64>,
        size: f64,
    ) -> Result<(), Stuck> {
        const GOLDEN: f64 = 0.618_033_988_749_895;
        let (mut low, mut high) = (0.0, size);
        let at = |h: f64| self.corrected(here, from, along, h).map(|p| p.strength);
        for _ in 0..40 {
            let (one, two) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
            let (a, b) = (at(one)?, at(two)?);
            if a.min(b) < CROSSED * from.strongest {
                return Err(Stuck::Branches);
            }
            if a < b {
                high = two;
            } else {
                low = one;
            }
        }
        Ok(())
    }

    /// The links from where the units have come to.
    fn rebased(&self, at: &[Rigid]) -> Model {
        let mut out = self.model.clone();
        for tie in &mut out.ties {
            tie.scaled = tie
                .scaled
                .rebased(&moved(at, tie.base), &moved(at, tie.incoming));
        }
        for (u, spin) in out.spins.iter_mut().enumerate() {
            *spin = spin.map(|s| moved(at, Some(u)).twist(&s));
        }
        out
    }

    /// The rows of the links and of what is held by its rate.
    fn matrix(&self, here: &Model, by: &[Rigid]) -> DMatrix<f64> {
        let rows = here.jacobian(by);
        let first = rows.nrows();
        let mut out = rows.insert_rows(first, self.held.len(), 0.0);
        for (k, held) in self.held.iter().enumerate() {
            out.set_row(first + k, &rate_row(here, by, held));
        }
        out
    }

    /// The motion in which the coordinate goes at a rate of 1, and how clearly it is the only one: the smallest
    /// singular value that counts.
    pub(super) fn tangent(&self, here: &Model) -> Result<(DVector<f64>, f64), Stuck> {
        let still = vec![Rigid::IDENTITY; self.model.units];
        let matrix = self.matrix(here, &still);
        let found = rank(&matrix).filter(Rank::is_clear).ok_or(Stuck::Unclear)?;
        match matrix.ncols().checked_sub(found.rank) {
            Some(1) => {}
            Some(0) | None => return Err(Stuck::Unclear),
            Some(_) => return Err(Stuck::Branches),
        }
        let free = null_space(&matrix, found.rank).column(0).into_owned();
        let start = Pose {
            value: 0.0,
            at: still.clone(),
            along: None,
            strength: 0.0,
            strongest: 0.0,
        };
        let rate = (self.driver(&start, &still) * &free).sum();
        if rate.abs() <= STILL * free.amax() {
            return Err(Stuck::Limit);
        }
        Ok((free / rate, found.smallest_counted))
    }

    /// How far the driven coordinate has come in a step.
    fn coordinate(&self, from: &Pose, by: &[Rigid]) -> f64 {
        let r = moved(by, Some(self.unit));
        match self.kind {
            DriveKind::Rotate => {
                // The turn about the direction of what is left when the tilt is taken out: of the rotation's
                // quaternion the part along it.
                let m = &r.rotation;
                let axial = Vector3::new(m.m32 - m.m23, m.m13 - m.m31, m.m21 - m.m12);
                2.0 * libm::atan2(axial.dot(&self.direction), 1.0 + m.trace())
            }
            DriveKind::Slide => {
                let was = moved(&from.at, Some(self.unit)).point(&self.point);
                (r.point(&was) - was).dot(&self.direction)
            }
        }
    }

    /// The rate of the coordinate by the units' twists.
    fn driver(&self, from: &Pose, by: &[Rigid]) -> RowDVector<f64> {
        let mut row = RowDVector::zeros(self.model.columns());
        let d = self.direction;
        let (turn, slide) = match self.kind {
            DriveKind::Rotate => (d, Vector3::zeros()),
            DriveKind::Slide => {
                let now = moved(&from.at, Some(self.unit)).point(&self.point);
                (moved(by, Some(self.unit)).point(&now).cross(&d), d)
            }
        };
        for (k, v) in turn.iter().chain(slide.iter()).enumerate() {
            if let Some(entry) = row.get_mut(6 * self.unit + k) {
                *entry = *v;
            }
        }
        row
    }
}

/// The correction by the normal equations, whose solution is one since the rows leave nothing free; none where
/// they are singular.
fn by_squares(matrix: &DMatrix<f64>, residual: &DVector<f64>) -> Option<DVector<f64>> {
    let turned = matrix.transpose();
    Some((&turned * matrix).cholesky()?.solve(&(turned * residual)))
}

/// The rate that is held, as a row on the units' twists.
fn rate_row(here: &Model, by: &[Rigid], held: &Held) -> RowDVector<f64> {
    let mut row = RowDVector::zeros(here.columns());
    let mut add = |unit: Option<usize>, part: nalgebra::Vector6<f64>| {
        for (k, v) in part.iter().enumerate() {
            if let Some(entry) = unit.and_then(|u| row.get_mut(6 * u + k)) {
                *entry += *v;
            }
        }
    };
    match held {
        Held::Joint(tie, twist) => {
            if let Some(tie) = here.ties.get(*tie) {
                let scaled = tie
                    .scaled
                    .rebased(&moved(by, tie.base), &moved(by, tie.incoming));
                let rate = |k: usize| {
                    let rates = scaled.rates(&nalgebra::Vector6::ith(k, 1.0));
                    rates.get(*twist).copied().unwrap_or_default()
                };
                let part = nalgebra::Vector6::from_fn(|k, _| rate(k));
                add(tie.base, -part);
                add(tie.incoming, part);
            }
        }
        Held::Spin(unit) => {
            let spin = here.spins.get(*unit).copied().flatten().unwrap_or_default();
            let now = moved(by, Some(*unit)).twist(&spin);
            add(
                Some(*unit),
                nalgebra::Vector6::new(now.x, now.y, now.z, 0.0, 0.0, 0.0),
            );
        }
        Held::Entry(column) => {
            add(Some(column / 6), nalgebra::Vector6::ith(column % 6, 1.0));
        }
    }
    row
}
