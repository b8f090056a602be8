//! The values of the language beyond Starlark's own; all of them immutable.

pub(crate) mod handle;
pub(crate) mod params;
mod place;
mod plain;
mod vector;

pub(crate) use handle::{Function, handle};
pub(crate) use params::Param;
pub(crate) use place::{Location, Plane};
pub(crate) use plain::{Item, Outline, Selector};
pub(crate) use vector::Vector;

/// A fault as an error of the interpreter.
pub(crate) fn native(fault: crate::fault::Fault) -> starlark::Error {
    starlark::Error::new_native(anyhow::Error::new(fault))
}
