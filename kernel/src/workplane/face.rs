//! What a FLAT_FACE port states of its face, measured.

use std::rc::Rc;

use assemcad_model::frame::Placement;

use super::chain::{level_x, plane};
use super::value::{Node, Vector};
use crate::brep::{Form, Topology};
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// How far, in mm, a face's plane may be from the port's.
const NEAR: f64 = 1e-6;

/// The extents about the origin, and the diameter of the hole there; 0 where there is none.
pub(super) struct Extents {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) hole: f64,
}

/// The frame of the selected face: at its centre, z outward, x level.
pub(super) fn seat(node: &Node) -> Result<Placement> {
    let mut found: Option<&Rc<Shape>> = None;
    for object in &node.objects {
        if let Some(face) = object.of(Topology::Face)? {
            found = Some(face);
            break;
        }
    }
    let Some(face) = found else {
        // No face is selected: the workplane itself says where.
        let origin = super::each::places(node)?;
        let place = origin.first().copied().unwrap_or_default();
        return Ok(node.plane * place);
    };
    if face.form()? != Form::Plane {
        return Err(KernelError::refused(
            "the selected face is not plane, and a FLAT_FACE port is on a plane face",
        ));
    }
    let normal = Vector::from(face.normal_at(None)?);
    plane(face.center()?.into(), level_x(&normal), normal)
}

/// The plane face of the solid through the origin of `at` that looks along its z.
pub(super) fn face_at(solid: &Shape, at: &Placement) -> Result<Shape> {
    let [_, _, z] = at.axes();
    let mut best: Option<(f64, Shape)> = None;
    for face in solid.parts(Topology::Face)? {
        if face.form()? != Form::Plane {
            continue;
        }
        let normal = Vector::from(face.normal_at(None)?);
        let level = (Vector::from(face.center()?) - at.origin()).dot(&normal);
        if normal.dot(&z) < 1.0 - 1e-9 || level.abs() > NEAR {
            continue;
        }
        // Of several faces in the plane the one at the origin, or nearest to it.
        let mark = marker(at)?;
        let (gap, _, _) = face.distance_to(&mark)?;
        if best.as_ref().is_none_or(|(least, _)| gap < *least) {
            best = Some((gap, face));
        }
    }
    best.map(|(_, face)| face).ok_or_else(|| {
        let [x, y, w] = at.origin().into();
        KernelError::refused(format!(
            "no plane face of the solid lies at ({x:.3}, {y:.3}, {w:.3}) and looks along ({:.3}, \
             {:.3}, {:.3})",
            z.x, z.y, z.z
        ))
    })
}

/// A short edge that stands out of the plane at the origin: its distance to anything in the plane is
/// the origin's.
fn marker(at: &Placement) -> Result<Shape> {
    Shape::line_edge(at.origin().into(), at.point([0.0, 0.0, 1e-3]))
}

/// How far the face reaches from the origin along x and y, the same on both sides.
pub(super) fn measure(face: &Shape, at: &Placement) -> Result<Extents> {
    let hole = hole_about(face, at)?;
    let extent = face.extent()?;
    let reach = Vector::from(extent.size()).norm()
        + (Vector::from(face.center()?) - at.origin()).norm()
        + 1.0;
    let mut halves = [0.0, 0.0];
    for (half, (ax, ay)) in halves.iter_mut().zip([(1.0, 0.0), (0.0, 1.0)]) {
        let mut least = f64::INFINITY;
        for sign in [1.0, -1.0] {
            let way = at.direction([sign * ax, sign * ay, 0.0]);
            let from = at.origin() + Vector::from(way) * (hole / 2.0);
            least = least.min(ray(face, from, way.into(), reach)?);
        }
        *half = hole / 2.0 + least;
    }
    let [x, y] = halves.map(|half| 2.0 * half);
    if !(x > 2.0 * NEAR && y > 2.0 * NEAR) {
        let [a, b, c] = at.origin().into();
        return Err(KernelError::refused(format!(
            "the middle of the face, ({a:.3}, {b:.3}, {c:.3}), is not on its material: give the port's \
             place as at = cq.Plane(origin, xDir, normal), with extent_x and extent_y"
        )));
    }
    Ok(Extents { x, y, hole })
}

/// How far material goes on from a point along a direction in the face.
fn ray(face: &Shape, from: Vector, way: Vector, reach: f64) -> Result<f64> {
    let line = Shape::line_edge(from.into(), (from + way * reach).into())?;
    let met = line.shared(&[face], None)?;
    let mut far = 0.0_f64;
    for edge in met.parts(Topology::Edge)? {
        let along = |p: [f64; 3]| (Vector::from(p) - from).dot(&way);
        let (a, b) = (along(edge.start_point()?), along(edge.end_point()?));
        if a.min(b) < NEAR {
            far = far.max(a.max(b));
        }
    }
    Ok(far)
}

/// The diameter of the circular hole about the origin; 0 where there is none.
fn hole_about(face: &Shape, at: &Placement) -> Result<f64> {
    for wire in face.inner_wires()? {
        let edges = wire.parts(Topology::Edge)?;
        let mut circles = 0;
        for edge in &edges {
            let center = Vector::from(wire.center()?);
            if edge.form()? == Form::Circle && (center - at.origin()).norm() < 1e-6 {
                circles += 1;
            }
        }
        if circles > 0
            && circles == edges.len()
            && let Some(edge) = edges.first()
        {
            return Ok(2.0 * edge.radius()?);
        }
    }
    Ok(0.0)
}
