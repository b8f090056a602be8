//! Assemblies that are wrong, each found for its own reason.

use serde_json::{Value, json};

use crate::kit::{Kit, near};

/// Two cubes of 20 and 10 mm, one on the other, lifted by `gap`.
fn cubes(gap: f64) -> (Kit, Value) {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "base", "test.block", json!({"size": 20}));
    kit.part("a", "top", "test.block", json!({"size": 10}));
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "face_to_face",
        "base": "base:top", "incoming": "top:bottom", "d_n_mm": gap,
    }));
    // What holds it is not the matter here.
    kit.intent("a", json!({"free": [{"part": "top"}]}));
    let report = kit.ok("verify", json!({"assembly": "a", "detail": "full"}));
    (kit, report)
}

#[test]
fn an_overlap_is_found_with_its_volume() {
    // 10 x 10 mm of the small cube's bottom, 2 mm deep in the large one.
    let (mut kit, report) = cubes(-2.0);
    assert_eq!(report["verdict"], "fail");
    let finding = &report["findings"][0];
    assert_eq!(finding["diagnostic"]["code"], "clash");
    assert_eq!(finding["parts"], json!(["base", "top"]));
    assert_eq!(finding["mates"], json!(["m"]));
    assert!(
        near(&finding["values"]["common_volume_mm3"], 200.0, 1e-6),
        "{finding}"
    );
    assert!(
        near(&finding["values"]["estimate_mm3"], 200.0, 2.0),
        "{finding}"
    );
    assert_eq!(finding["values"]["centre_mm"], json!([10.0, 10.0, 19.0]));
    // The export goes on, and says what the verification said.
    assert_eq!(
        kit.ok("export_step", json!({"assembly": "a"}))["verified"],
        "fail"
    );
    // A threshold above the server's own lets nothing pass.
    let report = kit.ok("verify", json!({"assembly": "a", "tau_mm3": 200.5}));
    assert_eq!(report["verdict"], "fail");
}

#[test]
fn a_thin_overlap_on_a_face_is_found() {
    let (_, report) = cubes(-0.01);
    assert!(
        near(
            &report["findings"][0]["values"]["common_volume_mm3"],
            1.0,
            1e-6
        ),
        "{report}"
    );
    // 1 micrometre on 10 x 10 mm is 0.1 mm3, above the threshold of 0.001.
    let (_, report) = cubes(-0.001);
    assert!(
        near(
            &report["findings"][0]["values"]["common_volume_mm3"],
            0.1,
            1e-6
        ),
        "{report}"
    );
}

#[test]
fn parts_that_only_touch_are_not_reported() {
    let (_, report) = cubes(0.0);
    assert_eq!(report["verdict"], "pass");
    // That it lies loose is shown, as it is stated.
    let findings = report["findings"].as_array().unwrap();
    assert!(
        findings
            .iter()
            .all(|f| f["check"] == "holding" && f["verdict"] == "pass")
    );
    let pair = &report["measured"]["pairs"][0];
    assert!(near(&pair["common_volume_mm3"], 0.0, 1e-9), "{pair}");
}

#[test]
fn parts_apart_are_not_reported() {
    let (_, report) = cubes(5.0);
    // It hangs in the air, whatever is stated of it, and overlaps nothing.
    let told: Vec<&Value> = report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|f| &f["check"])
        .collect();
    assert_eq!(told, ["holding"]);
    assert_eq!(report["measured"]["pairs"], json!([]));
}

#[test]
fn a_shaft_in_its_bore_touches_all_around_and_does_not_clash() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let report = kit.ok("verify", json!({"assembly": "stand", "detail": "full"}));
    let pair = |a: &str, b: &str| {
        let pairs = report["measured"]["pairs"].as_array().unwrap();
        pairs
            .iter()
            .find(|p| p["a"] == a && p["b"] == b)
            .unwrap()
            .clone()
    };
    assert!(near(
        &pair("bearing", "shaft")["common_volume_mm3"],
        0.0,
        1e-6
    ));
    assert!(near(
        &pair("block", "bearing")["common_volume_mm3"],
        0.0,
        1e-6
    ));
}

#[test]
fn a_part_that_nothing_joins_is_reported() {
    let (mut kit, _) = cubes(0.0);
    for part in ["loose_1", "loose_2", "lonely"] {
        kit.part("a", part, "test.block", json!({}));
    }
    kit.mate(json!({
        "assembly": "a", "id": "island", "mate_type": "face_to_face",
        "base": "loose_1:top", "incoming": "loose_2:bottom", "bond": "glued",
    }));
    let report = kit.ok("verify", json!({"assembly": "a"}));
    assert_eq!(report["verdict"], "fail");
    let found: Vec<(&str, &Value)> = report["findings"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|f| f["verdict"] != "pass")
        .map(|f| (f["diagnostic"]["code"].as_str().unwrap(), &f["parts"]))
        .collect();
    // One finding for each island; the mate inside the island cannot be checked.
    assert_eq!(
        found,
        [
            ("unconnected", &json!(["loose_1", "loose_2"])),
            ("unconnected", &json!(["lonely"])),
            ("indeterminate", &json!(["loose_1", "loose_2"])),
        ]
    );
}

#[test]
fn the_report_on_disk_is_the_whole_one() {
    let (kit, answer) = cubes(-2.0);
    let report: Value =
        serde_json::from_slice(&std::fs::read(kit.file("assemblies/a/report.json")).unwrap())
            .unwrap();
    assert_eq!(report["verdict"], "fail");
    assert_eq!(report["findings"], answer["findings"]);
    assert_eq!(report["pairs"], answer["measured"]["pairs"]);
    assert_eq!(
        report["specification_sha256"],
        answer["specification_sha256"]
    );
    assert_eq!(report["tau_mm3"], 0.001);
}
