//! Whole sessions that go well.

use serde_json::json;

use crate::harness::Session;
use crate::kit::{Kit, near, program};

#[test]
fn a_shaft_in_a_bearing_block_on_a_base_plate() {
    let mut kit = Kit::new();
    kit.whole_stand("stand");

    let state = kit.ok("get_assembly", json!({"assembly": "stand"}))["state"].clone();
    assert_eq!(state["root"], "plate");
    assert_eq!(state["unplaced"], json!([]));
    // The block's bottom is on the plate (15 mm thick); the bore's axis is 40 mm above it. The
    // bearing's body starts 14 mm behind the block's front at y = 20. The shaft's first segment of
    // 60 mm ends where the collar of 12 mm begins, at the back bearing's inner face at y = -6.
    let origins: Vec<&serde_json::Value> = state["parts"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| &p["origin_mm"])
        .collect();
    let wanted = [
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 15.0],
        [0.0, 6.0, 55.0],
        [0.0, -66.0, 55.0],
        [0.0, -6.0, 55.0],
    ];
    for (origin, wanted) in origins.iter().zip(wanted) {
        for (value, wanted) in origin.as_array().unwrap().iter().zip(wanted) {
            assert!(near(value, wanted, 0.0), "{origins:?}");
        }
    }

    let report = kit.ok("verify", json!({"assembly": "stand", "detail": "full"}));
    assert_eq!(report["verdict"], "pass", "{report}");
    // Nothing is wrong; that neither bearing locates the shaft is noted.
    let found = report["findings"].as_array().unwrap();
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0]["axioms"][0]["axiom"], "B-04");
    assert_eq!(
        (&found[0]["verdict"], &found[0]["diagnostic"]["severity"]),
        (&json!("pass"), &json!("note"))
    );
    assert!(!report["not_checked"].as_array().unwrap().is_empty());

    let step = kit.ok("export_step", json!({"assembly": "stand"}));
    assert_eq!(step["file"], "assemblies/stand/stand.step");
    assert_eq!(step["verified"], "pass");
    assert_eq!(
        (&step["products"], &step["instances"]),
        (&json!(4), &json!(5))
    );
    let text = std::fs::read_to_string(kit.file("assemblies/stand/stand.step")).unwrap();
    assert_eq!(text.len() as u64, step["bytes"].as_u64().unwrap());
    assert!(text.contains("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF"));
    assert!(text.contains("SI_UNIT(.MILLI.,.METRE.)"));
    let flat: String = text.split_whitespace().collect();
    assert!(flat.contains(step["specification_sha256"].as_str().unwrap()));
    assert!(flat.contains("'1970-01-01T00:00:00'"));
    for (i, part) in ["plate", "block", "bearing", "shaft", "back"]
        .iter()
        .enumerate()
    {
        assert!(flat.contains(&format!(
            "NEXT_ASSEMBLY_USAGE_OCCURRENCE('{}','{part}'",
            i + 1
        )));
    }
    for product in ["base_frame.rect_plate", "bearing.ball", "stand"] {
        assert_eq!(
            flat.matches(&format!("PRODUCT('{product}','{product}'"))
                .count(),
            1
        );
    }
    assert!(!text.contains("Open CASCADE"), "a product without a name");
    kit.session.close().unwrap();
}

#[test]
fn equal_parts_are_one_product() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "plate", "base_frame.rect_plate", json!({}));
    for (i, u) in [-60.0, 0.0, 60.0].iter().enumerate() {
        let part = format!("cube_{i}");
        // The third one is of another size: a product of its own.
        kit.part(
            "a",
            &part,
            "test.block",
            json!({"size": if i == 2 { 12 } else { 10 }}),
        );
        kit.mate(json!({
            "assembly": "a", "id": part, "mate_type": "face_to_face",
            "base": "plate:top_face", "incoming": format!("{part}:bottom"), "u_mm": u,
        }));
    }
    let step = kit.ok(
        "export_step",
        json!({"assembly": "a", "file": "some/where/else.stp"}),
    );
    assert_eq!(
        (&step["products"], &step["instances"]),
        (&json!(3), &json!(4))
    );
    assert_eq!(step["verified"], json!(null), "nothing was verified yet");
    let flat: String = std::fs::read_to_string(kit.file("exports/a/some/where/else.stp"))
        .unwrap()
        .split_whitespace()
        .collect();
    assert_eq!(flat.matches("MANIFOLD_SOLID_BREP(").count(), 3);
    assert_eq!(flat.matches("PRODUCT('test.block','test.block'").count(), 1);
    assert_eq!(
        flat.matches("PRODUCT('test.block-2','test.block-2'")
            .count(),
        1
    );
}

#[test]
fn calls_made_twice_change_nothing() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let before = kit.files();
    let again = kit.ok("new_assembly", json!({"assembly": "stand"}));
    assert_eq!(again["changed"], false);
    let again = kit.part("stand", "block", "base_frame.housing_block", json!({}));
    assert_eq!(again["changed"], false);
    let again = kit.mate(json!({
        "assembly": "stand", "id": "m1", "mate_type": "face_to_face",
        "base": "plate:top_face", "incoming": "block:bottom_face", "axioms": ["C-01"], "bond": "welded",
    }));
    assert_eq!(again["changed"], false);
    assert_eq!(kit.files(), before);
}

#[test]
fn what_is_removed_can_be_made_anew() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let d = kit.refusal(
        "remove",
        json!({"assembly": "stand", "kind": "part", "name": "bearing"}),
    );
    assert_eq!(
        (&d["code"], &d["found"]),
        (&json!("in_use"), &json!(["m2", "m3"]))
    );
    assert_eq!(
        d["next"]["arguments"],
        json!({"assembly": "stand", "kind": "mate", "name": "m2"})
    );
    for mate in ["m2", "m3"] {
        kit.ok(
            "remove",
            json!({"assembly": "stand", "kind": "mate", "name": mate}),
        );
    }
    let state = kit.ok(
        "remove",
        json!({"assembly": "stand", "kind": "part", "name": "bearing"}),
    );
    assert_eq!(state["state"]["unplaced"], json!(["shaft"]));
    kit.part("stand", "bearing", "bearing.ball", json!({"width": 20}));
}

#[test]
fn a_part_placed_from_the_other_side() {
    // The mate is made first between two parts without a place, then one of them is joined to the root.
    let mut kit = Kit::new();
    kit.new_assembly("a");
    for (part, size) in [("root", 30), ("b", 20), ("c", 10)] {
        kit.part("a", part, "test.block", json!({"size": size}));
    }
    let first = kit.mate(json!({
        "assembly": "a", "id": "c_on_b", "mate_type": "face_to_face",
        "base": "c:bottom", "incoming": "b:top",
    }));
    assert_eq!(first["state"]["unplaced"], json!(["b", "c"]));
    assert_eq!(first.get("residual"), None);
    let second = kit.mate(json!({
        "assembly": "a", "id": "b_on_root", "mate_type": "face_to_face",
        "base": "root:top", "incoming": "b:bottom",
    }));
    assert_eq!(second["state"]["unplaced"], json!([]));
    // Both got their places by this one mate: 20 mm on 30, 10 mm on that, all centred on (15, 15).
    assert_eq!(
        second["placed"],
        json!([
            {"part": "b", "box_min_mm": [5.0, 5.0, 30.0], "box_max_mm": [25.0, 25.0, 50.0]},
            {"part": "c", "box_min_mm": [10.0, 10.0, 50.0], "box_max_mm": [20.0, 20.0, 60.0]},
        ])
    );
    assert_eq!(
        (&second["state"]["parts"], &second["state"]["mates"]),
        (&json!(3), &json!(2))
    );
    let state = kit.ok("get_assembly", json!({"assembly": "a"}));
    let c = &state["state"]["parts"][2];
    assert_eq!(c["placed_by"], "c_on_b");
    // Centred on the root (15, 15), 30 + 20 high; the cube's own corner is 5 off its centre.
    assert_eq!(c["origin_mm"], json!([10.0, 10.0, 50.0]));
}

#[test]
fn a_session_piped_in_gets_all_its_answers() {
    // The input ends right behind the last call, as it does for `assemcad serve < session`.
    let root = tempfile::tempdir().unwrap();
    let mut session = Session::start(program(), root.path(), &[]).unwrap();
    session
        .call("new_assembly", json!({"assembly": "a"}))
        .unwrap();
    session
        .call(
            "add_part",
            json!({"assembly": "a", "part": "p", "factory": "base_frame.rect_plate"}),
        )
        .unwrap();
    session
        .begin_call("export_step", json!({"assembly": "a"}))
        .unwrap();
    session.close().unwrap();
    assert!(root.path().join("assemblies/a/a.step").exists());
}

#[test]
fn the_stateless_revision_is_spoken_too() {
    let root = tempfile::tempdir().unwrap();
    let mut session = Session::spawn(program(), root.path(), &[]).unwrap();
    let meta = json!({
        "io.modelcontextprotocol/protocolVersion": "2026-07-28",
        "io.modelcontextprotocol/clientInfo": {"name": "t", "version": "1"},
        "io.modelcontextprotocol/clientCapabilities": {},
    });
    let found = session
        .request("server/discover", json!({"_meta": meta}))
        .unwrap();
    assert!(
        found["result"]["supportedVersions"]
            .to_string()
            .contains("2026-07-28"),
        "{found}"
    );
    let list = session
        .request(
            "tools/call",
            json!({"_meta": meta, "name": "list_factories", "arguments": {}}),
        )
        .unwrap();
    assert_eq!(
        list["result"]["structuredContent"]["factories"][0]["factory"],
        "base_frame.bolt_circle_flange"
    );
}
