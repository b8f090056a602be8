//! Parts resolved, made and in their places: what verification, motion, pictures and export look at.
//!
//! Nothing here reads a specification from disk or calls a factory: who has resolved and placed an
//! assembly gives it to those that look at it. All geometry is asked at the door.

pub mod linkage;
pub mod partial;
pub mod place;
pub mod products;
pub mod resolved;
pub mod solids;

pub use partial::Partial;
pub use place::Placements;
pub use resolved::{Made, Resolved, ResolvedMate, ResolvedPart};
pub use solids::{Assembled, Box3};
