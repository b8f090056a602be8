//! Admitted factories as they are on disk: known at the start, and known again when somebody else, another server or
//! an editor, has written there.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use assemcad_factories::admission::{Manner, Report};
use assemcad_model::canonical::sha256;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_store::Stamp;

use crate::{Faults, Workshop};

/// So many edited sources are remembered with what is wrong with them.
const MOST_JUDGED: usize = 64;

/// What was read of the folder of admitted factories, and what was found of edited ones.
#[derive(Debug, Default)]
pub(crate) struct Admissions {
    /// The state of the files that was read last.
    read: tokio::sync::Mutex<BTreeMap<String, Vec<Stamp>>>,
    judged: Mutex<BTreeMap<String, Arc<Judged>>>,
}

/// What became of an edited source; held while it is being looked at, so that all who ask wait for one answer.
type Judged = tokio::sync::Mutex<Option<Faults>>;

impl Admissions {
    fn of(&self, name: &str, source: &str) -> Arc<Judged> {
        let mut judged = self.judged.lock().unwrap_or_else(PoisonError::into_inner);
        let key = format!("{name}\n{}", sha256(source.as_bytes()));
        if judged.len() >= MOST_JUDGED && !judged.contains_key(&key) {
            judged.clear();
        }
        Arc::clone(judged.entry(key).or_default())
    }
}

impl Workshop {
    /// Reads again what has changed in the folder of admitted factories; cheap where nothing has. What is at fault is
    /// reported and left out.
    pub async fn load_admitted(&self) -> Faults {
        let mut read = self.admissions.read.lock().await;
        let now = match self.store.factory_stamps() {
            Ok(now) => now,
            Err(d) => return vec![d],
        };
        if *read == now {
            return Faults::new();
        }
        let mut found = Faults::new();
        for name in read.keys().filter(|name| !now.contains_key(*name)) {
            self.registry.dismiss(name);
        }
        for (name, _) in now
            .iter()
            .filter(|(name, stamps)| read.get(*name) != Some(stamps))
        {
            let admitted = match self.store.stored_factory(name) {
                Ok(stored) => self.parsed(stored.record, &stored.source).await,
                Err(d) => Err(vec![d]),
            };
            match admitted {
                Ok(admitted) => self.registry.admit(admitted),
                Err(faults) => {
                    // What was there under this name is not there any more.
                    self.registry.dismiss(name);
                    found.extend(faults);
                }
            }
        }
        *read = now;
        found
    }

    /// Looks at a factory again whose source was edited since it was admitted: what passes is admitted as it is now,
    /// under the same version, for that is what the editor meant. A source is looked at once, whatever it comes to
    /// and however many parts are made of it.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub(crate) async fn recheck(&self, name: &str) -> Result<(), Faults> {
        // A name may be short; what is not found is told by whoever asked.
        let Ok(named) = self.registry.get(name) else {
            return Ok(());
        };
        let edited = || self.registry.admitted(named.name()).filter(|a| a.edited);
        let Some(now) = edited() else {
            return Ok(());
        };
        let (record, source) = (&now.record, now.factory.source());
        let judged = self.admissions.of(&record.name(), source);
        let mut judged = judged.lock().await;
        if let Some(faults) = &*judged {
            return Err(faults.clone());
        }
        // Another request may have looked at it while this one waited.
        if edited().is_none_or(|a| a.factory.source() != source) {
            return Ok(());
        }
        let manner = Manner {
            extent: record.evidence.sets,
            narrowed: !record.ranges.is_empty(),
            watch: &|_| {},
        };
        let gate = self.gate();
        let result = gate
            .judge(&record.name(), source, &record.request, manner)
            .await;
        let admission = match result {
            Ok(admission) => admission,
            Err(report) => {
                let lasts = lasts(&report);
                let faults = self.not_any_more(&record.name(), *report);
                if lasts {
                    *judged = Some(faults.clone());
                }
                return Err(faults);
            }
        };
        let _lock = self.store.lock_factories().await.map_err(|d| vec![d])?;
        if self.store.factory_source(&record.name()).ok().as_deref() != Some(source) {
            let place = format!("factory {}", record.name());
            let text = "its source was edited again while it was looked at";
            return Err(vec![
                Diagnostic::error(Code::FactoryFailed, place, text).hint("use it again"),
            ]);
        }
        self.renewed(record, source, admission).await?;
        Ok(())
    }

    fn not_any_more(&self, name: &str, report: Report) -> Faults {
        let place = format!("factory {name}");
        let changed = if report.findings.is_empty() {
            let left = report.tally.not_tried;
            let text = format!(
                "its source was edited since it was admitted, and looking at it again took longer than \
                 the limit of {} s: {left} of {} sets of parameters are left",
                self.synthesis_limit.as_secs(),
                report.tally.sets
            );
            Diagnostic::error(Code::FactoryFailed, place, text).hint(
                "use it again: solids that were made are kept; or start the server with a larger \
                 --synthesis-s",
            )
        } else {
            Diagnostic::error(
                Code::FactoryFailed,
                place,
                "its source was edited since it was admitted, and does not pass the gate any more",
            )
            .hint("mend the file, or give the source to synthesize_factory as a new version")
        };
        let mut all = vec![changed];
        all.extend(report.findings.into_iter().map(|f| f.diagnostic));
        all
    }
}

/// Whether a refusal will be the same the next time: the source is at fault, and no worker was lost by the way.
fn lasts(report: &Report) -> bool {
    let lost = [Code::WorkerCrashed, Code::WorkerFailed];
    let mut codes = report.findings.iter().map(|f| f.diagnostic.code);
    !report.findings.is_empty() && !codes.any(|c| lost.contains(&c))
}
