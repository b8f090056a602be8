//! The assemblies on disk: one folder each, below the root and nowhere else.
//!
//! `assemblies/NAME/assembly.json` is the specification; beside it lie the report and the STEP file.
//! The root is opened as a capability: whatever a path or a link says, nothing outside it is reached.
//! Files are written beside their place and moved there, so that a reader or a crash never sees half
//! of one.

use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name::{self, nearest};
use assemcad_model::param::clip;
use assemcad_model::spec::{Assembly, Document, FORMAT};
use cap_std::ambient_authority;
use cap_std::fs::Dir;
use serde_json::json;

const ASSEMBLIES: &str = "assemblies";
const SPECIFICATION: &str = "assembly.json";

/// The root folder.
#[derive(Debug)]
pub struct Store {
    root: Dir,
    path: PathBuf,
    written: AtomicU64,
}

/// Holds an assembly against every other writer, in this process or another, until dropped.
#[derive(Debug)]
pub struct Lock {
    _folder: std::fs::File,
}

impl Store {
    /// Opens the root folder, which is made where it is missing.
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
        open().map_err(|e| file_failed("--root", "opened", &e))
    }

    /// The root folder's path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The names of the assemblies, sorted.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn names(&self) -> Result<Vec<String>, Diagnostic> {
        let list = || -> io::Result<Vec<String>> {
            let mut names = Vec::new();
            for entry in self.root.read_dir(ASSEMBLIES)? {
                if let Ok(name) = entry?.file_name().into_string()
                    && name::is_valid(&name)
                    && self.root.exists(specification(&name))
                {
                    names.push(name);
                }
            }
            names.sort();
            Ok(names)
        };
        list().map_err(|e| file_failed(ASSEMBLIES, "listed", &e))
    }

    /// Waits until no other writer holds the assembly, and holds it.
    ///
    /// # Errors
    /// When there is no assembly of this name.
    pub async fn lock(&self, id: &str) -> Result<Lock, Diagnostic> {
        check_name("assembly", id)?;
        // Opened as a file: the handle of a folder opened as a capability cannot be locked.
        let folder = match self.root.open(format!("{ASSEMBLIES}/{id}")) {
            Ok(folder) => folder.into_std(),
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Err(self.unknown(id)),
            Err(e) => return Err(file_failed(id, "locked", &e)),
        };
        let locked = tokio::task::spawn_blocking(move || {
            rustix::fs::flock(&folder, rustix::fs::FlockOperation::LockExclusive)?;
            Ok::<_, io::Error>(folder)
        });
        match locked.await {
            Ok(Ok(folder)) => Ok(Lock { _folder: folder }),
            Ok(Err(e)) => Err(file_failed(id, "locked", &e)),
            Err(e) => Err(file_failed(id, "locked", &io::Error::other(e.to_string()))),
        }
    }

    /// Makes the folder of an assembly, so that it can be locked. An empty folder is no assembly.
    ///
    /// # Errors
    /// When the name is none or the folder cannot be made.
    pub fn make_folder(&self, id: &str) -> Result<(), Diagnostic> {
        check_name("assembly", id)?;
        let folder = format!("{ASSEMBLIES}/{id}");
        self.root
            .create_dir_all(&folder)
            .map_err(|e| file_failed(&folder, "made", &e))
    }

    /// Reads a specification.
    ///
    /// # Errors
    /// When there is no assembly of this name (the valid names are in the diagnostic), or the file
    /// is not a specification.
    pub fn load(&self, id: &str) -> Result<Assembly, Diagnostic> {
        check_name("assembly", id)?;
        let bytes = match self.root.read(specification(id)) {
            Ok(bytes) => bytes,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Err(self.unknown(id)),
            Err(e) => return Err(file_failed(&specification(id), "read", &e)),
        };
        let damaged = |why: String| {
            Diagnostic::error(
                Code::FileDamaged,
                specification(id),
                format!("the stored specification is not readable: {why}"),
            )
            .hint("restore the file from a copy, or make the assembly anew under another name")
        };
        let document: Document =
            serde_json::from_slice(&bytes).map_err(|e| damaged(format!("line {}", e.line())))?;
        if document.format != FORMAT {
            return Err(damaged(format!(
                "format {} instead of {FORMAT}",
                document.format
            )));
        }
        if document.assembly.id != id {
            return Err(damaged(format!(
                "it is that of '{}'",
                clip(&document.assembly.id)
            )));
        }
        Ok(document.assembly)
    }

    /// Whether an assembly of this name exists.
    #[must_use]
    pub fn exists(&self, id: &str) -> bool {
        name::is_valid(id) && self.root.exists(specification(id))
    }

    /// Writes a specification; it is on disk when this returns.
    ///
    /// # Errors
    /// When it cannot be written; what was there before is then untouched.
    pub fn save(&self, assembly: &Assembly) -> Result<(), Diagnostic> {
        check_name("assembly", &assembly.id)?;
        let document = Document {
            format: FORMAT,
            assembly: assembly.clone(),
        };
        self.write_json(&specification(&assembly.id), &document)
    }

    /// Writes a value as indented JSON; it is on disk when this returns.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_json<T: serde::Serialize>(&self, path: &str, value: &T) -> Result<(), Diagnostic> {
        let mut text = serde_json::to_vec_pretty(value)
            .map_err(|e| Diagnostic::error(Code::Internal, path, e.to_string()))?;
        text.push(b'\n');
        self.write(path, &text)
    }

    /// Reads a value from a JSON file, `None` where there is no such file or it holds something else.
    #[must_use]
    pub fn read_json<T: serde::de::DeserializeOwned>(&self, path: &str) -> Option<T> {
        let mut bytes = Vec::new();
        self.root.open(path).ok()?.read_to_end(&mut bytes).ok()?;
        serde_json::from_slice(&bytes).ok()
    }

    /// Writes a file below the root; it is on disk when this returns.
    ///
    /// # Errors
    /// When the path leads out of the root, or the file cannot be written.
    pub fn write(&self, path: &str, bytes: &[u8]) -> Result<(), Diagnostic> {
        let inside = inside(path)?;
        let folder = inside.parent().unwrap_or(Path::new(""));
        let name = inside
            .file_name()
            .and_then(|n| n.to_str())
            .unwrap_or_default();
        let write = || -> io::Result<()> {
            let here = if folder.as_os_str().is_empty() {
                self.root.try_clone()?
            } else {
                match self.root.open_dir(folder) {
                    Err(e) if e.kind() == io::ErrorKind::NotFound => {
                        self.root.create_dir_all(folder)?;
                        self.root.open_dir(folder)?
                    }
                    other => other?,
                }
            };
            // Two writers of one file, in this process or another, never share their unfinished file.
            let count = self.written.fetch_add(1, Ordering::Relaxed);
            let part = format!(".{name}.{}-{count}", std::process::id());
            let written = (|| {
                let mut file = here.create(&part)?;
                file.write_all(bytes)?;
                file.sync_all()?;
                here.rename(&part, &here, name)?;
                // The new name itself is on disk only when the folder is.
                here.open(".")?.sync_all()
            })();
            if written.is_err() {
                let _ = here.remove_file(&part);
            }
            written
        };
        write().map_err(|e| match e.kind() {
            io::ErrorKind::PermissionDenied => outside(path),
            _ => file_failed(path, "written", &e),
        })
    }

    fn unknown(&self, id: &str) -> Diagnostic {
        let names = self.names().unwrap_or_default();
        let near = nearest(id, names.iter().map(String::as_str), 1)
            .first()
            .map(|n| (*n).to_owned());
        let d = Diagnostic::error(
            Code::AssemblyUnknown,
            "assembly",
            format!("there is no assembly '{}'", clip(id)),
        )
        .found(id)
        .expected(json!(names));
        match near {
            Some(near) => d.hint(format!("did you mean '{near}'?")),
            None => d.next("new_assembly", json!({"assembly": id})),
        }
    }
}

/// The path of an assembly's file, below the root.
#[must_use]
pub fn file_of(id: &str, name: &str) -> String {
    format!("{ASSEMBLIES}/{id}/{name}")
}

fn specification(id: &str) -> String {
    file_of(id, SPECIFICATION)
}

/// Checks a name that a client chose.
///
/// # Errors
/// When it breaks the rule for names.
pub fn check_name(place: &str, name: &str) -> Result<(), Diagnostic> {
    if name::is_valid(name) {
        return Ok(());
    }
    Err(
        Diagnostic::error(Code::NameInvalid, place, "this is not a name".to_owned())
            .found(name)
            .expected(name::RULE),
    )
}

/// A path that names a file below the root, taken by its text alone. Links are the capability's matter.
fn inside(path: &str) -> Result<&Path, Diagnostic> {
    let p = Path::new(path);
    let plain = p.components().all(|c| matches!(c, Component::Normal(_)));
    if path.is_empty() || path.ends_with('/') || path.contains('\0') || path.len() > 1024 || !plain
    {
        return Err(outside(path));
    }
    Ok(p)
}

fn outside(path: &str) -> Diagnostic {
    Diagnostic::error(
        Code::PathInvalid,
        "file",
        "files are written below the root folder only",
    )
    .found(path)
    .expected("a relative path without '..' that no link leads out of the root folder")
}

fn file_failed(place: &str, done: &str, e: &io::Error) -> Diagnostic {
    Diagnostic::error(
        Code::FileFailed,
        clip(place),
        format!("it could not be {done}: {}", e.kind()),
    )
}

#[cfg(test)]
mod tests {
    use super::Store;
    use assemcad_model::diagnostic::Code;
    use assemcad_model::spec::Assembly;

    fn code<T: std::fmt::Debug>(r: Result<T, assemcad_model::diagnostic::Diagnostic>) -> Code {
        r.unwrap_err().code
    }

    #[test]
    fn what_is_saved_is_there_for_the_next_one() {
        let root = tempfile::tempdir().unwrap();
        let stand = Assembly::new("stand", "a stand");
        Store::open(root.path()).unwrap().save(&stand).unwrap();
        let again = Store::open(root.path()).unwrap();
        assert_eq!(again.load("stand").unwrap(), stand);
        assert_eq!(again.names().unwrap(), ["stand"]);
        let d = again.load("stnad").unwrap_err();
        assert_eq!(d.expected.unwrap(), serde_json::json!(["stand"]));
    }

    #[test]
    fn nothing_outside_the_root_is_written() {
        let outer = tempfile::tempdir().unwrap();
        let root = outer.path().join("root");
        let store = Store::open(&root).unwrap();
        std::fs::create_dir(outer.path().join("elsewhere")).unwrap();
        std::os::unix::fs::symlink(outer.path().join("elsewhere"), root.join("link")).unwrap();
        std::fs::write(outer.path().join("victim"), "safe").unwrap();
        std::os::unix::fs::symlink(outer.path().join("victim"), root.join("file.step")).unwrap();
        for path in [
            "../a.step",
            "/tmp/a.step",
            "a/../../b.step",
            "link/a.step",
            "",
            "a/",
            ".",
        ] {
            assert_eq!(code(store.write(path, b"x")), Code::PathInvalid, "{path}");
        }
        // A link in the file's own place is replaced, not followed.
        store.write("file.step", b"x").unwrap();
        assert_eq!(
            std::fs::read_to_string(outer.path().join("victim")).unwrap(),
            "safe"
        );
        assert_eq!(
            std::fs::read_dir(outer.path().join("elsewhere"))
                .unwrap()
                .count(),
            0
        );
        store.write("a/b/c.step", b"x").unwrap();
        assert_eq!(std::fs::read(root.join("a/b/c.step")).unwrap(), b"x");
    }

    #[test]
    fn a_damaged_specification_is_told_and_left_alone() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        store.save(&Assembly::new("a", "")).unwrap();
        let path = root.path().join("assemblies/a/assembly.json");
        for bad in [
            "",
            "{",
            r#"{"format":2,"assembly":{"id":"a"}}"#,
            r#"{"format":1,"assembly":{"id":"b"}}"#,
        ] {
            std::fs::write(&path, bad).unwrap();
            assert_eq!(code(store.load("a")), Code::FileDamaged, "{bad}");
            assert_eq!(std::fs::read_to_string(&path).unwrap(), bad);
        }
    }

    #[tokio::test]
    async fn two_writers_take_turns() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        assert_eq!(code(store.lock("a").await), Code::AssemblyUnknown);
        store.make_folder("a").unwrap();
        let held = store.lock("a").await.unwrap();
        let wait = std::time::Duration::from_millis(50);
        assert!(tokio::time::timeout(wait, store.lock("a")).await.is_err());
        drop(held);
        store.lock("a").await.unwrap();
    }
}
