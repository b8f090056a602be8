//! What writers that were killed left behind.

use cap_std::fs::Dir;
use rustix::fs::{FlockOperation, flock};

use crate::root::Store;

/// The folders in which files are written, and how deep below them.
const WRITTEN: [(&str, usize); 5] = [
    ("", 0),
    ("assemblies", 1),
    ("exports", 4),
    ("factories", 0),
    (".assemcad", 1),
];

impl Store {
    /// Removes files that were begun and never came to their places. What a living writer has begun is held by it,
    /// and stays.
    pub(crate) fn sweep(&self) {
        let mut left = Vec::new();
        for (folder, depth) in WRITTEN {
            look(&self.root, folder, depth, &mut left);
        }
        if left.is_empty() {
            return;
        }
        // Asked last: the writers of what was found are dead, and leave no note any more.
        let switches = self.switches();
        for (folder, name) in left {
            if switches.iter().any(|s| s.holds(&folder, &name)) {
                continue;
            }
            let path = join(&folder, &name);
            match self.root.remove_file(&path) {
                Ok(()) => tracing::info!("{path}: begun by a writer that died; removed"),
                Err(e) => tracing::warn!("{path}: begun by a writer that died; it stays: {e}"),
            }
        }
    }
}

/// Finds what nobody holds in a folder and below it.
fn look(root: &Dir, folder: &str, depth: usize, left: &mut Vec<(String, String)>) {
    let here = if folder.is_empty() {
        root.try_clone()
    } else {
        root.open_dir(folder)
    };
    let Ok(entries) = here.and_then(|here| here.entries()) else {
        return;
    };
    for entry in entries.flatten() {
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        let Ok(kind) = entry.file_type() else {
            continue;
        };
        if kind.is_dir() && depth > 0 {
            look(root, &join(folder, &name), depth - 1, left);
        } else if kind.is_file() && is_begun(&name) {
            let free = entry
                .open()
                .is_ok_and(|file| flock(&file, FlockOperation::NonBlockingLockExclusive).is_ok());
            if free {
                left.push((folder.to_owned(), name));
            }
        }
    }
}

/// Whether a name is one that [`Store::unique`] gives, or that of what a step keeps meanwhile.
fn is_begun(name: &str) -> bool {
    let name = name.strip_suffix(".old").unwrap_or(name);
    let numbers = name.strip_prefix('.').and_then(|n| n.rsplit_once('.'));
    let number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    numbers
        .and_then(|(_, numbers)| numbers.split_once('-'))
        .is_some_and(|(pid, count)| number(pid) && number(count))
}

fn join(folder: &str, name: &str) -> String {
    if folder.is_empty() {
        name.to_owned()
    } else {
        format!("{folder}/{name}")
    }
}

#[cfg(test)]
mod tests {
    use crate::root::Store;
    use assemcad_model::spec::Assembly;

    #[test]
    fn what_a_killed_write_left_goes_and_all_else_stays() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        store.save(&Assembly::new("a", "")).unwrap();
        let here = |name: &str| root.path().join(name);
        let gone = [
            "assemblies/a/.assembly.yaml.123-4",
            "assemblies/a/.report.json.123-5.old",
            "factories/.user.x@1.star.9-0",
            ".assemcad/drafts/.a.json.77-1",
        ];
        let stays = [
            "assemblies/a/.hidden",
            "assemblies/a/notes.123-4",
            "assemblies/a/.x.y-z",
            "assemblies/a/.held.5-5",
        ];
        for name in gone.iter().chain(&stays) {
            std::fs::create_dir_all(here(name).parent().unwrap()).unwrap();
            std::fs::write(here(name), "x").unwrap();
        }
        let held = std::fs::File::open(here("assemblies/a/.held.5-5")).unwrap();
        rustix::fs::flock(&held, rustix::fs::FlockOperation::LockExclusive).unwrap();
        Store::open(root.path()).unwrap();
        for name in gone {
            assert!(!here(name).exists(), "{name}");
        }
        for name in stays {
            assert!(here(name).exists(), "{name}");
        }
        assert!(here("assemblies/a/assembly.yaml").exists());
    }
}
