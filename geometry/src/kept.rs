//! Answers on disk, so that a server that is started again knows what was found out before it.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::{Duration, Instant};

use assemcad_cache::{Cache, Entry, Folder};
use assemcad_kernel::worker;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::door::OnDisk;

/// What answers depend on beside the kernel: the sources of this crate and of what it computes with.
const SOURCES: &str = env!("ASSEMCAD_GEOMETRY_SOURCES");

/// How often it is looked whether there is too much, while there is something to be written.
const LOOKED_AFTER: Duration = Duration::from_secs(60);

/// So many answers wait to be written. Where the disk cannot follow, further ones are not kept.
const WAITING: usize = 4096;

/// How long the end of the door waits for what is still to be written.
const PATIENCE: Duration = Duration::from_secs(2);

/// An answer that waits to be written.
struct Waiting {
    key: String,
    bytes: Box<dyn FnOnce() -> Option<Vec<u8>> + Send>,
}

/// The answers on disk. They are written by a thread that nobody waits for.
#[derive(Debug)]
pub(crate) struct Kept {
    answers: Arc<Cache>,
    queue: Option<SyncSender<Waiting>>,
    /// Closed when all is written.
    done: std::sync::Mutex<Receiver<()>>,
}

impl Kept {
    /// Opens the answers below a root; none where they cannot be kept there, which the log says.
    pub(crate) fn open(terms: &OnDisk) -> Option<Self> {
        let open = || {
            let folder = Arc::new(Folder::open(&terms.root)?);
            let maker = format!("{}/{SOURCES}", assemcad_kernel::fingerprint());
            let answers = Arc::new(Cache::new(Arc::clone(&folder), "answer", &maker));
            let (queue, waiting) = sync_channel(WAITING);
            let (ends, done) = sync_channel(0);
            let (own, solids, most) = (Arc::clone(&answers), worker::solids(folder), terms.bytes);
            let write = move || {
                let _ends: SyncSender<()> = ends;
                write(&own, &solids, most, &waiting);
            };
            let thread = std::thread::Builder::new().name("answers".to_owned());
            thread.spawn(write)?;
            Ok::<_, std::io::Error>(Self {
                answers,
                queue: Some(queue),
                done: std::sync::Mutex::new(done),
            })
        };
        match open() {
            Ok(kept) => Some(kept),
            Err(e) => {
                tracing::warn!("solids and answers cannot be kept on disk: {e}");
                None
            }
        }
    }

    /// What answers are read from.
    pub(crate) fn answers(&self) -> Arc<Cache> {
        Arc::clone(&self.answers)
    }

    /// Has an answer written some time soon, as the bytes that are then made of it.
    pub(crate) fn write<A: Send + 'static>(
        &self,
        key: [u8; 32],
        answer: A,
        bytes: fn(&A) -> Option<Vec<u8>>,
    ) {
        let waiting = Waiting {
            key: hex::encode(key),
            bytes: Box::new(move || bytes(&answer)),
        };
        if let Some(queue) = &self.queue
            && queue.try_send(waiting).is_err()
        {
            tracing::debug!("the disk is too slow for the answers: one is not kept");
        }
    }
}

impl Drop for Kept {
    fn drop(&mut self) {
        // No more comes: the thread ends behind what is there.
        self.queue = None;
        if let Ok(done) = self.done.get_mut() {
            let _ = done.recv_timeout(PATIENCE);
        }
    }
}

/// Writes what comes, and holds the limit for all kinds together.
fn write(answers: &Cache, solids: &Cache, most: u64, waiting: &Receiver<Waiting>) {
    let tidy = || {
        for cache in [solids, answers] {
            match cache.tidy(most) {
                Ok(left) => tracing::debug!("kept on disk: {left:?}"),
                Err(e) => tracing::warn!("what is kept on disk could not be looked through: {e}"),
            }
        }
        Instant::now()
    };
    let mut looked = tidy();
    while let Ok(next) = waiting.recv() {
        if let Some(bytes) = (next.bytes)() {
            answers.put(&next.key, &bytes);
        }
        if looked.elapsed() > LOOKED_AFTER {
            looked = tidy();
        }
    }
}

/// The value of a key, where one is there and whole, as what is made of its bytes.
pub(crate) fn read<A>(answers: &Cache, key: [u8; 32], answer: fn(&[u8]) -> Option<A>) -> Option<A> {
    match answers.get(&hex::encode(key)) {
        Entry::Sound(bytes) => answer(&bytes),
        Entry::Missing | Entry::Damaged => None,
    }
}

/// An answer as JSON, the form in which it came from the kernel's process. One that would not come back the same is
/// not kept: JSON has no word for a number that is not finite.
pub(crate) fn to_json<A: Serialize + DeserializeOwned + PartialEq>(answer: &A) -> Option<Vec<u8>> {
    let bytes = serde_json::to_vec(answer).ok()?;
    (from_json::<A>(&bytes)? == *answer).then_some(bytes)
}

/// An answer from JSON.
pub(crate) fn from_json<A: DeserializeOwned>(bytes: &[u8]) -> Option<A> {
    serde_json::from_slice(bytes).ok()
}

/// Says in a question that its answers are kept on disk, as JSON.
macro_rules! kept_as_json {
    () => {
        fn is_kept(&self) -> bool {
            true
        }

        fn to_bytes(answer: &Self::Answer) -> Option<Vec<u8>> {
            $crate::kept::to_json(answer)
        }

        fn from_bytes(bytes: &[u8]) -> Option<Self::Answer> {
            $crate::kept::from_json(bytes)
        }
    };
}
pub(crate) use kept_as_json;

#[cfg(test)]
mod tests {
    use super::{from_json, to_json};
    use assemcad_kernel::asked::Measured;

    #[test]
    fn an_answer_comes_back_to_the_last_bit_or_is_not_kept() {
        let mut of = Measured {
            volume: Some(0.1 + 0.2),
            area: 1e-320,
            centre: [f64::MIN_POSITIVE, -0.0, 1.0 / 3.0],
            min: [f64::MAX, -1.0, 2.5e-17],
            max: [0.0; 3],
            faces: Vec::new(),
        };
        let back: Measured = from_json(&to_json(&of).unwrap()).unwrap();
        assert_eq!(back, of);
        assert_eq!(back.centre.map(f64::to_bits), of.centre.map(f64::to_bits));
        // JSON would make none of it.
        of.volume = Some(f64::NAN);
        assert_eq!(to_json(&of), None);
        of.volume = None;
        of.area = f64::INFINITY;
        assert_eq!(to_json(&of), None);
    }
}
