//! Relative poses, rounded, so that equal parts in equal relative places are one question.

use assemcad_model::frame::{Placement, Rows};
use nalgebra::{Matrix3, Vector3};

/// Places are told apart down to a millionth of a micrometre.
const PLACES_PER_MM: f64 = 1e9;

/// Directions are told apart finer: at the end of a metre it is the same.
const DIRECTIONS: f64 = 1e12;

/// The pose of a second solid in the frame of a first one, rounded; answers are computed at the rounded pose.
#[must_use]
pub fn relative(first: &Placement, second: &Placement) -> Placement {
    rounded(&(first.inverse() * *second))
}

/// A pose on the grid of poses.
#[must_use]
pub fn rounded(pose: &Placement) -> Placement {
    let Rows(rows) = (*pose).into();
    Placement::from(Rows(rows.map(|[x, y, z, t]| {
        [
            on(x, DIRECTIONS),
            on(y, DIRECTIONS),
            on(z, DIRECTIONS),
            on(t, PLACES_PER_MM),
        ]
    })))
}

/// A direction and a point on the same grid.
pub(crate) fn rounded_point(p: [f64; 3]) -> [f64; 3] {
    p.map(|n| on(n, PLACES_PER_MM))
}

pub(crate) fn rounded_direction(d: [f64; 3]) -> [f64; 3] {
    d.map(|n| on(n, DIRECTIONS))
}

/// The numbers of a pose.
pub(crate) fn numbers(pose: &Placement) -> [f64; 12] {
    let Rows([[a, b, c, d], [e, f, g, h], [i, j, k, l]]) = (*pose).into();
    [a, b, c, d, e, f, g, h, i, j, k, l]
}

/// Adding 0 gives zero one sign.
fn on(n: f64, per_unit: f64) -> f64 {
    // By division: a whole number over a power of ten is the nearest double to that decimal.
    libm::round(n * per_unit) / per_unit + 0.0
}

/// Whether of two poses the first comes first; equal ones do not.
pub(crate) fn before(a: &Placement, b: &Placement) -> bool {
    let order = numbers(a)
        .iter()
        .zip(numbers(b))
        .map(|(x, y)| x.total_cmp(&y))
        .find(|o| o.is_ne());
    order.is_some_and(core::cmp::Ordering::is_lt)
}

/// A box of a box's corners at another place: smallest and largest corner.
pub(crate) fn moved_box((min, max): ([f64; 3], [f64; 3]), at: &Placement) -> ([f64; 3], [f64; 3]) {
    let (min, max) = (Vector3::from(min), Vector3::from(max));
    let (middle, half) = ((min + max) / 2.0, (max - min) / 2.0);
    let reach: Matrix3<f64> = at.rotation().abs();
    let (c, h) = (Vector3::from(at.point(middle.into())), reach * half);
    ((c - h).into(), (c + h).into())
}

#[cfg(test)]
mod tests {
    use super::{numbers, relative, rounded};
    use assemcad_model::frame::Placement;

    #[test]
    fn equal_relative_places_are_one_wherever_they_stand() {
        let (a, b) = (
            Placement::translation(1.0, 2.0, 3.0) * Placement::rotation_x(90.0),
            Placement::translation(-7.5, 0.25, 11.0) * Placement::rotation_z(180.0),
        );
        let here = relative(&a, &b);
        for deg in [1.0, 17.3, 123.4, 271.0] {
            let about = Placement::rotation_about([4.0, 5.0, 6.0], [0.36, 0.48, 0.8], deg).unwrap();
            let there = Placement::translation(101.3, -40.7, 3.9) * about;
            assert_eq!(
                numbers(&relative(&(there * a), &(there * b))),
                numbers(&here)
            );
        }
        // A micrometre is a difference.
        let moved = Placement::translation(1e-3, 0.0, 0.0) * b;
        assert_ne!(numbers(&relative(&a, &moved)), numbers(&here));
    }

    #[test]
    fn rounding_moves_no_point_of_a_part_by_more_than_two_nanometres() {
        let pose = Placement::translation(123.456_789_012_3, -9.876_543_210_9, 0.1)
            * Placement::rotation_about([0.0; 3], [0.6, 0.0, 0.8], 77.7).unwrap();
        let p = [1000.0, -1000.0, 1000.0];
        let (exact, near) = (pose.point(p), rounded(&pose).point(p));
        for (x, y) in exact.iter().zip(near) {
            assert!((x - y).abs() <= 2e-9, "{x} {y}");
        }
        assert_eq!(numbers(&rounded(&rounded(&pose))), numbers(&rounded(&pose)));
    }
}
