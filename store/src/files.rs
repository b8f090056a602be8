//! Reading and writing files below the root.

use std::io::{self, Read, Write};
use std::path::{Component, Path};
use std::sync::atomic::Ordering;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::clip;
use assemcad_model::yaml::MOST_BYTES;
use cap_std::fs::{Dir, File};
use rustix::fs::FlockOperation;

use crate::fault::{file_failed, outside};
use crate::root::Store;
use crate::switch::{Move, Switch};

impl Store {
    /// Writes a value as indented JSON; it is on disk when this returns.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_json<T: serde::Serialize>(&self, path: &str, value: &T) -> Result<(), Diagnostic> {
        self.write(path, &json_bytes(path, value)?)
    }

    /// Reads a value from a JSON file, `None` where there is no such file or it holds something else.
    #[must_use]
    pub fn read_json<T: serde::de::DeserializeOwned>(&self, path: &str) -> Option<T> {
        serde_json::from_slice(&self.read_bytes(path)?).ok()
    }

    /// Reads a file below the root, `None` where there is none.
    #[must_use]
    pub fn read_bytes(&self, path: &str) -> Option<Vec<u8>> {
        let inside = inside(path).ok()?;
        // Opening a pipe would wait for whoever writes to it.
        if !self.root.metadata(inside).ok()?.is_file() {
            return None;
        }
        let mut bytes = Vec::new();
        self.root.open(inside).ok()?.read_to_end(&mut bytes).ok()?;
        Some(bytes)
    }

    /// Writes a file below the root; it is on disk when this returns.
    ///
    /// # Errors
    /// When the path leads out of the root, or the file cannot be written.
    pub fn write(&self, path: &str, bytes: &[u8]) -> Result<(), Diagnostic> {
        self.write_all(&[(path, bytes)])
    }

    /// Writes files below the root as one step: all come to their places, or all is as it was.
    ///
    /// # Errors
    /// As [`Store::write`].
    pub fn write_all(&self, files: &[(&str, &[u8])]) -> Result<(), Diagnostic> {
        let mut ready: Vec<Part> = Vec::new();
        for (path, bytes) in files {
            match self.prepare(path, bytes) {
                Ok(part) => ready.push(part),
                Err(d) => {
                    ready.iter().for_each(Part::remove);
                    return Err(d);
                }
            }
        }
        let switch = Switch {
            moves: ready.iter().map(|part| part.moved.clone()).collect(),
        };
        let done = self.switch(&switch);
        if let Err(e) = done {
            ready.iter().for_each(Part::remove);
            let path = files.first().map_or("", |(path, _)| path);
            return Err(not_written(path, &e));
        }
        Ok(())
    }

    /// The name of a file until it is whole. Two writers of one file, in this process or another, never share it.
    pub(crate) fn unique(&self, name: &str) -> String {
        let count = self.written.fetch_add(1, Ordering::Relaxed);
        format!(".{name}.{}-{count}", std::process::id())
    }

    /// Writes a file beside its place.
    fn prepare(&self, path: &str, bytes: &[u8]) -> Result<Part, Diagnostic> {
        let inside = inside(path)?;
        let folder = inside.parent().unwrap_or(Path::new(""));
        let name = inside
            .file_name()
            .and_then(|n| n.to_str())
            .unwrap_or_default();
        let write = || -> io::Result<Part> {
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
            if here
                .symlink_metadata(name)
                .is_ok_and(|there| there.is_dir())
            {
                return Err(io::Error::from(io::ErrorKind::IsADirectory));
            }
            let beside = self.unique(name);
            let moved = Move {
                folder: folder.to_str().unwrap_or_default().to_owned(),
                beside,
                name: name.to_owned(),
            };
            let mut file = here.create(&moved.beside)?;
            let written = (|| {
                // Held until it is in its place: what nobody holds was left behind.
                rustix::fs::flock(&file, FlockOperation::NonBlockingLockExclusive)?;
                file.write_all(bytes)?;
                file.sync_all()
            })();
            let part = Part {
                here,
                moved,
                _held: file,
            };
            if let Err(e) = written {
                part.remove();
                return Err(e);
            }
            Ok(part)
        };
        write().map_err(|e| not_written(path, &e))
    }

    /// The names of the files in a folder below the root, sorted; none where there is no such folder.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn files_in(&self, folder: &str) -> Result<Vec<String>, Diagnostic> {
        let list = || -> io::Result<Vec<String>> {
            let mut names = Vec::new();
            for entry in self.root.read_dir(folder)? {
                if let Ok(name) = entry?.file_name().into_string() {
                    names.push(name);
                }
            }
            names.sort();
            Ok(names)
        };
        match list() {
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(Vec::new()),
            other => other.map_err(|e| file_failed(folder, "listed", &e)),
        }
    }

    /// Reads a text file below the root that a client names.
    ///
    /// # Errors
    /// When the path leads out of the root, or there is no such text of at most [`MOST_BYTES`].
    pub fn read_text(&self, path: &str) -> Result<String, Diagnostic> {
        let inside = inside(path)?;
        let read = || -> io::Result<String> {
            // Opening a pipe would wait for whoever writes to it.
            let facts = self.root.metadata(inside)?;
            if !facts.is_file() {
                return Err(io::Error::other("this is no file"));
            }
            if facts.len() > MOST_BYTES as u64 {
                return Err(io::Error::other("the file is too long"));
            }
            let mut text = String::new();
            let file = self.root.open(inside)?;
            // It may have grown since; what is longer is refused by its reader.
            file.take(MOST_BYTES as u64 + 1).read_to_string(&mut text)?;
            Ok(text)
        };
        read().map_err(|e| match e.kind() {
            io::ErrorKind::PermissionDenied => outside(path),
            io::ErrorKind::Other => Diagnostic::error(
                Code::FileFailed,
                clip(path),
                format!("it could not be read: {e}"),
            ),
            _ => file_failed(path, "read", &e),
        })
    }
}

/// A file that is written beside its place.
struct Part {
    here: Dir,
    moved: Move,
    _held: File,
}

impl Part {
    fn remove(&self) {
        let _ = self.here.remove_file(&self.moved.beside);
    }
}

/// A value as indented JSON.
///
/// # Errors
/// When it is none.
pub fn json_bytes<T: serde::Serialize>(path: &str, value: &T) -> Result<Vec<u8>, Diagnostic> {
    let mut text = serde_json::to_vec_pretty(value)
        .map_err(|e| Diagnostic::error(Code::Internal, path, e.to_string()))?;
    text.push(b'\n');
    Ok(text)
}

/// Checks a path that a client names: that it stays below the folder that it starts from.
///
/// # Errors
/// When it does not.
pub fn check_path(path: &str) -> Result<(), Diagnostic> {
    inside(path).map(|_| ())
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

fn not_written(path: &str, e: &io::Error) -> Diagnostic {
    match e.kind() {
        io::ErrorKind::PermissionDenied => outside(path),
        _ => file_failed(path, "written", e),
    }
}

#[cfg(test)]
mod tests {
    use crate::root::Store;
    use assemcad_model::diagnostic::Code;

    fn code<T: std::fmt::Debug>(r: Result<T, assemcad_model::diagnostic::Diagnostic>) -> Code {
        r.unwrap_err().code
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
    fn files_are_written_together_or_not_at_all() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        store.write("a/one", b"old").unwrap();
        // The second cannot be written: a file stands where its folder would be.
        let files: [(&str, &[u8]); 2] = [("a/one", b"new"), ("a/one/two", b"new")];
        store.write_all(&files).unwrap_err();
        assert_eq!(std::fs::read(root.path().join("a/one")).unwrap(), b"old");
        let left = std::fs::read_dir(root.path().join("a")).unwrap().count();
        assert_eq!(left, 1, "nothing is left beside it");
        store
            .write_all(&[("a/one", b"1"), ("b/two", b"2")])
            .unwrap();
        assert_eq!(std::fs::read(root.path().join("b/two")).unwrap(), b"2");
    }

    #[test]
    fn texts_are_read_below_the_root_only_and_up_to_a_length() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        store.write("a.yaml", "\u{e9}".as_bytes()).unwrap();
        assert_eq!(store.read_text("a.yaml").unwrap(), "\u{e9}");
        assert_eq!(code(store.read_text("../a.yaml")), Code::PathInvalid);
        std::os::unix::fs::symlink("/etc/hostname", root.path().join("link")).unwrap();
        assert_eq!(code(store.read_text("link")), Code::PathInvalid);
        store
            .write("b.yaml", &vec![b'x'; super::MOST_BYTES + 1])
            .unwrap();
        store.write("c.yaml", b"\xff").unwrap();
        let pipe = root.path().join("pipe");
        rustix::fs::mknodat(
            rustix::fs::CWD,
            &pipe,
            rustix::fs::FileType::Fifo,
            rustix::fs::Mode::RUSR,
            0,
        )
        .unwrap();
        for file in ["none", "assemblies", "b.yaml", "c.yaml", "pipe"] {
            assert_eq!(code(store.read_text(file)), Code::FileFailed, "{file}");
        }
    }
}
