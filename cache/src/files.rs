//! A kind of values in the folder, a file each.

use std::fs::{File, FileTimes};
use std::io::{self, Read, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, SystemTime};

use rustix::fs::{FlockOperation, flock};
use sha2::{Digest, Sha256};

use crate::folder::Folder;

/// The first word of a file; its number is the version of this format.
const MAGIC: &str = "assemcad-kept-1";

/// A file that was used within this time is not marked as used again: marking costs a write.
const USED_LATELY: Duration = Duration::from_secs(600);

/// Names of files that were begun, each another one, in all caches of this process.
static BEGUN: AtomicU64 = AtomicU64::new(0);

/// What a file turned out to be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Entry {
    /// The bytes, as they were written.
    Sound(Vec<u8>),
    /// There is none.
    Missing,
    /// Something is there that was not written like this.
    Damaged,
}

/// One kind of values, made by one version of what makes them.
///
/// A file's name is `KEY.TAG.KIND`, the tag being made of the maker and the folder's mark. Its first line is
/// `MAGIC NAME SHA256`; the rest are the bytes of the value.
#[derive(Debug)]
pub struct Cache {
    pub(crate) folder: Arc<Folder>,
    pub(crate) kind: &'static str,
    pub(crate) tag: String,
    /// Whether it was said already that nothing can be kept.
    said: AtomicBool,
}

impl Cache {
    /// The values of one kind, a word in small letters. `maker` is everything that they depend on beside their keys.
    #[must_use]
    pub fn new(folder: Arc<Folder>, kind: &'static str, maker: &str) -> Self {
        let tag = hex::encode(Sha256::digest(format!("{maker}\n{}", folder.mark())));
        Self {
            folder,
            kind,
            tag: tag.chars().take(16).collect(),
            said: AtomicBool::new(false),
        }
    }

    /// The folder that it is in.
    #[must_use]
    pub fn folder(&self) -> &Folder {
        &self.folder
    }

    fn name(&self, key: &str) -> String {
        format!("{key}.{}.{}", self.tag, self.kind)
    }

    /// The value of a key, which is a SHA-256 in hexadecimal digits. One that is found counts as used now.
    #[must_use]
    pub fn get(&self, key: &str) -> Entry {
        let name = self.name(key);
        let mut file = match self.folder.file(&name) {
            Ok(Some(file)) => file,
            Ok(None) => return Entry::Missing,
            Err(_) => return Entry::Damaged,
        };
        match sound(&mut file, &name) {
            Some(value) => {
                mark_used(&file);
                Entry::Sound(value)
            }
            None => Entry::Damaged,
        }
    }

    /// Keeps a value. It comes to its place whole, and what was there goes. Where that cannot be done, the log says so
    /// once: whoever asks again has it made again.
    pub fn put(&self, key: &str, value: &[u8]) {
        if let Err(e) = self.write(&self.name(key), value) {
            if self.said.swap(true, Ordering::Relaxed) {
                tracing::debug!("{}: not kept: {e}", self.kind);
            } else {
                tracing::warn!(
                    "of the kind '{}' nothing can be kept on disk at the moment, and will be made again: {e}",
                    self.kind
                );
            }
        }
    }

    fn write(&self, name: &str, value: &[u8]) -> io::Result<()> {
        let count = BEGUN.fetch_add(1, Ordering::Relaxed);
        let begun = format!(".{name}.{}-{count}", std::process::id());
        let mut file = match self.folder.begin(&begun) {
            // Of a killed process that had the same number, perhaps in another container.
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {
                self.folder.remove(&begun)?;
                self.folder.begin(&begun)?
            }
            begun => begun?,
        };
        let head = format!("{MAGIC} {name} {}\n", hex::encode(Sha256::digest(value)));
        let written = (|| {
            // Held until it is in its place: what nobody holds was left behind.
            flock(&file, FlockOperation::NonBlockingLockExclusive)?;
            file.write_all(head.as_bytes())?;
            file.write_all(value)?;
            // Not synced: what a crash of the machine cuts short does not fit its sum.
            self.folder.rename(&begun, name)
        })();
        if written.is_err() {
            let _ = self.folder.remove(&begun);
        }
        written
    }
}

/// The value in a file of this name, where it is whole.
fn sound(file: &mut File, name: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes).ok()?;
    let end = bytes.iter().position(|b| *b == b'\n')?;
    let value = bytes.split_off(end + 1);
    bytes.pop();
    let head = std::str::from_utf8(&bytes).ok()?;
    match head.split(' ').collect::<Vec<_>>().as_slice() {
        [MAGIC, of, sum] if *of == name && *sum == hex::encode(Sha256::digest(&value)) => {
            Some(value)
        }
        _ => None,
    }
}

fn mark_used(file: &File) {
    let now = SystemTime::now();
    let used = file.metadata().and_then(|facts| facts.modified());
    let lately = used
        .ok()
        .and_then(|at| now.duration_since(at).ok())
        .is_some_and(|ago| ago < USED_LATELY);
    if !lately {
        // On a disk that is only read nothing goes either.
        let _ = file.set_times(FileTimes::new().set_modified(now));
    }
}

#[cfg(test)]
mod tests {
    use super::{Cache, Entry};
    use crate::Folder;
    use std::path::{Path, PathBuf};
    use std::sync::Arc;
    use std::time::{Duration, Instant};

    fn cache(root: &Path, maker: &str) -> Cache {
        Cache::new(Arc::new(Folder::open(root).unwrap()), "solid", maker)
    }

    /// The only file of a key, wherever it is.
    fn path(root: &Path, key: &str) -> PathBuf {
        let all = std::fs::read_dir(root.join(".assemcad/cache")).unwrap();
        let mut of = all
            .map(|e| e.unwrap().path())
            .filter(|p| p.file_name().unwrap().to_str().unwrap().starts_with(key));
        of.next().unwrap()
    }

    #[test]
    fn damage_of_every_kind_is_noticed() {
        let root = tempfile::tempdir().unwrap();
        let kept = cache(root.path(), "kernel 1");
        assert_eq!(kept.get("aa"), Entry::Missing);
        kept.put("aa", b"value\nbytes");
        let sound = Entry::Sound(b"value\nbytes".to_vec());
        assert_eq!(kept.get("aa"), sound);

        let file = path(root.path(), "aa");
        let good = std::fs::read(&file).unwrap();
        for i in 0..good.len() {
            let mut bad = good.clone();
            bad[i] ^= 1;
            std::fs::write(&file, &bad).unwrap();
            assert_eq!(kept.get("aa"), Entry::Damaged, "byte {i}");
            std::fs::write(&file, &good[..i]).unwrap();
            assert_eq!(kept.get("aa"), Entry::Damaged, "cut at {i}");
        }
        kept.put("aa", b"value\nbytes");
        assert_eq!(kept.get("aa"), sound, "it is mended");
        // A file under another key's name is not that key's value.
        let other = file.with_file_name(
            file.file_name()
                .unwrap()
                .to_str()
                .unwrap()
                .replace("aa", "bb"),
        );
        std::fs::copy(&file, &other).unwrap();
        assert_eq!(kept.get("bb"), Entry::Damaged);
    }

    #[test]
    fn what_another_kernel_made_or_came_from_elsewhere_is_not_taken() {
        let (root, copy) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        cache(root.path(), "kernel 1").put("aa", b"value");
        assert_eq!(cache(root.path(), "kernel 2").get("aa"), Entry::Missing);
        let there = cache(copy.path(), "kernel 1");
        let file = path(root.path(), "aa");
        let name = file.file_name().unwrap();
        std::fs::copy(&file, copy.path().join(".assemcad/cache").join(name)).unwrap();
        assert_eq!(there.get("aa"), Entry::Missing);
        // Renamed to what this folder would call it.
        let own = format!("aa.{}.solid", there.tag);
        std::fs::copy(&file, copy.path().join(".assemcad/cache").join(own)).unwrap();
        assert_eq!(there.get("aa"), Entry::Damaged);
    }

    #[test]
    fn links_pipes_and_folders_are_no_values_and_nothing_waits_for_them() {
        let root = tempfile::tempdir().unwrap();
        let kept = cache(root.path(), "kernel 1");
        kept.put("aa", b"value");
        let file = path(root.path(), "aa");
        let moved = root.path().join("moved");
        std::fs::rename(&file, &moved).unwrap();
        let begun = Instant::now();
        std::os::unix::fs::symlink(&moved, &file).unwrap();
        assert_eq!(kept.get("aa"), Entry::Damaged);
        // The link itself is replaced: what it names is left alone.
        kept.put("aa", b"other");
        assert_eq!(kept.get("aa"), Entry::Sound(b"other".to_vec()));
        assert!(std::fs::read(&moved).unwrap().ends_with(b"value"));

        std::fs::remove_file(&file).unwrap();
        let (kind, mode) = (rustix::fs::FileType::Fifo, rustix::fs::Mode::RWXU);
        rustix::fs::mknodat(rustix::fs::CWD, &file, kind, mode, 0).unwrap();
        assert_eq!(kept.get("aa"), Entry::Damaged);
        kept.put("aa", b"value");
        assert_eq!(kept.get("aa"), Entry::Sound(b"value".to_vec()));

        std::fs::remove_file(&file).unwrap();
        std::fs::create_dir(&file).unwrap();
        assert_eq!(kept.get("aa"), Entry::Damaged);
        // A folder is in the way, and stays.
        kept.put("aa", b"value");
        assert_eq!(kept.get("aa"), Entry::Damaged);
        assert!(begun.elapsed() < Duration::from_secs(5));
        let left = std::fs::read_dir(root.path().join(".assemcad/cache")).unwrap();
        assert_eq!(left.count(), 1, "nothing is left beside it");
    }

    #[test]
    fn many_writers_of_one_value_leave_one_whole_value() {
        let root = tempfile::tempdir().unwrap();
        std::thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    let kept = cache(root.path(), "kernel 1");
                    for _ in 0..50 {
                        kept.put("aa", &[7; 10_000]);
                        assert_eq!(kept.get("aa"), Entry::Sound(vec![7; 10_000]));
                    }
                });
            }
        });
        let left = std::fs::read_dir(root.path().join(".assemcad/cache")).unwrap();
        assert_eq!(left.count(), 1);
    }
}
