//! Where two solids meet face to face: the patches over which they touch, or are so near that one stops the other
//! soon, each with the directions in which it holds.
//!
//! Planes that face each other, cylinders and cones in holes about one axis, balls in sockets, lines and points of
//! contact come out of the surfaces themselves. Which part of a surface is there is told by its triangles, whose
//! corners lie on it. Other surfaces meet by their triangles alone.

mod clip;
mod flat;
mod free;
mod round;
mod tangent;

use std::collections::BTreeMap;

use assemcad_kernel::skin::{SkinCurve, SkinFace, SkinSurface};
use assemcad_model::frame::Placement;
use parry3d_f64::bounding_volume::BoundingVolume;
use serde::{Deserialize, Serialize};

use super::boundary::{Boundary, aabb};
use super::patch::{Patch, Surface, V};
use super::relate::turned;
use super::triangles::on_triangle;

/// Up to this distance two faces touch, in mm: what placing and the kernel's tolerance leave, and well below any
/// play that is made on purpose.
pub const TOUCH_MM: f64 = 1e-4;

/// Faces that face each other across more than this stop nothing, in mm. Ours.
pub const REACH_MM: f64 = 1.0;

/// What sort of contact it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Kind {
    /// Plane on plane.
    Plane,
    /// A cylinder in a cylindrical hole.
    Cylinder,
    /// A cone in a conical hole.
    Cone,
    /// A ball in a socket.
    Ball,
    /// A cylinder along a plane or another cylinder.
    Line,
    /// A ball on a plane.
    Point,
    /// Surfaces of other kinds.
    Free,
}

/// A point of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spot {
    /// Where it is, in mm.
    pub at: [f64; 3],
    /// Unit direction out of the first solid into the second: the second cannot go against it.
    pub normal: [f64; 3],
    /// How far the second may still go against it, in mm; negative where they overlap.
    pub gap_mm: f64,
}

/// About which axis a round contact is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct About {
    /// A point of the hole's axis.
    pub point: [f64; 3],
    /// Unit direction of the hole's axis.
    pub direction: [f64; 3],
    /// The radius of the hole, in mm; of a cone that at the point.
    pub hole_mm: f64,
    /// The radius of what is in it.
    pub inner_mm: f64,
    /// Where the common length begins and ends, from the point along the direction.
    pub range: [f64; 2],
    /// The share of the circle over which both are there.
    pub share: f64,
    /// Whether the first solid has the hole.
    pub first_has_hole: bool,
}

/// Two faces that meet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Meeting {
    /// The sort of contact.
    pub kind: Kind,
    /// The least distance across it, in mm: half of the play of a cylinder that stands in the middle of its hole.
    pub gap_mm: f64,
    /// The common area, in mm2; 0 of lines, points, balls and free surfaces.
    pub area_mm2: f64,
    /// About which axis, of cylinders and cones.
    pub about: Option<About>,
    /// Points that hold as the whole contact does.
    pub spots: Vec<Spot>,
}

impl Meeting {
    /// Whether the faces touch, or overlap.
    #[must_use]
    pub fn touches(&self) -> bool {
        self.gap_mm <= TOUCH_MM
    }

    /// The same contact in another frame, seen from the other solid where they are exchanged.
    #[must_use]
    pub fn placed(mut self, at: &Placement, exchanged: bool) -> Self {
        for spot in &mut self.spots {
            spot.at = at.point(spot.at);
            let normal = at.direction(spot.normal);
            spot.normal = match exchanged {
                true => normal.map(|n| 0.0 - n),
                false => normal,
            };
        }
        if let Some(about) = &mut self.about {
            about.point = at.point(about.point);
            about.direction = at.direction(about.direction);
            about.first_has_hole ^= exchanged;
        }
        self
    }
}

/// Every meeting of two solids, the second placed in the frame of the first, in the order of their faces.
#[must_use]
pub fn meetings(a: &Boundary, b: &Boundary, at: &Placement) -> Vec<Meeting> {
    let mut out = Vec::new();
    for ((index_a, index_b), near) in faces_near(a, b, at) {
        let whole = Placement::IDENTITY;
        let faces = (
            a.skin().faces.get(index_a as usize),
            b.skin().faces.get(index_b as usize),
        );
        let (Some(face_a), Some(face_b)) = faces else {
            continue;
        };
        let (on_a, on_b) = (Patch::face(a, &whole, face_a), Patch::face(b, at, face_b));
        let found = match (&on_a.surface, &on_b.surface) {
            (Surface::Plane { .. }, Surface::Plane { .. }) => flat::meet(&on_a, &on_b, &near),
            (Surface::Round { .. }, Surface::Round { .. }) => round::meet(&on_a, &on_b, &near)
                .or_else(|| tangent::beside(&on_a, &on_b))
                .or_else(|| free::meet((a, &on_a), (b, &on_b, at), &near)),
            (Surface::Round { .. }, Surface::Plane { .. }) => tangent::on_plane(&on_a, &on_b),
            (Surface::Plane { .. }, Surface::Round { .. }) => {
                tangent::on_plane(&on_b, &on_a).map(|m| m.placed(&Placement::IDENTITY, true))
            }
            (Surface::Sphere { .. }, Surface::Plane { .. }) => tangent::ball_on_plane(&on_a, &on_b),
            (Surface::Plane { .. }, Surface::Sphere { .. }) => {
                tangent::ball_on_plane(&on_b, &on_a).map(|m| m.placed(&Placement::IDENTITY, true))
            }
            (Surface::Sphere { .. }, Surface::Sphere { .. }) => tangent::socket(&on_a, &on_b),
            _ => free::meet((a, &on_a), (b, &on_b, at), &near),
        };
        out.extend(found);
    }
    out
}

/// Triangles of either solid that come near each other, by the faces that they belong to.
type Near = BTreeMap<(u32, u32), Vec<(u32, u32)>>;

fn faces_near(a: &Boundary, b: &Boundary, at: &Placement) -> Near {
    let mut out = Near::new();
    let reach = REACH_MM + a.off() + b.off();
    let region = a.bounds().loosened(reach);
    let seen = turned(&region, &at.inverse());
    if !region.intersects(&turned(b.bounds(), at)) {
        return out;
    }
    let plains =
        |of: &Boundary| -> Vec<bool> { of.skin().faces.iter().map(|f| plain(of, f)).collect() };
    let (plains_a, plains_b) = (plains(a), plains(b));
    let is = |all: &[bool], face: u32| all.get(face as usize).copied().unwrap_or_default();
    for leaf in b.tree().leaves(|node| node.aabb().intersects(&seen)) {
        let Some((face_b, _, own)) = b.triangle(leaf) else {
            continue;
        };
        let around = aabb(&own.map(|p| V::from(at.point(p.into())))).loosened(reach);
        for other in a.tree().leaves(|node| node.aabb().intersects(&around)) {
            let Some((face_a, ..)) = a.triangle(other) else {
                continue;
            };
            let near = out.entry((face_a, face_b)).or_default();
            // Planes are told by their borders, where these are lines and arcs: one pair of triangles says enough.
            if near.is_empty() || !(is(&plains_a, face_a) && is(&plains_b, face_b)) {
                near.push((other, leaf));
            }
        }
    }
    out
}

/// Whether a face is a plane that lines and arcs bound.
fn plain(of: &Boundary, face: &SkinFace) -> bool {
    matches!(face.surface, SkinSurface::Plane { .. })
        && face.edges.iter().all(|e| {
            let curve = of.edge(*e).map(|e| e.curve);
            !matches!(curve, None | Some(SkinCurve::Other))
        })
}

/// Whether a face is there at a point of its surface.
fn covers(patch: &Patch<'_>, point: &V) -> bool {
    let back = patch.placement().inverse();
    let own = V::from(back.point((*point).into()));
    let reach = patch.face.off + 1e-3;
    let mut near = patch.boundary().triangles_near(&own, reach);
    near.any(|(face, corners)| {
        core::ptr::eq(face, patch.face) && (on_triangle(&own, &corners) - own).norm() <= reach
    })
}

/// Two directions across a unit direction.
fn across(direction: &V) -> (V, V) {
    let least = direction.iamin();
    let mut other = V::zeros();
    if let Some(slot) = other.get_mut(least) {
        *slot = 1.0;
    }
    let x = direction.cross(&other);
    let x = x / x.norm().max(1e-12);
    (x, direction.cross(&x))
}

fn spot(at: V, normal: V, gap_mm: f64) -> Spot {
    Spot {
        at: at.into(),
        normal: normal.into(),
        gap_mm,
    }
}
