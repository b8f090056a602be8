//! The sweep: one free motion driven through a range, and the first collision on the way.
//!
//! What is coupled to the driven part follows by the mates' constraints. Two parts collide where they have more in
//! common than their mates mean, as at rest. Of two parts that only turn against each other about one axis, of which
//! one is a solid of revolution about it or which bounds about it keep apart, one pose tells all others: they are
//! proven. All other pairs are sampled, and may collide between two samples.

mod answer;
mod hulls;
mod mechanism;
mod pairs;
mod request;
mod sweep;
mod walk;

pub use answer::{Collision, Open, Pairs, Proof, Proven, Stop, Sweep, Unit};
pub use request::{DEFAULT_STEP_DEG, DEFAULT_STEPS, MOST_POSES, Request};
pub use sweep::sweep;
