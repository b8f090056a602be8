//! The one door to geometry: questions about solids, and their answers.
//!
//! A question names solids by the hash of their recipe, and where they are to each other. Its answer depends on
//! nothing else but the kernel, and so it is found out once: for all who ask at the same time, wherever equal parts
//! stand in equal relative places, and again after a part next to others was changed only where it was. The
//! specification remains the only state: what is remembered here can be lost at any time.
//!
//! Nobody else calls the kernel.

mod door;
mod gate;
mod kept;
pub mod narrow;
mod pair;
pub mod pose;
pub mod questions;

mod ask;

pub use door::{Asker, Counts, Door, Key, OnDisk, Question, Terms};
pub use gate::Urgency;
pub use pair::PlacedSolid;
pub use questions::beyond::Stray;
pub use questions::overlap::ENTERS;
