//! The pieces: exponentials, rows against residuals, ranks.

use nalgebra::{DMatrix, Vector3, Vector6};
use proptest::prelude::*;

use super::{TURN, placement_of};
use crate::freedom::linear::{complement, null_space, rank};
use crate::freedom::link::Scaled;
use crate::freedom::rigid::Rigid;
use crate::freedom::{Hold, Link};
use crate::mates::Twist;

fn twist() -> impl Strategy<Value = Vector6<f64>> {
    prop::array::uniform6(-1.0..1.0f64).prop_map(Vector6::from)
}

fn holds() -> Vec<Hold> {
    let gears = |x: f64, ratio: f64, slope: f64| Hold::Gears {
        incoming_axis: [x, 0.3, 0.0],
        ratio,
        slope,
    };
    vec![
        Hold::Free(vec![Twist(TURN)]),
        Hold::Free(vec![Twist([0.0, 0.0, 1.0, 0.0, 0.0, 0.7])]),
        gears(3.0, -0.4, 0.0),
        gears(3.0, -0.4, 0.5),
        gears(1.0, 3.0, -0.5),
        gears(-1.0, 0.25, 0.5),
    ]
}

#[test]
fn a_rank_that_hangs_between_is_not_told() {
    let of = |small: f64, smaller: f64| {
        let m = DMatrix::from_diagonal(&nalgebra::DVector::from_vec(vec![1.0, small, smaller]));
        let r = rank(&m).unwrap();
        (r.rank, r.is_clear())
    };
    assert_eq!(of(1e-3, 1e-15), (2, true));
    assert_eq!(of(2e-7, 5e-8), (2, false));
    assert_eq!(of(1.0, 0.5), (3, true));
    assert_eq!(rank(&DMatrix::from_element(2, 2, f64::NAN)), None);
}

#[test]
fn a_null_space_is_taken_to_nothing() {
    // Rows 1 and 2, and their sum.
    let m = DMatrix::from_row_slice(
        3,
        4,
        &[1.0, 2.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 3.0, 1.0, 1.0],
    );
    let r = rank(&m).unwrap();
    let free = null_space(&m, r.rank);
    assert_eq!((r.rank, free.ncols()), (2, 2));
    assert!((m * free).amax() < 1e-12);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn logarithms_undo_exponentials(t in twist(), small in prop::bool::ANY) {
        let t = if small { t * 1e-5 } else { t };
        prop_assert!((Rigid::exp(&t).log() - t).norm() < 1e-12);
    }

    #[test]
    fn a_complement_is_at_right_angles_and_complete(a in twist(), b in twist()) {
        let held = complement(&[a, b]);
        prop_assert_eq!(held.len(), 4);
        for (i, w) in held.iter().enumerate() {
            prop_assert!(w.dot(&a).abs() < 1e-12 && w.dot(&b).abs() < 1e-12);
            for (k, v) in held.iter().enumerate() {
                prop_assert!((w.dot(v) - f64::from(u8::from(i == k))).abs() < 1e-12);
            }
        }
    }

    /// The rows are the derivatives of the residuals: by central differences of small motions of either body.
    #[test]
    fn rows_are_the_slopes_of_residuals(t in twist(), of_base in prop::bool::ANY, deg in -180.0..180.0f64) {
        const H: f64 = 1e-5;
        for hold in holds() {
            let by = placement_of([0.4, -1.0, 2.0], [1.0, 2.0, 0.5], deg);
            let hold = match hold {
                Hold::Gears { incoming_axis, ratio, slope } => Hold::Gears {
                    incoming_axis: by.point(incoming_axis),
                    ratio,
                    slope,
                },
                free => free,
            };
            let link = Link { name: String::new(), base: 0, incoming: 1, frame: by, hold };
            let scaled = Scaled::new(&link, &Vector3::zeros(), 1.0);
            let still = Rigid::IDENTITY;
            let at = |h: f64| {
                let moved = Rigid::exp(&(t * h));
                if of_base { scaled.residual(&moved, &still) } else { scaled.residual(&still, &moved) }
            };
            let sign = if of_base { -1.0 } else { 1.0 };
            let rows = scaled.jacobian(&still, &still);
            prop_assert_eq!(rows.len(), scaled.rows());
            for ((w, up), down) in rows.iter().zip(at(H)).zip(at(-H)) {
                let slope = (up - down) / (2.0 * H);
                prop_assert!((sign * w.dot(&t) - slope).abs() < 1e-7, "{:?}: {} {}", link.hold, w.dot(&t), slope);
            }
        }
    }
}
