//! Admission: a factory that somebody wrote becomes one of the registry's, on evidence.
//!
//! The paper's algorithm 2 with the writing left to the caller: a [`Request`] says what is wanted, a
//! source is held against it by the [`Gate`], and what passes is kept with its [`Record`].

mod agree;
mod examples;
mod gate;
mod hints;
mod narrow;
mod ports;
mod record;
mod report;
mod request;
mod sets;
mod stages;
mod trial;

pub use examples::{evidence, nearest};
pub use gate::{Admission, Gate, Manner};
pub use record::{NAMESPACE, Record, file_name, is_valid_user_name, split_version, versioned};
pub use report::{Evidence, Finding, Layer, LayerVerdict, PortEvidence, Report, Tally};
pub use request::{AskedKind, AskedParam, ExpectedPort, Request};
pub use sets::Origin;
pub use stages::{Extent, Progress, Stage};
