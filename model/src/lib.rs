//! Pure data and mathematics of assemblies.
//!
//! This crate knows no kernel, no files and no protocol: it says what a part, a port, a mate, a
//! recipe, a specification, a diagnostic and a report *are*, and computes placements in closed form.
//!
//! Units everywhere: millimetres; degrees where a name ends in `_deg`; right-handed frames.

pub mod angle;
pub mod canonical;
pub mod diagnostic;
pub mod frame;
pub mod freedom;
pub mod language;
pub mod mates;
pub mod name;
pub mod param;
pub mod ports;
pub mod probe;
pub mod recipe;
pub mod report;
pub mod selector;
pub mod spec;
pub mod told;
pub mod yaml;
