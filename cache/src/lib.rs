//! Values that can be made anew, kept on disk below the root by the name of what they depend on.
//!
//! Nothing here is state: all of it can be lost at any time. What is read was written by the same kernel into this
//! very folder, whole, or it is not taken: a value stands behind the hash of its bytes, in a plain file that no link
//! leads to. Several processes may use one folder at once. Where it grows over its limit, what was not used for the
//! longest time goes first.

mod files;
mod folder;
mod tidy;

pub use files::{Cache, Entry};
pub use folder::Folder;
pub use tidy::Left;
