//! Realisation of specifications: build parts, place them, verify, export; the assemblies on disk.
//!
//! The specification on disk is the only state. Every operation reads it, and every accepted change
//! is written back before the operation returns, so that a killed server loses nothing.

mod admitted;
pub mod draft;
pub mod edit;
pub mod export;
mod made;
mod partial;
pub mod realize;
mod remembered;
pub mod report_files;
mod reports;
pub mod resolve;
pub mod state;
mod step_header;
mod sweep;
pub mod synthesis;
mod verify;
mod views;
mod workshop;

pub use assemcad_model::diagnostic::Faults;
pub use verify::Verified;
pub use workshop::{DEFAULT_CACHE_MB, DEFAULT_LIMIT_S, DEFAULT_ROUNDS, Workshop};
