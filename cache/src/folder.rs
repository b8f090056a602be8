//! The folder of what is kept.

use std::fs::File;
use std::io;
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::os::unix::fs::MetadataExt;
use std::path::Path;
use std::time::UNIX_EPOCH;

use rustix::fs::{AtFlags, FileType, Mode, OFlags, mkdirat, openat, statat};
use rustix::io::Errno;
use sha2::{Digest, Sha256};

/// Where the folder is, below the root.
const INSIDE: [&str; 2] = [".assemcad", "cache"];

/// The open folder `.assemcad/cache` of a root.
///
/// It is reached step by step without following a link, and everything in it through its handle: whatever is planted
/// below the root, nothing outside is read or written.
#[derive(Debug)]
pub struct Folder {
    handle: OwnedFd,
    mark: String,
}

impl Folder {
    /// Opens the folder of a root, which is made where it is missing.
    ///
    /// # Errors
    /// When it cannot be made or opened, or a link or a file stands in its place.
    pub fn open(root: &Path) -> io::Result<Self> {
        let mut here = rustix::fs::open(root, OFlags::DIRECTORY | OFlags::CLOEXEC, Mode::empty())?;
        for name in INSIDE {
            here = step(&here, name)?;
        }
        let mark = mark(&here)?;
        Ok(Self { handle: here, mark })
    }

    /// What tells this folder from every copy of it: files that come with a copy are not taken for its own.
    ///
    /// An archive or a repository of others may bring a folder like this along; its values were computed by nobody
    /// who is known here.
    #[must_use]
    pub fn mark(&self) -> &str {
        &self.mark
    }

    /// What a name stands for: its kind, when it was changed in seconds since 1970, and how many bytes it takes on
    /// disk.
    pub(crate) fn look(&self, name: &str) -> io::Result<(FileType, i64, u64)> {
        let found = statat(&self.handle, name, AtFlags::SYMLINK_NOFOLLOW)?;
        let bytes = |n: i64| u64::try_from(n).unwrap_or(0);
        // Whole blocks are taken; a file system that does not say how many says nothing.
        let taken = bytes(found.st_size).max(bytes(found.st_blocks) * 512);
        Ok((
            FileType::from_raw_mode(found.st_mode),
            found.st_mtime,
            taken,
        ))
    }

    /// Opens a plain file; none where there is none. Whatever else stands there is an error, at once: opening a pipe
    /// would wait for whoever writes to it, and opening a device may do something.
    pub(crate) fn file(&self, name: &str) -> io::Result<Option<File>> {
        let plain = |kind| match kind {
            FileType::RegularFile => Ok(()),
            _ => Err(io::Error::other("this is no file")),
        };
        match self.look(name) {
            Ok((kind, ..)) => plain(kind)?,
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return Err(e),
        }
        let flags = OFlags::RDONLY | OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::CLOEXEC;
        let file = match openat(&self.handle, name, flags, Mode::empty()) {
            Ok(file) => File::from(file),
            Err(Errno::NOENT) => return Ok(None),
            Err(e) => return Err(e.into()),
        };
        // It may have been exchanged since.
        plain(FileType::from_raw_mode(rustix::fs::fstat(&file)?.st_mode))?;
        Ok(Some(file))
    }

    /// Makes a file that was not there.
    pub(crate) fn begin(&self, name: &str) -> io::Result<File> {
        let flags =
            OFlags::WRONLY | OFlags::CREATE | OFlags::EXCL | OFlags::NOFOLLOW | OFlags::CLOEXEC;
        let mode = Mode::from_raw_mode(0o666);
        Ok(File::from(openat(&self.handle, name, flags, mode)?))
    }

    pub(crate) fn rename(&self, from: &str, to: &str) -> io::Result<()> {
        Ok(rustix::fs::renameat(&self.handle, from, &self.handle, to)?)
    }

    pub(crate) fn remove(&self, name: &str) -> io::Result<()> {
        Ok(rustix::fs::unlinkat(&self.handle, name, AtFlags::empty())?)
    }

    /// The names of all that is in it.
    pub(crate) fn names(&self) -> io::Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in rustix::fs::Dir::read_from(&self.handle)? {
            // What is not text was not written here.
            if let Ok(name) = entry?.file_name().to_str() {
                names.push(name.to_owned());
            }
        }
        Ok(names)
    }
}

impl AsFd for Folder {
    fn as_fd(&self) -> BorrowedFd<'_> {
        self.handle.as_fd()
    }
}

/// Opens a folder in a folder, which is made where it is missing.
fn step(here: &OwnedFd, name: &str) -> io::Result<OwnedFd> {
    let flags = OFlags::DIRECTORY | OFlags::NOFOLLOW | OFlags::CLOEXEC;
    let open = || openat(here, name, flags, Mode::empty());
    match open() {
        Err(Errno::NOENT) => match mkdirat(here, name, Mode::from_raw_mode(0o777)) {
            // Another process may have made it just now.
            Ok(()) | Err(Errno::EXIST) => Ok(open()?),
            Err(e) => Err(e.into()),
        },
        opened => Ok(opened?),
    }
}

/// The folder's number and when it was made, where that is known.
fn mark(folder: &OwnedFd) -> io::Result<String> {
    let facts = File::from(folder.try_clone()?).metadata()?;
    let made = facts.created().ok();
    let made = made.and_then(|at| at.duration_since(UNIX_EPOCH).ok());
    let text = format!("{} {}", facts.ino(), made.map_or(0, |at| at.as_nanos()));
    Ok(hex::encode(Sha256::digest(text)))
}

#[cfg(test)]
mod tests {
    use super::Folder;
    use std::os::unix::fs::symlink;

    #[test]
    fn no_link_leads_out_and_no_file_is_taken_for_a_folder() {
        let outer = tempfile::tempdir().unwrap();
        let elsewhere = outer.path().join("elsewhere");
        std::fs::create_dir_all(elsewhere.join("cache")).unwrap();
        let root = |name: &str| {
            let root = outer.path().join(name);
            std::fs::create_dir(&root).unwrap();
            root
        };
        let first = root("first");
        symlink(&elsewhere, first.join(".assemcad")).unwrap();
        Folder::open(&first).unwrap_err();
        let second = root("second");
        std::fs::create_dir(second.join(".assemcad")).unwrap();
        symlink(elsewhere.join("cache"), second.join(".assemcad/cache")).unwrap();
        Folder::open(&second).unwrap_err();
        // Within the root, too: what is kept stands nowhere else.
        let third = root("third");
        std::fs::create_dir(third.join("real")).unwrap();
        symlink("real", third.join(".assemcad")).unwrap();
        Folder::open(&third).unwrap_err();
        let fourth = root("fourth");
        std::fs::write(fourth.join(".assemcad"), "a file").unwrap();
        Folder::open(&fourth).unwrap_err();
        Folder::open(&root("fifth")).unwrap();
    }

    #[test]
    fn a_copy_of_a_folder_is_another_one() {
        let (a, b) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let of = |root: &tempfile::TempDir| Folder::open(root.path()).unwrap().mark().to_owned();
        assert_eq!(of(&a), of(&a));
        assert_ne!(of(&a), of(&b));
    }
}
