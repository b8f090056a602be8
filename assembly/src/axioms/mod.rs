//! The engineering axioms at work: what mates cite, what checks read, and what the checks say.

mod check;
pub(crate) mod cite;
mod facts;
mod mend;
mod trace;

pub(crate) use check::{Measurements, not_checked, run};
