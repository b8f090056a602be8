//! Several files put in their places by one step.
//!
//! All are whole beside their places before anything moves. Then a note is left in [`FOLDER`] that says which: with
//! it the step is taken, and whoever finds it behind a writer that died does the rest. Where a file cannot be moved,
//! all that were moved before it are put back, so that nothing new stands beside something old.

use std::io::{self, Read, Write};

use cap_std::fs::{Dir, File, OpenOptions};
use rustix::fs::{FlockOperation, flock};
use serde::{Deserialize, Serialize};

use crate::root::Store;

/// Where notes are left.
const FOLDER: &str = ".assemcad/switch";

/// The longest note that is read, in bytes.
const LONGEST: u64 = 1 << 20;

/// What a note says: the files of one step.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Switch {
    pub(crate) moves: Vec<Move>,
}

/// A file and its place.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Move {
    /// The folder, below the root; empty for the root itself.
    pub(crate) folder: String,
    /// The file's name until it is in its place.
    pub(crate) beside: String,
    /// Its name there.
    pub(crate) name: String,
}

impl Move {
    /// Under which name the file that was there before is kept until all are moved.
    fn before(&self) -> String {
        format!("{}.old", self.beside)
    }

    fn here(&self, root: &Dir) -> io::Result<Dir> {
        if self.folder.is_empty() {
            root.try_clone()
        } else {
            root.open_dir(&self.folder)
        }
    }
}

impl Switch {
    /// Moves all files to their places, or none.
    fn take(&self, root: &Dir) -> io::Result<()> {
        for (done, file) in self.moves.iter().enumerate() {
            if let Err(e) = file.take(root) {
                self.moves
                    .iter()
                    .take(done)
                    .for_each(|file| file.give_back(root));
                self.moves.iter().for_each(|file| file.forget(root));
                return Err(e);
            }
        }
        self.moves.iter().for_each(|file| file.forget(root));
        Ok(())
    }

    /// Whether a name is that of a file that is on its way.
    pub(crate) fn holds(&self, folder: &str, name: &str) -> bool {
        let mut moves = self.moves.iter().filter(|m| m.folder == folder);
        moves.any(|m| m.beside == name || m.before() == name)
    }
}

impl Move {
    fn take(&self, root: &Dir) -> io::Result<()> {
        let here = self.here(root)?;
        if !here.try_exists(&self.beside)? {
            // Another who found the note has moved it.
            return Ok(());
        }
        if here
            .symlink_metadata(&self.name)
            .is_ok_and(|there| there.is_dir())
        {
            return Err(io::Error::from(io::ErrorKind::IsADirectory));
        }
        match here.hard_link(&self.name, &here, self.before()) {
            Ok(()) => {}
            // Nothing was there, or this was begun before.
            Err(e)
                if matches!(
                    e.kind(),
                    io::ErrorKind::NotFound | io::ErrorKind::AlreadyExists
                ) => {}
            // There are file systems without a second name for a file.
            Err(_) => here.rename(&self.name, &here, self.before())?,
        }
        here.rename(&self.beside, &here, &self.name)?;
        // The new name itself is on disk only when the folder is.
        here.open(".")?.sync_all()
    }

    /// Puts back what was there before.
    fn give_back(&self, root: &Dir) {
        let Ok(here) = self.here(root) else { return };
        if here.rename(self.before(), &here, &self.name).is_err() {
            let _ = here.remove_file(&self.name);
        }
    }

    /// Removes what is not needed any more.
    fn forget(&self, root: &Dir) {
        let Ok(here) = self.here(root) else { return };
        let _ = here.remove_file(self.before());
        let _ = here.remove_file(&self.beside);
    }
}

impl Store {
    /// Takes a step all of whose files are whole beside their places.
    ///
    /// # Errors
    /// When the note cannot be left, or a file cannot be moved; then all is as it was before.
    pub(crate) fn switch(&self, switch: &Switch) -> io::Result<()> {
        if let [only] = switch.moves.as_slice() {
            // Moving one file is one step by itself.
            let here = only.here(&self.root)?;
            here.rename(&only.beside, &here, &only.name)?;
            return here.open(".")?.sync_all();
        }
        self.root.create_dir_all(FOLDER)?;
        let folder = self.root.open_dir(FOLDER)?;
        let note = self.unique("note");
        let text = serde_json::to_vec(switch)?;
        let mut file = folder.create(&note)?;
        // Held until the step is taken or this process is dead, so that nobody else takes it meanwhile.
        flock(&file, FlockOperation::NonBlockingLockExclusive)?;
        let name = format!("{}.json", note.trim_start_matches('.'));
        let left = (|| {
            file.write_all(&text)?;
            file.sync_all()?;
            folder.rename(&note, &folder, &name)?;
            folder.open(".")?.sync_all()
        })();
        if let Err(e) = left {
            let _ = folder.remove_file(&note);
            let _ = folder.remove_file(&name);
            return Err(e);
        }
        let taken = switch.take(&self.root);
        let _ = folder.remove_file(&name);
        drop(file);
        taken
    }

    /// Ends the steps of writers that died in the middle of one.
    pub(crate) fn mend(&self) {
        let Ok(folder) = self.root.open_dir(FOLDER) else {
            return;
        };
        for (name, mut file) in notes(&folder) {
            if flock(&file, FlockOperation::NonBlockingLockExclusive).is_err() {
                // Its writer lives.
                continue;
            }
            match read(&mut file) {
                Some(switch) => match switch.take(&self.root) {
                    Ok(()) => tracing::warn!("a change that was broken off was brought to its end"),
                    Err(e) => tracing::warn!("a change that was broken off was taken back: {e}"),
                },
                None => tracing::warn!("{FOLDER}/{name} is no note of a change"),
            }
            let _ = folder.remove_file(&name);
        }
    }

    /// The steps that are being taken at this moment.
    pub(crate) fn switches(&self) -> Vec<Switch> {
        let Ok(folder) = self.root.open_dir(FOLDER) else {
            return Vec::new();
        };
        let notes = notes(&folder).into_iter();
        notes.filter_map(|(_, mut file)| read(&mut file)).collect()
    }
}

/// The notes in their folder, by name.
fn notes(folder: &Dir) -> Vec<(String, File)> {
    let Ok(entries) = folder.entries() else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for entry in entries.flatten() {
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        // Opening a pipe would wait for whoever writes to it.
        let plain = entry.file_type().is_ok_and(|t| t.is_file());
        if plain
            && name.ends_with(".json")
            && let Ok(file) = folder.open_with(&name, OpenOptions::new().read(true))
        {
            found.push((name, file));
        }
    }
    found.sort_by(|(a, _), (b, _)| a.cmp(b));
    found
}

fn read(file: &mut File) -> Option<Switch> {
    let mut text = Vec::new();
    file.take(LONGEST).read_to_end(&mut text).ok()?;
    let switch: Switch = serde_json::from_slice(&text).ok()?;
    // Whoever may write into the folder may write anything: names stay names, and what is moved is what was
    // written beside its place.
    let plain = |name: &str| !name.is_empty() && !name.contains('/') && name != "." && name != "..";
    let sound = |m: &Move| plain(&m.beside) && m.beside.starts_with('.') && plain(&m.name);
    switch.moves.iter().all(sound).then_some(switch)
}

#[cfg(test)]
mod tests {
    use super::{FOLDER, Move, Switch};
    use crate::root::Store;
    use std::path::Path;

    fn content(root: &Path, name: &str) -> String {
        std::fs::read_to_string(root.join("a").join(name)).unwrap_or_default()
    }

    /// A root with two files and what is to take their places, as a writer leaves it that dies behind its note.
    fn broken_off(root: &Path) -> Switch {
        std::fs::create_dir_all(root.join("a")).unwrap();
        std::fs::create_dir_all(root.join(FOLDER)).unwrap();
        let moves = ["one", "two"].map(|name| Move {
            folder: "a".to_owned(),
            beside: format!(".{name}.4000000-0"),
            name: name.to_owned(),
        });
        for m in &moves {
            std::fs::write(root.join("a").join(&m.name), "old").unwrap();
            std::fs::write(root.join("a").join(&m.beside), "new").unwrap();
        }
        let switch = Switch {
            moves: moves.to_vec(),
        };
        let note = serde_json::to_vec(&switch).unwrap();
        std::fs::write(root.join(FOLDER).join("note.4000000-1.json"), note).unwrap();
        switch
    }

    fn only(root: &Path, names: &[&str]) {
        let all = std::fs::read_dir(root.join("a")).unwrap();
        let mut all: Vec<String> = all
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .collect();
        all.sort();
        assert_eq!(all, names);
        let notes = std::fs::read_dir(root.join(FOLDER)).map_or(0, Iterator::count);
        assert_eq!(notes, 0);
    }

    #[test]
    fn a_step_that_was_broken_off_is_ended_at_the_next_start() {
        let root = tempfile::tempdir().unwrap();
        let switch = broken_off(root.path());
        // It had come as far as the first file.
        std::fs::rename(
            root.path().join("a").join(&switch.moves[0].beside),
            root.path().join("a/one"),
        )
        .unwrap();
        Store::open(root.path()).unwrap();
        for name in ["one", "two"] {
            assert_eq!(content(root.path(), name), "new");
        }
        only(root.path(), &["one", "two"]);
    }

    #[test]
    fn what_cannot_be_moved_takes_all_back() {
        let root = tempfile::tempdir().unwrap();
        broken_off(root.path());
        // A folder stands in the second one's place.
        std::fs::remove_file(root.path().join("a/two")).unwrap();
        std::fs::create_dir(root.path().join("a/two")).unwrap();
        Store::open(root.path()).unwrap();
        assert_eq!(content(root.path(), "one"), "old");
        only(root.path(), &["one", "two"]);
    }

    #[test]
    fn the_same_where_nobody_died() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        store.write("a/one", b"old").unwrap();
        std::fs::create_dir(root.path().join("a/two")).unwrap();
        let files: [(&str, &[u8]); 3] = [("a/new", b"new"), ("a/one", b"new"), ("a/two", b"new")];
        store.write_all(&files).unwrap_err();
        assert_eq!(content(root.path(), "one"), "old");
        only(root.path(), &["one", "two"]);
    }

    #[test]
    fn a_note_moves_nothing_out_of_its_folder() {
        let root = tempfile::tempdir().unwrap();
        let mut switch = broken_off(root.path());
        switch.moves[0].name = "../up".to_owned();
        let note = serde_json::to_vec(&switch).unwrap();
        std::fs::write(root.path().join(FOLDER).join("note.4000000-1.json"), note).unwrap();
        Store::open(root.path()).unwrap();
        assert!(!root.path().join("up").exists());
        assert_eq!(content(root.path(), "one"), "old");
    }

    #[test]
    fn the_step_of_a_living_writer_is_left_alone() {
        let root = tempfile::tempdir().unwrap();
        broken_off(root.path());
        let note =
            std::fs::File::open(root.path().join(FOLDER).join("note.4000000-1.json")).unwrap();
        rustix::fs::flock(&note, rustix::fs::FlockOperation::LockExclusive).unwrap();
        Store::open(root.path()).unwrap();
        assert_eq!(content(root.path(), "one"), "old");
        assert!(root.path().join("a/.one.4000000-0").exists());
    }
}
