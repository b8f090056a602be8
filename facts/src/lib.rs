//! What is so in the placed solids of an assembly, found from how they meet, without reading a mate.
//!
//! A contact holds one way: at a point `p` with a normal `n` out of one part into another, the second cannot go
//! against it, `n . (v + w x p) >= 0` for its twist against the first. Stacked over all contacts these make a cone
//! of motions that nothing stops (Reuleaux; Lakshminarayana 1978; Mattikalli and Khosla 1992). A linear programme
//! finds every contact that can open; the others stay, and the null space of their rows is what moves.
//!
//! Friction holds what is pressed: interference fits, threads, and what lies in the grip of a screw whose whole
//! stack touches. Such parts are one body.

mod clamp;
mod cone;
mod groups;
mod hold;
mod rows;
mod stops;
mod union;

pub use groups::Reason;
pub use hold::{Coupled, Free, Held, IdleScrew, PairMeetings, Placed, Thread, Tight, Way, held};
pub use rows::Rows;
pub use stops::stops as guides;
