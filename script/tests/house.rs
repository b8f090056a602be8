//! Rules of the house that no lint sees.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

#[test]
fn no_unsafe_code_is_written_by_hand() {
    // The lint is off where the interpreter's derive needs it; this keeps it at that.
    let mut folders = vec![std::path::PathBuf::from(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/src"
    ))];
    let mut seen = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            seen += 1;
            let text = std::fs::read_to_string(&path).unwrap();
            let code = text
                .replace("unsafe_code", "")
                .replace("an unsafe trait", "");
            assert!(!code.contains("unsafe"), "{}", path.display());
        }
    }
    assert!(seen > 10);
}
