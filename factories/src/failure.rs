//! Failures of the kernel and its workers, in the words of those who called for the part.

use assemcad_kernel::protocol::{Failure, FailureKind};
use assemcad_model::diagnostic::{Code, Diagnostic};

/// A failure in making a part, with the line of the factory's source that it came to.
#[must_use]
pub fn failed_in(
    failure: &Failure,
    part: Option<&str>,
    factory: &str,
    lines: &[u32],
) -> Diagnostic {
    let line = line(failure, lines).map(|l| format!(", line {l}"));
    let part = part.map(|id| format!("part '{id}', ")).unwrap_or_default();
    let place = format!("{part}factory {factory}{}", line.unwrap_or_default());
    diagnostic(failure, &place)
}

/// The line (1-based) of the source at which a recipe failed.
#[must_use]
pub fn line(failure: &Failure, lines: &[u32]) -> Option<u32> {
    let step = failure.doing.as_ref().and_then(|d| d.step)?;
    lines.get(step).copied()
}

/// A failure of the kernel or its worker as a diagnostic.
#[must_use]
pub fn diagnostic(failure: &Failure, place: &str) -> Diagnostic {
    let doing = failure
        .doing
        .as_ref()
        .map(|d| format!("in {d}: "))
        .unwrap_or_default();
    let message = format!("{doing}{}", failure.message);
    let (code, hint) = match failure.kind {
        FailureKind::Refused => (Code::KernelFailed, None),
        FailureKind::Memory => (
            Code::WorkerMemoryLimit,
            Some("make the geometry simpler, or start the server with a larger --worker-memory-mb"),
        ),
        FailureKind::Cpu => (
            Code::WorkerCpuLimit,
            Some("make the geometry simpler, or start the server with a larger --worker-cpu-s"),
        ),
        FailureKind::Wall => (
            Code::WorkerTimeout,
            Some("make the geometry simpler, or start the server with a larger --worker-wall-s"),
        ),
        FailureKind::Crash => (
            Code::WorkerCrashed,
            Some(
                "the worker was replaced and nothing was lost; if the same call fails again, \
                  change the parameters of this operation",
            ),
        ),
        FailureKind::Worker => (Code::WorkerFailed, None),
    };
    let d = Diagnostic::error(code, place, message);
    match hint {
        Some(hint) => d.hint(hint),
        None => d,
    }
}
