//! The language in one page.

/// The language in one page.
#[must_use]
pub fn reference() -> String {
    String::new()
}
