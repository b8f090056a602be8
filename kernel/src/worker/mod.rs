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
    assemcad_workers::serve::<KernelWork>(
        limits,
        jobs::Bench::new(settings.cache, settings.memory_mb),
    )
}

impl Handler<KernelWork> for jobs::Bench {
    fn work(&mut self, job: &Job, tell: Tell<'_>) -> Result<(Reply, Vec<u8>), Refusal> {
        Self::work(self, job, tell).map_err(|error| match error.kind {
            crate::Kind::OutOfMemory => Refusal::OutOfMemory,
            _ => Refusal::Refused(error.message),
        })
    }

    /// Solids and triangles of earlier jobs, and what the kernel never gives back, are not to be the next job's
    /// trouble.
    fn is_fit(&self) -> bool {
        address_space().is_none_or(|used| used < self.most_bytes)
    }
}

/// The address space of this process in bytes, where the system tells.
fn address_space() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    let pages: u64 = text.split_whitespace().next()?.parse().ok()?;
    pages.checked_mul(u64::try_from(rustix::param::page_size()).ok()?)
}
