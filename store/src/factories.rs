//! Admitted factories on disk: `factories/NAME@VERSION.star` is a source and `factories/NAME@VERSION.json` on
//! what it was admitted.

use std::collections::BTreeMap;

use assemcad_factories::admission::{Record, file_name, is_valid_user_name, split_version};
use assemcad_model::diagnostic::{Code, Diagnostic};
use cap_std::fs::MetadataExt;

use crate::files::json_bytes;
use crate::root::{Lock, Store};

/// Where admitted factories are kept.
const FOLDER: &str = "factories";

/// What tells one state of a file from another: its number on disk, its length, and when it was written.
pub type Stamp = (u64, u64, (i64, i64));

/// A record and its source.
#[derive(Debug)]
pub struct StoredFactory {
    /// On what it was admitted.
    pub record: Record,
    /// Its source as it is now: whoever edited it may have changed it since.
    pub source: String,
}

impl Store {
    /// Waits until no other writer holds the admitted factories, and holds them.
    ///
    /// # Errors
    /// When their folder cannot be made or held.
    pub async fn lock_factories(&self) -> Result<Lock, Diagnostic> {
        self.lock_folder(FOLDER).await
    }

    /// The newest version of a name on disk; 0 where there is none.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn newest_version(&self, name: &str) -> Result<u32, Diagnostic> {
        let files = self.files_in(FOLDER)?;
        let versions = files.iter().filter_map(|file| {
            let stem = file.strip_suffix(".json").or(file.strip_suffix(".star"))?;
            let (stored, version) = split_version(stem)?;
            (stored == name).then_some(version)
        });
        Ok(versions.max().unwrap_or(0))
    }

    /// Writes a record, and its source where one is given; both are on disk when this returns.
    ///
    /// # Errors
    /// When they cannot be written; what was there before is then untouched.
    pub fn write_factory(&self, record: &Record, source: Option<&str>) -> Result<(), Diagnostic> {
        let path = |extension| {
            let file = file_name(&record.factory, record.version, extension);
            format!("{FOLDER}/{file}")
        };
        let (star, json) = (path("star"), path("json"));
        let bytes = json_bytes(&json, record)?;
        // The record is the last to be moved to its place: a source without one is not admitted.
        let mut files: Vec<(&str, &[u8])> = Vec::new();
        files.extend(source.map(|text| (star.as_str(), text.as_bytes())));
        files.push((&json, &bytes));
        self.write_all(&files)
    }

    /// The stamps of each admitted factory's files, by its name with the version: others whenever somebody wrote its
    /// record or its source.
    ///
    /// # Errors
    /// When the folder cannot be read.
    pub fn factory_stamps(&self) -> Result<BTreeMap<String, Vec<Stamp>>, Diagnostic> {
        let mut stamps: BTreeMap<String, Vec<Stamp>> = BTreeMap::new();
        for file in self.files_in(FOLDER)? {
            let stem = file.strip_suffix(".json").or(file.strip_suffix(".star"));
            let facts = self.root.metadata(format!("{FOLDER}/{file}"));
            if let (Some(stem), Ok(facts)) = (stem, facts) {
                let written = (facts.mtime(), facts.mtime_nsec());
                let stamp = (facts.ino(), facts.len(), written);
                stamps.entry(stem.to_owned()).or_default().push(stamp);
            }
        }
        Ok(stamps)
    }

    /// The source of an admitted factory as it is now.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn factory_source(&self, name: &str) -> Result<String, Diagnostic> {
        self.read_text(&format!("{FOLDER}/{name}.star"))
    }

    /// An admitted factory by its name with the version.
    ///
    /// # Errors
    /// What is at fault with it.
    pub fn stored_factory(&self, name: &str) -> Result<StoredFactory, Diagnostic> {
        let record = format!("{FOLDER}/{name}.json");
        if !self.root.exists(&record) {
            let d = Diagnostic::error(
                Code::FileFailed,
                format!("{FOLDER}/{name}.star"),
                "this source was not admitted: there is no record beside it",
            );
            return Err(d.hint("give it to synthesize_factory"));
        }
        self.admitted_factory(&record, name)
    }

    fn admitted_factory(&self, path: &str, stem: &str) -> Result<StoredFactory, Diagnostic> {
        let damaged = |what: &str| {
            let d = Diagnostic::error(
                Code::FileDamaged,
                path,
                format!("this is no record of a factory: {what}"),
            );
            d.hint("give the source to synthesize_factory again")
        };
        let text = self.read_text(path)?;
        let record: Record =
            serde_json::from_str(&text).map_err(|e| damaged(&format!("line {}", e.line())))?;
        if record.format != Record::FORMAT {
            return Err(damaged(&format!("format {}", record.format)));
        }
        if record.name() != stem || !is_valid_user_name(&record.factory) {
            return Err(damaged("it names another factory than its file"));
        }
        let source = self.factory_source(stem)?;
        Ok(StoredFactory { record, source })
    }
}
