//! The worker process: jobs come in on its private socket, answers go out there, one at a time.
//!
//! It may crash, hang or run out of its limits at any time; the pool on the other side copes.

mod asked;
mod cache;
mod jobs;
mod limits;

use std::io;
use std::os::fd::AsFd;
use std::os::unix::net::UnixStream;
use std::path::PathBuf;

use crate::protocol::{self, Doing, Failure, FailureKind, Message};

/// What a worker is started with.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Address space in MiB.
    pub memory_mb: u64,
    /// Processor time of one job in seconds.
    pub cpu_s: u64,
    /// Folder of the cache of solids.
    pub cache: Option<PathBuf>,
}

/// Serves jobs from the socket that is this process's standard input, until it closes.
///
/// # Errors
/// When the limits cannot be set or the socket breaks.
pub fn run(settings: Settings) -> io::Result<()> {
    limits::set_memory_mb(settings.memory_mb)?;
    let mut socket = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    let mut bench = jobs::Bench::new(settings.cache);
    while let Some((job, _)) = protocol::read(&mut socket)? {
        limits::allow_cpu_s(settings.cpu_s)?;
        let mut last = None;
        let mut lost = None;
        let result = bench.work(&job, &mut |doing: Doing| {
            // An answer that cannot be sent ends the process, but not in the middle of an operation.
            if let Err(e) = protocol::write(&mut socket, &Message::Doing(doing.clone()), &[]) {
                lost.get_or_insert(e);
            }
            last = Some(doing);
        });
        if let Some(e) = lost {
            return Err(e);
        }
        match result {
            Ok((reply, block)) => protocol::write(&mut socket, &Message::Done(reply), &block)?,
            Err(error) => {
                let out_of_memory = error.kind == crate::Kind::OutOfMemory;
                let kind = if out_of_memory {
                    FailureKind::Memory
                } else {
                    FailureKind::Kernel
                };
                let message = if out_of_memory {
                    format!(
                        "it needed more memory than the limit of {} MiB",
                        settings.memory_mb
                    )
                } else {
                    error.message
                };
                let failure = Failure {
                    kind,
                    doing: last,
                    message,
                };
                protocol::write(&mut socket, &Message::Failed(failure), &[])?;
                if out_of_memory {
                    // What is left of the address space is in pieces: the next job gets a new process.
                    return Ok(());
                }
            }
        }
    }
    Ok(())
}
