//! What goes wrong with files.

use std::io;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::clip;

pub(crate) fn outside(path: &str) -> Diagnostic {
    Diagnostic::error(
        Code::PathInvalid,
        "file",
        "files are read and written below the root folder only",
    )
    .found(path)
    .expected("a relative path without '..' that no link leads out of the root folder")
}

pub(crate) fn file_failed(place: &str, done: &str, e: &io::Error) -> Diagnostic {
    Diagnostic::error(
        Code::FileFailed,
        clip(place),
        format!("it could not be {done}: {}", e.kind()),
    )
}
