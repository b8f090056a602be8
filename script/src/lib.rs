//! The factory language: Starlark source to a recipe with ports.
//!
//! No kernel, no files and no clock are in reach of a script. It *records* calls of CadQuery's
//! vocabulary ([`assemcad_model::language`]) and never computes geometry, so the same source and the
//! same parameters give the same recipe in every process.
//!
//! A source is text of a stranger. Every limit in [`Limits`] that it exceeds, and every fault that it
//! holds, comes back as a [`assemcad_model::diagnostic::Diagnostic`] that names the line.

mod expression;
mod factory;
mod fault;
mod hints;
mod imports;
mod involute;
mod language;
mod limits;
mod python;
mod recorder;
mod reference;
mod run;
mod scan;
mod thread;
mod values;
pub mod worker;

pub use expression::expressions;
pub use factory::{Evaluated, Factory, script, script_within};
pub use limits::Limits;
pub use reference::reference;
pub use worker::Evaluator;
