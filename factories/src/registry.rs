//! The factories that there are, and what they make.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Arc, LazyLock, Mutex, PoisonError, RwLock};

use assemcad_model::canonical;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name;
use assemcad_model::param::clip;
use assemcad_script::{Evaluated, Evaluator, Factory};
use serde_json::{Map, Value, json};

use crate::admission::{Record, split_version};
use crate::builtin;

/// So many results of evaluations are kept.
const MOST_KEPT: usize = 256;

/// The largest factory file that is read, in bytes; longer ones are refused before they are in memory.
const MOST_FILE_BYTES: u64 = 1 << 20;

/// Factories by name: ours, those of a folder, and those that were admitted, by version.
#[derive(Debug, Default)]
pub struct Registry {
    factories: BTreeMap<String, Arc<Factory>>,
    admitted: RwLock<BTreeMap<String, BTreeMap<u32, Admitted>>>,
    kept: Mutex<Kept>,
}

/// A version of an admitted factory. Its own name holds the version, so that whoever writes a found
/// factory's name down keeps to that version.
#[derive(Debug, Clone)]
pub struct Admitted {
    /// The factory, within the ranges for which it was admitted.
    pub factory: Arc<Factory>,
    /// On what it was admitted.
    pub record: Arc<Record>,
    /// Whether its source is another than the one that was admitted: it has to be looked at again.
    pub edited: bool,
}

/// Results of evaluations by name and canonical parameters.
#[derive(Debug, Default)]
struct Kept {
    results: BTreeMap<(String, Vec<u8>), Arc<Evaluated>>,
    /// How often a factory was taken in or given up: an evaluation that began before is of another time.
    changes: u64,
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
        static BUILTIN: LazyLock<Registry> = LazyLock::new(|| Registry::ours().0);
        &BUILTIN
    }

    /// The built-in factories and those of a folder of `NAMESPACE.NAME.star` files.
    ///
    /// What is at fault is reported and left out; the rest is there. A file cannot take the place of a
    /// built-in factory: two sources under one name would make one specification mean two things.
    #[must_use]
    pub async fn load(extra: Option<&Path>, others: &Evaluator) -> (Self, Vec<Diagnostic>) {
        let (mut registry, mut found) = Self::ours();
        if let Some(folder) = extra {
            for (name, source) in registry.sources_in(folder, &mut found) {
                registry.add(&name, others.parse(&name, &source).await, &mut found);
            }
        }
        (registry, found)
    }

    /// The built-in factories.
    fn ours() -> (Self, Vec<Diagnostic>) {
        let mut registry = Self::default();
        let mut found = Vec::new();
        for (name, source) in builtin::ALL {
            registry.add(name, Factory::parse(name, source), &mut found);
        }
        (registry, found)
    }

    fn add(
        &mut self,
        name: &str,
        parsed: Result<Factory, Vec<Diagnostic>>,
        found: &mut Vec<Diagnostic>,
    ) {
        match parsed {
            Ok(factory) => {
                self.factories.insert(name.to_owned(), Arc::new(factory));
            }
            Err(faults) => found.extend(faults),
        }
    }

    /// The sources of a folder by name.
    fn sources_in(&self, folder: &Path, found: &mut Vec<Diagnostic>) -> Vec<(String, String)> {
        let mut sources = Vec::new();
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
                return sources;
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
                    Ok(source) => sources.push((name, source)),
                    Err(why) => {
                        found.push(Diagnostic::error(Code::FileFailed, place, why));
                    }
                }
            }
        }
        sources
    }

    /// Whether a factory is one of ours: its defaults are made in a moment, which of others nobody knows.
    #[must_use]
    pub fn is_builtin(name: &str) -> bool {
        builtin::ALL.iter().any(|(known, _)| *known == name)
    }

    /// Whether a name is that of a factory that was not admitted: ours, or one of the folder's.
    #[must_use]
    pub fn is_given(&self, name: &str) -> bool {
        self.factories.contains_key(name)
    }

    /// The names of all factories, sorted; of an admitted one, the newest version's.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.all().iter().map(|f| f.name().to_owned()).collect()
    }

    /// The factories, sorted by name; of an admitted one, the newest version.
    #[must_use]
    pub fn all(&self) -> Vec<Arc<Factory>> {
        let admitted = self.admitted.read().unwrap_or_else(PoisonError::into_inner);
        let newest = admitted.values().filter_map(|v| v.last_key_value());
        let mut all: Vec<_> = self.factories.values().map(Arc::clone).collect();
        all.extend(newest.map(|(_, a)| Arc::clone(&a.factory)));
        all.sort_by(|a, b| a.name().cmp(b.name()));
        all
    }

    /// The factory of a name, or of the part of a name behind the point where only one has it:
    /// `rect_plate` for `base_frame.rect_plate`. Of an admitted factory the newest version, where the
    /// name does not say which.
    ///
    /// # Errors
    /// [`Code::FactoryUnknown`] with the nearest names, or with all that the short name could mean.
    pub fn get(&self, name: &str) -> Result<Arc<Factory>, Box<Diagnostic>> {
        if let Some(factory) = self.factories.get(name) {
            return Ok(Arc::clone(factory));
        }
        if let Some(admitted) = self.admitted(name) {
            return Ok(admitted.factory);
        }
        let short = |f: &&Arc<Factory>| {
            let plain = split_version(f.name()).map_or(f.name(), |(plain, _)| plain);
            plain.split_once('.').is_some_and(|(_, s)| s == name)
        };
        let all = self.all();
        let meant: Vec<&Arc<Factory>> = all.iter().filter(short).collect();
        match meant.as_slice() {
            [one] => Ok(Arc::clone(one)),
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

    /// An admitted factory by its name, with a version or without.
    #[must_use]
    pub fn admitted(&self, name: &str) -> Option<Admitted> {
        let all = self.admitted.read().unwrap_or_else(PoisonError::into_inner);
        match split_version(name) {
            Some((plain, version)) => all.get(plain)?.get(&version).cloned(),
            None => all.get(name)?.last_key_value().map(|(_, a)| a.clone()),
        }
    }

    /// The newest factory that was admitted for a request: of the first name that has one. One whose
    /// source was edited since is not what was admitted.
    #[must_use]
    pub fn admitted_for(&self, request_sha256: &str) -> Option<Admitted> {
        let all = self.admitted.read().unwrap_or_else(PoisonError::into_inner);
        let of = |versions: &BTreeMap<u32, Admitted>| {
            let mut newest = versions.values().rev();
            newest
                .find(|a| !a.edited && a.record.request_sha256 == request_sha256)
                .cloned()
        };
        all.values().find_map(of)
    }

    /// Takes an admitted factory in.
    pub fn admit(&self, admitted: Admitted) {
        let mut all = self
            .admitted
            .write()
            .unwrap_or_else(PoisonError::into_inner);
        let versions = all.entry(admitted.record.factory.clone()).or_default();
        versions.insert(admitted.record.version, admitted);
        drop(all);
        self.changed();
    }

    /// Gives up an admitted factory by its name with the version: it is not there any more.
    pub fn dismiss(&self, name: &str) {
        let Some((plain, version)) = split_version(name) else {
            return;
        };
        let mut all = self
            .admitted
            .write()
            .unwrap_or_else(PoisonError::into_inner);
        if let Some(versions) = all.get_mut(plain) {
            versions.remove(&version);
        }
        all.retain(|_, versions| !versions.is_empty());
        drop(all);
        self.changed();
    }

    /// What was evaluated of another source under a name is no longer true.
    fn changed(&self) {
        let mut kept = self.kept();
        kept.changes += 1;
        kept.results.clear();
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
    fn nearest(&self, wanted: &str) -> Vec<String> {
        let short = |n: &str| n.split_once('.').map_or(n, |(_, s)| s).to_owned();
        let last = short(wanted);
        let names = self.names();
        let shorts: Vec<(String, &String)> = names.iter().map(|n| (short(n), n)).collect();
        let whole = name::nearest(wanted, names.iter().map(String::as_str), 3);
        let mut near: Vec<String> = whole.into_iter().map(str::to_owned).collect();
        for s in name::nearest(&last, shorts.iter().map(|(s, _)| s.as_str()), 3) {
            near.extend(
                shorts
                    .iter()
                    .filter(|(x, _)| x == s)
                    .map(|(_, n)| (*n).clone()),
            );
        }
        let mut seen: Vec<String> = Vec::new();
        for n in near {
            if !seen.contains(&n) {
                seen.push(n);
            }
        }
        seen.truncate(3);
        seen
    }

    /// Evaluates a factory; results are kept, so that the same question costs nothing again. Sources that
    /// are not ours are evaluated by `others`.
    ///
    /// # Errors
    /// An unknown factory, or what [`Factory::build`] finds.
    pub async fn build(
        &self,
        others: &Evaluator,
        name: &str,
        params: &Map<String, Value>,
    ) -> Result<Arc<Evaluated>, Vec<Diagnostic>> {
        // Read before the factory is: what changes behind this is noticed.
        let changes = self.kept().changes;
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
        let result = Arc::new(if Self::is_builtin(factory.name()) {
            factory.build(&checked)?
        } else {
            others.build(&factory, &checked).await?
        });
        if let Some(key) = key {
            let mut kept = self.kept();
            if kept.changes != changes {
                return Ok(result);
            }
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
