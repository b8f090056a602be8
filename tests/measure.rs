//! Measurements, held against closed forms.

use core::f64::consts::PI;

use serde_json::{Value, json};

use crate::kit::{Kit, near};

/// Blocks of 30 and 10 mm: one on top of the other in the middle, one 5 mm above a corner.
fn blocks() -> Kit {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    for (part, size) in [("base", 30), ("on", 10), ("over", 10), ("lost", 20)] {
        kit.part("a", part, "test.block", json!({"size": size}));
    }
    for (part, u, v, gap) in [("on", 0.0, 0.0, 0.0), ("over", 10.0, 10.0, 5.0)] {
        kit.mate(json!({
            "assembly": "a", "id": part, "mate_type": "face_to_face", "base": "base:top",
            "incoming": format!("{part}:bottom"), "u_mm": u, "v_mm": v, "d_n_mm": gap,
        }));
    }
    kit
}

fn ask(kit: &mut Kit, what: &str, of: &str, to: Option<&str>) -> Value {
    let mut call = json!({"assembly": "a", "what": what, "of": of});
    if let Some(to) = to {
        call["to"] = json!(to);
    }
    kit.ok("measure", call)
}

fn point(value: &Value, wanted: [f64; 3]) {
    let all = value.as_array().unwrap();
    let same = all.iter().zip(wanted).all(|(v, w)| near(v, w, 1e-6));
    assert!(all.len() == 3 && same, "{value} is not {wanted:?}");
}

#[test]
fn blocks_are_measured() {
    let mut kit = blocks();
    // Its port bottom is at its middle, turned over: a block of 10 at the middle (15, 15) of 30.
    let found = ask(&mut kit, "box", "on", None);
    point(&found["box_min_mm"], [10.0, 10.0, 30.0]);
    point(&found["box_max_mm"], [20.0, 20.0, 40.0]);
    point(
        &ask(&mut kit, "centre", "on", None)["centre_mm"],
        [15.0, 15.0, 35.0],
    );
    // Top and base touch; the one above the corner hangs 5 mm over the base.
    assert_eq!(
        ask(&mut kit, "distance", "base", Some("on"))["distance_mm"],
        0.0
    );
    let over = ask(&mut kit, "distance", "over", Some("base"));
    assert_eq!(over["distance_mm"], 5.0);
    let points = &over["points_mm"];
    assert!(
        near(&points[0][2], 35.0, 1e-4) && near(&points[1][2], 30.0, 1e-4),
        "{over}"
    );
    // Their middles are 10 mm apart both ways, so their sides meet in one corner line: 0 apart in the
    // plane, and they overlap in height.
    assert_eq!(
        ask(&mut kit, "distance", "over", Some("on"))["distance_mm"],
        0.0
    );
    // Faces: the tops of the two are 45 and 40 high.
    let faces = ask(&mut kit, "distance", "over@>Z", Some("on@>Z"));
    assert!(near(&faces["distance_mm"], 5.0, 1e-6), "{faces}");
    point(
        &ask(&mut kit, "centre", "over@>Z", None)["centre_mm"],
        [25.0, 25.0, 45.0],
    );
    let side = ask(&mut kit, "box", "over@<X", None);
    point(&side["box_min_mm"], [20.0, 20.0, 35.0]);
    point(&side["box_max_mm"], [20.0, 30.0, 45.0]);
    // Mass: 1000 mm3 of steel are 7.85 g, of aluminium 2.7 g.
    let mass = ask(&mut kit, "mass", "on", None);
    assert!(near(&mass["volume_mm3"], 1000.0, 1e-6) && near(&mass["mass_kg"], 0.00785, 1e-9));
    assert!(mass["how"].as_str().unwrap().contains("7850"), "{mass}");
    let light = json!({"assembly": "a", "what": "mass", "of": "on", "density_kg_m3": 2700});
    assert!(near(&kit.ok("measure", light)["mass_kg"], 0.0027, 1e-9));
}

#[test]
fn ports_are_measured_in_closed_form() {
    let mut kit = blocks();
    // base:top at (15, 15, 30), over:top at (25, 25, 45).
    let found = ask(&mut kit, "distance", "base:top", Some("over:top"));
    assert!(near(
        &found["distance_mm"],
        (100.0_f64 + 100.0 + 225.0).sqrt(),
        1e-6
    ));
    point(&found["vector_mm"], [10.0, 10.0, 15.0]);
    assert!(
        near(&found["axis_distance_mm"], 200.0_f64.sqrt(), 1e-6),
        "{found}"
    );
    assert_eq!(
        ask(&mut kit, "angle", "base:top", Some("over:top"))["angle_deg"],
        0.0
    );
    let opposite = ask(&mut kit, "angle", "base:bottom", Some("over:top"));
    assert_eq!(
        (&opposite["angle_deg"], &opposite["lines_angle_deg"]),
        (&json!(180.0), &json!(0.0))
    );
    assert_eq!(
        ask(&mut kit, "angle", "base:top", Some("over@>X"))["angle_deg"],
        90.0
    );
    point(
        &ask(&mut kit, "centre", "over:bottom", None)["centre_mm"],
        [25.0, 25.0, 35.0],
    );
}

#[test]
fn cylinders_and_slanted_parts_are_measured() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part(
        "a",
        "plate",
        "base_frame.rect_plate",
        json!({"length": 100, "width": 60, "thickness": 10}),
    );
    kit.part(
        "a",
        "rod",
        "base_frame.stepped_shaft",
        json!({"segments": [{"d": 20, "length": 50}]}),
    );
    kit.part("a", "block", "test.block", json!({"size": 10}));
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "face_to_face",
        "base": "plate:top_face", "incoming": "rod:end_face_start", "d_n_mm": 2,
    }));
    // Beside the rod, turned by 30 degrees about the plate's normal.
    kit.mate(json!({
        "assembly": "a", "id": "n", "mate_type": "face_to_face",
        "base": "plate:top_face", "incoming": "block:bottom", "u_mm": 30, "alpha_deg": 30,
    }));
    let rod = kit.ok(
        "measure",
        json!({"assembly": "a", "what": "mass", "of": "rod"}),
    );
    // Chamfers, where the factory makes them, would show here.
    assert!(near(&rod["volume_mm3"], 5000.0 * PI, 1e-5), "{rod}");
    assert!(near(&rod["mass_kg"], 5000.0 * PI * 7850e-9, 1e-6));
    assert!(near(
        &ask(&mut kit, "distance", "rod", Some("plate"))["distance_mm"],
        2.0,
        1e-6
    ));
    // The block's edges are turned by 30 degrees: its box is 10 (cos 30 + sin 30) wide, and so far apart
    // are its normals from the plate's.
    let half = 5.0 * (3.0_f64.sqrt() / 2.0 + 0.5);
    let found = ask(&mut kit, "box", "block", None);
    assert!(near(&found["box_min_mm"][0], 30.0 - half, 1e-6), "{found}");
    assert!(near(&found["box_max_mm"][1], half, 1e-6), "{found}");
    let angle = ask(&mut kit, "angle", "block@>X", Some("plate@>X"));
    let lines = angle["lines_angle_deg"].as_f64().unwrap();
    assert!(
        (lines - 30.0).abs() < 1e-6 || (lines - 60.0).abs() < 1e-6,
        "{angle}"
    );
    // A cylinder's axis has no sense.
    let axis = ask(&mut kit, "angle", "rod@%CYLINDER", Some("plate:top_face"));
    assert_eq!(axis["angle_deg"], 0.0);
    assert!(axis["how"].as_str().unwrap().contains("no sense"));
    // The rod's wall is 10 from its axis: the plate's side at x = 50 is 40 off.
    let wall = ask(&mut kit, "distance", "rod@%CYLINDER", Some("plate@>X"));
    assert!(
        near(&wall["distance_mm"], (40.0_f64 * 40.0 + 4.0).sqrt(), 1e-6),
        "{wall}"
    );
}

#[test]
fn the_centre_of_an_angle_is_that_of_its_two_legs() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    // Two blocks in an L: 30 mm and, on its top's corner side, 10 mm.
    for (part, size) in [("base", 30), ("on", 10)] {
        kit.part("a", part, "test.block", json!({"size": size}));
    }
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "face_to_face",
        "base": "base:top", "incoming": "on:bottom", "u_mm": 10,
    }));
    // By hand: 27000 mm3 at (15, 15, 15) and 1000 mm3 at (25, 15, 35).
    let whole = kit.ok("measure", json!({"assembly": "a", "what": "centre"}));
    point(
        &whole["centre_mm"],
        [
            (27.0 * 15.0 + 25.0) / 28.0,
            15.0,
            (27.0 * 15.0 + 35.0) / 28.0,
        ]
        .map(|x: f64| (x * 1e6).round() / 1e6),
    );
    let bounds = kit.ok("measure", json!({"assembly": "a", "what": "box"}));
    point(&bounds["box_max_mm"], [30.0, 30.0, 40.0]);
    let mass = kit.ok(
        "measure",
        json!({"assembly": "a", "what": "mass", "density_kg_m3": 1000}),
    );
    assert!(near(&mass["mass_kg"], 0.028, 1e-9));
}

#[test]
fn what_has_no_measure_is_refused_with_what_would() {
    let mut kit = blocks();
    let mut refused = |call: Value| {
        let mut whole = json!({"assembly": "a"});
        whole
            .as_object_mut()
            .unwrap()
            .extend(call.as_object().unwrap().clone());
        let d = kit.refusal("measure", whole);
        (
            d["code"].as_str().unwrap().to_owned(),
            d["where"].as_str().unwrap().to_owned(),
        )
    };
    let is = |code: &str, place: &str| (code.to_owned(), place.to_owned());
    assert_eq!(
        refused(json!({"what": "distance", "of": "base"})),
        is("argument_invalid", "to")
    );
    assert_eq!(
        refused(json!({"what": "angle", "to": "base"})),
        is("argument_invalid", "of")
    );
    assert_eq!(
        refused(json!({"what": "mass", "of": "base", "to": "on"})),
        is("argument_invalid", "to")
    );
    assert_eq!(
        refused(json!({"what": "mass", "of": "bass"})),
        is("part_unknown", "of")
    );
    assert_eq!(
        refused(json!({"what": "mass", "of": "lost"})),
        is("unconnected", "of")
    );
    assert_eq!(
        refused(json!({"what": "mass"})),
        is("indeterminate", "assembly")
    );
    assert_eq!(
        refused(json!({"what": "mass", "of": "base@>Z"})),
        is("argument_invalid", "of")
    );
    assert_eq!(
        refused(json!({"what": "box", "of": "base:top"})),
        is("argument_invalid", "of")
    );
    assert_eq!(
        refused(json!({"what": "centre", "of": "base:tops"})),
        is("port_unknown", "of")
    );
    assert_eq!(
        refused(json!({"what": "centre", "of": "base@>Q"})),
        is("argument_invalid", "of")
    );
    assert_eq!(
        refused(json!({"what": "centre", "of": "base@%TORUS"})).0,
        "kernel_failed"
    );
    assert_eq!(
        refused(json!({"what": "angle", "of": "base", "to": "on@>Z"})),
        is("argument_invalid", "of")
    );
    assert_eq!(
        refused(json!({"what": "angle", "of": "base@|Z", "to": "on@>Z"})),
        is("argument_invalid", "of")
    );
    assert_eq!(
        refused(json!({"what": "distance", "of": "base:top", "to": "on"})),
        is("argument_invalid", "to")
    );
    assert_eq!(
        refused(json!({"what": "mass", "of": "on", "density_kg_m3": 0})),
        is("argument_invalid", "density_kg_m3")
    );
    kit.new_assembly("empty");
    let d = kit.refusal("measure", json!({"assembly": "empty", "what": "mass"}));
    assert_eq!(d["code"], "assembly_empty");
}
