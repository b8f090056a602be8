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

/// The most that can open at once: each contact counts 1 where it opens at all.
fn open(unknowns: usize, rows: &[Row], one_way: &[&Row]) -> Option<(DVector<f64>, Vec<bool>)> {
    let count = one_way.len();
    let columns = unknowns + count;
    // As `b - A x` in the non-negative cone.
    let (mut is, mut js, mut values) = (Vec::new(), Vec::new(), Vec::new());
    let mut b: Vec<f64> = Vec::new();
    let mut line = |of: &[(usize, f64)], most: f64| {
        for (j, x) in of {
            if *x != 0.0 {
                is.push(b.len());
                js.push(*j);
                values.push(*x);
            }
        }
        b.push(most);
    };
    let negative = |of: &[(usize, f64)]| of.iter().map(|(j, x)| (*j, -x)).collect::<Vec<_>>();
    for (k, row) in one_way.iter().enumerate() {
        let mut own = negative(&entries(row).collect::<Vec<_>>());
        own.push((unknowns + k, 1.0));
        line(&own, 0.0);
        line(&[(unknowns + k, 1.0)], 1.0);
        line(&[(unknowns + k, -1.0)], 0.0);
    }
    for row in rows.iter().filter(|r| r.both_ways) {
        let own: Vec<_> = entries(row).collect();
        line(&own, 0.0);
        line(&negative(&own), 0.0);
    }
    for j in 0..unknowns {
        line(&[(j, 1.0)], FARTHEST);
        line(&[(j, -1.0)], FARTHEST);
    }
    let height = b.len();
    let a = CscMatrix::new_from_triplets(height, columns, is, js, values);
    let p = CscMatrix::zeros((columns, columns));
    let mut q = vec![0.0; unknowns];
    q.extend(core::iter::repeat_n(-1.0, count));
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .max_iter(200)
        .build()
        .ok()?;
    let mut solver =
        DefaultSolver::new(&p, &q, &a, &b, &[NonnegativeConeT(height)], settings).ok()?;
    solver.solve();
    if !matches!(
        solver.solution.status,
        SolverStatus::Solved | SolverStatus::AlmostSolved
    ) {
        return None;
    }
    let (motion, opened) = solver.solution.x.split_at_checked(unknowns)?;
    let opened = opened.iter().map(|s| *s > 0.5).collect();
    Some((DVector::from_column_slice(motion), opened))
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
