//! The server's side of the workers: as many processes as asked for, each with limits.
//!
//! A worker that dies, hangs or exceeds a limit is replaced; the request that it had answers with a
//! [`Failure`] that says which operation it was, and no other request notices. Time is counted from
//! when a worker gets the job, not from when the job was queued.

use std::collections::VecDeque;
use std::ffi::OsString;
use std::marker::PhantomData;
use std::os::fd::OwnedFd;
use std::os::unix::process::ExitStatusExt;
use std::path::PathBuf;
use std::process::{ExitStatus, Stdio};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use tokio::io::{AsyncBufReadExt, AsyncReadExt, AsyncWriteExt, BufReader};
use tokio::net::UnixStream;
use tokio::process::{Child, ChildStderr, Command};
use tokio::sync::Semaphore;
use tokio::task::JoinHandle;

use crate::protocol::{self, Doing, Failure, FailureKind, Message};
use crate::{Limits, Work};

/// What a worker keeps of the environment: where the dynamic linker is told to look for libraries, and how much is
/// logged.
const KEPT: [&str; 4] = [
    "ASSEMCAD_LOG",
    "LD_LIBRARY_PATH",
    "DYLD_LIBRARY_PATH",
    "DYLD_FALLBACK_LIBRARY_PATH",
];

/// How a line of the standard library's last words begins when an allocation fails, before it aborts.
const OUT_OF_MEMORY: &str = "memory allocation of ";

/// So many last lines are kept: more may follow the one that says why.
const LAST_LINES: usize = 8;

/// The most that is read of one worker's standard error, in bytes: a log is short.
const LONGEST_LOG: u64 = 1 << 20;

/// How workers are started.
#[derive(Debug, Clone)]
pub struct Config {
    /// The program; it is called as `program SUBCOMMAND --memory-mb N --cpu-s N ARGUMENTS`.
    pub program: PathBuf,
    /// Further arguments.
    pub arguments: Vec<OsString>,
    /// How many workers, at least one.
    pub workers: usize,
    /// What one request may use.
    pub limits: Limits,
}

/// A reply and the block of bytes that came with it.
type Done<W> = (<W as Work>::Reply, Vec<u8>);

/// The worker processes.
#[derive(Debug)]
pub struct Pool<W> {
    config: Config,
    permits: Semaphore,
    idle: Mutex<Vec<Worker>>,
    work: PhantomData<fn(W)>,
}

#[derive(Debug)]
struct Worker {
    // Killed when dropped, so that a request whose caller went away leaves nothing running.
    child: Child,
    socket: UnixStream,
    /// The last lines that it wrote on standard error, where that is listened to.
    last_words: Option<JoinHandle<Vec<String>>>,
}

impl<W: Work> Pool<W> {
    /// A pool; workers are started when there is work for them.
    #[must_use]
    pub fn new(config: impl Into<Config>) -> Self {
        let config = config.into();
        let permits = Semaphore::new(config.workers.max(1));
        Self {
            config,
            permits,
            idle: Mutex::new(Vec::new()),
            work: PhantomData,
        }
    }

    /// The most requests that run at once.
    #[must_use]
    pub fn size(&self) -> usize {
        self.config.workers.max(1)
    }

    /// What one request may use.
    #[must_use]
    pub fn limits(&self) -> Limits {
        self.config.limits
    }

    /// Has a job done by some worker.
    ///
    /// # Errors
    /// [`Failure`], with the operation that was under way where that is known.
    pub async fn run(&self, job: &W::Job) -> Result<Done<W>, Failure> {
        let _permit = self.permit().await?;
        // A worker that died while idle cost nobody anything: the job goes to the next one.
        while let Some(mut worker) = self.pop() {
            match self.work(&mut worker, job).await {
                Outcome::Done(result) => {
                    self.push(worker);
                    return result;
                }
                Outcome::Lost {
                    started: true,
                    failure,
                } => return Err(failure),
                Outcome::Lost { started: false, .. } => {}
            }
        }
        let mut worker = self.start().await?;
        match self.work(&mut worker, job).await {
            Outcome::Done(result) => {
                self.push(worker);
                result
            }
            Outcome::Lost { failure, .. } => Err(failure),
        }
    }

    /// Has a job done by a process that did nothing before and does nothing after.
    ///
    /// The STEP writer numbers instances by a counter of its process: only a fresh process gives
    /// the same numbers every time.
    ///
    /// # Errors
    /// As [`Pool::run`].
    pub async fn run_fresh(&self, job: &W::Job) -> Result<Done<W>, Failure> {
        let _permit = self.permit().await?;
        let mut worker = self.start().await?;
        match self.work(&mut worker, job).await {
            Outcome::Done(result) => result,
            Outcome::Lost { failure, .. } => Err(failure),
        }
    }

    async fn permit(&self) -> Result<tokio::sync::SemaphorePermit<'_>, Failure> {
        self.permits
            .acquire()
            .await
            .map_err(|_| failed(FailureKind::Worker, "the pool is closed"))
    }

    fn pop(&self) -> Option<Worker> {
        self.idle
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .pop()
    }

    fn push(&self, worker: Worker) {
        self.idle
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(worker);
    }

    async fn start(&self) -> Result<Worker, Failure> {
        self.spawn().map_err(|e| {
            failed(
                FailureKind::Worker,
                &format!("a worker could not be started: {e}"),
            )
        })
    }

    fn spawn(&self) -> std::io::Result<Worker> {
        let (ours, theirs) = std::os::unix::net::UnixStream::pair()?;
        ours.set_nonblocking(true)?;
        let limits = self.config.limits;
        let mut command = Command::new(&self.config.program);
        // The program may be named by a path that says nothing in a list of processes.
        command.arg0("assemcad");
        command.arg(W::SUBCOMMAND);
        command.args(["--memory-mb", &limits.memory_mb.to_string()]);
        command.args(["--cpu-s", &limits.cpu_s.to_string()]);
        command.args(&self.config.arguments);
        // The socket is the worker's standard input, in both directions: whatever a library
        // prints on standard output cannot touch it.
        command.stdin(Stdio::from(OwnedFd::from(theirs)));
        command.stdout(Stdio::null()).kill_on_drop(true);
        command.stderr(Stdio::piped()).env_clear();
        command.envs(KEPT.iter().filter_map(|k| Some((k, std::env::var_os(k)?))));
        let mut child = command.spawn()?;
        let last_words = child.stderr.take().map(|said| tokio::spawn(listen(said)));
        Ok(Worker {
            child,
            socket: UnixStream::from_std(ours)?,
            last_words,
        })
    }

    async fn work(&self, worker: &mut Worker, job: &W::Job) -> Outcome<W> {
        let mut doing = None;
        let wall = Duration::from_secs(self.config.limits.wall_s);
        match tokio::time::timeout(wall, converse::<W>(worker, job, &mut doing)).await {
            Ok(Ok(result)) => Outcome::Done(result),
            Ok(Err(error)) => {
                let started = doing.is_some();
                Outcome::Lost {
                    started,
                    failure: self.post_mortem(worker, doing, &error).await,
                }
            }
            Err(_) => {
                // Waits for the process to be gone, so that its memory is free for the next one.
                let _ = worker.child.kill().await;
                let message = format!("it took longer than the limit of {} s", wall.as_secs());
                Outcome::Lost {
                    started: true,
                    failure: Failure {
                        kind: FailureKind::Wall,
                        doing,
                        message,
                    },
                }
            }
        }
    }

    /// Why a worker's socket broke off.
    async fn post_mortem(
        &self,
        worker: &mut Worker,
        doing: Option<Doing>,
        error: &std::io::Error,
    ) -> Failure {
        // The socket closes a moment before the process is reaped; one that lives on is at fault itself.
        let status = tokio::time::timeout(Duration::from_secs(2), worker.child.wait()).await;
        let (kind, message) = match status {
            Ok(Ok(status)) => {
                let said = match &mut worker.last_words {
                    Some(task) => tokio::time::timeout(Duration::from_secs(2), task).await,
                    None => Ok(Ok(Vec::new())),
                };
                let said = said.ok().and_then(Result::ok).unwrap_or_default();
                self.cause_of_death(status, &said)
            }
            _ => {
                let _ = worker.child.kill().await;
                (
                    FailureKind::Worker,
                    format!("the worker could not be understood: {error}"),
                )
            }
        };
        Failure {
            kind,
            doing,
            message,
        }
    }

    fn cause_of_death(&self, status: ExitStatus, said: &[String]) -> (FailureKind, String) {
        use rustix::process::Signal;
        let limits = self.config.limits;
        let aborted = status.signal() == Some(Signal::ABORT.as_raw());
        let no_memory = aborted && said.iter().any(|line| line.starts_with(OUT_OF_MEMORY));
        match status.signal() {
            _ if no_memory => (FailureKind::Memory, limits.memory_exceeded()),
            Some(s) if s == Signal::XCPU.as_raw() => (
                FailureKind::Cpu,
                format!(
                    "it used more processor time than the limit of {} s",
                    limits.cpu_s
                ),
            ),
            Some(s) => (FailureKind::Crash, format!("the worker died of signal {s}")),
            None => (
                FailureKind::Crash,
                format!(
                    "the worker ended with code {}",
                    status.code().unwrap_or_default()
                ),
            ),
        }
    }
}

enum Outcome<W: Work> {
    /// The worker answered, and lives.
    Done(Result<Done<W>, Failure>),
    /// The worker is gone.
    Lost { started: bool, failure: Failure },
}

/// Hands the worker's log on to that of this process and keeps its last lines.
async fn listen(said: ChildStderr) -> Vec<String> {
    let mut lines = BufReader::new(said.take(LONGEST_LOG)).lines();
    let mut last = VecDeque::new();
    while let Ok(Some(line)) = lines.next_line().await {
        tracing::warn!("a worker: {line}");
        last.push_back(line);
        if last.len() > LAST_LINES {
            last.pop_front();
        }
    }
    last.into()
}

async fn converse<W: Work>(
    worker: &mut Worker,
    job: &W::Job,
    doing: &mut Option<Doing>,
) -> std::io::Result<Result<Done<W>, Failure>> {
    worker
        .socket
        .write_all(&protocol::encode(job, &[])?)
        .await?;
    loop {
        let mut head = [0; 8];
        worker.socket.read_exact(&mut head).await?;
        let (header, block) = protocol::lengths(head)?;
        let header = exactly(&mut worker.socket, header).await?;
        let bytes = exactly(&mut worker.socket, block).await?;
        match serde_json::from_slice(&header)? {
            Message::Doing(what) => *doing = Some(what),
            Message::Done(reply) => return Ok(Ok((reply, bytes))),
            Message::Failed(failure) => return Ok(Err(failure)),
        }
    }
}

/// So many bytes, which take memory as they come: a length is a worker's claim.
async fn exactly(socket: &mut UnixStream, length: usize) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    socket.take(length as u64).read_to_end(&mut bytes).await?;
    if bytes.len() < length {
        return Err(std::io::ErrorKind::UnexpectedEof.into());
    }
    Ok(bytes)
}

fn failed(kind: FailureKind, message: &str) -> Failure {
    Failure {
        kind,
        doing: None,
        message: message.to_owned(),
    }
}
