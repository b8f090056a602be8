//! The kernel's worker process.

mod asked;
mod cache;
mod jobs;

use std::io;
use std::path::PathBuf;

use assemcad_workers::{Handler, Limits, Refusal, Tell};

use crate::protocol::{Job, KernelWork, Reply};

/// What a worker is started with.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Address space in MiB.
    pub memory_mb: u64,
    /// Processor time of one job in seconds.
    pub cpu_s: u64,
    /// Folder of the cache of solids.
    pub cache: Option<PathBuf>,
}

/// Serves jobs from the socket that is this process's standard input, until it closes.
///
/// # Errors
/// When the limits cannot be set or the socket breaks.
pub fn run(settings: Settings) -> io::Result<()> {
    let limits = Limits {
        memory_mb: settings.memory_mb,
        cpu_s: settings.cpu_s,
        ..Limits::default()
    };
    assemcad_workers::serve::<KernelWork>(limits, jobs::Bench::new(settings.cache))
}

impl Handler<KernelWork> for jobs::Bench {
    fn work(&mut self, job: &Job, tell: Tell<'_>) -> Result<(Reply, Vec<u8>), Refusal> {
        Self::work(self, job, tell).map_err(|error| match error.kind {
            crate::Kind::OutOfMemory => Refusal::OutOfMemory,
            _ => Refusal::Refused(error.message),
        })
    }
}
