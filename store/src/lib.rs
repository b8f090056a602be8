//! What is on disk: assemblies, rounds of drafts and of sources, admitted factories.
//!
//! The root is opened as a capability: whatever a path or a link says, nothing outside it is reached.
//! Files are written beside their place and moved there, so that a reader or a crash never sees half
//! of one.

mod assemblies;
pub mod draft;
mod factories;
mod fault;
mod files;
mod root;
mod rounds;
mod sweep;
mod switch;

pub use assemblies::{check_name, export_of, file_of, specification, yaml_bytes};
pub use draft::Draft;
pub use factories::{Stamp, StoredFactory};
pub use files::{check_path, json_bytes};
pub use root::{Lock, Store};
pub use rounds::{Round, history};
