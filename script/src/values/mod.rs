//! The values of the language beyond Starlark's own; all of them immutable.

pub(crate) mod params;
mod plain;
mod solid;
mod solid_methods;

pub(crate) use params::Param;
pub(crate) use plain::{Edges, Frame, Outline, Profile, Segment, pieces};
pub(crate) use solid::Solid;
