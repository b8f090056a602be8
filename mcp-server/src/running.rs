//! How many calls are running.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The calls that are running.
#[derive(Debug, Clone, Default)]
pub(crate) struct Running(Arc<AtomicUsize>);

/// A running call, until dropped.
#[derive(Debug)]
pub(crate) struct Call(Running);

impl Running {
    /// Counts a call until the answer is dropped.
    pub(crate) fn start(&self) -> Call {
        self.0.fetch_add(1, Ordering::SeqCst);
        Call(self.clone())
    }

    /// Whether none is running.
    pub(crate) fn none(&self) -> bool {
        self.0.load(Ordering::SeqCst) == 0
    }
}

impl Drop for Call {
    fn drop(&mut self) {
        self.0.0.fetch_sub(1, Ordering::SeqCst);
    }
}
