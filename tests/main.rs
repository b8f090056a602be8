//! Scripted sessions over the real protocol, against a server of their own each.
#![cfg(test)]

mod admission;
#[cfg(test)]
mod admission_order;
mod axioms;
mod bad_input;
mod bolted;
mod defects;
mod determinism;
mod drafts;
mod faults;
mod gear_pairs;
mod gears;
mod geometry;
mod harness;
mod keeping;
mod kept;
mod kit;
mod mates;
mod measure;
mod motion;
mod mutation;
mod overlaps;
mod persistence;
mod pictures;
mod ports;
mod realize;
mod refusals;
mod report_pages;
mod script_workers;
mod sessions;
mod stalls;
#[path = "defects/suite.rs"]
mod suite;
mod synthesis;
mod verification;
mod verification_cases;
