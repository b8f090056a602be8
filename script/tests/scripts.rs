//! Plain CadQuery, as people write it, is recorded without fault.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_model::language::method;
use assemcad_script::script;

#[test]
fn every_script_is_recorded() {
    let folder =
        std::path::PathBuf::from(std::env::var_os("ASSEMCAD_SCRIPTS").unwrap_or_else(|| {
            concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/cadquery/scripts").into()
        }));
    // The folder comes with the scripts of the comparison with CadQuery.
    let Ok(entries) = std::fs::read_dir(&folder) else {
        return;
    };
    let mut wrong = Vec::new();
    for entry in entries {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "py") {
            continue;
        }
        let source = std::fs::read_to_string(&path).unwrap();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        match script(&name, &source) {
            Ok(done) => {
                assert_eq!(done.lines.len(), done.recipe.calls.len());
                for (call, line) in done.recipe.calls.iter().zip(&done.lines) {
                    let method = method(&call.call).unwrap();
                    let short = method.name.rsplit('.').next().unwrap();
                    let text = source.lines().nth(*line as usize - 1).unwrap_or_default();
                    let ours = [
                        "eachLocation",
                        "eachObject",
                        "union",
                        "cut",
                        "intersect",
                        "split",
                    ];
                    assert!(
                        text.contains(short) || ours.contains(&short),
                        "{name}:{line}: {short} is not in {text}"
                    );
                }
            }
            Err(faults) => wrong.push(format!("{name}: {faults:?}")),
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
