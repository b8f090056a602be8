//! Solids for pictures: what two placed solids have in common, and what a plane leaves of one.

use assemcad_model::frame::{Frame, Placement};
use nalgebra::Vector3;

use crate::booleans::{Kind, judge};
use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::shape::Shape;

/// A plane that reaches less than this into a solid, in mm, does not cut it.
const REACH_MM: f64 = 1e-6;

/// The common part of two placed solids, in the world; none where they have no volume in common.
///
/// # Errors
/// When a placement is not rigid, or the boolean did not end properly or cannot be right.
pub fn shared(a: &Shape, at_a: &Placement, b: &Shape, at_b: &Placement) -> Result<Option<Shape>> {
    if a.bounds_at(at_a)?.common(&b.bounds_at(at_b)?).is_none() {
        return Ok(None);
    }
    let (a, b) = (a.placed(at_a)?, b.placed(at_b)?);
    let common = a.shared(&[&b], None)?;
    if common.parts(Topology::Solid)?.is_empty() {
        return Ok(None);
    }
    judge(Kind::Common, &a, &b, &common)?;
    settled(&common).map(Some)
}

/// What is left of a solid behind the plane through `point` across `normal`: the side into which the
/// normal points is taken away. None where nothing is left.
///
/// # Errors
/// When the plane is none, or the boolean did not end properly or cannot be right.
pub fn behind(solid: &Shape, point: [f64; 3], normal: [f64; 3]) -> Result<Option<Shape>> {
    let plane = across(point, normal)?;
    // The extent across the plane, exactly: the solid's box as the plane's own frame sees it.
    let seen = solid.bounds_at(&plane.inverse())?;
    let ([x0, y0, low], [x1, y1, high]) = (seen.min, seen.max);
    if high <= REACH_MM {
        return solid.try_clone().map(Some);
    }
    if low >= -REACH_MM {
        return Ok(None);
    }
    // The half space as far as it matters: a box on the plane, wider and higher than the solid.
    let wide = 1.0 + 0.1 * (x1 - x0).max(y1 - y0).max(high - low);
    let corner = Frame {
        origin: plane.point([x0 - wide, y0 - wide, 0.0]),
        ..plane.frame(&Frame::WORLD)
    };
    let size = [x1 - x0 + 2.0 * wide, y1 - y0 + 2.0 * wide, high + wide];
    let tool = Shape::cuboid(&corner, size)?;
    let left = solid.without(&[&tool], None)?;
    judge(Kind::Cut, solid, &tool, &left)?;
    settled(&left).map(Some)
}

/// A frame whose z is across the plane.
fn across(point: [f64; 3], normal: [f64; 3]) -> Result<Placement> {
    let z = Vector3::from(normal);
    // Any direction will do that is not along the normal: that of its smallest component.
    let mut x = Vector3::zeros();
    if let Some(component) = x.get_mut(z.abs().imin()) {
        *component = 1.0;
    }
    let x = x - z * (x.dot(&z) / z.norm_squared());
    Frame::new(point, normal, x.into())
        .and_then(|frame| frame.placement())
        .map_err(|e| KernelError::refused(e.to_string()))
}

/// The same from every process: the kernel's booleans list their faces in any order.
fn settled(shape: &Shape) -> Result<Shape> {
    Shape::from_bytes(&shape.baked()?.to_bytes()?)
}
