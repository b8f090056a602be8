//! Triangles from the kernel's workers.

use std::sync::Arc;

use assemcad_factories::failure::diagnostic;
use assemcad_geometry::Asker;
use assemcad_kernel::asked::Body;
use assemcad_kernel::facts::Turn;
use assemcad_kernel::mesh::Mesh;
use assemcad_model::diagnostic::Diagnostic;
use assemcad_render::Surface;

/// How far a triangle may be turned from the surface, in degrees: shading hides what is left.
const ANGLE_DEG: f64 = 12.0;

/// How near to the plane the nodes of a cut face are, in mm.
const ON_PLANE_MM: f64 = 1e-5;

/// How well the normal of a cut face agrees with the plane's: the cosine of 2.6 degrees.
const ALONG: f64 = 0.999;

/// The surface of a body in its frame; none where the body is empty. `place` says whose it is.
pub(super) async fn surface(
    door: Asker<'_>,
    body: Body,
    deflection_mm: f64,
    place: &str,
) -> Result<Option<Arc<Surface>>, Diagnostic> {
    let plane = match &body {
        Body::Behind { point, normal, .. } => Some((*point, *normal)),
        _ => None,
    };
    match door.mesh(&body, deflection_mm, ANGLE_DEG).await {
        Ok(mesh) => Ok(mesh.map(|mesh| Arc::new(drawn(&mesh, plane)))),
        Err(failure) => Err(diagnostic(&failure, place)),
    }
}

/// A mesh as it is drawn: edges at which the surface bends, and the faces in the plane of the cut.
fn drawn(mesh: &Mesh, plane: Option<([f64; 3], [f64; 3])>) -> Surface {
    let cut = match plane {
        None => Vec::new(),
        Some((point, normal)) => {
            let dot =
                |a: &[f64; 3], b: &[f64; 3]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
            let level = dot(&point, &normal);
            let on = |i: &u32| {
                let i = usize::try_from(*i).unwrap_or(usize::MAX);
                let (p, n) = (mesh.positions.get(i), mesh.normals.get(i));
                p.is_some_and(|p| (dot(p, &normal) - level).abs() <= ON_PLANE_MM)
                    && n.is_some_and(|n| dot(n, &normal) >= ALONG)
            };
            mesh.triangles.iter().map(|t| t.iter().all(on)).collect()
        }
    };
    let bends = |turn: Turn| matches!(turn, Turn::Convex | Turn::Concave);
    Surface {
        positions: mesh.positions.clone(),
        normals: mesh.normals.clone(),
        triangles: mesh.triangles.clone(),
        cut,
        edges: mesh
            .lines
            .iter()
            .filter(|line| bends(line.turn))
            .map(|line| line.points.clone())
            .collect(),
    }
}
