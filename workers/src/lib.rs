//! Work done in processes of its own, each with limits on memory and time.
//!
//! A kind of work ([`Work`]) says what a job and its reply are. The server has jobs done by a [`Pool`]
//! of worker processes; a worker process serves them with [`serve`]. What a worker does to itself, it
//! does to nobody else: one that crashes, hangs or runs out of its limits costs one [`Failure`]. It sees nothing of
//! the user's: no files but those in folders of its own, no network, no other process, no environment.

mod limits;
mod pool;
pub mod protocol;
mod seclude;
mod serve;

pub use limits::Limits;
pub use pool::{Config, Pool};
pub use protocol::{Doing, Failure, FailureKind, Message};
pub use seclude::{Keeps, missing as missing_seclusion};
pub use serve::{Handler, Refusal, Tell, serve};

/// A kind of work that worker processes do.
pub trait Work {
    /// What is asked of a worker.
    type Job: serde::Serialize + serde::de::DeserializeOwned + Sync;
    /// What it answers.
    type Reply: serde::Serialize + serde::de::DeserializeOwned;
    /// The subcommand of the program that makes it a worker for this kind of work.
    const SUBCOMMAND: &'static str;
    /// A job's name, for diagnostics.
    fn name(job: &Self::Job) -> &'static str;
}
