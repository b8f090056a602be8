//! Requests that cannot be done, each answered with what would mend it.

use serde_json::json;

use crate::kit::{Kit, codes};

#[test]
fn incompatible_ports_are_refused_with_those_that_fit() {
    let mut kit = Kit::new();
    kit.stand("stand");
    kit.part("stand", "pin", "base_frame.stepped_shaft", json!({}));
    let before = kit.files();
    let d = kit.refusal(
        "mate",
        json!({
            "assembly": "stand", "id": "bad", "mate_type": "face_to_face",
            "base": "block:bore_port", "incoming": "pin:shaft_seat_1",
        }),
    );
    assert_eq!(d["code"], "mate_incompatible");
    assert_eq!(d["where"], "mate_type");
    assert_eq!(d["found"], json!(["face_to_face", "BORE", "SHAFT"]));
    assert_eq!(
        d["expected"]["mate_types_for_these_ports"],
        json!(["coaxial", "press_fit"])
    );
    // The literal next call: the same with the mate type that fits. It works (the bore is wide enough).
    assert_eq!(d["next"]["tool"], "mate");
    let next = d["next"]["arguments"].clone();
    assert_eq!(next["mate_type"], "coaxial");
    assert_eq!(kit.files(), before);
    kit.mate(next);

    let d = kit.refusal(
        "mate",
        json!({
            "assembly": "stand", "id": "worse", "mate_type": "coaxial",
            "base": "plate:top_face", "incoming": "pin:end_face_start",
        }),
    );
    assert_eq!(
        d["expected"]["mate_types_for_these_ports"],
        json!(["coaxial_face", "face_to_face", "snap_to_face"])
    );
    assert_eq!(
        d["expected"]["incoming_ports_for_this_mate_and_base"],
        json!([])
    );
}

#[test]
fn a_shaft_thicker_than_its_bore_is_refused() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "bearing", "bearing.ball", json!({}));
    kit.part("a", "shaft", "base_frame.stepped_shaft", json!({}));
    let d = kit.refusal(
        "mate",
        json!({
            "assembly": "a", "id": "m", "mate_type": "coaxial",
            "base": "bearing:inner_ring", "incoming": "shaft:shaft_seat_2",
        }),
    );
    assert_eq!(
        (&d["code"], &d["found"]),
        (&json!("mate_incompatible"), &json!(25.0))
    );
}

#[test]
fn unknown_names_are_answered_with_the_valid_ones() {
    let mut kit = Kit::new();
    kit.stand("stand");

    let d = kit.refusal("verify", json!({"assembly": "stnd"}));
    assert_eq!(
        (&d["code"], &d["expected"]),
        (&json!("assembly_unknown"), &json!(["stand"]))
    );
    assert_eq!(d["hint"], "did you mean 'stand'?");

    let d = kit.refusal(
        "add_part",
        json!({"assembly": "stand", "part": "x", "factory": "base_frame.plate"}),
    );
    assert_eq!(d["code"], "factory_unknown");
    assert!(
        d["expected"]
            .as_array()
            .unwrap()
            .contains(&json!("base_frame.rect_plate"))
    );
    assert!(
        d["hint"]
            .as_str()
            .unwrap()
            .contains("base_frame.rect_plate")
    );

    let d = kit.refusal(
        "add_part",
        json!({
            "assembly": "stand", "part": "x", "factory": "base_frame.rect_plate",
            "params": {"lenght": 10},
        }),
    );
    assert_eq!(
        (&d["code"], &d["where"]),
        (&json!("param_unknown"), &json!("params.lenght"))
    );
    assert_eq!(
        d["expected"],
        json!(["length", "width", "thickness", "bolt_d", "hole_d", "edge"])
    );

    let d = kit.refusal(
        "mate",
        json!({
            "assembly": "stand", "id": "x", "mate_type": "coaxial",
            "base": "block:bore", "incoming": "shaft:shaft_seat_1",
        }),
    );
    assert_eq!(
        (&d["code"], &d["where"]),
        (&json!("port_unknown"), &json!("base"))
    );
    assert!(
        d["expected"]
            .as_array()
            .unwrap()
            .contains(&json!("bore_port"))
    );

    let d = kit.refusal(
        "mate",
        json!({
            "assembly": "stand", "id": "x", "mate_type": "coaxial",
            "base": "blok:bore_port", "incoming": "shaft:shaft_seat_1",
        }),
    );
    assert_eq!(
        (&d["code"], &d["where"]),
        (&json!("part_unknown"), &json!("base"))
    );
    assert_eq!(d["expected"], json!(["plate", "block", "bearing", "shaft"]));

    let d = kit.refusal(
        "remove",
        json!({"assembly": "stand", "kind": "mate", "name": "m9"}),
    );
    assert_eq!(
        (&d["code"], &d["expected"]),
        (&json!("mate_unknown"), &json!(["m1", "m2", "m3"]))
    );

    // The protocol has an error for this one.
    let call = json!({"name": "make_coffee", "arguments": {}});
    let answer = kit.session.request("tools/call", call).unwrap();
    assert_eq!(answer["error"]["code"], -32602);
    let d = &answer["error"]["data"];
    assert_eq!(d["code"], "tool_unknown");
    assert_eq!(d["expected"].as_array().unwrap().len(), 18);
}

#[test]
fn all_that_is_wrong_is_told_at_once() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let found = kit.refused(
        "mate",
        json!({
            "assembly": "stand", "id": "a/b", "mate_type": "face_to_face",
            "base": "plate:topface", "incoming": "nobody:face", "d_mm": 3, "u_mm": 1e9,
        }),
    );
    let mut all = codes(&found);
    all.sort_unstable();
    assert_eq!(
        all,
        [
            "name_invalid",
            "param_invalid",
            "param_unknown",
            "part_unknown",
            "port_unknown"
        ]
    );
    let found = kit.refused(
        "add_part",
        json!({
            "assembly": "stand", "part": "block", "factory": "base_frame.rect_plate",
            "params": {"length": -1, "width": "wide", "colour": "red"},
        }),
    );
    let mut all = codes(&found);
    all.sort_unstable();
    assert_eq!(
        all,
        [
            "name_taken",
            "param_invalid",
            "param_invalid",
            "param_unknown"
        ]
    );
}

#[test]
fn a_loop_that_does_not_close_is_refused_with_its_residual() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let before = kit.files();
    // The block stands on the plate's top; its side is 90 degrees and some way from the plate's side.
    let d = kit.refusal(
        "mate",
        json!({
            "assembly": "stand", "id": "loop", "mate_type": "face_to_face",
            "base": "plate:top_face", "incoming": "block:bottom_face", "d_n_mm": 0.25,
        }),
    );
    assert_eq!(d["code"], "mate_residual");
    assert_eq!(d["found"], json!({"distance_mm": 0.25, "angle_deg": 0.0}));
    assert_eq!(kit.files(), before);
    // One that holds is accepted and says so.
    let held = kit.mate(json!({
        "assembly": "stand", "id": "loop", "mate_type": "coaxial",
        "base": "block:bore_port_back", "incoming": "shaft:shaft_seat_1",
    }));
    assert_eq!(
        held["residual"],
        json!({"distance_mm": 0.0, "angle_deg": 0.0})
    );
}

#[test]
fn a_part_that_no_rule_allows_is_refused_with_the_rule() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    let d = kit.refusal(
        "add_part",
        json!({
            "assembly": "a", "part": "b", "factory": "base_frame.housing_block",
            "params": {"length": 40, "bore_d": 39},
        }),
    );
    assert!(d["message"].as_str().unwrap().contains("bore_d"), "{d}");
    assert_eq!(
        kit.ok("get_assembly", json!({"assembly": "a"}))["state"]["parts"],
        json!([])
    );
}

#[test]
fn export_needs_a_place_for_every_part() {
    let mut kit = Kit::new();
    kit.stand("stand");
    kit.part("stand", "loose", "test.block", json!({}));
    let d = kit.refusal("export_step", json!({"assembly": "stand"}));
    assert_eq!(d["code"], "unconnected");
    assert!(!kit.file("assemblies/stand/stand.step").exists());
    kit.new_assembly("empty");
    for tool in ["export_step", "verify"] {
        assert_eq!(
            kit.refusal(tool, json!({"assembly": "empty"}))["code"],
            "assembly_empty"
        );
    }
}
