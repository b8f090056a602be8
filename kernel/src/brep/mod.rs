//! Shapes of any kind, from vertices to compounds, and the verbs of a workplane on them.
//!
//! A [`Shape`] here may be a vertex, an edge, a wire, a face, a shell, a solid or a group of them.
//! The verbs do what CadQuery's classes of the same purpose do and judge no further: whether what
//! comes out is one sound solid, whoever called asks at the end. Points and lengths are in mm, angles
//! in degrees where a name ends in `_deg`.

use assemcad_model::frame::Placement;
use cxx::UniquePtr;

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge::{At, Solid};
use crate::limits::{SMALLEST, coordinates};
use crate::shape::{Shape, pose, start};

mod along;
mod booleans;
mod curves;
mod faces;
mod ffi;
mod look;
mod solids;
mod sweeps;
mod topology;
mod wires;

pub use curves::Spline;
pub use look::{Form, Measure};
pub use sweeps::{Side, Sweep, Transition};
pub use topology::Topology;
pub use wires::Corner;

use ffi::bridge;

/// A shape that C++ made, or the sentence why not.
fn made(
    made: core::result::Result<UniquePtr<Solid>, cxx::Exception>,
    what: impl FnOnce() -> String,
) -> Result<Shape> {
    made.context(what).and_then(Shape::wrap)
}

/// Shapes on their way to C++.
fn bundle(shapes: &[&Shape]) -> Result<UniquePtr<bridge::Bundle>> {
    start()?;
    let mut out = bridge::bundle();
    for shape in shapes {
        out.pin_mut()
            .push(shape.solid()?)
            .context(|| "the shapes could not be put together".into())?;
    }
    Ok(out)
}

/// Shapes on their way from C++.
fn unbundle(
    made: core::result::Result<UniquePtr<bridge::Bundle>, cxx::Exception>,
    what: impl Fn() -> String,
) -> Result<Vec<Shape>> {
    let made = made.context(&what)?;
    let shapes = made
        .as_ref()
        .ok_or_else(|| KernelError::internal("the kernel returned no list of shapes"))?;
    (0..shapes.size())
        .map(|index| self::made(shapes.at(index), &what))
        .collect()
}

/// A placement as C++ takes a frame.
fn frame(at: &Placement) -> Result<At> {
    start()?;
    // For what it refuses: a placement that mirrors or is not finite.
    pose(at)?;
    let [x, _, z] = at.axes();
    Ok(At {
        origin: at.origin().into(),
        x: x.into(),
        z: z.into(),
    })
}

/// An angle in degrees as C++ takes it, in radians, at most ten turns either way.
fn radians(what: &str, deg: f64) -> Result<f64> {
    // Written so that NaN fails too.
    if deg.abs() <= 3600.0 {
        Ok(deg.to_radians())
    } else {
        Err(KernelError::refused(format!(
            "the {what} is {deg} degrees, and must lie between -3600 and 3600"
        )))
    }
}

fn gap(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(p, q)| (p - q) * (p - q)).sum();
    square.sqrt()
}

/// That two points are no single one.
fn apart(what: &str, a: &[f64; 3], b: &[f64; 3]) -> Result<()> {
    if gap(a, b) < SMALLEST {
        let [x, y, z] = a;
        return Err(KernelError::refused(format!(
            "the {what} has two points in one place, ({x}, {y}, {z})"
        )));
    }
    Ok(())
}

/// Points that a curve runs through: finite, and no two in one place that follow each other.
fn run<'a>(what: &str, points: &'a [[f64; 3]]) -> Result<&'a [f64]> {
    let flat = points.as_flattened();
    coordinates(what, flat)?;
    for (a, b) in points.iter().zip(points.iter().skip(1)) {
        apart(what, a, b)?;
    }
    if points.len() < 2 {
        return Err(KernelError::refused(format!(
            "the {what} has {} points, and needs at least 2",
            points.len()
        )));
    }
    Ok(flat)
}
