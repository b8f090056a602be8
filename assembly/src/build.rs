//! Parts made and measured by the kernel's workers.

use assemcad_kernel::protocol::{Built, Failure, FailureKind, Job, Reply};
use assemcad_model::diagnostic::{Code, Diagnostic};

use crate::Workshop;
use crate::resolve::ResolvedPart;

impl Workshop {
    /// Makes a part's solid and measures it. The kernel answers only for one valid closed solid of
    /// positive volume.
    ///
    /// # Errors
    /// Why there is no such solid, with the operation and its line in the factory's source.
    pub async fn build(&self, part: &ResolvedPart) -> Result<Built, Diagnostic> {
        let job = Job::Build {
            recipe: part.made.recipe.clone(),
        };
        match self.pool.run(&job).await {
            Ok((Reply::Built(built), _)) => Ok(built),
            Ok(_) => Err(unexpected(&job)),
            Err(failure) => Err(part_failure(&failure, part)),
        }
    }
}

/// A failure in making a part.
#[must_use]
pub fn part_failure(failure: &Failure, part: &ResolvedPart) -> Diagnostic {
    let step = failure.doing.as_ref().and_then(|d| d.step);
    let line = step
        .and_then(|s| part.made.lines.get(s))
        .map(|l| format!(", line {l}"));
    let place = format!(
        "part '{}', factory {}{}",
        part.id,
        part.factory,
        line.unwrap_or_default()
    );
    diagnostic(failure, &place)
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
        FailureKind::Kernel => (Code::KernelFailed, None),
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

/// A worker's answer to another question: a fault of the server.
#[must_use]
pub(crate) fn unexpected(job: &Job) -> Diagnostic {
    Diagnostic::error(
        Code::Internal,
        job.name(),
        "the worker answered another question",
    )
}
