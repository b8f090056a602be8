//! Whether two solids enter each other, shown by a point.

use assemcad_model::frame::Placement;

use super::boundary::{Boundary, real3};
use super::inside::contains;
use super::patch::V;
use super::relate::Sleeve;

/// Whether some point of one solid's skin lies for sure within the other, the second placed in the frame of the
/// first: then they have a volume in common, however small. That none is found shows nothing.
#[must_use]
pub fn enter(a: &Boundary, b: &Boundary, at: &Placement) -> bool {
    reaches_into(a, b, &at.inverse()) || reaches_into(b, a, at)
}

/// Whether a point of one skin lies in the other solid, which the placement puts its points into the frame of.
fn reaches_into(of: &Boundary, other: &Boundary, at: &Placement) -> bool {
    (0..of.count()).any(|index| {
        let Some((_, face, [p, q, r])) = of.triangle(index) else {
            return false;
        };
        // The middle of the triangle is that near to a point of the skin.
        let middle = V::from(at.point(((p + q + r) / 3.0).into()));
        other.bounds().contains_local_point(real3(&middle))
            && contains(other, &middle, face.off) == Some(true)
    })
}

/// A point of one solid that lies for sure within the other and in none of the sleeves, in the frame of the first.
/// That none is found shows nothing.
#[must_use]
pub fn strays(a: &Boundary, b: &Boundary, at: &Placement, sleeves: &[Sleeve]) -> Option<[f64; 3]> {
    let outside = |p: &V| !sleeves.iter().any(|s| s.holds(p));
    let back = at.inverse();
    let of = |from: &Boundary, other: &Boundary, to_other: &Placement, to_first: &Placement| {
        (0..from.count()).find_map(|index| {
            let (_, face, [p, q, r]) = from.triangle(index)?;
            let points = [
                (p + q + r) / 3.0,
                p,
                q,
                r,
                (p + q) / 2.0,
                (q + r) / 2.0,
                (r + p) / 2.0,
            ];
            points.into_iter().find_map(|own| {
                let there = V::from(to_other.point(own.into()));
                let seen = V::from(to_first.point(own.into()));
                (other.bounds().contains_local_point(real3(&there))
                    && outside(&seen)
                    && contains(other, &there, face.off) == Some(true))
                .then(|| seen.into())
            })
        })
    };
    of(a, b, &back, &Placement::IDENTITY).or_else(|| of(b, a, at, at))
}
