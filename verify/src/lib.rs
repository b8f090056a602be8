//! Verification: what the placed parts are, measured, and what that says.
//!
//! Every check fails closed: pass, fail, or indeterminate with the reason. What was not checked is said.

pub mod axioms;
mod bill;
pub mod checks;
mod results;
mod terms;
mod verification;

pub use results::Results;
pub use terms::{DEFAULT_TAU_MM3, Terms};
pub use verification::{Subject, verify};
