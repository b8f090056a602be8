//! The kernel's worker processes.

use std::path::PathBuf;

pub use assemcad_workers::Limits;

use crate::protocol::KernelWork;

/// The kernel's worker processes.
pub type Pool = assemcad_workers::Pool<KernelWork>;

/// How the kernel's workers are started.
#[derive(Debug, Clone)]
pub struct Config {
    /// The program; it is called as `program worker --memory-mb N --cpu-s N [--cache FOLDER]`.
    pub program: PathBuf,
    /// Folder of the cache of solids.
    pub cache: Option<PathBuf>,
    /// How many workers, at least one.
    pub workers: usize,
    /// What one request may use.
    pub limits: Limits,
}

impl From<Config> for assemcad_workers::Config {
    fn from(config: Config) -> Self {
        let cache = config.cache.into_iter();
        Self {
            program: config.program,
            arguments: cache.flat_map(|f| ["--cache".into(), f.into()]).collect(),
            workers: config.workers,
            limits: config.limits,
        }
    }
}
