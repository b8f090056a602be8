//! The kernel's worker processes.

use std::path::PathBuf;

pub use assemcad_workers::Limits;

use crate::protocol::KernelWork;

/// The kernel's worker processes.
pub type Pool = assemcad_workers::Pool<KernelWork>;

/// How the kernel's workers are started.
#[derive(Debug, Clone)]
pub struct Config {
    /// The program; it is called as `program worker --memory-mb N --cpu-s N [--root FOLDER]`.
    pub program: PathBuf,
    /// The root folder, below which solids are kept on disk; nowhere where there is none.
    pub root: Option<PathBuf>,
    /// How many workers, at least one.
    pub workers: usize,
    /// What one request may use.
    pub limits: Limits,
}

impl From<Config> for assemcad_workers::Config {
    fn from(config: Config) -> Self {
        let root = config.root.into_iter();
        Self {
            program: config.program,
            arguments: root.flat_map(|f| ["--root".into(), f.into()]).collect(),
            workers: config.workers,
            limits: config.limits,
        }
    }
}
