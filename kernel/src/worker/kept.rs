//! Solids that were made before: in memory, and on disk by the hash of their recipe.

use std::num::NonZeroUsize;
use std::sync::Arc;

use assemcad_cache::{Cache, Folder};
use lru::LruCache;

/// How many solids a worker keeps in memory.
const IN_MEMORY: NonZeroUsize = NonZeroUsize::new(128).unwrap();

/// The solids on disk that this version of the kernel made.
#[must_use]
pub fn solids(folder: Arc<Folder>) -> Cache {
    Cache::new(folder, "solid", &crate::fingerprint())
}

/// Solids in memory, the least recently used forgotten first.
pub(super) fn in_memory<T>() -> LruCache<String, T> {
    LruCache::new(IN_MEMORY)
}
