//! OpenCASCADE behind a narrow wall: task-level verbs, each of which may fail and says why.
//!
//! Lengths in mm, angles in degrees where a name ends in `_deg`. The kernel may still crash or hang
//! on bad luck in its geometry: whoever calls it does so in a process that may die.

// Linked for what it finds: it names the libraries of OCCT and where they are.
use opencascade_sys as _;

pub mod asked;
pub mod booleans;
pub mod brep;
pub mod contact;
pub mod error;
pub mod facts;
mod ffi;
pub mod limits;
mod memory;
pub mod mesh;
pub mod named;
pub mod pair;
pub mod pool;
pub mod primitives;
pub mod probe;
pub mod protocol;
pub mod query;
pub mod replay;
pub mod revolution;
pub mod section;
pub mod shape;
pub mod skin;
pub mod step;
pub mod worker;
pub mod workplane;

pub use error::{KernelError, Kind};
pub use replay::{ReplayError, replay};
pub use shape::Shape;

/// The kernel's name and version.
#[must_use]
pub fn version() -> String {
    format!("OCCT {}", env!("ASSEMCAD_OCCT_VERSION"))
}

/// What a solid, and what is found out about one, depends on beside its recipe: OCCT, the sources of this crate, the
/// processor.
#[must_use]
pub fn fingerprint() -> String {
    format!(
        "occt-{}/{}/{}",
        env!("ASSEMCAD_OCCT_VERSION"),
        env!("ASSEMCAD_KERNEL_SOURCES"),
        std::env::consts::ARCH
    )
}
