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
use crate::shape::{Shape, pose, start};

mod along;
mod ffi;
mod look;
mod topology;

pub use look::{Form, Measure};
pub use topology::Topology;

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
