//! Whether the memory of this process comes to its end.
//!
//! The kernel does not survive every failed allocation: it is better not to begin what cannot be
//! finished.

use rustix::process::{Resource, getrlimit};

/// This share of the limit is left for finishing a call and for telling what happened.
const SHARE_LEFT: f64 = 0.1;

/// Whether more than nine tenths of the limit on address space are in use. False where there is no
/// limit, or the system does not tell what is in use (it does on Linux).
#[must_use]
pub(crate) fn nearly_exhausted() -> bool {
    share_in_use().is_some_and(|share| share > 1.0 - SHARE_LEFT)
}

/// Which share of the limit on address space is in use; none where there is no limit, or the system does not tell.
#[must_use]
pub(crate) fn share_in_use() -> Option<f64> {
    let limit = getrlimit(Resource::As).current?;
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    let pages: u64 = text.split_whitespace().next()?.parse().ok()?;
    let page = u64::try_from(rustix::param::page_size()).unwrap_or(4096);
    let used = pages.saturating_mul(page);
    #[allow(
        clippy::cast_precision_loss,
        reason = "a comparison of sizes needs no last digits"
    )]
    let share = used as f64 / limit.max(1) as f64;
    Some(share)
}
