//! The rounds of a draft or of a factory's source, counted on disk, so that a server started again goes on
//! counting.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::time::SystemTime;

use assemcad_model::diagnostic::{Diagnostic, Severity};
use assemcad_model::name;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::root::Store;

/// So many rounds of one row are remembered: what is told of them is shorter.
const MOST_ROUNDS: usize = 1000;

/// How many bytes the rows of one folder take at most. The rows that were not counted on for the longest time go first.
const MOST_BYTES: u64 = 8 << 20;

/// What a file takes at least.
const BLOCK: u64 = 4096;

/// What a round found.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Round {
    /// SHA-256 of the text that was tried.
    pub text_sha256: String,
    /// How many errors.
    pub errors: usize,
    /// How many warnings.
    pub warnings: usize,
    /// How often each code was found.
    pub codes: BTreeMap<String, usize>,
}

impl Round {
    /// The round in which this was found of a text.
    #[must_use]
    pub fn of(found: &[Diagnostic], text_sha256: String) -> Self {
        let of = |s: Severity| found.iter().filter(|d| d.severity == s).count();
        let mut codes = BTreeMap::new();
        for d in found {
            let code = serde_json::to_value(d.code).ok();
            let code = code.and_then(|c| c.as_str().map(str::to_owned));
            *codes.entry(code.unwrap_or_default()).or_default() += 1;
        }
        Self {
            text_sha256,
            errors: of(Severity::Error),
            warnings: of(Severity::Warning),
            codes,
        }
    }
}

impl Store {
    /// Counts a round of what a folder and a name stand for, and gives all its rounds, this one the last.
    /// A good one is the last of its row: the next begins anew. Rows that nothing was counted on for the longest
    /// time are forgotten where there are too many.
    ///
    /// # Errors
    /// When the count cannot be written. A damaged count begins anew.
    pub async fn count_round(
        &self,
        folder: &str,
        id: Option<&str>,
        round: Round,
        valid: bool,
    ) -> Result<Vec<Round>, Diagnostic> {
        let _lock = self.lock_folder(folder).await?;
        let file = count_file(folder, id);
        let before: Vec<Round> = self.read_json(&file).unwrap_or_default();
        let mut rounds = before.clone();
        if rounds.last().map(|r| &r.text_sha256) != Some(&round.text_sha256) {
            if rounds.len() >= MOST_ROUNDS {
                rounds.remove(0);
            }
            rounds.push(round);
        }
        if valid {
            // There may be none.
            let _ = self.root.remove_file(&file);
        } else if rounds != before {
            self.write_json(&file, &rounds)?;
            if before.is_empty()
                && let Err(e) = self.prune(folder, &file, MOST_BYTES)
            {
                tracing::warn!("{folder}: what is too much could not be removed: {e}");
            }
        }
        Ok(rounds)
    }

    /// Removes the oldest rows of a folder, which is held, where all take more than so many bytes; not the one that
    /// was written just now.
    fn prune(&self, folder: &str, written: &str, most: u64) -> io::Result<()> {
        let mut above = Path::new(folder).ancestors();
        // A link may lead to files that are no rows.
        if !above.all(|a| a.as_os_str().is_empty() || self.is_own_folder(a)) {
            return Ok(());
        }
        let mut rows = Vec::new();
        let mut bytes = 0;
        for entry in self.root.read_dir(folder)? {
            let entry = entry?;
            let (Ok(name), Ok(facts)) = (entry.file_name().into_string(), entry.metadata()) else {
                continue;
            };
            let path = format!("{folder}/{name}");
            if !facts.is_file() || !name.ends_with(".json") {
                continue;
            }
            let size = facts.len().max(BLOCK);
            bytes += size;
            if path != written {
                let changed = facts
                    .modified()
                    .map_or(SystemTime::UNIX_EPOCH, |t| t.into_std());
                rows.push((changed, path, size));
            }
        }
        if bytes <= most {
            return Ok(());
        }
        rows.sort();
        for (_, path, size) in rows {
            if bytes <= most {
                break;
            }
            self.root.remove_file(&path)?;
            bytes -= size;
        }
        Ok(())
    }

    /// Whether a path is a folder, and no link to one.
    fn is_own_folder(&self, path: &Path) -> bool {
        self.root
            .symlink_metadata(path)
            .is_ok_and(|facts| facts.is_dir())
    }

    /// The rounds so far.
    #[must_use]
    pub fn rounds(&self, folder: &str, id: &str) -> Vec<Round> {
        self.read_json(&count_file(folder, Some(id)))
            .unwrap_or_default()
    }
}

fn count_file(folder: &str, id: Option<&str>) -> String {
    // No valid name begins with a point, so texts without a usable name share one count.
    let name = id.filter(|id| name::is_valid(id)).unwrap_or(".unnamed");
    format!("{folder}/{name}.json")
}

/// The last rounds of a row, as a failure tells them.
#[must_use]
pub fn history(rounds: &[Round]) -> Value {
    let all = rounds.iter().enumerate();
    let told = all.map(|(i, r)| json!({"round": i + 1, "errors": r.errors, "codes": r.codes}));
    // A loop that goes on all the same is told of its last rounds only.
    told.skip(rounds.len().saturating_sub(10)).collect()
}

#[cfg(test)]
mod tests {
    use super::{MOST_ROUNDS, Round};
    use crate::root::Store;
    use std::time::{Duration, SystemTime};

    const FOLDER: &str = ".assemcad/drafts";

    fn round(n: usize) -> Round {
        Round::of(&[], n.to_string())
    }

    #[tokio::test]
    async fn the_oldest_rows_go_where_there_are_too_many() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        let here = |name: &str| root.path().join(FOLDER).join(name);
        for n in 0..20_u64 {
            let id = format!("row{n}");
            store
                .count_round(FOLDER, Some(&id), round(0), false)
                .await
                .unwrap();
            let file = std::fs::File::open(here(&format!("{id}.json"))).unwrap();
            let at = SystemTime::now() - Duration::from_secs(1000 - n);
            file.set_times(std::fs::FileTimes::new().set_modified(at))
                .unwrap();
        }
        std::fs::write(here("notes.txt"), vec![b'x'; 100_000]).unwrap();
        // The oldest of all was written just now.
        let written = format!("{FOLDER}/row0.json");
        store.prune(FOLDER, &written, 20 * 4096).unwrap();
        assert_eq!(store.files_in(FOLDER).unwrap().len(), 21);
        store.prune(FOLDER, &written, 5 * 4096).unwrap();
        let left = store.files_in(FOLDER).unwrap();
        let wanted = [
            "notes.txt",
            "row0.json",
            "row16.json",
            "row17.json",
            "row18.json",
            "row19.json",
        ];
        assert_eq!(left, wanted);
    }

    #[tokio::test]
    async fn nothing_goes_where_a_link_leads() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        std::fs::create_dir_all(root.path().join("assemblies/a")).unwrap();
        std::fs::create_dir(root.path().join(".assemcad")).unwrap();
        std::os::unix::fs::symlink("../assemblies/a", root.path().join(FOLDER)).unwrap();
        let report = root.path().join("assemblies/a/report.json");
        std::fs::write(&report, "{}").unwrap();
        store.prune(FOLDER, "", 0).unwrap();
        assert!(report.exists());
    }

    #[tokio::test]
    async fn a_row_has_an_end_and_a_good_round_removes_it() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        let file = root.path().join(FOLDER).join("a.json");
        let many: Vec<Round> = (0..MOST_ROUNDS).map(round).collect();
        store
            .write_json(&format!("{FOLDER}/a.json"), &many)
            .unwrap();
        let next = store
            .count_round(FOLDER, Some("a"), round(MOST_ROUNDS), false)
            .await
            .unwrap();
        assert_eq!(next.len(), MOST_ROUNDS);
        assert_eq!(next.last(), Some(&round(MOST_ROUNDS)));
        store
            .count_round(FOLDER, Some("a"), round(0), true)
            .await
            .unwrap();
        assert!(!file.exists());
        let anew = store
            .count_round(FOLDER, Some("a"), round(1), false)
            .await
            .unwrap();
        assert_eq!(anew.len(), 1);
    }

    #[tokio::test]
    async fn a_pipe_in_a_rows_place_holds_nobody() {
        let root = tempfile::tempdir().unwrap();
        let store = Store::open(root.path()).unwrap();
        std::fs::create_dir_all(root.path().join(FOLDER)).unwrap();
        let pipe = root.path().join(FOLDER).join("a.json");
        let (kind, mode) = (rustix::fs::FileType::Fifo, rustix::fs::Mode::RWXU);
        rustix::fs::mknodat(rustix::fs::CWD, &pipe, kind, mode, 0).unwrap();
        assert_eq!(store.rounds(FOLDER, "a"), Vec::new());
        let counted = store
            .count_round(FOLDER, Some("a"), round(0), false)
            .await
            .unwrap();
        assert_eq!(counted.len(), 1);
        assert!(std::fs::metadata(&pipe).unwrap().is_file());
    }
}
