//! The calls that are running: how many, how many of the heavy ones at once, and their end.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use assemcad_tools::Weight;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, watch};

/// So many calls may be under way, those that wait for their turn among them: what waits holds its arguments.
const MOST_WAITING: usize = 256;

/// So many calls that ask for a little work run at once.
const MOST_USUAL: usize = 32;

/// The calls that are running.
#[derive(Debug, Clone)]
pub(crate) struct Running(Arc<Inner>);

#[derive(Debug)]
struct Inner {
    calls: AtomicUsize,
    heavy: Arc<Semaphore>,
    usual: Arc<Semaphore>,
    stop: watch::Sender<bool>,
}

/// A running call, until dropped.
#[derive(Debug)]
pub(crate) struct Call(Running);

impl Running {
    /// None yet; `heavy` is how many of the heavy ones run at once.
    pub(crate) fn new(heavy: usize) -> Self {
        Self(Arc::new(Inner {
            calls: AtomicUsize::new(0),
            heavy: Arc::new(Semaphore::new(heavy.max(1))),
            usual: Arc::new(Semaphore::new(MOST_USUAL)),
            stop: watch::Sender::new(false),
        }))
    }

    /// Counts a call until the answer is dropped; none where there are too many already.
    pub(crate) fn start(&self) -> Option<Call> {
        let before = self.0.calls.fetch_add(1, Ordering::SeqCst);
        // Dropped where it is not given, which takes it off again.
        let call = Call(self.clone());
        (before < MOST_WAITING).then_some(call)
    }

    /// Whether none is running.
    pub(crate) fn none(&self) -> bool {
        self.0.calls.load(Ordering::SeqCst) == 0
    }

    /// Waits for the turn of a call of some weight, and holds it until dropped.
    pub(crate) async fn turn(&self, weight: Weight) -> Option<OwnedSemaphorePermit> {
        let turns = match weight {
            Weight::Light => return None,
            Weight::Usual => &self.0.usual,
            Weight::Heavy => &self.0.heavy,
        };
        // Never closed; were it, there would be no limit, and no call would be lost.
        Arc::clone(turns).acquire_owned().await.ok()
    }

    /// Ends all calls: nobody reads their answers any more.
    pub(crate) fn stop(&self) {
        self.0.stop.send_replace(true);
    }

    /// Comes back when all calls are to end.
    pub(crate) async fn stopped(&self) {
        let mut stop = self.0.stop.subscribe();
        // The sender lives as long as this does.
        let _ = stop.wait_for(|stop| *stop).await;
    }
}

impl Drop for Call {
    fn drop(&mut self) {
        self.0.0.calls.fetch_sub(1, Ordering::SeqCst);
    }
}

#[cfg(test)]
mod tests {
    use super::{MOST_WAITING, Running};
    use assemcad_tools::Weight;
    use std::time::Duration;

    #[tokio::test(start_paused = true)]
    async fn heavy_calls_take_turns_and_light_ones_do_not_wait() {
        let running = Running::new(1);
        let first = running.turn(Weight::Heavy).await;
        assert!(first.is_some());
        let wait = Duration::from_secs(1);
        let second = running.turn(Weight::Heavy);
        assert!(tokio::time::timeout(wait, second).await.is_err());
        assert!(running.turn(Weight::Usual).await.is_some());
        assert!(running.turn(Weight::Light).await.is_none());
        drop(first);
        assert!(running.turn(Weight::Heavy).await.is_some());
    }

    #[test]
    fn there_is_an_end_to_what_waits() {
        let running = Running::new(1);
        let calls: Vec<_> = (0..MOST_WAITING).map(|_| running.start()).collect();
        assert!(calls.iter().all(Option::is_some));
        assert!(running.start().is_none());
        drop(calls);
        assert!(running.none() && running.start().is_some());
    }
}
