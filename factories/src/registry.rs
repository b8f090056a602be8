//! The factories that there are, and what they make.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};

use assemcad_model::canonical;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name;
use assemcad_model::param::clip;
use assemcad_script::{Evaluated, Factory};
use serde_json::{Map, Value, json};

use crate::builtin;

/// So many results of evaluations are kept.
const MOST_KEPT: usize = 256;

/// The largest factory file that is read, in bytes; longer ones are refused before they are in memory.
const MOST_FILE_BYTES: u64 = 1 << 20;

/// Factories by name.
#[derive(Debug, Default)]
pub struct Registry {
    factories: BTreeMap<String, Factory>,
    kept: Mutex<Kept>,
}

/// Results of evaluations by name and canonical parameters.
#[derive(Debug, Default)]
struct Kept {
    results: BTreeMap<(String, Vec<u8>), Arc<Evaluated>>,
}

/// Whether a text may name a factory: `NAMESPACE.NAME`, both valid names.
#[must_use]
pub fn is_valid_name(text: &str) -> bool {
    text.split_once('.')
        .is_some_and(|(space, rest)| name::is_valid(space) && name::is_valid(rest))
}

impl Registry {
    /// The built-in factories, read once.
    #[must_use]
    pub fn builtin() -> &'static Self {
        static BUILTIN: LazyLock<Registry> = LazyLock::new(|| Registry::load(None).0);
        &BUILTIN
    }

    /// The built-in factories and those of a folder of `NAMESPACE.NAME.star` files.
    ///
    /// What is at fault is reported and left out; the rest is there. A file cannot take the place of a
    /// built-in factory: two sources under one name would make one specification mean two things.
    #[must_use]
    pub fn load(extra: Option<&Path>) -> (Self, Vec<Diagnostic>) {
        let mut registry = Self::default();
        let mut found = Vec::new();
        for (name, source) in builtin::ALL {
            registry.add(name, source, &mut found);
        }
        if let Some(folder) = extra {
            registry.add_folder(folder, &mut found);
        }
        (registry, found)
    }

    fn add(&mut self, name: &str, source: &str, found: &mut Vec<Diagnostic>) {
        match Factory::parse(name, source) {
            Ok(factory) => {
                self.factories.insert(name.to_owned(), factory);
            }
            Err(faults) => found.extend(faults),
        }
    }

    fn add_folder(&mut self, folder: &Path, found: &mut Vec<Diagnostic>) {
        let entries = match std::fs::read_dir(folder) {
            Ok(entries) => entries,
            Err(e) => {
                found.push(
                    Diagnostic::error(
                        Code::FileFailed,
                        folder.display().to_string(),
                        "the folder of factories cannot be read",
                    )
                    .hint(e.kind().to_string()),
                );
                return;
            }
        };
        // A folder's own order differs between machines.
        let mut paths: Vec<_> = entries.filter_map(Result::ok).map(|e| e.path()).collect();
        paths.sort();
        for path in paths {
            if path.extension().is_none_or(|e| e != "star") {
                continue;
            }
            let name = path.file_stem().map(|s| s.to_string_lossy().into_owned());
            let name = name.unwrap_or_default();
            let place = format!("factory {}", clip(&name));
            if !is_valid_name(&name) {
                found.push(
                    Diagnostic::error(
                        Code::NameInvalid,
                        place,
                        "a factory file is named NAMESPACE.NAME.star",
                    )
                    .hint(format!("both are {}", name::RULE)),
                );
            } else if self.factories.contains_key(&name) {
                found.push(Diagnostic::error(
                    Code::NameTaken,
                    place,
                    "there is a factory of this name already",
                ));
            } else {
                match read(&path) {
                    Ok(source) => self.add(&name, &source, found),
                    Err(why) => {
                        found.push(Diagnostic::error(Code::FileFailed, place, why));
                    }
                }
            }
        }
    }

    /// Whether a factory is one of ours: its defaults are made in a moment, which of others nobody knows.
    #[must_use]
    pub fn is_builtin(name: &str) -> bool {
        builtin::ALL.iter().any(|(known, _)| *known == name)
    }

    /// The names of all factories, sorted.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        self.factories.keys().map(String::as_str).collect()
    }

    /// The factories, sorted by name.
    pub fn iter(&self) -> impl Iterator<Item = &Factory> {
        self.factories.values()
    }

    /// The factory of a name, or of the part of a name behind the point where only one has it:
    /// `rect_plate` for `base_frame.rect_plate`.
    ///
    /// # Errors
    /// [`Code::FactoryUnknown`] with the nearest names, or with all that the short name could mean.
    pub fn get(&self, name: &str) -> Result<&Factory, Box<Diagnostic>> {
        if let Some(factory) = self.factories.get(name) {
            return Ok(factory);
        }
        let short = |f: &&Factory| f.name().split_once('.').is_some_and(|(_, s)| s == name);
        let meant: Vec<&Factory> = self.factories.values().filter(short).collect();
        match meant.as_slice() {
            [one] => Ok(one),
            [] => Err(Box::new(self.unknown(name))),
            several => {
                let names: Vec<&str> = several.iter().map(|f| f.name()).collect();
                Err(Box::new(
                    Diagnostic::error(
                        Code::FactoryUnknown,
                        "factory",
                        format!("'{}' could mean several factories", clip(name)),
                    )
                    .found(name)
                    .expected(json!(names)),
                ))
            }
        }
    }

    fn unknown(&self, name: &str) -> Diagnostic {
        let d = Diagnostic::error(
            Code::FactoryUnknown,
            "factory",
            format!("there is no factory '{}'", clip(name)),
        )
        .found(name)
        .expected(json!(self.names()))
        .next("list_factories", json!({}));
        match self.nearest(name).as_slice() {
            [] => d,
            near => d.hint(format!("did you mean {}?", near.join(" or "))),
        }
    }

    /// The names most like a name, best first: by the whole name, and by what is behind the point.
    fn nearest(&self, wanted: &str) -> Vec<&str> {
        let short = |n: &str| n.split_once('.').map_or(n, |(_, s)| s).to_owned();
        let last = short(wanted);
        let shorts: Vec<(String, &str)> = self.names().into_iter().map(|n| (short(n), n)).collect();
        let mut near = name::nearest(wanted, self.names(), 3);
        for s in name::nearest(&last, shorts.iter().map(|(s, _)| s.as_str()), 3) {
            near.extend(shorts.iter().filter(|(x, _)| x == s).map(|(_, n)| *n));
        }
        let mut seen: Vec<&str> = Vec::new();
        for n in near {
            if !seen.contains(&n) {
                seen.push(n);
            }
        }
        seen.truncate(3);
        seen
    }

    /// Evaluates a factory; results are kept, so that the same question costs nothing again.
    ///
    /// # Errors
    /// An unknown factory, or what [`Factory::build`] finds.
    pub fn build(
        &self,
        name: &str,
        params: &Map<String, Value>,
    ) -> Result<Arc<Evaluated>, Vec<Diagnostic>> {
        let factory = self.get(name).map_err(|d| vec![*d])?;
        let checked = factory.check(params)?;
        let key = canonical::to_bytes(&checked)
            .ok()
            .map(|bytes| (factory.name().to_owned(), bytes));
        if let Some(result) = key
            .as_ref()
            .and_then(|key| self.kept().results.get(key).cloned())
        {
            return Ok(result);
        }
        let result = Arc::new(factory.build(&checked)?);
        if let Some(key) = key {
            let mut kept = self.kept();
            // Evaluations cost milliseconds: starting anew is cheaper than knowing which were used last.
            if kept.results.len() >= MOST_KEPT {
                kept.results.clear();
            }
            kept.results.insert(key, Arc::clone(&result));
        }
        Ok(result)
    }

    fn kept(&self) -> std::sync::MutexGuard<'_, Kept> {
        // Nothing leaves the map half changed, so one that a panic left behind is good.
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn read(path: &Path) -> Result<String, String> {
    let size = std::fs::metadata(path)
        .map_err(|e| e.kind().to_string())?
        .len();
    if size > MOST_FILE_BYTES {
        return Err(format!(
            "the file has {size} bytes, more than {MOST_FILE_BYTES}"
        ));
    }
    std::fs::read_to_string(path).map_err(|e| format!("the file cannot be read: {}", e.kind()))
}
