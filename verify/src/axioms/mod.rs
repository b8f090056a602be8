//! The engineering axioms at work: what mates cite, what checks read, and what the checks say.

pub mod accept;
mod check;
pub mod cite;
mod facts;
mod limit;
mod looker;
mod measure;
mod mend;
mod rays;
mod sight;
#[cfg(test)]
mod timing;
mod trace;
mod tree;
mod ways;

pub(crate) use check::{not_checked, run};
pub(crate) use facts::Measurements;
