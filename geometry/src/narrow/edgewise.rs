//! Faces that can meet only in the plane of a neighbour.
//!
//! Where a face ends in outer edges at a plane face, and lies below it, its solid is below that plane near those
//! edges. A face of another solid that lies above the plane meets it there at most, on the border, and the other
//! solid's material is above.

use super::patch::{Edge, PARALLEL, Patch, Surface, V};
use super::side::TOUCH_MM;

/// A plane in which alone a face can meet another.
#[derive(Debug, Clone, Copy)]
pub(super) struct Between {
    normal: V,
}

/// The plane of a neighbour of the first face that has this one below it and the second above.
pub(super) fn between(of: &Patch<'_>, index: u32, other: &Patch<'_>) -> Option<Between> {
    of.neighbours(index).find_map(|plane| {
        let Surface::Plane { origin, normal } = plane.surface else {
            return None;
        };
        let height = origin.dot(&normal);
        let above = other.lowest(&normal)? >= height - TOUCH_MM;
        let below = above && -of.lowest(&-normal)? <= height + TOUCH_MM;
        (below && ends_in_outer_edges(of, &normal, height)).then_some(Between { normal })
    })
}

impl Between {
    /// Whether the face meets the plane in its border at most.
    pub(super) fn meets_border_of(&self, face: &Patch<'_>) -> bool {
        match face.surface {
            Surface::Plane { normal, .. } => normal.cross(&self.normal).norm() > 0.1,
            Surface::Round { axis, .. } => axis.cross(&self.normal).norm() <= PARALLEL,
            _ => false,
        }
    }
}

/// Whether all edges of a face that lie in a plane are outer ones.
fn ends_in_outer_edges(face: &Patch<'_>, normal: &V, height: f64) -> bool {
    face.borders_and_turns().all(|(edge, outer)| {
        let off = |p: &V| (p.dot(normal) - height).abs();
        let within = match edge {
            Edge::Line(a, b) => off(&a).max(off(&b)) <= TOUCH_MM,
            Edge::Circle { center, axis, .. } => {
                axis.cross(normal).norm() <= PARALLEL && off(&center) <= TOUCH_MM
            }
            Edge::Unknown => return false,
        };
        outer || !within
    })
}
