//! The checks, one file each. None knows the others, nor who runs them.

pub(crate) mod clearance;
pub(crate) mod connectivity;
pub(crate) mod contact;
pub(crate) mod freedom;
pub(crate) mod holding;
pub mod interference;
pub(crate) mod mates;
pub(crate) mod parts;
pub(crate) mod port_use;
pub mod ports;
