//! Triangles of a solid.

use serde::{Deserialize, Serialize};

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge;
use crate::limits::length;
use crate::shape::Shape;

/// The surface of a solid as triangles, counter-clockwise seen from outside.
///
/// Faces share no nodes, so that each keeps its own normals at an edge.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Mesh {
    /// Nodes in mm.
    pub positions: Vec<[f64; 3]>,
    /// Unit normals out of the material, one for each node.
    pub normals: Vec<[f64; 3]>,
    /// Three nodes each.
    pub triangles: Vec<[u32; 3]>,
}

impl Shape {
    /// Triangles that deviate at most `deflection` mm and `angle_deg` degrees from the surface.
    ///
    /// # Errors
    /// When a number is out of range or a face cannot be meshed.
    pub fn mesh(&self, deflection: f64, angle_deg: f64) -> Result<Mesh> {
        length("deflection of the mesh", deflection)?;
        if !(1.0..=90.0).contains(&angle_deg) {
            return Err(KernelError::refused(format!(
                "the angle of the mesh is {angle_deg} degrees, and must lie between 1 and 90"
            )));
        }
        let raw = bridge::mesh(self.solid()?, deflection, angle_deg.to_radians())
            .context(|| "the solid could not be meshed".to_owned())?;
        Ok(Mesh {
            positions: raw.positions.as_chunks::<3>().0.to_vec(),
            normals: raw.normals.as_chunks::<3>().0.to_vec(),
            triangles: raw.triangles.as_chunks::<3>().0.to_vec(),
        })
    }
}
