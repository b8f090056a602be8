//! Whether two solids enter each other, shown by a point.

use assemcad_model::frame::Placement;

use super::boundary::{Boundary, real3};
use super::inside::contains;
use super::patch::V;

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
