//! The door: a question, its answer, and what is remembered between.

use std::any::Any;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use assemcad_kernel::pool::Pool;
use assemcad_kernel::protocol::{Failure, FailureKind, Job, Reply};
use moka::future::Cache;
use sha2::{Digest, Sha256};
use tokio::sync::Semaphore;

use crate::gate::{Gate, Urgency};
use crate::kept;

/// Something that is asked of solids.
///
/// What is asked is plain data; the answer depends on it and on the kernel alone, so that it can be remembered.
pub trait Question: Send + Sync {
    /// What is answered.
    type Answer: Clone + Send + Sync + 'static;

    /// The name of this kind of question, in every key.
    const KIND: &'static str;

    /// Everything that the answer depends on, beside the kind and the kernel.
    fn key(&self, into: &mut Key);

    /// About how many bytes an answer takes.
    fn bytes(answer: &Self::Answer) -> usize {
        size_of_val(answer) + 200
    }

    /// Whether the answer to this question is kept on disk, too.
    fn is_kept(&self) -> bool {
        false
    }

    /// An answer as bytes; none where it cannot be kept.
    fn to_bytes(_answer: &Self::Answer) -> Option<Vec<u8>> {
        None
    }

    /// An answer from such bytes; none where they are none.
    fn from_bytes(_bytes: &[u8]) -> Option<Self::Answer> {
        None
    }

    /// Finds the answer.
    fn answer(
        &self,
        door: &Asker<'_>,
    ) -> impl Future<Output = Result<Self::Answer, Failure>> + Send;
}

/// What a question's key is made of.
#[derive(Debug)]
pub struct Key(Sha256);

impl Key {
    fn of<Q: Question>(question: &Q) -> [u8; 32] {
        let mut key = Self(Sha256::new());
        key.text(Q::KIND);
        question.key(&mut key);
        key.0.finalize().into()
    }

    /// A text, led by its length.
    pub fn text(&mut self, text: &str) {
        self.0.update((text.len() as u64).to_le_bytes());
        self.0.update(text);
    }

    /// Numbers, by their bits; 0 has one sign.
    pub fn numbers(&mut self, numbers: impl IntoIterator<Item = f64>) {
        for n in numbers {
            self.0.update((n + 0.0).to_bits().to_le_bytes());
        }
    }

    /// Anything that has a canonical form in JSON.
    pub fn json<T: serde::Serialize>(&mut self, value: &T) {
        self.text(&serde_json::to_string(value).unwrap_or_default());
    }
}

/// What was asked and what it cost, since the server started.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// Questions asked.
    pub asked: u64,
    /// Of these, answers that were found out anew.
    pub computed: u64,
    /// Of these, answers that stood on disk.
    pub recalled: u64,
    /// Jobs that kernel processes were given.
    pub kernel_calls: u64,
    /// Questions that were not answered.
    pub failed: u64,
}

/// How the door is opened.
#[derive(Debug, Clone)]
pub struct Terms {
    /// How many bytes of answers are remembered in memory.
    pub memory_bytes: u64,
    /// Where answers are kept on disk; nowhere where nothing is said.
    pub disk: Option<OnDisk>,
}

/// How answers are kept on disk.
#[derive(Debug, Clone)]
pub struct OnDisk {
    /// The root folder: they stand in `.assemcad/cache` below it, beside the solids.
    pub root: PathBuf,
    /// How many bytes answers and solids together may take. It is looked after from time to time: what was written
    /// in between comes on top.
    pub bytes: u64,
}

impl Default for Terms {
    fn default() -> Self {
        Self {
            memory_bytes: 256 << 20,
            disk: None,
        }
    }
}

/// An answer of any kind, and about how many bytes it takes.
#[derive(Clone)]
struct Kept {
    answer: Arc<dyn Any + Send + Sync>,
    bytes: u32,
}

/// The one door to geometry.
#[derive(Debug)]
pub struct Door {
    pool: Pool,
    gate: Gate,
    /// Threads for what is found out here, without the kernel.
    threads: Semaphore,
    kept: Cache<[u8; 32], Kept>,
    disk: Option<kept::Kept>,
    asked: AtomicU64,
    computed: AtomicU64,
    recalled: AtomicU64,
    kernel_calls: AtomicU64,
    failed: AtomicU64,
}

impl Door {
    /// A door to the kernel behind some workers.
    #[must_use]
    pub fn new(pool: Pool, terms: &Terms) -> Self {
        let cores = std::thread::available_parallelism().map_or(2, usize::from);
        let kept = Cache::builder()
            .max_capacity(terms.memory_bytes)
            .weigher(|_, kept: &Kept| kept.bytes)
            .build();
        Self {
            gate: Gate::new(pool.size()),
            pool,
            threads: Semaphore::new(cores),
            kept,
            disk: terms.disk.as_ref().and_then(kept::Kept::open),
            asked: AtomicU64::new(0),
            computed: AtomicU64::new(0),
            recalled: AtomicU64::new(0),
            kernel_calls: AtomicU64::new(0),
            failed: AtomicU64::new(0),
        }
    }

    /// What was asked so far.
    #[must_use]
    pub fn counts(&self) -> Counts {
        let of = |n: &AtomicU64| n.load(Ordering::Relaxed);
        Counts {
            asked: of(&self.asked),
            computed: of(&self.computed),
            recalled: of(&self.recalled),
            kernel_calls: of(&self.kernel_calls),
            failed: of(&self.failed),
        }
    }

    /// Asks in the order of arrival.
    #[must_use]
    pub fn asker(&self) -> Asker<'_> {
        Asker {
            door: self,
            urgency: Urgency::Usual,
        }
    }

    /// Asks before what is asked in the order of arrival: somebody waits for a short answer.
    #[must_use]
    pub fn urgent(&self) -> Asker<'_> {
        Asker {
            door: self,
            urgency: Urgency::First,
        }
    }
}

/// Who asks.
#[derive(Debug, Clone, Copy)]
pub struct Asker<'a> {
    door: &'a Door,
    urgency: Urgency,
}

impl Asker<'_> {
    /// How many kernel processes there are.
    #[must_use]
    pub fn processes(&self) -> usize {
        self.door.pool.size()
    }

    /// The answer to a question: remembered, in memory or on disk, or found out once for all who ask at the same
    /// time. A failure is not remembered.
    ///
    /// # Errors
    /// Why there is no answer.
    pub async fn ask<Q: Question>(&self, question: &Q) -> Result<Q::Answer, Failure> {
        let door = self.door;
        door.asked.fetch_add(1, Ordering::Relaxed);
        let key = Key::of(question);
        let find = async {
            let answer = match self.recall(question, key).await {
                Some(answer) => answer,
                None => self.find(question, key).await?,
            };
            let bytes = u32::try_from(Q::bytes(&answer)).unwrap_or(u32::MAX);
            Ok(Kept {
                answer: Arc::new(answer),
                bytes,
            })
        };
        let kept = door
            .kept
            .try_get_with(key, find)
            .await
            .map_err(|failure: Arc<Failure>| {
                door.failed.fetch_add(1, Ordering::Relaxed);
                (*failure).clone()
            })?;
        match kept.answer.downcast_ref::<Q::Answer>() {
            Some(answer) => Ok(answer.clone()),
            None => Err(nonsense()),
        }
    }

    /// The answer on disk, where there is one.
    async fn recall<Q: Question>(&self, question: &Q, key: [u8; 32]) -> Option<Q::Answer> {
        let disk = self.door.disk.as_ref().filter(|_| question.is_kept())?;
        let (answers, of) = (disk.answers(), Q::from_bytes as fn(&[u8]) -> _);
        let found = self.work(move || kept::read(&answers, key, of)).await;
        let answer = found.ok().flatten()?;
        self.door.recalled.fetch_add(1, Ordering::Relaxed);
        Some(answer)
    }

    /// Finds an answer out, and has it kept.
    async fn find<Q: Question>(&self, question: &Q, key: [u8; 32]) -> Result<Q::Answer, Failure> {
        self.door.computed.fetch_add(1, Ordering::Relaxed);
        let answer = question.answer(self).await?;
        if let Some(disk) = self.door.disk.as_ref().filter(|_| question.is_kept()) {
            disk.write(key, answer.clone(), Q::to_bytes);
        }
        Ok(answer)
    }

    /// Has a job done by a kernel process. Where that was lost, or ran out of memory, which it may have been short of
    /// from earlier jobs, the job is tried once more by a process that did nothing before.
    pub(crate) async fn kernel(&self, job: &Job) -> Result<(Reply, Vec<u8>), Failure> {
        let first = match self.once(&job.without_recipes()).await {
            Ok((Reply::Unknown, _)) => self.once(job).await,
            done => done,
        };
        match first {
            Err(failure) if worth_another_try(&failure) => {
                tracing::warn!("{}: tried once more", failure.message);
                self.fresh(job).await
            }
            done => done,
        }
    }

    async fn once(&self, job: &Job) -> Result<(Reply, Vec<u8>), Failure> {
        let _turn = self.door.gate.turn(self.urgency).await;
        self.door.kernel_calls.fetch_add(1, Ordering::Relaxed);
        self.door.pool.run(job).await
    }

    /// Has a job done by a process that did nothing before.
    pub(crate) async fn fresh(&self, job: &Job) -> Result<(Reply, Vec<u8>), Failure> {
        let _turn = self.door.gate.turn(self.urgency).await;
        self.door.kernel_calls.fetch_add(1, Ordering::Relaxed);
        self.door.pool.run_fresh(job).await
    }

    /// Works something out on a thread of its own, as many at a time as there are cores.
    pub(crate) async fn work<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> T + Send + 'static,
    ) -> Result<T, Failure> {
        let _permit = self.door.threads.acquire().await;
        let done = tokio::task::spawn_blocking(work).await;
        done.map_err(|_| failed("a thread of the server was lost"))
    }
}

/// Whether the same job may go well in another process.
fn worth_another_try(failure: &Failure) -> bool {
    matches!(
        failure.kind,
        FailureKind::Crash | FailureKind::Memory | FailureKind::Worker
    )
}

/// A worker's answer to another question.
pub(crate) fn nonsense() -> Failure {
    failed("the worker answered another question")
}

pub(crate) fn failed(message: &str) -> Failure {
    Failure {
        kind: FailureKind::Worker,
        doing: None,
        message: message.to_owned(),
    }
}

impl core::fmt::Debug for Kept {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "Kept({} bytes)", self.bytes)
    }
}
