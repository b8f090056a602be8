//! Scripted sessions over the real protocol, against a server of their own each.
#![cfg(test)]

mod bad_input;
mod determinism;
mod faults;
mod geometry;
mod harness;
mod kit;
mod persistence;
mod refusals;
mod sessions;
mod verification;
