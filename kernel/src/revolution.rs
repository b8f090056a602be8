//! Whether a solid is one of revolution.
//!
//! It is where every face lies in a surface of revolution about the axis: a plane across it, a cylinder, a cone or a
//! torus about it, a sphere with its centre on it. An edge lies in two of these, which meet in circles about the
//! axis, or in one of them on both of its sides, where it bounds nothing. So the whole skin is carried into itself
//! by every turn. A free-form face is not looked into: then the answer is no, which proves nothing.

use nalgebra::Vector3;

use crate::facts::{Face, Surface};

/// How far a face may be from the axis, in mm: what placing leaves.
const NEAR_MM: f64 = 1e-6;

/// How far its direction may be off, in radians.
const NEAR_RAD: f64 = 1e-9;

/// Whether a solid with these faces is one of revolution about the axis through a point along a unit direction.
#[must_use]
pub fn is_about(faces: &[Face], point: [f64; 3], direction: [f64; 3]) -> bool {
    let (point, direction) = (Vector3::from(point), Vector3::from(direction));
    let along = |d: &[f64; 3]| Vector3::from(*d).cross(&direction).norm() <= NEAR_RAD;
    let on_axis = |p: &[f64; 3]| (Vector3::from(*p) - point).cross(&direction).norm() <= NEAR_MM;
    let about = |face: &Face| match &face.surface {
        Surface::Plane { normal } => along(normal),
        Surface::Cylinder { axis, .. }
        | Surface::Cone { axis, .. }
        | Surface::Torus { axis, .. } => along(axis) && on_axis(&face.origin),
        Surface::Sphere { .. } => on_axis(&face.origin),
        Surface::Other => false,
    };
    !faces.is_empty() && faces.iter().all(about)
}
