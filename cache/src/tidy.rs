//! What goes: leftovers, and what was not used for the longest time where there is too much.

use std::io;

use rustix::fs::{FileType, FlockOperation, flock};

use crate::files::Cache;

/// After there was too much, this share of the limit is left free, so that not every value costs a look at all.
const FREED: u64 = 8;

/// What is in the folder after it was tidied.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Left {
    /// How many files.
    pub files: usize,
    /// How many bytes they take on disk.
    pub bytes: u64,
    /// How many files went.
    pub removed: usize,
}

/// A value in the folder.
struct Value {
    name: String,
    used: i64,
    bytes: u64,
}

impl Cache {
    /// Removes what killed writers left behind, values of this kind that others made, and, where all kinds together
    /// take more than `limit` bytes, values of any kind, the longest unused first. What has another name than what is
    /// kept here is not touched.
    ///
    /// # Errors
    /// When the folder cannot be read. What cannot be removed stays.
    pub fn tidy(&self, limit: u64) -> io::Result<Left> {
        let mut values = Vec::new();
        let mut left = Left::default();
        for name in self.folder.names()? {
            let goes = match parts(&name) {
                Some((tag, kind)) => kind == self.kind && tag != Some(self.tag.as_str()),
                None if is_begun(&name) => self.is_left_behind(&name),
                None => continue,
            };
            // Somebody else may have removed it just now.
            let Ok((kind, used, bytes)) = self.folder.look(&name) else {
                continue;
            };
            if kind == FileType::Directory {
                continue;
            }
            if goes && self.folder.remove(&name).is_ok() {
                left.removed += 1;
                continue;
            }
            left.bytes += bytes;
            if parts(&name).is_some() {
                values.push(Value { name, used, bytes });
            }
        }
        left.files = values.len();
        if left.bytes <= limit {
            return Ok(left);
        }
        // By name where they are equally old, so that several who tidy at once agree.
        values.sort_by(|a, b| (a.used, &a.name).cmp(&(b.used, &b.name)));
        for value in values {
            if left.bytes <= limit - limit / FREED {
                break;
            }
            if self.folder.remove(&value.name).is_ok() {
                left.bytes = left.bytes.saturating_sub(value.bytes);
                left.files -= 1;
                left.removed += 1;
            }
        }
        Ok(left)
    }

    /// Whether nobody holds a file that was begun.
    fn is_left_behind(&self, name: &str) -> bool {
        match self.folder.file(name) {
            Ok(Some(file)) => flock(&file, FlockOperation::NonBlockingLockExclusive).is_ok(),
            Ok(None) => false,
            Err(_) => true,
        }
    }
}

/// The tag and the kind of a value's name; no tag where an earlier version wrote it, and none where it is no value's
/// name.
fn parts(name: &str) -> Option<(Option<&str>, &str)> {
    let hex = |text: &str, digits: usize| {
        text.len() == digits && text.bytes().all(|b| b.is_ascii_hexdigit())
    };
    let word = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_lowercase());
    match name.split('.').collect::<Vec<_>>().as_slice() {
        [key, tag, kind] if hex(key, 64) && hex(tag, 16) && word(kind) => Some((Some(tag), kind)),
        [key, kind] if hex(key, 64) && word(kind) => Some((None, kind)),
        _ => None,
    }
}

/// Whether a name is one of a file that is not yet in its place: `.NAME.PID-COUNT`.
fn is_begun(name: &str) -> bool {
    let numbers = name.strip_prefix('.').and_then(|n| n.rsplit_once('.'));
    let number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    numbers
        .and_then(|(_, numbers)| numbers.split_once('-'))
        .is_some_and(|(pid, count)| number(pid) && number(count))
}

#[cfg(test)]
mod tests {
    use crate::{Cache, Entry, Folder};
    use std::fs::{File, FileTimes};
    use std::path::Path;
    use std::sync::Arc;
    use std::time::{Duration, SystemTime};

    fn cache(root: &Path, kind: &'static str, maker: &str) -> Cache {
        Cache::new(Arc::new(Folder::open(root).unwrap()), kind, maker)
    }

    fn key(n: usize) -> String {
        format!("{n:064x}")
    }

    /// Lets a value have been used so long ago.
    fn aged(root: &Path, of: &Cache, n: usize, hours: u64) {
        let name = format!("{}.{}.{}", key(n), of.tag, of.kind);
        let file = File::open(root.join(".assemcad/cache").join(name)).unwrap();
        let at = SystemTime::now() - Duration::from_secs(hours * 3600);
        file.set_times(FileTimes::new().set_modified(at)).unwrap();
    }

    #[test]
    fn the_longest_unused_go_first_whatever_their_kind() {
        let root = tempfile::tempdir().unwrap();
        let solids = cache(root.path(), "solid", "k");
        let answers = cache(root.path(), "answer", "g");
        for n in 0..10 {
            let of = if n % 2 == 0 { &solids } else { &answers };
            of.put(&key(n), &[1; 100_000]);
            aged(root.path(), of, n, 100 - n as u64);
        }
        // Used again, the oldest is the youngest.
        assert!(matches!(solids.get(&key(0)), Entry::Sound(_)));
        let all = solids.tidy(u64::MAX).unwrap();
        assert_eq!((all.files, all.removed), (10, 0));
        assert!(all.bytes >= 1_000_000);
        let left = answers.tidy(600_000).unwrap();
        assert!(left.bytes <= 600_000, "{left:?}");
        for n in 0..10 {
            let of = if n % 2 == 0 { &solids } else { &answers };
            let there = of.get(&key(n)) != Entry::Missing;
            assert_eq!(there, n == 0 || n + left.files > 10, "{n} {left:?}");
        }
        assert!((4..=5).contains(&left.files), "{left:?}");
    }

    #[test]
    fn leftovers_go_and_what_is_not_ours_stays() {
        let root = tempfile::tempdir().unwrap();
        let (old, now) = (
            cache(root.path(), "solid", "1"),
            cache(root.path(), "solid", "2"),
        );
        let answers = cache(root.path(), "answer", "1");
        for (n, of) in [&old, &now, &answers].into_iter().enumerate() {
            of.put(&key(n), b"value");
        }
        let here = |name: &str| root.path().join(".assemcad/cache").join(name);
        let before = format!("{}.solid", key(9));
        let left = [before.as_str(), ".aa.tag.solid.123-4"];
        let stays = ["notes.txt", ".aa.tag.solid.123-5", "aa.solid", ".hidden"];
        for name in left.iter().chain(&stays) {
            std::fs::write(here(name), "x").unwrap();
        }
        let held = File::open(here(".aa.tag.solid.123-5")).unwrap();
        rustix::fs::flock(&held, rustix::fs::FlockOperation::LockExclusive).unwrap();
        assert_eq!(now.tidy(u64::MAX).unwrap().removed, 3);
        for name in left {
            assert!(!here(name).exists(), "{name}");
        }
        for name in stays {
            assert!(here(name).exists(), "{name}");
        }
        assert_eq!(old.get(&key(0)), Entry::Missing);
        assert_eq!(now.get(&key(1)), Entry::Sound(b"value".to_vec()));
        assert_eq!(answers.get(&key(2)), Entry::Sound(b"value".to_vec()));
    }

    #[test]
    fn a_planted_link_goes_and_what_it_names_stays() {
        let root = tempfile::tempdir().unwrap();
        let victim = root.path().join("victim");
        std::fs::write(&victim, "safe").unwrap();
        let kept = cache(root.path(), "solid", "1");
        let name = format!("{}.0123456789abcdef.solid", key(1));
        let link = root.path().join(".assemcad/cache").join(name);
        std::os::unix::fs::symlink(&victim, &link).unwrap();
        assert_eq!(kept.tidy(u64::MAX).unwrap().removed, 1);
        assert!(std::fs::symlink_metadata(&link).is_err());
        assert_eq!(std::fs::read_to_string(&victim).unwrap(), "safe");
    }
}
