//! Realisation of specifications: build parts, place them, verify, export; the assemblies on disk.
//!
//! The specification on disk is the only state. Every operation reads it, and every accepted change
//! is written back before the operation returns, so that a killed server loses nothing.

mod axioms;
mod bill;
pub mod build;
mod contact_check;
pub mod draft;
pub mod edit;
pub mod export;
mod freedom_check;
mod interference;
mod made;
pub mod measure;
mod near;
pub mod page;
mod partial;
pub mod picture;
pub mod place;
mod port_use;
mod ports_check;
pub mod realize;
pub mod report_files;
pub mod resolve;
mod rounds;
pub mod state;
pub mod store;
pub mod sweep;
pub mod synthesis;
pub mod verify;

use std::path::Path;
use std::time::Duration;

use assemcad_factories::Registry;
use assemcad_kernel::pool::Pool;
use assemcad_model::diagnostic::Diagnostic;
use assemcad_script::Evaluator;

pub use crate::made::Made;
use crate::store::Store;

/// Everything that is wrong with a request: never empty.
pub type Faults = Vec<Diagnostic>;

/// What all operations work with: the factories, the kernel's workers and the assemblies on disk.
#[derive(Debug)]
pub struct Workshop {
    /// The factories.
    pub registry: Registry,
    /// The kernel's workers.
    pub pool: Pool,
    /// Who evaluates the sources that are not ours.
    pub evaluator: Evaluator,
    /// The assemblies on disk.
    pub store: Store,
    /// What was made already.
    pub(crate) kept: made::Kept,
    /// How often a draft may be wrong before its decomposition counts as failed.
    pub draft_rounds: usize,
    /// How many sources a request for a factory may have before its synthesis counts as failed.
    pub synthesis_rounds: usize,
    /// After how long the trial of a source begins no further set of parameters.
    pub synthesis_limit: Duration,
}

impl Workshop {
    /// A workshop over a root folder, which is made where it is missing.
    ///
    /// # Errors
    /// When the folder cannot be made or opened.
    pub fn open(
        root: &Path,
        registry: Registry,
        pool: Pool,
        evaluator: Evaluator,
    ) -> Result<Self, Diagnostic> {
        Ok(Self {
            registry,
            pool,
            evaluator,
            store: Store::open(root)?,
            kept: made::Kept::default(),
            draft_rounds: draft::DEFAULT_ROUNDS,
            synthesis_rounds: synthesis::DEFAULT_ROUNDS,
            synthesis_limit: Duration::from_secs(synthesis::DEFAULT_LIMIT_S),
        })
    }
}
