//! The root folder, opened as a capability: whatever a path or a link says, nothing outside it is reached.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicU64;

use assemcad_model::diagnostic::Diagnostic;
use cap_std::ambient_authority;
use cap_std::fs::Dir;

use crate::fault::file_failed;

/// The folder of the assemblies, which is always there.
pub(crate) const ASSEMBLIES: &str = "assemblies";

/// The root folder.
#[derive(Debug)]
pub struct Store {
    pub(crate) root: Dir,
    path: PathBuf,
    /// How many files were begun: each has a name of its own until it is whole.
    pub(crate) written: AtomicU64,
}

/// Holds an assembly against every other writer, in this process or another, until dropped.
#[derive(Debug)]
pub struct Lock {
    _folder: std::fs::File,
}

impl Store {
    /// Opens the root folder, which is made where it is missing. What writers that were killed left behind is
    /// brought to its end or removed.
    ///
    /// # Errors
    /// When the folder cannot be made or opened.
    pub fn open(path: &Path) -> Result<Self, Diagnostic> {
        let open = || -> io::Result<Self> {
            std::fs::create_dir_all(path)?;
            let path = path.canonicalize()?;
            let root = Dir::open_ambient_dir(&path, ambient_authority())?;
            root.create_dir_all(ASSEMBLIES)?;
            Ok(Self {
                root,
                path,
                written: AtomicU64::new(0),
            })
        };
        let store = open().map_err(|e| file_failed("--root", "opened", &e))?;
        store.mend();
        store.sweep();
        Ok(store)
    }

    /// The root folder's path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Holds a folder below the root, which is made where it is missing, against every other writer.
    ///
    /// # Errors
    /// When it cannot be made or held.
    pub(crate) async fn lock_folder(&self, folder: &str) -> Result<Lock, Diagnostic> {
        self.root
            .create_dir_all(folder)
            .map_err(|e| file_failed(folder, "made", &e))?;
        let open = self.root.open(folder);
        flock(
            open.map_err(|e| file_failed(folder, "locked", &e))?
                .into_std(),
            folder,
        )
        .await
    }
}

/// Waits until nobody else holds an open folder, and holds it.
pub(crate) async fn flock(folder: std::fs::File, name: &str) -> Result<Lock, Diagnostic> {
    let locked = tokio::task::spawn_blocking(move || {
        rustix::fs::flock(&folder, rustix::fs::FlockOperation::LockExclusive)?;
        Ok::<_, io::Error>(folder)
    });
    match locked.await {
        Ok(Ok(folder)) => Ok(Lock { _folder: folder }),
        Ok(Err(e)) => Err(file_failed(name, "locked", &e)),
        Err(e) => Err(file_failed(
            name,
            "locked",
            &io::Error::other(e.to_string()),
        )),
    }
}
