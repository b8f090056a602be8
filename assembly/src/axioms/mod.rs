//! The engineering axioms at work: what mates cite, what checks read, and what the checks say.

mod check;
pub(crate) mod cite;
mod facts;
mod measure;
mod mend;
mod rays;
mod sight;
mod trace;
mod ways;

pub(crate) use check::{Measurements, not_checked, run};
