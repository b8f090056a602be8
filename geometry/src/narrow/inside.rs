//! Whether a point well away from a solid's skin lies in the solid.

use super::boundary::{Boundary, real3};
use super::patch::V;
use super::triangles::{Met, met, on_triangle};
use parry3d_f64::bounding_volume::BoundingVolume;
use parry3d_f64::query::Ray;

/// Directions of rays; no part is made along them.
const RAYS: [[f64; 3]; 6] = [
    [0.531_71, 0.279_33, 0.799_54],
    [-0.412_37, 0.823_11, 0.389_92],
    [0.187_29, -0.741_83, 0.643_91],
    [0.903_17, -0.317_71, -0.288_43],
    [-0.611_93, -0.389_57, 0.687_61],
    [0.271_13, 0.613_37, -0.741_97],
];

/// Whether a point in the solid's frame is inside; none where no ray can tell, or where the point is no more
/// than `margin` mm farther from the triangles than they may be off.
pub(super) fn contains(boundary: &Boundary, point: &V, margin: f64) -> Option<bool> {
    if near(boundary, point, boundary.off() + margin) {
        return None;
    }
    RAYS.iter().find_map(|ray| {
        let along = V::from(*ray);
        let cast = Ray::new(real3(point), real3(&along));
        let leaves = boundary
            .tree()
            .leaves(|node| node.cast_ray(&cast, f64::MAX) < f64::MAX);
        let mut odd = false;
        for leaf in leaves {
            let (.., corners) = boundary.triangle(leaf)?;
            match met(point, &along, &corners) {
                Met::Not => {}
                Met::Through => odd = !odd,
                Met::Unclear => return None,
            }
        }
        Some(odd)
    })
}

fn near(boundary: &Boundary, point: &V, gap: f64) -> bool {
    let around = super::boundary::aabb(&[*point]).loosened(gap);
    let mut leaves = boundary
        .tree()
        .leaves(|node| node.aabb().intersects(&around));
    leaves.any(|leaf| {
        boundary
            .triangle(leaf)
            .is_none_or(|(.., corners)| (on_triangle(point, &corners) - point).norm() <= gap)
    })
}
