//! An assembly as far as it can be made and placed.

use assemcad_model::diagnostic::{Code, Diagnostic};
use serde_json::json;

use crate::place::Placements;
use crate::resolved::Resolved;

/// What could be made and placed, and what not.
#[derive(Debug)]
pub struct Partial {
    /// The parts and mates that are there.
    pub resolved: Resolved,
    /// Where the parts are.
    pub placements: Placements,
    /// One sentence for everything that is missing.
    pub missing: Vec<String>,
}

/// The diagnostic for a part that is in the assembly but has no place or no solid.
#[must_use]
pub fn nowhere(id: &str, place: &str) -> Diagnostic {
    Diagnostic::error(
        Code::Unconnected,
        place,
        format!("'{id}' has no place or could not be made"),
    )
    .found(id)
    .hint("join it to the root with the mate tool; verify says what is wrong with it")
}

/// The diagnostic for an assembly without parts.
#[must_use]
pub fn no_parts(assembly: &str) -> Diagnostic {
    Diagnostic::error(
        Code::AssemblyEmpty,
        "assembly",
        format!("'{assembly}' has no parts"),
    )
    .next("list_factories", json!({}))
}
