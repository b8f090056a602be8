//! Evaluations run in threads of their own, with a stack of known size and a time after which nobody
//! waits any longer.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};

use crate::fault::{Fault, too_long};
use crate::limits::Limits;

/// Evaluations that were left behind and have not ended yet.
static LEFT_BEHIND: AtomicUsize = AtomicUsize::new(0);

/// More than so many are not left behind: each may still hold a processor.
const MOST_LEFT_BEHIND: usize = 4;

/// Whether an evaluation did not find the memory for its thread.
static NO_THREAD: AtomicBool = AtomicBool::new(false);

/// Whether this process is as good as new: nothing was left behind in it, and threads can be started.
pub(crate) fn is_fit() -> bool {
    LEFT_BEHIND.load(Ordering::SeqCst) == 0 && !NO_THREAD.load(Ordering::SeqCst)
}

/// Runs `work` in a thread of its own and gives what it gives.
///
/// `work` is handed a flag that is raised when nobody waits any longer. A thread cannot be ended from
/// outside; one that sits in a single long operation of the interpreter is left behind, and while
/// several such are alive no new one is started.
pub(crate) fn run<T: Send + 'static>(
    limits: &Limits,
    work: impl FnOnce(Arc<AtomicBool>) -> T + Send + 'static,
) -> Result<T, Fault> {
    if LEFT_BEHIND.load(Ordering::SeqCst) >= MOST_LEFT_BEHIND {
        return Err(Fault::new("earlier evaluations have not ended yet")
            .hint("wait until they have, or restart the server"));
    }
    let (send, receive) = mpsc::channel();
    let cancelled = Arc::new(AtomicBool::new(false));
    let ended = Arc::new(AtomicBool::new(false));
    let (flag, end) = (Arc::clone(&cancelled), Arc::clone(&ended));
    let thread = std::thread::Builder::new()
        .name("script".to_owned())
        .stack_size(limits.stack_bytes)
        .spawn(move || {
            // A fault of the interpreter unwinds to here; the count below must be settled all the same.
            let result = catch_unwind(AssertUnwindSafe(|| work(Arc::clone(&flag)))).ok();
            // Whoever comes second, this thread or the one that gave up waiting, settles the count.
            if end.swap(true, Ordering::SeqCst) {
                LEFT_BEHIND.fetch_sub(1, Ordering::SeqCst);
            }
            // Nobody may be listening any more, and then there is nobody to tell.
            drop(send.send(result));
        })
        .map_err(|e| {
            NO_THREAD.store(true, Ordering::SeqCst);
            Fault::new(format!(
                "no thread could be started for the evaluation: {e}"
            ))
        })?;
    match receive.recv_timeout(limits.time.saturating_mul(2)) {
        Ok(Some(result)) => {
            // Its stack is free again when the next evaluation asks for one.
            drop(thread.join());
            Ok(result)
        }
        Err(mpsc::RecvTimeoutError::Timeout) => {
            cancelled.store(true, Ordering::SeqCst);
            LEFT_BEHIND.fetch_add(1, Ordering::SeqCst);
            if ended.swap(true, Ordering::SeqCst) {
                LEFT_BEHIND.fetch_sub(1, Ordering::SeqCst);
            }
            Err(too_long(limits))
        }
        Ok(None) | Err(mpsc::RecvTimeoutError::Disconnected) => Err(Fault::new(
            "the interpreter met a fault of its own in this script",
        )
        .hint("write the script in a simpler way")),
    }
}
