//! Solids that were made before: in memory, and on disk by the hash of their recipe.

use std::fs;
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use assemcad_model::canonical::sha256;
use lru::LruCache;

/// How many solids a worker keeps in memory.
const IN_MEMORY: NonZeroUsize = NonZeroUsize::new(128).unwrap();

/// The first word of an entry; its number is the version of this file format.
const MAGIC: &str = "assemcad-solid-1";

/// What an entry on disk turned out to be.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Entry {
    /// The BREP bytes, as they were written.
    Sound(Vec<u8>),
    /// There is none, or one of another kernel.
    Missing,
    /// Something is there that was not written like this.
    Damaged,
}

/// The cache on disk: a file per solid.
///
/// The first line of a file is `MAGIC KERNEL RECIPE-SHA256 PAYLOAD-SHA256`; the rest are BREP bytes.
#[derive(Debug)]
pub(super) struct Disk {
    folder: PathBuf,
    kernel: String,
}

impl Disk {
    pub(super) fn new(folder: PathBuf, kernel: &str) -> Self {
        Self {
            folder,
            kernel: kernel.replace(char::is_whitespace, "_"),
        }
    }

    fn path(&self, recipe: &str) -> PathBuf {
        self.folder.join(format!("{recipe}.solid"))
    }

    pub(super) fn read(&self, recipe: &str) -> Entry {
        let bytes = match fs::read(self.path(recipe)) {
            Ok(bytes) => bytes,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Entry::Missing,
            Err(_) => return Entry::Damaged,
        };
        let Some(end) = bytes.iter().position(|b| *b == b'\n') else {
            return Entry::Damaged;
        };
        let (head, payload) = bytes.split_at(end);
        let payload = payload.get(1..).unwrap_or_default();
        let Ok(head) = std::str::from_utf8(head) else {
            return Entry::Damaged;
        };
        match head.split(' ').collect::<Vec<_>>().as_slice() {
            [MAGIC, kernel, _, _] if *kernel != self.kernel => Entry::Missing,
            [MAGIC, _, of, sum] if *of == recipe && *sum == sha256(payload) => {
                Entry::Sound(payload.to_vec())
            }
            _ => Entry::Damaged,
        }
    }

    /// Writes an entry beside its place and moves it there, so that no reader sees half of one.
    pub(super) fn write(&self, recipe: &str, payload: &[u8]) -> io::Result<()> {
        fs::create_dir_all(&self.folder)?;
        let part = self
            .folder
            .join(format!(".{recipe}.{}", std::process::id()));
        let head = format!("{MAGIC} {} {recipe} {}\n", self.kernel, sha256(payload));
        let done = write_whole(&part, head.as_bytes(), payload)
            .and_then(|()| fs::rename(&part, self.path(recipe)));
        if done.is_err() {
            let _ = fs::remove_file(&part);
        }
        done
    }
}

fn write_whole(path: &Path, head: &[u8], payload: &[u8]) -> io::Result<()> {
    let mut file = fs::File::create(path)?;
    file.write_all(head)?;
    file.write_all(payload)
}

/// Solids in memory, the least recently used forgotten first.
pub(super) fn in_memory<T>() -> LruCache<String, T> {
    LruCache::new(IN_MEMORY)
}

#[cfg(test)]
mod tests {
    use super::{Disk, Entry};

    #[test]
    fn damage_of_every_kind_is_noticed() {
        let folder = tempfile::tempdir().unwrap();
        let disk = Disk::new(folder.path().join("cache"), "kernel 1");
        assert_eq!(disk.read("aa"), Entry::Missing);
        disk.write("aa", b"solid\nbytes").unwrap();
        assert_eq!(disk.read("aa"), Entry::Sound(b"solid\nbytes".to_vec()));

        let path = folder.path().join("cache/aa.solid");
        let good = std::fs::read(&path).unwrap();
        for i in 0..good.len() {
            let mut bad = good.clone();
            bad[i] ^= 1;
            std::fs::write(&path, &bad).unwrap();
            // A changed kernel name is another kernel's entry; all other changes are damage.
            assert!(!matches!(disk.read("aa"), Entry::Sound(_)), "byte {i}");
            std::fs::write(&path, &good[..i]).unwrap();
            assert_eq!(disk.read("aa"), Entry::Damaged, "cut at {i}");
        }
        // An entry under another recipe's name is not that recipe's solid.
        std::fs::write(folder.path().join("cache/bb.solid"), &good).unwrap();
        assert_eq!(disk.read("bb"), Entry::Damaged);
        let other = Disk::new(folder.path().join("cache"), "kernel 2");
        std::fs::write(&path, &good).unwrap();
        assert_eq!(other.read("aa"), Entry::Missing);
    }
}
