//! The kernel's worker process.

mod asked;
mod jobs;
mod kept;

use std::io;
use std::os::fd::AsFd;
use std::path::PathBuf;
use std::sync::Arc;

use assemcad_cache::Folder;
use assemcad_workers::{Handler, Keeps, Limits, Refusal, Tell};

use crate::memory;
use crate::protocol::{Job, KernelWork, Reply};
pub use kept::solids;

/// A process that holds more than this share of its limit on address space after a job does no other one.
const MOST_KEPT: f64 = 0.5;

/// What a worker is started with.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Address space in MiB.
    pub memory_mb: u64,
    /// Processor time of one job in seconds.
    pub cpu_s: u64,
    /// The root folder, below which solids are kept on disk.
    pub root: Option<PathBuf>,
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
    let solids = settings.root.and_then(|root| match Folder::open(&root) {
        Ok(folder) => Some(solids(Arc::new(folder))),
        Err(e) => {
            // The server says so aloud, once.
            tracing::debug!("solids cannot be kept on disk: {e}");
            None
        }
    });
    let folder = solids.as_ref().map(|s| s.folder().as_fd());
    let keeps = Keeps {
        folders: folder
            .map(|f| f.try_clone_to_owned())
            .transpose()?
            .into_iter()
            .collect(),
        // How much memory it has in use.
        read: vec!["/proc/self".into()],
    };
    assemcad_workers::serve::<KernelWork>(limits, &keeps, jobs::Bench::new(solids))
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
