//! A folder for each check, in it assemblies that pass and assemblies that fail for that reason alone.
//!
//! `report.json` is what must be said of each, but for the version of the kernel and for the axioms that
//! are about nothing there or were not checked. Accept it with
//! `ASSEMCAD_ACCEPT=1 cargo test -p assemcad --test sessions verification_cases`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::drafts::draft;
use crate::kit::Kit;

fn folders(of: &Path) -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = std::fs::read_dir(of)
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    all.sort();
    all
}

fn name(path: &Path) -> &str {
    path.file_name().unwrap().to_str().unwrap()
}

/// What is held: all of a report that does not go with the kernel's version or with axioms elsewhere.
fn held(mut report: Value) -> Value {
    let whole = report.as_object_mut().unwrap();
    whole.shift_remove("kernel");
    let axioms = whole["axioms"]["each"].as_array().unwrap().clone();
    let told =
        |a: &&Value| !["not_applicable", "not_checked"].contains(&a["status"].as_str().unwrap());
    let told: Vec<&Value> = axioms.iter().filter(told).collect();
    whole["axioms"] = json!(told);
    whole["not_checked"] = Value::Null;
    for check in whole["checks"].as_array_mut().unwrap() {
        if check["check"] == "axioms" {
            check["how"] = Value::Null;
            check["cases"] = Value::Null;
        }
    }
    report
}

/// The names of the checks with this verdict.
fn with<'a>(report: &'a Value, verdict: &str) -> Vec<&'a str> {
    let checks = report["checks"].as_array().unwrap().iter();
    checks
        .filter(|c| c["verdict"] == verdict)
        .map(|c| c["check"].as_str().unwrap())
        .collect()
}

#[test]
fn every_check_passes_and_fails_for_its_own_reason() {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/verification");
    let mut kit = Kit::new();
    let mut checks = Vec::new();
    for folder in folders(&top) {
        let check = name(&folder).to_owned();
        let mut kinds = Vec::new();
        for case in folders(&folder) {
            let fails = name(&case).starts_with("fail_");
            kinds.push(fails);
            let id = format!("{check}_{}", name(&case));
            let place = kit.file(&format!("assemblies/{id}"));
            std::fs::create_dir_all(&place).unwrap();
            std::fs::copy(case.join("assembly.yaml"), place.join("assembly.yaml")).unwrap();
            let found = if check == "parts" && fails {
                // Without a solid there are no ports to place it by: the assembly has no report.
                let refused = kit.refusal("verify", json!({"assembly": id}));
                assert_eq!(refused["code"], "kernel_failed", "{id}");
                refused
            } else {
                kit.ok("verify", json!({"assembly": id}));
                let report = std::fs::read(place.join("report.json")).unwrap();
                let report: Value = serde_json::from_slice(&report).unwrap();
                judge(&report, &check, fails, &id);
                held(report)
            };
            accept_or_compare(&case.join("report.json"), &found);
        }
        assert!(
            kinds.contains(&true) && kinds.contains(&false),
            "{check} lacks a case"
        );
        checks.push(check);
    }
    assert_eq!(
        checks,
        [
            "axioms",
            "connectivity",
            "contact",
            "freedom",
            "interference",
            "mates",
            "parts",
            "ports"
        ]
    );
}

/// What the names of a case say of its report, whatever its golden file says.
fn judge(report: &Value, check: &str, fails: bool, id: &str) {
    let (bad, open) = (with(report, "fail"), with(report, "indeterminate"));
    if !fails {
        assert_eq!(report["verdict"], "pass", "{id}");
        assert!(bad.is_empty() && open.is_empty(), "{id}: {bad:?} {open:?}");
        return;
    }
    assert_eq!(report["verdict"], "fail", "{id}");
    // An axiom that says the same is broken with it; and what is wrong may leave other questions open.
    let other: Vec<&&str> = bad
        .iter()
        .filter(|c| **c != check && **c != "axioms")
        // What touches nothing is held by nothing.
        .filter(|c| !(["contact", "interference"].contains(&check) && **c == "holding"))
        .collect();
    assert!(bad.contains(&check) && other.is_empty(), "{id}: {bad:?}");
    for f in report["findings"].as_array().unwrap() {
        if f["verdict"] == "fail" {
            let follows = ["contact", "interference"].contains(&check) && f["check"] == "holding";
            assert!(f["check"] == check || follows, "{id}: {f}");
        }
    }
}

fn accept_or_compare(path: &Path, found: &Value) {
    let text = format!("{}\n", serde_json::to_string_pretty(found).unwrap());
    if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
        std::fs::write(path, &text).unwrap();
    }
    let wanted = std::fs::read_to_string(path).unwrap_or_default();
    let line = wanted.lines().zip(text.lines()).find(|(a, b)| a != b);
    assert!(wanted == text, "{}: {line:?}", path.display());
}

/// Assemblies whose files are the same wherever they are made with one version of the kernel.
const HASHED: [&str; 10] = [
    "good_anchor",
    "good_backwards",
    "good_closed_loop",
    "good_everything",
    "good_json_document",
    "good_one_part",
    "good_odd_names",
    "good_side_by_side",
    "good_stand",
    "good_tree_json",
];

/// The hashes of report and STEP file of each of them, and the kernel's version.
fn hashed(kit: &mut Kit) -> (BTreeMap<String, Value>, String) {
    let mut hashes: BTreeMap<String, Value> = BTreeMap::new();
    let mut kernel = String::new();
    for case in HASHED {
        let call = json!({"draft": draft(case), "keep_failed": true});
        let done = kit.ok("realize", call);
        assert_eq!(done["realized"], true, "{case}: {done}");
        let bytes = std::fs::read(kit.file(done["report_file"].as_str().unwrap())).unwrap();
        let report: Value = serde_json::from_slice(&bytes).unwrap();
        assert_eq!(report["step"]["sha256"], done["step_sha256"]);
        kernel = report["kernel"].as_str().unwrap().to_owned();
        hashes.insert(
            case.to_owned(),
            json!({"report": assemcad_model::canonical::sha256(&bytes), "step": done["step_sha256"]}),
        );
    }
    (hashes, kernel)
}

#[test]
fn ten_assemblies_have_the_hashes_that_they_always_had() {
    let (hashes, kernel) = hashed(&mut Kit::new());
    // One file for each version of the kernel, whose last digits and whose STEP header may be its own.
    let file = format!("../tests/golden/hashes.{}.json", kernel.replace(' ', "-"));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    if path.exists() || std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
        accept_or_compare(&path, &json!(hashes));
    } else {
        // A kernel that nobody has accepted the hashes of: another server gives the same ones.
        assert_eq!(hashed(&mut Kit::with(&["--workers", "1"])).0, hashes);
    }
}
