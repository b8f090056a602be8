//! What a request may use, and the limits that a worker sets on itself.

use std::io;

use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
use rustix::time::{ClockId, clock_gettime};

/// What one request may use.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Address space of a worker in MiB.
    pub memory_mb: u64,
    /// Processor time of a request in seconds.
    pub cpu_s: u64,
    /// Elapsed time of a request in seconds; kept by the pool.
    pub wall_s: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            memory_mb: 4096,
            cpu_s: 60,
            wall_s: 120,
        }
    }
}

impl Limits {
    /// What is said when the limit on memory was reached.
    pub(crate) fn memory_exceeded(self) -> String {
        format!(
            "it needed more memory than the limit of {} MiB",
            self.memory_mb
        )
    }
}

const NOTHING: Rlimit = Rlimit {
    current: Some(0),
    maximum: Some(0),
};

/// Limits the address space of this process, for good, and forbids core files.
///
/// # Errors
/// When the system refuses.
pub(crate) fn set_memory_mb(memory_mb: u64) -> io::Result<()> {
    let bytes = memory_mb.saturating_mul(1 << 20);
    setrlimit(
        Resource::As,
        Rlimit {
            current: Some(bytes),
            maximum: Some(bytes),
        },
    )?;
    setrlimit(Resource::Core, NOTHING)?;
    Ok(())
}

/// Allows this process so many more seconds of processor time from now on; then the system ends it
/// with SIGXCPU. Whole seconds: the limit is rounded up, never down.
///
/// # Errors
/// When the system refuses.
pub(crate) fn allow_cpu_s(cpu_s: u64) -> io::Result<()> {
    let used = clock_gettime(ClockId::ProcessCPUTime).tv_sec;
    let until = u64::try_from(used).unwrap_or_default() + cpu_s + 1;
    // Only the soft limit moves: the hard limit may not be raised again.
    let maximum = getrlimit(Resource::Cpu).maximum;
    setrlimit(
        Resource::Cpu,
        Rlimit {
            current: Some(until),
            maximum,
        },
    )?;
    Ok(())
}
