//! The kernel's worker process.

mod asked;
mod cache;
mod jobs;

use std::io;
use std::path::PathBuf;

use assemcad_workers::{Handler, Keeps, Limits, Refusal, Tell};

use crate::memory;
use crate::protocol::{Job, KernelWork, Reply};

/// A process that holds more than this share of its limit on address space after a job does no other one.
const MOST_KEPT: f64 = 0.5;

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
    let keeps = Keeps {
        folders: settings.cache.iter().cloned().collect(),
        // How much memory it has in use.
        read: vec!["/proc/self".into()],
    };
    if let Some(folder) = &settings.cache
        && let Err(e) = std::fs::create_dir_all(folder)
    {
        tracing::warn!("solids cannot be kept on disk: {e}");
    }
    assemcad_workers::serve::<KernelWork>(limits, &keeps, jobs::Bench::new(settings.cache))
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
        memory::share_in_use().is_none_or(|share| share < MOST_KEPT)
    }
}
