//! What all operations work with.

use std::path::Path;
use std::time::Duration;

use assemcad_factories::Registry;
use assemcad_geometry::{Door, OnDisk, Terms};
use assemcad_kernel::pool::Pool;
use assemcad_model::diagnostic::Diagnostic;
use assemcad_script::Evaluator;

use crate::admitted::Admissions;
use crate::draft::Nameless;
use crate::remembered::Remembered;
use crate::reports::Reports;
use assemcad_store::Store;

/// How many rounds a draft, or a source of a factory, has where the server's command line says nothing.
pub const DEFAULT_ROUNDS: usize = 5;

/// After how many seconds the trial of a source begins no further set of parameters where the command line says
/// nothing.
pub const DEFAULT_LIMIT_S: u64 = 120;

/// How many MiB solids and answers may take on disk where the command line says nothing.
pub const DEFAULT_CACHE_MB: u64 = 2048;

/// What all operations work with: the factories, the kernel and the assemblies on disk.
#[derive(Debug)]
pub struct Workshop {
    /// The factories.
    pub registry: Registry,
    /// The door to geometry.
    pub door: Door,
    /// Who evaluates the sources that are not ours.
    pub evaluator: Evaluator,
    /// The assemblies on disk.
    pub store: Store,
    /// What was made already.
    pub(crate) remembered: Remembered,
    /// Admitted factories as they were read.
    pub(crate) admissions: Admissions,
    /// The rounds of drafts without a name.
    pub(crate) nameless: Nameless,
    /// What was verified already.
    pub(crate) reports: Reports,
    /// How often a draft may be wrong before its decomposition counts as failed.
    pub draft_rounds: usize,
    /// How many sources a request for a factory may have before its synthesis counts as failed.
    pub synthesis_rounds: usize,
    /// After how long the trial of a source begins no further set of parameters.
    pub synthesis_limit: Duration,
}

impl Workshop {
    /// A workshop over a root folder, which is made where it is missing. Solids and answers about them may take
    /// `cache_bytes` below it.
    ///
    /// # Errors
    /// When the folder cannot be made or opened.
    pub fn open(
        root: &Path,
        registry: Registry,
        pool: Pool,
        evaluator: Evaluator,
        cache_bytes: u64,
    ) -> Result<Self, Diagnostic> {
        let store = Store::open(root)?;
        let disk = OnDisk {
            root: store.path().to_owned(),
            bytes: cache_bytes,
        };
        let terms = Terms {
            disk: Some(disk),
            ..Terms::default()
        };
        Ok(Self {
            registry,
            door: Door::new(pool, &terms),
            evaluator,
            store,
            remembered: Remembered::default(),
            admissions: Admissions::default(),
            nameless: Nameless::default(),
            reports: Reports::default(),
            draft_rounds: DEFAULT_ROUNDS,
            synthesis_rounds: DEFAULT_ROUNDS,
            synthesis_limit: Duration::from_secs(DEFAULT_LIMIT_S),
        })
    }
}
