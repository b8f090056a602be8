//! Triangles and edges of a body.

use std::sync::Arc;

use assemcad_kernel::asked::Body;
use assemcad_kernel::mesh::Mesh as Triangles;
use assemcad_kernel::protocol::{Failure, Job, Reply};

use crate::door::{Asker, Key, Question, nonsense};

/// Triangles of a body; none where it is empty.
#[derive(Debug)]
pub struct Mesh<'a> {
    /// The body.
    pub body: &'a Body,
    /// How far a triangle may be from the surface, in mm.
    pub deflection: f64,
    /// How far a triangle may be turned from the surface, in degrees.
    pub angle_deg: f64,
}

impl Question for Mesh<'_> {
    type Answer = Option<Arc<Triangles>>;
    const KIND: &'static str = "mesh";

    fn key(&self, into: &mut Key) {
        match self.body {
            Body::Whole { recipe } => into.text(recipe.hash()),
            Body::Behind {
                recipe,
                point,
                normal,
            } => {
                into.text(recipe.hash());
                into.numbers(point.iter().chain(normal).copied());
            }
            Body::Shared { a, b } => {
                for part in [a, b] {
                    into.text(part.recipe.hash());
                    into.numbers(crate::pose::numbers(&part.placement.into()));
                }
            }
        }
        into.numbers([self.deflection, self.angle_deg]);
    }

    fn bytes(mesh: &Option<Arc<Triangles>>) -> usize {
        let mesh = mesh.as_ref();
        mesh.map_or(200, |m| m.positions.len() * 48 + m.triangles.len() * 12)
    }

    /// Those of whole parts, which verification looks at, too; not those of one picture.
    fn is_kept(&self) -> bool {
        matches!(self.body, Body::Whole { .. })
    }

    fn to_bytes(mesh: &Self::Answer) -> Option<Vec<u8>> {
        mesh.as_ref()?.to_bytes().ok()
    }

    fn from_bytes(bytes: &[u8]) -> Option<Self::Answer> {
        Triangles::from_bytes(bytes).map(|mesh| Some(Arc::new(mesh)))
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Self::Answer, Failure> {
        let job = Job::Tessellate {
            body: self.body.clone(),
            deflection: self.deflection,
            angle_deg: self.angle_deg,
        };
        match door.kernel(&job).await? {
            (Reply::Mesh { some: false }, _) => Ok(None),
            (Reply::Mesh { some: true }, bytes) => {
                let mesh = Triangles::from_bytes(&bytes).ok_or_else(nonsense)?;
                Ok(Some(Arc::new(mesh)))
            }
            _ => Err(nonsense()),
        }
    }
}
