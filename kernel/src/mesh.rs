//! Triangles of a solid, and its edges as the triangles have them.

use crate::error::{Context, KernelError, Result};
use crate::facts::Turn;
use crate::ffi::bridge;
use crate::limits::length;
use crate::shape::Shape;

/// The surface of a solid as triangles, counter-clockwise seen from outside.
///
/// Faces share no nodes, so that each keeps its own normals at an edge.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Nodes in mm.
    pub positions: Vec<[f64; 3]>,
    /// Unit normals out of the material, one for each node.
    pub normals: Vec<[f64; 3]>,
    /// Three nodes each.
    pub triangles: Vec<[u32; 3]>,
    /// The edges, in the order of [`Shape::edges`]; those that are a point are left out.
    pub lines: Vec<Line>,
}

/// An edge of a solid as a chain of points that are nodes of its faces' triangles.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// How the faces meet there.
    pub turn: Turn,
    /// The points in mm.
    pub points: Vec<[f64; 3]>,
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
        let points = raw.lines.as_chunks::<3>().0;
        let mut lines = Vec::new();
        let mut from = 0;
        for (end, turn) in raw.line_ends.iter().zip(&raw.line_turns) {
            let to = usize::try_from(*end).unwrap_or(usize::MAX);
            lines.push(Line {
                turn: Turn::of(*turn),
                points: points.get(from..to).unwrap_or_default().to_vec(),
            });
            from = to;
        }
        Ok(Mesh {
            positions: raw.positions.as_chunks::<3>().0.to_vec(),
            normals: raw.normals.as_chunks::<3>().0.to_vec(),
            triangles: raw.triangles.as_chunks::<3>().0.to_vec(),
            lines,
        })
    }
}

impl Mesh {
    /// The mesh as bytes, little-endian: the numbers of nodes, triangles and lines (32 bits each), the
    /// nodes, the normals, the triangles, and of each line its turn, its number of points and these.
    ///
    /// # Errors
    /// When there are more nodes than 32 bits count.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        let mut out = Vec::new();
        let count = |n: usize| {
            u32::try_from(n).map_err(|_| KernelError::refused("the mesh has too many nodes"))
        };
        for n in [self.positions.len(), self.triangles.len(), self.lines.len()] {
            out.extend(count(n)?.to_le_bytes());
        }
        let mut put = |points: &[[f64; 3]]| {
            let flat = points.as_flattened().iter();
            out.extend(flat.flat_map(|n| n.to_le_bytes()));
        };
        put(&self.positions);
        put(&self.normals);
        let corners = self.triangles.as_flattened().iter();
        out.extend(corners.flat_map(|n| n.to_le_bytes()));
        for line in &self.lines {
            out.push(line.turn.code());
            out.extend(count(line.points.len())?.to_le_bytes());
            let flat = line.points.as_flattened().iter();
            out.extend(flat.flat_map(|n| n.to_le_bytes()));
        }
        Ok(out)
    }

    /// A mesh from [`Mesh::to_bytes`]; none where the bytes are no mesh.
    #[must_use]
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let mut from = Reader(bytes);
        let (nodes, triangles, lines) = (from.count()?, from.count()?, from.count()?);
        let mut mesh = Self {
            positions: from.points(nodes)?,
            normals: from.points(nodes)?,
            ..Self::default()
        };
        for _ in 0..triangles {
            let corners = [from.count()?, from.count()?, from.count()?];
            if corners.iter().any(|c| *c >= nodes) {
                return None;
            }
            mesh.triangles.push(corners);
        }
        for _ in 0..lines {
            let turn = Turn::of(*from.take::<1>()?.first()?);
            let count = from.count()?;
            let points = from.points(count)?;
            mesh.lines.push(Line { turn, points });
        }
        from.0.is_empty().then_some(mesh)
    }
}

/// What is left to be read.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (head, rest) = self.0.split_first_chunk::<N>()?;
        self.0 = rest;
        Some(*head)
    }

    fn count(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn point(&mut self) -> Option<[f64; 3]> {
        let mut number = || self.take().map(f64::from_le_bytes);
        Some([number()?, number()?, number()?])
    }

    fn points(&mut self, count: u32) -> Option<Vec<[f64; 3]>> {
        (0..count).map(|_| self.point()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Line, Mesh, Turn};

    #[test]
    fn a_mesh_comes_back_as_it_went() {
        let mesh = Mesh {
            positions: vec![[0.0, 0.5, -1.0], [1e-9, 2.0, 3.0], [4.0, 5.0, 6.0]],
            normals: vec![[0.0, 0.0, 1.0]; 3],
            triangles: vec![[0, 1, 2], [2, 1, 0]],
            lines: vec![Line {
                turn: Turn::of(0),
                points: vec![[0.0, 0.5, -1.0], [1e-9, 2.0, 3.0]],
            }],
        };
        let bytes = mesh.to_bytes().unwrap();
        assert_eq!(Mesh::from_bytes(&bytes).as_ref(), Some(&mesh));
        // Cut short, or with a corner that is no node.
        for n in [0, 7, 20, bytes.len() - 1] {
            assert_eq!(Mesh::from_bytes(&bytes[..n]), None, "{n}");
        }
        let lost = Mesh {
            triangles: vec![[0, 1, 3]],
            ..mesh
        };
        assert_eq!(Mesh::from_bytes(&lost.to_bytes().unwrap()), None);
    }
}
