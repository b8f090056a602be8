//! Whether two placed solids have anything in common, decided from their skins alone.
//!
//! # Why it is a proof
//!
//! Let every pair of pieces of faces that come nearer to each other than their triangles may be off be
//! *parted*: all of one piece lies on the outer side of the other's surface, or of a plane that the other runs
//! up to from below and ends at in outer edges. Say the interiors of two solids
//! meet, and neither lies in the other. Then the part R of the one's skin that is inside the other ends
//! somewhere on both skins. Where it ends within a face and within a face, they cross, and neither piece is
//! on one side of the other's surface; or they touch with their materials on the same side. Where it ends on
//! an edge of one or of both, the wedges of material at that edge are held against each other, and the same
//! follows but for one case: both edges are inner edges (their material takes more than half of a turn), on
//! each other. So three things are asked beside the parting: near pieces that look the same way lie
//! beside each other, so that they meet on edges of both at most; inner
//! edges of both solids do not come near each other, and of every shell some point lies outside the other
//! solid. Where one of them cannot be shown the answer is open, and the kernel decides.

mod arc;
mod beside;
mod boundary;
mod edgewise;
mod enter;
mod inside;
pub mod meet;
mod patch;
mod region;
mod relate;
mod side;
mod touch;
mod triangles;

pub use boundary::Boundary;
pub use enter::{enter, strays};
pub use relate::{Common, Sleeve, common, common_beside};
pub use touch::touch;
