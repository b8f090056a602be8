//! Built-in factories, one `.star` file each under `builtin/`, the registry that finds factories, and the
//! admission of factories that users write.
//!
//! The file name without `.star` is the factory's name: `NAMESPACE.NAME`. Which ports a factory has,
//! where its frame sits and what its parameters mean stands in the file itself.

pub mod admission;
mod builtin;
pub mod evidence;
pub mod failure;
mod registry;

pub use assemcad_script::{Evaluated, Factory};
pub use registry::{Admitted, Registry, is_valid_name};
