//! What a STEP file's header says of the specification that it is of.

/// The line of a STEP file's description that says of which specification it is.
pub(crate) fn of_specification(sha256: &str) -> String {
    format!("specification sha256 {sha256}")
}

/// Whether a STEP file's description says that it is of this specification.
pub(crate) fn names_specification(step: &[u8], sha256: &str) -> bool {
    // It stands in the first lines, which are broken anywhere.
    let head = step.iter().take(4096).copied();
    let head: Vec<u8> = head.filter(|c| !matches!(c, b'\n' | b'\r')).collect();
    String::from_utf8_lossy(&head).contains(&of_specification(sha256))
}
