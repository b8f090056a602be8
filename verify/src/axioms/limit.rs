//! Much work on many things: on all processors, up to a limit, until nobody waits for it any more.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// How much may be done.
#[derive(Debug)]
pub(super) struct Limit {
    left: AtomicUsize,
    given_up: Arc<AtomicBool>,
}

/// Ends the work when it is dropped.
#[derive(Debug)]
pub(super) struct Waiting(Arc<AtomicBool>);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Fewer things than this are done one after the other.
const FEW: usize = 32;

impl Limit {
    /// So much work, and who waits for it.
    pub(super) fn new(most: usize) -> (Self, Waiting) {
        let given_up = Arc::new(AtomicBool::new(false));
        let waiting = Waiting(Arc::clone(&given_up));
        let left = AtomicUsize::new(most);
        (Self { left, given_up }, waiting)
    }

    /// Whether nobody waits any more.
    pub(super) fn is_given_up(&self) -> bool {
        self.given_up.load(Ordering::Relaxed)
    }

    /// Takes from what is left; false where that is not enough. Whether the work comes to an end depends on its sum
    /// alone, not on the order in which it is done.
    pub(super) fn take(&self, work: usize) -> bool {
        let less = |left: usize| left.checked_sub(work);
        let taken = self
            .left
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, less);
        if taken.is_err() {
            self.left.store(0, Ordering::Relaxed);
        }
        taken.is_ok()
    }

    /// What comes of each thing, in their order; none where it does not come to an end.
    pub(super) fn each<T: Sync, R: Send>(
        &self,
        things: &[T],
        of: impl Fn(&T) -> Option<R> + Sync,
    ) -> Option<Vec<R>> {
        let of = |thing: &T| {
            if self.is_given_up() {
                return None;
            }
            of(thing)
        };
        if things.len() < FEW {
            return things.iter().map(of).collect();
        }
        let threads = std::thread::available_parallelism().map_or(1, core::num::NonZero::get);
        let next = AtomicUsize::new(0);
        let some = || {
            let mut done = Vec::new();
            loop {
                let at = next.fetch_add(1, Ordering::Relaxed);
                let Some(thing) = things.get(at) else {
                    return Some(done);
                };
                done.push((at, of(thing)?));
            }
        };
        let mut done = Vec::with_capacity(things.len());
        let found: Option<Vec<Vec<(usize, R)>>> = std::thread::scope(|scope| {
            let threads: Vec<_> = (0..threads).map(|_| scope.spawn(some)).collect();
            // One that was lost leaves the question open.
            threads.into_iter().map(|t| t.join().ok()?).collect()
        });
        done.extend(found?.into_iter().flatten());
        done.sort_by_key(|(at, _)| *at);
        Some(done.into_iter().map(|(_, r)| r).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::Limit;

    #[test]
    fn all_is_done_in_order_up_to_the_limit() {
        let things: Vec<usize> = (0..1000).collect();
        let (limit, waiting) = Limit::new(2000);
        let double = |n: &usize| limit.take(1).then_some(2 * n);
        let wanted: Vec<usize> = things.iter().map(|n| 2 * n).collect();
        assert_eq!(limit.each(&things, double), Some(wanted));
        assert!(limit.each(&things, double).is_some());
        assert_eq!(limit.each(&things, double), None);
        // Nor is anything done for nobody.
        let (limit, other) = Limit::new(2000);
        drop(other);
        assert_eq!(limit.each(&[1], |n| Some(*n)), None);
        drop(waiting);
    }
}
