//! Parts that were made already, by the hash of their recipe.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use assemcad_placing::Made;

/// So many made parts are remembered.
const MOST: usize = 1024;

/// Made parts by the hash of their recipe.
#[derive(Debug, Default)]
pub(crate) struct Remembered {
    parts: Mutex<BTreeMap<String, Arc<Made>>>,
}

impl Remembered {
    pub(crate) fn get(&self, hash: &str) -> Option<Arc<Made>> {
        let parts = self.parts.lock().unwrap_or_else(PoisonError::into_inner);
        parts.get(hash).cloned()
    }

    pub(crate) fn put(&self, hash: String, made: Arc<Made>) {
        let mut parts = self.parts.lock().unwrap_or_else(PoisonError::into_inner);
        // The workers keep the solids: starting anew is cheaper than knowing which were used last.
        if parts.len() >= MOST {
            parts.clear();
        }
        parts.insert(hash, made);
    }
}
