//! Built-in factories, one `.star` file each under `builtin/`, and the registry that finds factories.
//!
//! The file name without `.star` is the factory's name: `NAMESPACE.NAME`. Which ports a factory has,
//! where its frame sits and what its parameters mean stands in the file itself.

mod builtin;
mod registry;

pub use assemcad_script::{Evaluated, Factory};
pub use registry::{Registry, is_valid_name};
