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

impl Mesh {
    /// Positions and triangles as plain bytes, little-endian: the number of nodes, three 64-bit coordinates
    /// for each, then three 32-bit nodes for each triangle. Normals are left out.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let nodes = self.positions.len() as u64;
        let mut out = Vec::with_capacity(8 + 24 * self.positions.len() + 12 * self.triangles.len());
        out.extend(nodes.to_le_bytes());
        let coordinates = self.positions.as_flattened().iter();
        out.extend(coordinates.flat_map(|x| x.to_le_bytes()));
        let corners = self.triangles.as_flattened().iter();
        out.extend(corners.flat_map(|n| n.to_le_bytes()));
        out
    }

    /// A mesh without normals from [`Mesh::to_bytes`]; none where the bytes are not those of one.
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (head, rest) = bytes.split_first_chunk::<8>()?;
        let nodes = usize::try_from(u64::from_le_bytes(*head)).ok()?;
        let (positions, triangles) = rest.split_at_checked(nodes.checked_mul(24)?)?;
        let (coordinates, _) = positions.as_chunks::<8>();
        let coordinates: Vec<f64> = coordinates.iter().map(|b| f64::from_le_bytes(*b)).collect();
        let (corners, []) = triangles.as_chunks::<4>() else {
            return None;
        };
        let corners: Vec<u32> = corners.iter().map(|b| u32::from_le_bytes(*b)).collect();
        let (triangles, []) = corners.as_chunks::<3>() else {
            return None;
        };
        let known = corners.iter().all(|n| (*n as usize) < nodes);
        known.then(|| Self {
            positions: coordinates.as_chunks::<3>().0.to_vec(),
            normals: Vec::new(),
            triangles: triangles.to_vec(),
        })
    }
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

#[cfg(test)]
mod tests {
    use super::Mesh;

    #[test]
    fn a_mesh_comes_back_as_it_went() {
        let mesh = Mesh {
            positions: vec![[0.0, 0.5, -1.0], [1e-9, 2.0, 3.0], [4.0, 5.0, 6.0]],
            normals: Vec::new(),
            triangles: vec![[0, 1, 2], [2, 1, 0]],
        };
        let bytes = mesh.to_bytes();
        assert_eq!(bytes.len(), 8 + 9 * 8 + 6 * 4);
        assert_eq!(Mesh::from_bytes(&bytes).as_ref(), Some(&mesh));
        // Cut short, or with a corner that is no node.
        for n in [0, 7, 20, bytes.len() - 1] {
            assert_eq!(Mesh::from_bytes(&bytes[..n]), None, "{n}");
        }
        let lost = Mesh {
            triangles: vec![[0, 1, 3]],
            ..mesh
        };
        assert_eq!(Mesh::from_bytes(&lost.to_bytes()), None);
    }
}
