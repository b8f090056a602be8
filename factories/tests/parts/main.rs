//! The built-in factories through language and kernel: their solids against closed forms, their ports
//! against what is documented, and every port's evidence.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

#[cfg(test)]
mod blocks;
#[cfg(test)]
mod closed;
#[cfg(test)]
mod fasteners;
#[cfg(test)]
mod gears;
#[cfg(test)]
mod golden;
#[cfg(test)]
mod kit;
#[cfg(test)]
mod ranges;
#[cfg(test)]
mod rounds;
#[cfg(test)]
mod sample;
#[cfg(test)]
mod tables;
