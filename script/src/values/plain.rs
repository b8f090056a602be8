//! Frames, outlines, profiles and choices of edges: what the model knows, as values of the language.
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
use assemcad_model::recipe;
use starlark::environment::{Methods, MethodsBuilder};
use starlark::values::{
    NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, Value, starlark_value,
};
use starlark::{starlark_module, starlark_simple_value};

use crate::language::number;

/// A frame.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Frame {
    #[allocative(skip)]
    pub(crate) frame: assemcad_model::frame::Frame,
}
starlark_simple_value!(Frame);
starlark::methods_static!(FRAME_METHODS = frame_methods);

#[starlark_value(type = "Frame")]
impl<'v> StarlarkValue<'v> for Frame {
    fn get_methods() -> Option<&'static Methods> {
        Some(FRAME_METHODS.methods())
    }
}

#[starlark_module]
fn frame_methods(builder: &mut MethodsBuilder) {
    /// The origin in mm.
    #[starlark(attribute)]
    fn origin(this: &Frame) -> anyhow::Result<(f64, f64, f64)> {
        Ok(this.frame.origin.into())
    }
    /// The x direction.
    #[starlark(attribute)]
    fn x(this: &Frame) -> anyhow::Result<(f64, f64, f64)> {
        Ok(this.frame.x.into())
    }
    /// The z direction.
    #[starlark(attribute)]
    fn z(this: &Frame) -> anyhow::Result<(f64, f64, f64)> {
        Ok(this.frame.z.into())
    }
    /// `shifted(x, y, z)`: the frame moved along its own axes.
    fn shifted<'v>(
        this: &Frame,
        x: Value<'v>,
        y: Value<'v>,
        z: Value<'v>,
    ) -> anyhow::Result<Frame> {
        let by = [number(x, "x")?, number(y, "y")?, number(z, "z")?];
        Ok(Frame {
            frame: shift(&this.frame, by)?,
        })
    }
}

/// A frame moved along its own axes.
pub(crate) fn shift(
    frame: &assemcad_model::frame::Frame,
    by: [f64; 3],
) -> Result<assemcad_model::frame::Frame, crate::fault::Fault> {
    let placement = frame
        .placement()
        .map_err(|e| crate::fault::Fault::new(e.to_string()))?;
    Ok(assemcad_model::frame::Frame {
        origin: placement.point(by),
        ..*frame
    })
}

macro_rules! plain {
    ($(#[$doc:meta])* $name:ident, $type:literal, $field:ident: $inner:ty) => {
        $(#[$doc])*
        #[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
        pub(crate) struct $name {
            #[allocative(skip)]
            pub(crate) $field: $inner,
        }
        starlark_simple_value!($name);
        #[starlark_value(type = $type)]
        impl<'v> StarlarkValue<'v> for $name {}
        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(concat!("<", $type, ">"))
            }
        }
    };
}

plain!(
    /// A closed outline in a plane.
    Outline, "Outline", outline: recipe::Outline
);
plain!(
    /// A piece of a path.
    Segment, "Segment", segment: recipe::Segment
);
plain!(
    /// A plane region.
    Profile, "Profile", profile: recipe::Profile
);
plain!(
    /// A choice of edges.
    Edges, "Edges", edges: recipe::EdgeSelector
);

impl fmt::Display for Frame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let show = |[x, y, z]: [f64; 3]| format!("({x}, {y}, {z})");
        let (origin, z, x) = (self.frame.origin, self.frame.z, self.frame.x);
        write!(
            f,
            "frame(origin = {}, z = {}, x = {})",
            show(origin),
            show(z),
            show(x)
        )
    }
}

/// How many pieces a profile holds.
pub(crate) fn pieces(profile: &recipe::Profile) -> usize {
    core::iter::once(&profile.outer)
        .chain(&profile.holes)
        .map(|outline| match outline {
            recipe::Outline::Circle { .. } => 1,
            recipe::Outline::Path { segments, .. } => segments.len() + 1,
        })
        .sum()
}
