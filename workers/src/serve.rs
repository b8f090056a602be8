//! The worker process: jobs come in on its private socket, answers go out there, one at a time.
//!
//! It may crash, hang or run out of its limits at any time; the pool on the other side copes.

use std::io;
use std::os::fd::AsFd;
use std::os::unix::net::UnixStream;

use rustix::event::{PollFd, PollFlags, poll};

use crate::Work;
use crate::limits::{self, Limits};
use crate::protocol::{self, Doing, Failure, FailureKind, Message};
use crate::seclude::{Keeps, seclude};

/// What is seen of a socket whose other end is closed.
#[cfg(target_os = "linux")]
const GONE: PollFlags = PollFlags::RDHUP;
#[cfg(not(target_os = "linux"))]
const GONE: PollFlags = PollFlags::HUP;

/// The stack of a thread that waits, in bytes.
const WATCH_STACK: usize = 128 << 10;

/// Says what is about to be done.
pub type Tell<'a> = &'a mut dyn FnMut(Doing);

/// Why a job is not done.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// The work itself cannot be done, with the reason in one sentence.
    Refused(String),
    /// There is not enough memory. The process ends behind it: what is left of its address space is in
    /// pieces.
    OutOfMemory,
}

/// Who does the jobs in a worker process.
pub trait Handler<W: Work> {
    /// Does one job; gives the reply and a block of bytes that goes with it.
    ///
    /// # Errors
    /// Why it is not done.
    fn work(&mut self, job: &W::Job, tell: Tell<'_>) -> Result<(W::Reply, Vec<u8>), Refusal>;

    /// Whether this process can do another job. One that cannot ends, and the pool starts another.
    fn is_fit(&self) -> bool {
        true
    }
}

/// Serves jobs from the socket that is this process's standard input, until it closes.
///
/// Of the limits, memory and processor time are set here; elapsed time is the pool's matter. The process keeps what
/// it is told to keep, and nothing else ([`Keeps`]). It ends when the socket closes, even in the middle of a job:
/// nobody waits for the answer.
///
/// # Errors
/// When the limits cannot be set or the socket breaks.
pub fn serve<W: Work>(
    limits: Limits,
    keeps: &Keeps,
    mut handler: impl Handler<W>,
) -> io::Result<()> {
    limits::set_memory_mb(limits.memory_mb)?;
    let mut socket = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    seclude(keeps)?;
    end_with_the_server()?;
    while let Some((job, _)) = protocol::read::<W::Job>(&mut socket)? {
        limits::allow_cpu_s(limits.cpu_s)?;
        let mut last = None;
        let mut lost = None;
        let mut tell = |doing: Doing| {
            let message = Message::<W::Reply>::Doing(doing.clone());
            // An answer that cannot be sent ends the process, but not in the middle of an operation.
            if let Err(e) = protocol::write(&mut socket, &message, &[]) {
                lost.get_or_insert(e);
            }
            last = Some(doing);
        };
        // Said at once: from now on the job counts as started.
        tell(Doing {
            operation: W::name(&job).to_owned(),
            step: None,
            recipe: None,
        });
        let result = handler.work(&job, &mut tell);
        if let Some(e) = lost {
            return Err(e);
        }
        let out_of_memory = matches!(result, Err(Refusal::OutOfMemory));
        let (message, block) = match result {
            Ok((reply, block)) => (Message::Done(reply), block),
            Err(refusal) => (Message::Failed(failure(refusal, last, limits)), Vec::new()),
        };
        protocol::write(&mut socket, &message, &block)?;
        if out_of_memory || !handler.is_fit() {
            return Ok(());
        }
    }
    Ok(())
}

/// Ends this process when nobody is at the other end of standard input any more.
fn end_with_the_server() -> io::Result<()> {
    let watch = || {
        let input = io::stdin();
        loop {
            let mut asked = [PollFd::new(&input, GONE)];
            match poll(&mut asked, None) {
                Ok(_) => std::process::exit(0),
                Err(rustix::io::Errno::INTR) => {}
                // The job goes on without being watched, as far as its limits let it.
                Err(_) => return,
            }
        }
    };
    let thread = std::thread::Builder::new().name("watch".to_owned());
    thread.stack_size(WATCH_STACK).spawn(watch).map(drop)
}

fn failure(refusal: Refusal, doing: Option<Doing>, limits: Limits) -> Failure {
    let (kind, message) = match refusal {
        Refusal::Refused(message) => (FailureKind::Refused, message),
        Refusal::OutOfMemory => (FailureKind::Memory, limits.memory_exceeded()),
    };
    Failure {
        kind,
        doing,
        message,
    }
}
