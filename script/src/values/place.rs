//! `cq.Plane` and `cq.Location`.
#![allow(
    clippy::panic,
    reason = "derive(StarlarkPagablePanic); nothing here is ever paged out"
)]
#![allow(missing_docs, reason = "the macros make public items of the values")]
#![allow(
    unsafe_code,
    reason = "derive(ProvidesStaticType) implements an unsafe trait; none of ours"
)]

use core::fmt;

use allocative::Allocative;
use assemcad_model::frame::{Frame, Placement};
use starlark::environment::{Methods, MethodsBuilder};
use starlark::values::{
    Heap, NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, Value,
    starlark_value,
};
use starlark::{starlark_module, starlark_simple_value};

use super::handle::Place;
use super::{Vector, native};
use crate::fault::Fault;
use crate::language::kind_of;

/// A plane: its frame.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Plane {
    #[allocative(skip)]
    pub(crate) frame: Frame,
}
starlark_simple_value!(Plane);
starlark::methods_static!(PLANE_METHODS = plane_methods);

impl Plane {
    /// A plane as CadQuery makes it.
    pub(crate) fn new(
        origin: [f64; 3],
        x: Option<[f64; 3]>,
        normal: [f64; 3],
    ) -> Result<Self, Fault> {
        if normal == [0.0; 3] {
            return Err(Fault::new("normal has a length, not (0, 0, 0)"));
        }
        let x = x.unwrap_or_else(|| across(normal));
        Frame::new(origin, normal, x)
            .map(|frame| Self { frame })
            .map_err(|e| Fault::new(e.to_string()).hint("xDir is at a right angle to normal"))
    }
}

/// The x direction that `gp_Ax3(gp_Pnt, gp_Dir)` of OCCT takes where none is stated: the normal with
/// its smallest component left out and the others swapped.
fn across([a, b, c]: [f64; 3]) -> [f64; 3] {
    let (p, q, r) = (a.abs(), b.abs(), c.abs());
    if q <= p && q <= r {
        if p > r { [-c, 0.0, a] } else { [c, 0.0, -a] }
    } else if p <= q && p <= r {
        if q > r { [0.0, -c, b] } else { [0.0, c, -b] }
    } else if p > q {
        [-b, a, 0.0]
    } else {
        [b, -a, 0.0]
    }
}

impl fmt::Display for Plane {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let show = |[x, y, z]: [f64; 3]| format!("({x}, {y}, {z})");
        let Frame { origin, x, z } = self.frame;
        write!(
            f,
            "Plane(origin={}, xDir={}, normal={})",
            show(origin),
            show(x),
            show(z)
        )
    }
}

#[starlark_value(type = "Plane")]
impl<'v> StarlarkValue<'v> for Plane {
    fn get_methods() -> Option<&'static Methods> {
        Some(PLANE_METHODS.methods())
    }
}

#[starlark_module]
fn plane_methods(builder: &mut MethodsBuilder) {
    #[starlark(attribute)]
    fn origin(this: &Plane) -> anyhow::Result<Vector> {
        Ok(Vector::new(this.frame.origin)?)
    }
    #[starlark(attribute)]
    fn xDir(this: &Plane) -> anyhow::Result<Vector> {
        Ok(Vector::new(this.frame.x)?)
    }
    #[starlark(attribute)]
    fn yDir(this: &Plane) -> anyhow::Result<Vector> {
        Ok(Vector::new(this.frame.z)?.cross_with(this.frame.x)?)
    }
    #[starlark(attribute)]
    fn zDir(this: &Plane) -> anyhow::Result<Vector> {
        Ok(Vector::new(this.frame.z)?)
    }
}

/// A motion.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Location {
    #[allocative(skip)]
    pub(crate) placement: Placement,
}
starlark_simple_value!(Location);
starlark::methods_static!(LOCATION_METHODS = location_methods);

impl Location {
    /// Turned about x, y and z of the world one after the other, in degrees, then moved.
    pub(crate) fn turned([x, y, z]: [f64; 3], [rx, ry, rz]: [f64; 3]) -> Result<Self, Fault> {
        let about_y = Placement::rotation_about([0.0; 3], [0.0, 1.0, 0.0], ry)
            .map_err(|e| Fault::new(e.to_string()))?;
        let placement = Placement::translation(x, y, z)
            * Placement::rotation_z(rz)
            * about_y
            * Placement::rotation_x(rx);
        Ok(Self { placement })
    }

    /// Turned about an axis through the origin, then moved.
    pub(crate) fn about([x, y, z]: [f64; 3], axis: [f64; 3], deg: f64) -> Result<Self, Fault> {
        let turn = Placement::rotation_about([0.0; 3], axis, deg)
            .map_err(|_| Fault::new("the axis of a location has a length, not (0, 0, 0)"))?;
        Ok(Self {
            placement: Placement::translation(x, y, z) * turn,
        })
    }

    /// The motion of the world's axes to a frame.
    pub(crate) fn of(frame: &Frame) -> Result<Self, Fault> {
        frame
            .placement()
            .map(|placement| Self { placement })
            .map_err(|e| Fault::new(e.to_string()))
    }
}

impl TryFrom<&Location> for Frame {
    type Error = Fault;

    fn try_from(location: &Location) -> Result<Self, Fault> {
        let p = location.placement;
        let [x, _, z] = p.axes().map(|axis| <[f64; 3]>::from(axis).map(|n| n + 0.0));
        let origin = <[f64; 3]>::from(p.origin()).map(|n| n + 0.0);
        Self::new(origin, z, x).map_err(|e| Fault::new(e.to_string()))
    }
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("<Location>")
    }
}

#[starlark_value(type = "Location")]
impl<'v> StarlarkValue<'v> for Location {
    fn get_methods() -> Option<&'static Methods> {
        Some(LOCATION_METHODS.methods())
    }
    fn mul(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
        Some(match Self::from_value(other) {
            Some(inner) => Ok(heap.alloc(Self {
                placement: self.placement * inner.placement,
            })),
            None if Place::from_value(other).is_some() => Err(native(
                Fault::new("the location that a function is given is not known yet")
                    .hint("move the shape twice: write shape.moved(loc).moved(outer)"),
            )),
            None => Err(native(Fault::new(format!(
                "a Location is multiplied by a Location, not by {}",
                kind_of(other)
            )))),
        })
    }
}

#[starlark_module]
fn location_methods(builder: &mut MethodsBuilder) {
    #[starlark(attribute)]
    fn inverse(this: &Location) -> anyhow::Result<Location> {
        Ok(Location {
            placement: this.placement.inverse(),
        })
    }
    #[starlark(attribute)]
    fn plane(this: &Location) -> anyhow::Result<Plane> {
        Ok(Plane {
            frame: Frame::try_from(this)?,
        })
    }
}
