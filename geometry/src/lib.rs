//! The one door to geometry.

pub mod narrow;
