//! The skin of a solid: surfaces, borders and triangles of its faces, enough to decide without the kernel
//! whether two placed solids are apart, or touch without entering each other.

use serde::{Deserialize, Serialize};

use crate::error::{Context, KernelError, Result};
use crate::facts::Turn;
use crate::ffi::bridge;
use crate::limits::length;
use crate::shape::Shape;

/// By how much the measured distances between triangles and surfaces are taken larger: they were looked at
/// in the middles of triangles and their sides only. On a cylinder or cone these are the worst places; on a
/// sphere the worst is off by a third more.
const WORST: f64 = 1.5;

/// What is added for the nodes themselves, which lie on their surfaces within the kernel's tolerance, in mm.
const NODES_MM: f64 = 2e-7;

/// The skin of a solid. Lengths in mm.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Skin {
    /// The faces, in the kernel's order.
    pub faces: Vec<SkinFace>,
    /// The edges, in the kernel's order.
    pub edges: Vec<SkinEdge>,
    /// Nodes of the triangles; each face has its own.
    pub positions: Vec<[f64; 3]>,
    /// Three nodes each, counter-clockwise seen from outside; those of one face follow each other.
    pub triangles: Vec<[u32; 3]>,
}

/// A face.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SkinFace {
    /// Which of the solid's shells it belongs to.
    pub shell: u32,
    /// Its surface.
    pub surface: SkinSurface,
    /// Whether the normal out of the material points away from the axis, the centre or the middle of the
    /// tube; of a plane always.
    pub outward: bool,
    /// No point of the face is farther from its triangles than this, and no point of its triangles from it.
    pub off: f64,
    /// Its triangles: from, to (exclusive).
    pub triangles: [u32; 2],
    /// Its border, as indices of edges; a seam stands twice.
    pub edges: Vec<u32>,
}

/// A surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum SkinSurface {
    /// A plane.
    Plane {
        /// A point of it.
        origin: [f64; 3],
        /// Unit normal out of the material.
        normal: [f64; 3],
    },
    /// A cylinder, between two heights above the origin along the axis.
    Cylinder {
        /// A point of the axis.
        origin: [f64; 3],
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// Radius.
        radius: f64,
        /// Where the face begins and ends.
        range: [f64; 2],
    },
    /// A cone, between two heights above the origin along the axis.
    Cone {
        /// A point of the axis.
        origin: [f64; 3],
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// Radius at the origin.
        radius: f64,
        /// By how much the radius grows along the axis.
        slope: f64,
        /// Where the face begins and ends.
        range: [f64; 2],
    },
    /// A sphere.
    Sphere {
        /// The centre.
        center: [f64; 3],
        /// Radius.
        radius: f64,
    },
    /// A torus.
    Torus {
        /// The centre.
        center: [f64; 3],
        /// Unit direction of the axis.
        axis: [f64; 3],
        /// Distance of the tube's middle from the axis.
        radius: f64,
        /// Radius of the tube.
        tube: f64,
    },
    /// Anything else.
    Other,
}

/// An edge.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SkinEdge {
    /// Its curve.
    pub curve: SkinCurve,
    /// How the faces meet there.
    pub turn: Turn,
    /// Where it begins.
    pub start: [f64; 3],
    /// Where it ends.
    pub end: [f64; 3],
    /// The middle of the curve's parameter.
    pub middle: [f64; 3],
}

/// A curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum SkinCurve {
    /// A straight line.
    Line,
    /// A circle or an arc of one.
    Circle {
        /// The centre.
        center: [f64; 3],
        /// Unit direction of its axis: the arc goes round it by the right-hand rule.
        axis: [f64; 3],
        /// Radius.
        radius: f64,
        /// How far it goes, in radians.
        sweep: f64,
    },
    /// Anything else.
    Other,
    /// A point that closes a face, such as a pole of a sphere.
    Point,
}

impl Shape {
    /// The skin, its triangles about `deflection` mm and `angle_deg` degrees off the surface: by how
    /// much they are is measured.
    ///
    /// # Errors
    /// When a number is out of range or a face cannot be meshed.
    pub fn skin(&self, deflection: f64, angle_deg: f64) -> Result<Skin> {
        length("deflection of the mesh", deflection)?;
        let raw = bridge::skin(self.solid()?, deflection, angle_deg.to_radians())
            .context(|| "the solid could not be meshed".to_owned())?;
        let (mut triangle, mut border) = (0, 0);
        let mut faces = Vec::with_capacity(raw.faces.len());
        for face in &raw.faces {
            let span = |from: u32, to: u32| Some(from as usize..to as usize);
            let edges = span(border, face.edges_end).and_then(|r| raw.face_edges.get(r));
            faces.push(SkinFace {
                shell: face.shell,
                surface: surface(face),
                outward: face.outward,
                off: off(face)?,
                triangles: [triangle, face.triangles_end],
                edges: edges.unwrap_or_default().to_vec(),
            });
            (triangle, border) = (face.triangles_end, face.edges_end);
        }
        Ok(Skin {
            faces,
            edges: raw.edges.iter().map(edge).collect(),
            positions: raw.positions.as_chunks::<3>().0.to_vec(),
            triangles: raw.triangles.as_chunks::<3>().0.to_vec(),
        })
    }
}

impl Skin {
    /// The skin as bytes.
    ///
    /// # Errors
    /// When it cannot be encoded.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        postcard::to_stdvec(self)
            .map_err(|_| KernelError::internal("the skin could not be encoded"))
    }

    /// A skin from [`Skin::to_bytes`]; none where the bytes are no skin.
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        postcard::from_bytes(bytes).ok()
    }
}

/// The bound of a face, from what was measured.
fn off(face: &bridge::SkinFaceRaw) -> Result<f64> {
    let off = WORST * face.off + NODES_MM;
    match off.is_finite() {
        true => Ok(off),
        false => Err(KernelError::invalid(
            "how far the triangles of a face are off its surface is not known",
        )),
    }
}

fn surface(raw: &bridge::SkinFaceRaw) -> SkinSurface {
    let (origin, axis, radius) = (raw.origin, raw.axis, raw.radius);
    match raw.kind {
        0 => SkinSurface::Plane {
            origin,
            normal: axis,
        },
        1 => SkinSurface::Cylinder {
            origin,
            axis,
            radius,
            range: [raw.low, raw.high],
        },
        2 => {
            // The kernel's second parameter runs along the cone's side.
            let along = 1.0 / libm::sqrt(1.0 + raw.other * raw.other);
            SkinSurface::Cone {
                origin,
                axis,
                radius,
                slope: raw.other,
                range: [raw.low * along, raw.high * along],
            }
        }
        3 => SkinSurface::Sphere {
            center: origin,
            radius,
        },
        4 => SkinSurface::Torus {
            center: origin,
            axis,
            radius,
            tube: raw.other,
        },
        _ => SkinSurface::Other,
    }
}

fn edge(raw: &bridge::SkinEdgeRaw) -> SkinEdge {
    let curve = match raw.kind {
        0 => SkinCurve::Line,
        1 => SkinCurve::Circle {
            center: raw.center,
            axis: raw.axis,
            radius: raw.radius,
            sweep: raw.sweep,
        },
        2 => SkinCurve::Other,
        _ => SkinCurve::Point,
    };
    SkinEdge {
        curve,
        turn: Turn::of(raw.turn),
        start: raw.start,
        end: raw.end,
        middle: raw.middle,
    }
}
