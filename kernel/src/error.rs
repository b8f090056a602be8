//! What the kernel says when something cannot be done.

use serde::{Deserialize, Serialize};

/// An error of the kernel: what sort, and one plain sentence.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, Serialize, Deserialize)]
#[error("{message}")]
pub struct KernelError {
    /// What sort of error.
    pub kind: Kind,
    /// What is wrong, in the words of the field.
    pub message: String,
}

/// The sorts of errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The input or its geometry is at fault.
    Refused,
    /// The kernel made nothing usable of valid input.
    Invalid,
    /// There was not enough memory.
    OutOfMemory,
    /// A fault of this program.
    Internal,
}

/// The result of everything here.
pub type Result<T> = core::result::Result<T, KernelError>;

impl KernelError {
    /// The input or its geometry is at fault.
    #[must_use]
    pub fn refused(message: impl Into<String>) -> Self {
        Self {
            kind: Kind::Refused,
            message: message.into(),
        }
    }

    /// The kernel made nothing usable.
    #[must_use]
    pub fn invalid(message: impl Into<String>) -> Self {
        Self {
            kind: Kind::Invalid,
            message: message.into(),
        }
    }

    /// A fault of this program.
    #[must_use]
    pub fn internal(message: impl Into<String>) -> Self {
        Self {
            kind: Kind::Internal,
            message: message.into(),
        }
    }

    /// The sentence `{what}: {detail}` from what C++ threw; `cpp/shim.h` sets the first letter.
    pub(crate) fn thrown(what: &str, exception: &cxx::Exception) -> Self {
        let text = exception.what();
        let mut letters = text.chars();
        let kind = letters.next();
        let detail = letters.as_str();
        match kind {
            Some('M') => Self {
                kind: Kind::OutOfMemory,
                message: format!("{what}: there is not enough memory"),
            },
            Some('R') => Self::refused(format!("{what}: {detail}")),
            Some('I') => Self::invalid(format!("{what}: {detail}")),
            Some('K') => Self::refused(format!("{what}: the kernel gave up ({detail})")),
            _ => Self::internal(format!("{what}: {text}")),
        }
    }
}

/// Gives what C++ threw its sentence.
pub(crate) trait Context<T> {
    /// `what` is the sentence's beginning, such as "the fillet of 5 mm could not be built".
    fn context(self, what: impl FnOnce() -> String) -> Result<T>;
}

impl<T> Context<T> for core::result::Result<T, cxx::Exception> {
    fn context(self, what: impl FnOnce() -> String) -> Result<T> {
        self.map_err(|e| KernelError::thrown(&what(), &e))
    }
}
