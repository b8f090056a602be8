//! The cone of motions that one-sided rows leave.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus,
};
use nalgebra::{DMatrix, DVector, Vector6};

/// A row on two bodies: the second against the first; none for what stands still.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) first: Option<usize>,
    pub(crate) second: Option<usize>,
    pub(crate) row: Vector6<f64>,
    /// Whether it holds both ways.
    pub(crate) both_ways: bool,
    /// How far it lets go before it holds, in mm.
    pub(crate) gap_mm: f64,
}

/// How far bodies may go while a contact opens by 1: what is nearly parallel does not count as opening.
const FARTHEST: f64 = 1e3;

/// Singular values below this share of the largest count as zero.
const RANK: f64 = 1e-7;

/// The number of unknowns up to which it can be told.
const MOST: usize = 1500;

/// What moves.
#[derive(Debug, Clone)]
pub(crate) struct Cone {
    /// An orthonormal basis of the motions, or of their hull where some go one way only: six numbers a body.
    pub(crate) basis: DMatrix<f64>,
    /// One motion that opens every contact that can open.
    pub(crate) opening: DVector<f64>,
    /// Whether any contact opens.
    pub(crate) opens: bool,
}

/// What `bodies` bodies may do; none where it cannot be told.
pub(crate) fn cone(bodies: usize, rows: &[Row]) -> Option<Cone> {
    let unknowns = 6 * bodies;
    if unknowns > MOST {
        return None;
    }
    let one_way: Vec<&Row> = rows.iter().filter(|r| !r.both_ways).collect();
    let (opening, opened) = if one_way.is_empty() {
        (DVector::zeros(unknowns), Vec::new())
    } else {
        open(unknowns, rows, &one_way)?
    };
    let mut opened_rows = opened.iter();
    let stays: Vec<&Row> = rows
        .iter()
        .filter(|r| r.both_ways || !opened_rows.next().copied().unwrap_or_default())
        .collect();
    let basis = null_space(unknowns, &stays);
    Some(Cone {
        basis,
        opening,
        opens: opened.iter().any(|o| *o),
    })
}

/// The entries of a row: column and value.
fn entries(row: &Row) -> impl Iterator<Item = (usize, f64)> {
    let of = |body: Option<usize>, sign: f64| {
        let each = row.row.iter().enumerate();
        let at = body.map(|b| 6 * b);
        each.filter_map(move |(k, x)| Some((at? + k, sign * x)))
            .collect::<Vec<_>>()
    };
    let mut all = of(row.first, -1.0);
    all.extend(of(row.second, 1.0));
    all.into_iter()
}

/// Rows `b - A x >= 0`, as they are gathered.
#[derive(Default)]
struct Programme {
    is: Vec<usize>,
    js: Vec<usize>,
    values: Vec<f64>,
    b: Vec<f64>,
}

impl Programme {
    /// At most `most`.
    fn line(&mut self, of: impl IntoIterator<Item = (usize, f64)>, most: f64) {
        for (j, x) in of {
            if x != 0.0 {
                self.is.push(self.b.len());
                self.js.push(j);
                self.values.push(x);
            }
        }
        self.b.push(most);
    }

    /// What rows that hold both ways and the bounds of the motions say.
    fn bounds(&mut self, unknowns: usize, rows: &[Row]) {
        for row in rows.iter().filter(|r| r.both_ways) {
            self.line(entries(row), 0.0);
            self.line(entries(row).map(|(j, x)| (j, -x)), 0.0);
        }
        for j in 0..unknowns {
            self.line([(j, 1.0)], FARTHEST);
            self.line([(j, -1.0)], FARTHEST);
        }
    }

    /// The least of a linear function.
    fn solve(self, q: &[f64]) -> Option<Vec<f64>> {
        let (height, columns) = (self.b.len(), q.len());
        let a = CscMatrix::new_from_triplets(height, columns, self.is, self.js, self.values);
        let p = CscMatrix::zeros((columns, columns));
        let settings = DefaultSettingsBuilder::default()
            .verbose(false)
            .max_iter(200)
            .build()
            .ok()?;
        let cones = [NonnegativeConeT(height)];
        let mut solver = DefaultSolver::new(&p, q, &a, &self.b, &cones, settings).ok()?;
        solver.solve();
        let solved = matches!(
            solver.solution.status,
            SolverStatus::Solved | SolverStatus::AlmostSolved
        );
        solved.then_some(solver.solution.x)
    }
}

/// The most that can open at once: each contact counts 1 where it opens at all.
fn open(unknowns: usize, rows: &[Row], one_way: &[&Row]) -> Option<(DVector<f64>, Vec<bool>)> {
    let mut programme = Programme::default();
    for (k, row) in one_way.iter().enumerate() {
        let opening = unknowns + k;
        let own = entries(row).map(|(j, x)| (j, -x));
        programme.line(own.chain([(opening, 1.0)]), 0.0);
        programme.line([(opening, 1.0)], 1.0);
        programme.line([(opening, -1.0)], 0.0);
    }
    programme.bounds(unknowns, rows);
    let mut q = vec![0.0; unknowns];
    q.extend(core::iter::repeat_n(-1.0, one_way.len()));
    let found = programme.solve(&q)?;
    let (motion, opened) = found.split_at_checked(unknowns)?;
    let opened = opened.iter().map(|s| *s > 0.5).collect();
    Some((DVector::from_column_slice(motion), opened))
}

/// How far a row goes before contacts stop it, each after its gap.
pub(crate) fn farthest(bodies: usize, rows: &[Row], along: &Row) -> Option<f64> {
    let unknowns = 6 * bodies;
    if unknowns > MOST {
        return None;
    }
    let mut programme = Programme::default();
    for row in rows.iter().filter(|r| !r.both_ways) {
        programme.line(entries(row).map(|(j, x)| (j, -x)), row.gap_mm);
    }
    programme.bounds(unknowns, rows);
    let mut q = vec![0.0; unknowns];
    for (j, x) in entries(along) {
        if let Some(slot) = q.get_mut(j) {
            *slot -= x;
        }
    }
    let found = programme.solve(&q)?;
    Some(-q.iter().zip(&found).map(|(q, x)| q * x).sum::<f64>())
}

/// The motions that none of some rows stops.
pub(crate) fn null_space(unknowns: usize, rows: &[&Row]) -> DMatrix<f64> {
    let mut triangle = DMatrix::<f64>::zeros(unknowns, unknowns);
    // By batches: of each, and of what came before, only the triangle of its QR is kept.
    for batch in rows.chunks(unknowns.max(64)) {
        let mut stacked = DMatrix::<f64>::zeros(unknowns + batch.len(), unknowns);
        stacked.rows_mut(0, unknowns).copy_from(&triangle);
        for (i, row) in batch.iter().enumerate() {
            for (j, x) in entries(row) {
                if let Some(slot) = stacked.get_mut((unknowns + i, j)) {
                    *slot += x;
                }
            }
        }
        triangle = stacked.qr().r();
    }
    let svd = triangle.svd(false, true);
    let largest = svd.singular_values.iter().copied().fold(0.0, f64::max);
    let Some(v_t) = svd.v_t else {
        return DMatrix::zeros(unknowns, 0);
    };
    let free: Vec<DVector<f64>> = svd
        .singular_values
        .iter()
        .enumerate()
        .filter(|(_, s)| **s <= RANK * largest.max(1.0))
        .map(|(i, _)| v_t.row(i).transpose())
        .collect();
    match free.is_empty() {
        true => DMatrix::zeros(unknowns, 0),
        false => DMatrix::from_columns(&free),
    }
}

#[cfg(test)]
mod tests {
    use super::{Row, cone};
    use nalgebra::{Vector3, Vector6};

    fn row(at: [f64; 3], normal: [f64; 3]) -> Row {
        let (p, n) = (Vector3::from(at), Vector3::from(normal));
        let turn = p.cross(&n);
        Row {
            first: None,
            second: Some(0),
            row: Vector6::new(turn.x, turn.y, turn.z, n.x, n.y, n.z),
            both_ways: false,
            gap_mm: 0.0,
        }
    }

    fn corners(z: f64, normal: f64) -> Vec<Row> {
        let at = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        at.map(|(x, y)| row([x, y, z], [0.0, 0.0, normal])).to_vec()
    }

    #[test]
    fn a_block_on_a_floor_may_do_all_that_does_not_sink() {
        let found = cone(1, &corners(0.0, 1.0)).unwrap();
        assert_eq!(found.basis.ncols(), 6);
        assert!(found.opens);
    }

    #[test]
    fn a_block_between_two_floors_slides_and_turns_in_their_plane() {
        let mut rows = corners(0.0, 1.0);
        rows.extend(corners(1.0, -1.0));
        let found = cone(1, &rows).unwrap();
        assert_eq!((found.basis.ncols(), found.opens), (3, false));
    }

    #[test]
    fn a_pin_in_a_hole_turns_and_slides_and_a_shoulder_lets_it_out_one_way() {
        let mut rows = Vec::new();
        for k in 0..8 {
            let (sin, cos) = libm::sincos(f64::from(k) * core::f64::consts::FRAC_PI_4);
            rows.push(row([cos, sin, -1.0], [-cos, -sin, 0.0]));
            rows.push(row([cos, sin, 1.0], [-cos, -sin, 0.0]));
        }
        let found = cone(1, &rows).unwrap();
        assert_eq!((found.basis.ncols(), found.opens), (2, false));
        rows.extend(corners(1.0, 1.0));
        let found = cone(1, &rows).unwrap();
        assert_eq!((found.basis.ncols(), found.opens), (2, true));
        rows.extend(corners(-1.0, -1.0));
        let found = cone(1, &rows).unwrap();
        assert_eq!((found.basis.ncols(), found.opens), (1, false));
    }
}
