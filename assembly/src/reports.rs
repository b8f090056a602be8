//! Reports that were made already.
//!
//! A report is a fold over answers: the same specification, with parts that are made of the same recipes, has the
//! same report under the same terms. One is kept only where every question was answered: what a lost process left
//! open is asked again.

use std::num::NonZeroUsize;
use std::sync::{Arc, Mutex, PoisonError};

use assemcad_model::canonical::sha256;
use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::report::Report;
use assemcad_model::spec::Assembly;
use assemcad_placing::Resolved;
use assemcad_verify::Terms;
use lru::LruCache;

/// So many reports are kept.
const MOST: NonZeroUsize = NonZeroUsize::new(16).unwrap();

/// Reports by what they depend on.
#[derive(Debug)]
pub(crate) struct Reports(Mutex<LruCache<String, Arc<Report>>>);

impl Default for Reports {
    fn default() -> Self {
        Self(Mutex::new(LruCache::new(MOST)))
    }
}

impl Reports {
    /// The name of a report: of all that it depends on.
    pub(crate) fn key(
        spec: &Assembly,
        resolved: &Resolved,
        terms: &Terms,
    ) -> Result<String, Diagnostic> {
        let mut text = format!("{}\n{terms:?}\n", spec.sha256()?);
        for part in &resolved.parts {
            for word in [&part.factory, part.made.solid.hash()] {
                text.push_str(word);
                text.push('\n');
            }
        }
        Ok(sha256(text.as_bytes()))
    }

    pub(crate) fn get(&self, key: &str) -> Option<Report> {
        let mut reports = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        reports.get(key).map(|report| Report::clone(report))
    }

    pub(crate) fn put(&self, key: String, report: &Report) {
        let mut reports = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        reports.put(key, Arc::new(report.clone()));
    }
}
