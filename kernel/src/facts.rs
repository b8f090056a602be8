//! The faces and edges of a solid: what they are and where.

use serde::{Deserialize, Serialize};

use crate::error::{Context, Result};
use crate::ffi::bridge;
use crate::query::Bounds;
use crate::shape::Shape;

/// A face. Lengths in mm, areas in mm2, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Face {
    /// The surface and its own numbers.
    pub surface: Surface,
    /// Planes and free-form faces: the centroid of the face. Cylinders and cones: the point of the
    /// axis nearest to the centroid. Spheres and tori: the centre.
    pub origin: [f64; 3],
    /// Area.
    pub area: f64,
    /// Tight box.
    pub bounds: Bounds,
}

/// The sorts of surfaces.
///
/// `inward`: the material lies around the surface, as at a hole. `span_deg`: how far the face goes
/// round; 360 for a full turn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Surface {
    /// A plane.
    Plane {
        /// Unit normal out of the material.
        normal: [f64; 3],
    },
    /// A cylinder.
    Cylinder {
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// Radius.
        radius: f64,
        /// Whether it is a hole.
        inward: bool,
        /// How far the face goes round.
        span_deg: f64,
        /// Where the face begins and ends along the axis, from the origin.
        range: [f64; 2],
    },
    /// A cone.
    Cone {
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// Radius at the origin.
        radius: f64,
        /// Angle between axis and surface.
        half_angle_deg: f64,
        /// Whether it is a hole.
        inward: bool,
        /// How far the face goes round.
        span_deg: f64,
        /// Where the face begins and ends along the axis, from the origin.
        range: [f64; 2],
    },
    /// A sphere.
    Sphere {
        /// Radius.
        radius: f64,
        /// Whether it is a hollow.
        inward: bool,
    },
    /// A torus.
    Torus {
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// Distance of the tube's centre from the axis.
        radius: f64,
        /// Radius of the tube.
        tube_radius: f64,
        /// Whether the material lies around the tube.
        inward: bool,
    },
    /// Anything else.
    Other,
}

/// An edge. Lengths in mm.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Edge {
    /// The curve.
    pub curve: Curve,
    /// How the faces meet there.
    pub turn: Turn,
    /// Where the curve begins.
    pub start: [f64; 3],
    /// Where the curve ends; the start again when it is closed.
    pub end: [f64; 3],
    /// The point halfway in the curve's parameter.
    pub middle: [f64; 3],
    /// Unit direction of the curve there; zero for an edge without length.
    pub tangent: [f64; 3],
    /// Length.
    pub length: f64,
    /// Tight box.
    pub bounds: Bounds,
    /// Points along the edge, its ends included.
    pub samples: Vec<[f64; 3]>,
}

/// The sorts of curves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Curve {
    /// A straight line.
    Line,
    /// A circle or an arc of one.
    Circle {
        /// Centre.
        center: [f64; 3],
        /// Unit direction of the circle's axis.
        axis: [f64; 3],
        /// Radius.
        radius: f64,
    },
    /// Anything else.
    Other,
    /// No curve: a point that closes a face, such as a pole of a sphere.
    Point,
}

/// How two faces meet at an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Turn {
    /// An outer edge: less than half a turn of material.
    Convex,
    /// An inner edge: more than half a turn of material.
    Concave,
    /// No visible edge: the faces run into each other smoothly.
    Smooth,
    /// No edge between two faces: where a face closes onto itself.
    Seam,
}

impl Turn {
    /// From the numbers of `turn_of` in `cpp/facts.cpp`.
    pub(crate) fn of(code: u8) -> Self {
        match code {
            0 => Self::Convex,
            1 => Self::Concave,
            2 => Self::Smooth,
            _ => Self::Seam,
        }
    }

    /// The number that [`Turn::of`] reads.
    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Convex => 0,
            Self::Concave => 1,
            Self::Smooth => 2,
            Self::Seam => 3,
        }
    }
}

impl Shape {
    /// Every face, in the kernel's order, which is the same for the same solid.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn faces(&self) -> Result<Vec<Face>> {
        let raw = bridge::faces(self.solid()?)
            .context(|| "the faces of the solid could not be listed".to_owned())?;
        Ok(raw.into_iter().map(face).collect())
    }

    /// Every edge, in the kernel's order; the position is the number that [`Shape::fillet`] and
    /// [`Shape::chamfer`] take.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn edges(&self) -> Result<Vec<Edge>> {
        let raw = bridge::edges(self.solid()?)
            .context(|| "the edges of the solid could not be listed".to_owned())?;
        Ok(raw.into_iter().map(edge).collect())
    }
}

fn face(raw: bridge::FaceRaw) -> Face {
    let (inward, radius, axis) = (raw.inward, raw.radius, raw.axis);
    let span_deg = raw.span.to_degrees();
    let range = [raw.low, raw.high];
    let surface = match raw.kind {
        0 => Surface::Plane { normal: raw.normal },
        1 => Surface::Cylinder {
            axis,
            radius,
            inward,
            span_deg,
            range,
        },
        2 => {
            let half_angle_deg = raw.half_angle.to_degrees();
            Surface::Cone {
                axis,
                radius,
                half_angle_deg,
                inward,
                span_deg,
                range,
            }
        }
        3 => Surface::Sphere { radius, inward },
        4 => Surface::Torus {
            axis,
            radius,
            tube_radius: raw.minor_radius,
            inward,
        },
        _ => Surface::Other,
    };
    Face {
        surface,
        origin: raw.origin,
        area: raw.area,
        bounds: raw.bounds.into(),
    }
}

fn edge(raw: bridge::EdgeRaw) -> Edge {
    let curve = match raw.kind {
        0 => Curve::Line,
        1 => Curve::Circle {
            center: raw.center,
            axis: raw.axis,
            radius: raw.radius,
        },
        2 => Curve::Other,
        _ => Curve::Point,
    };
    let turn = Turn::of(raw.turn);
    Edge {
        curve,
        turn,
        start: raw.start,
        end: raw.end,
        middle: raw.middle,
        tangent: raw.tangent,
        length: raw.length,
        bounds: raw.bounds.into(),
        samples: raw.samples.as_chunks::<3>().0.to_vec(),
    }
}
