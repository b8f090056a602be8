//! Whether two placed solids touch over an area, and over how much.
//!
//! Faces touch where they lie in the same plane, or on the same cylinder, with their materials on opposite
//! sides, and have some area in common. A common edge or point has none, and faces apart are not in the
//! same surface.

use assemcad_model::frame::Placement;
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::error::{Context, KernelError, Result};
use crate::facts::{Face, Surface};
use crate::ffi::bridge;
use crate::shape::{Shape, pose};

/// How far two faces may be apart and still lie in the same surface, in mm: what placing leaves.
pub const TOUCH_MM: f64 = 1e-6;

/// How far their directions may be from each other, in radians.
const TOUCH_RAD: f64 = 1e-6;

/// Where two solids should touch, in the world.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Where {
    /// In a plane.
    Plane {
        /// A point of it.
        point: [f64; 3],
        /// Its unit normal, either way.
        normal: [f64; 3],
    },
    /// On cylinders about an axis.
    Axis {
        /// A point of it.
        point: [f64; 3],
        /// Its unit direction, either way.
        direction: [f64; 3],
    },
}

/// The contact of two placed solids.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Touch {
    /// How many faces of the first solid are in the stated surface.
    pub faces_a: u32,
    /// How many faces of the second solid are.
    pub faces_b: u32,
    /// The area that they have in common, in mm2.
    pub area: f64,
    /// What the kernel warned of.
    pub warnings: Vec<String>,
}

/// The area over which two placed solids touch in a stated surface.
///
/// # Errors
/// When a placement is not rigid or the common part of two faces cannot be computed; never taken for 0.
pub fn touch(
    a: &Shape,
    at_a: &Placement,
    b: &Shape,
    at_b: &Placement,
    place: &Where,
) -> Result<Touch> {
    let (faces_a, faces_b) = (sheets(a, at_a, place)?, sheets(b, at_b, place)?);
    let mut out = Touch {
        faces_a: number(faces_a.len())?,
        faces_b: number(faces_b.len())?,
        ..Touch::default()
    };
    for one in &faces_a {
        for two in &faces_b {
            if (one.radius - two.radius).abs() > TOUCH_MM || one.towards == two.towards {
                continue;
            }
            let common = bridge::face_common(
                a.solid()?,
                &pose(at_a)?,
                one.index,
                b.solid()?,
                &pose(at_b)?,
                two.index,
            )
            .context(|| "the contact of two faces could not be computed".to_owned())?;
            // Written so that NaN fails too.
            let most = one.area.min(two.area) * (1.0 + 1e-6);
            if !(0.0..=most).contains(&common.area) {
                return Err(KernelError::invalid(format!(
                    "the contact of two faces came out as {} mm2, and the smaller one has only {most} mm2",
                    common.area
                )));
            }
            out.area += common.area;
            out.warnings.extend(common.warnings);
        }
    }
    Ok(out)
}

/// A face in the stated surface.
struct Sheet {
    index: u32,
    area: f64,
    /// 0 for a plane.
    radius: f64,
    /// Whether its normal looks along the stated one, or towards the axis.
    towards: bool,
}

fn sheets(shape: &Shape, at: &Placement, place: &Where) -> Result<Vec<Sheet>> {
    let mut out = Vec::new();
    for (index, face) in shape.faces()?.iter().enumerate() {
        if let Some((radius, towards)) = lies(face, at, place) {
            out.push(Sheet {
                index: number(index)?,
                area: face.area,
                radius,
                towards,
            });
        }
    }
    Ok(out)
}

/// Radius and side of a face that lies in the stated surface.
fn lies(face: &Face, at: &Placement, place: &Where) -> Option<(f64, bool)> {
    let origin = Vector3::from(at.point(face.origin));
    match (&face.surface, place) {
        (
            Surface::Plane { normal },
            Where::Plane {
                point,
                normal: wanted,
            },
        ) => {
            let (normal, wanted) = (Vector3::from(at.direction(*normal)), Vector3::from(*wanted));
            let flat = normal.cross(&wanted).norm() <= TOUCH_RAD
                && (origin - Vector3::from(*point)).dot(&wanted).abs() <= TOUCH_MM;
            flat.then(|| (0.0, normal.dot(&wanted) > 0.0))
        }
        (
            Surface::Cylinder {
                axis,
                radius,
                inward,
                ..
            },
            Where::Axis { point, direction },
        ) => {
            let (axis, wanted) = (
                Vector3::from(at.direction(*axis)),
                Vector3::from(*direction),
            );
            let arm = origin - Vector3::from(*point);
            let off = (arm - wanted * arm.dot(&wanted)).norm();
            (axis.cross(&wanted).norm() <= TOUCH_RAD && off <= TOUCH_MM)
                .then_some((*radius, *inward))
        }
        _ => None,
    }
}

fn number(n: usize) -> Result<u32> {
    u32::try_from(n).map_err(|_| KernelError::internal("a solid has too many faces"))
}
