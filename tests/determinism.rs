//! Same input, same bytes.

use std::collections::BTreeSet;

use serde_json::json;

use crate::kit::Kit;

fn export(kit: &mut Kit, assembly: &str) -> (String, Vec<u8>) {
    let answer = kit.ok("export_step", json!({"assembly": assembly}));
    let bytes = std::fs::read(kit.file(answer["file"].as_str().unwrap())).unwrap();
    (answer["sha256"].as_str().unwrap().to_owned(), bytes)
}

#[test]
fn twenty_exports_give_one_file() {
    let mut hashes = BTreeSet::new();
    let mut files = BTreeSet::new();
    let mut reports = BTreeSet::new();
    let mut count = 0;
    let mut note = |(hash, bytes): (String, Vec<u8>)| {
        hashes.insert(hash);
        files.insert(bytes);
        count += 1;
    };
    // In one process, again and again, then after unrelated work.
    let mut kit = Kit::with(&["--workers", "2"]);
    kit.stand("stand");
    for _ in 0..6 {
        note(export(&mut kit, "stand"));
    }
    kit.stand("other");
    kit.part(
        "other",
        "extra",
        "base_frame.housing_block",
        json!({"length": 100}),
    );
    kit.ok(
        "remove",
        json!({"assembly": "other", "kind": "part", "name": "extra"}),
    );
    kit.ok("verify", json!({"assembly": "other"}));
    for _ in 0..4 {
        export(&mut kit, "other");
        note(export(&mut kit, "stand"));
    }
    kit.ok("verify", json!({"assembly": "stand"}));
    reports.insert(std::fs::read(kit.file("assemblies/stand/report.json")).unwrap());
    // By fresh processes over fresh folders, so that every solid is made anew, with 1 and 2 workers.
    for workers in ["1", "2", "1", "2", "1"] {
        let mut kit = Kit::with(&["--workers", workers]);
        kit.stand("stand");
        note(export(&mut kit, "stand"));
        kit.ok("verify", json!({"assembly": "stand"}));
        reports.insert(std::fs::read(kit.file("assemblies/stand/report.json")).unwrap());
        // By a fresh process over the same folder, with the solids from disk.
        let mut kit = kit.killed_and_started_again();
        note(export(&mut kit, "stand"));
    }
    assert_eq!(count, 20);
    assert_eq!(hashes.len(), 1, "{hashes:?}");
    assert_eq!(files.len(), 1);
    assert_eq!(reports.len(), 1);
}

#[test]
fn the_order_of_arguments_does_not_matter() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    let mut hash = |text: &str| {
        let params: serde_json::Value = serde_json::from_str(text).unwrap();
        let name = format!("a{}", text.len());
        kit.new_assembly(&name);
        kit.part(&name, "p", "base_frame.rect_plate", params);
        let report = kit.ok("verify", json!({"assembly": name, "detail": "full"}));
        report["measured"]["parts"][0]["recipe_sha256"]
            .as_str()
            .unwrap()
            .to_owned()
    };
    let plain = hash(r#"{"length": 50, "width": 40}"#);
    assert_eq!(hash(r#"{"width": 40.0,  "length": 5e1}"#), plain);
    // The defaults written out are the same part.
    assert_eq!(
        hash(r#"{"length": 50, "width": 40, "thickness": 15}"#),
        plain
    );
    assert_ne!(
        hash(r#"{"length": 50, "width": 40, "thickness": 15.5}"#),
        plain
    );
}

#[test]
fn a_part_of_many_operations_is_the_same_in_every_process() {
    // OCCT keeps shapes in maps keyed by addresses, and addresses differ from process to process.
    let mut files = BTreeSet::new();
    for workers in ["1", "2", "1", "2", "1", "2"] {
        let mut kit = Kit::with(&["--workers", workers]);
        kit.new_assembly("a");
        if workers == "2" {
            kit.part("a", "extra", "bearing.ball", json!({}));
            kit.ok(
                "remove",
                json!({"assembly": "a", "kind": "part", "name": "extra"}),
            );
        }
        kit.part("a", "p", "test.busy", json!({}));
        files.insert(export(&mut kit, "a"));
    }
    assert_eq!(files.len(), 1);
}
