//! Overlaps, gaps and contacts that have a closed form, down to a micrometre.

use std::f64::consts::PI;

use serde_json::{Value, json};

use crate::kit::{Kit, near};

/// Two bodies of `test.body` on a plate, 20 mm less `h` apart along x.
fn beside(kit: &mut Kit, shape: &str, h: f64) {
    kit.new_assembly("a");
    let plate = json!({"length": 200, "width": 100});
    kit.part("a", "plate", "base_frame.rect_plate", plate);
    for (part, u) in [("left", 0.0), ("right", 20.0 - h)] {
        kit.part("a", part, "test.body", json!({"shape": shape}));
        kit.mate(json!({
            "assembly": "a", "id": part, "mate_type": "face_to_face",
            "base": "plate:top_face", "incoming": format!("{part}:foot"), "u_mm": u, "bond": "glued",
        }));
    }
}

/// The report of a verification; the assembly is taken away again.
fn verified(kit: &mut Kit, more: Value) -> Value {
    let mut call = json!({"assembly": "a", "detail": "full"});
    for (key, value) in more.as_object().unwrap() {
        call[key] = value.clone();
    }
    kit.ok("verify", call)
}

fn start_anew(kit: &mut Kit) {
    std::fs::remove_dir_all(kit.file("assemblies/a")).unwrap();
}

fn of_check<'a>(report: &'a Value, check: &str) -> Vec<&'a Value> {
    let all = report["findings"].as_array().unwrap();
    all.iter().filter(|f| f["check"] == check).collect()
}

/// What two bodies of radius or half width 10 have in common that are `h` into each other.
fn common(shape: &str, h: f64) -> f64 {
    let (r, d) = (10.0, 20.0 - h);
    match shape {
        "box" => 20.0 * 20.0 * h,
        // The lens of two circles, times the height. For small h its area is 4/3 sqrt(r) h^1.5, which
        // does not cancel; the next term is smaller by 3 h / (20 r).
        "cylinder" if h < 0.1 => 20.0 * 4.0 / 3.0 * libm::sqrt(r) * libm::pow(h, 1.5),
        "cylinder" => {
            let half = d / 2.0;
            20.0 * (2.0 * r * r * libm::acos(half / r) - d * libm::sqrt(r * r - half * half))
        }
        // Two caps of the height h / 2.
        _ => {
            let cap = h / 2.0;
            2.0 * PI * cap * cap * (3.0 * r - cap) / 3.0
        }
    }
}

#[test]
fn overlaps_are_found_down_to_a_micrometre() {
    let mut kit = Kit::new();
    for shape in ["box", "cylinder", "ball"] {
        for h in [1.0, 0.01, 0.001] {
            beside(&mut kit, shape, h);
            let report = verified(&mut kit, json!({"tau_mm3": 1e-6}));
            let found = of_check(&report, "interference");
            assert_eq!(found.len(), 1, "{shape} {h}: {found:?}");
            let values = &found[0]["values"];
            let wanted = common(shape, h);
            // Reported to a millionth.
            let tolerance = 1e-3 * wanted + 1e-6;
            assert!(
                near(&values["common_volume_mm3"], wanted, tolerance),
                "{shape} {h}: {values} {wanted}"
            );
            // Moved by what they have in common the two are free.
            assert!(
                near(&values["penetration_at_most_mm"], h, 1e-5 + 1e-3 * h),
                "{shape} {h}: {values}"
            );
            start_anew(&mut kit);
        }
    }
}

#[test]
fn what_only_touches_is_not_reported() {
    let mut kit = Kit::new();
    for shape in ["box", "cylinder", "ball"] {
        beside(&mut kit, shape, 0.0);
        let report = verified(&mut kit, json!({"tau_mm3": 1e-6, "clearance_mm": 0.5}));
        assert_eq!(report["findings"], json!([]), "{shape}");
        assert_eq!(report["measured"]["near_misses"], json!([]), "{shape}");
        start_anew(&mut kit);
    }
}

#[test]
fn near_misses_are_told_where_they_are_asked_for() {
    let mut kit = Kit::new();
    for shape in ["box", "cylinder", "ball"] {
        beside(&mut kit, shape, -0.05);
        let quiet = verified(&mut kit, json!({}));
        assert_eq!(of_check(&quiet, "clearance").len(), 0);
        let open = quiet["not_checked"].as_array().unwrap();
        assert!(
            open.iter()
                .any(|w| w.as_str().unwrap().starts_with("clearance"))
        );
        let less = verified(&mut kit, json!({"clearance_mm": 0.04}));
        assert_eq!(less["measured"]["near_misses"], json!([]));
        let report = verified(&mut kit, json!({"clearance_mm": 0.06}));
        let miss = &report["measured"]["near_misses"];
        // The parts that stand on the plate are joined to it, and no near misses.
        assert_eq!(miss.as_array().map(Vec::len), Some(1), "{shape}: {miss}");
        assert!(near(&miss[0]["distance_mm"], 0.05, 2e-6), "{shape}: {miss}");
        let found = of_check(&report, "clearance");
        assert_eq!(found[0]["diagnostic"]["code"], "near_miss");
        // A warning: nothing says how much it should be.
        assert_eq!(
            (&found[0]["verdict"], &report["verdict"]),
            (&json!("pass"), &quiet["verdict"])
        );
        start_anew(&mut kit);
    }
}

#[test]
fn the_way_out_is_one_that_leads_out() {
    // Two bars that cross: 10 x 10 mm of each lie in the other over 20 mm of height. Along either bar there
    // is no way out by 10 mm; upwards there is, by 20.
    let mut kit = Kit::new();
    kit.new_assembly("a");
    let bar = json!({"length": 100, "width": 10, "thickness": 20});
    for part in ["one", "two"] {
        kit.part("a", part, "base_frame.rect_plate", bar.clone());
    }
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "face_to_face", "base": "one:top_face",
        "incoming": "two:bottom_face", "d_n_mm": -20, "alpha_deg": 90,
    }));
    let report = verified(&mut kit, json!({}));
    let values = &of_check(&report, "interference")[0]["values"];
    assert!(near(&values["common_volume_mm3"], 2000.0, 1e-6), "{values}");
    assert!(
        near(&values["penetration_at_most_mm"], 20.0, 1e-5),
        "{values}"
    );
    let along = values["second_part_comes_free_along"].as_array().unwrap();
    assert!(
        near(&along[2].as_f64().unwrap().abs().into(), 1.0, 1e-9),
        "{along:?}"
    );
}

#[test]
fn the_same_part_twice_in_one_place_is_told_as_that() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "base", "test.block", json!({"size": 20}));
    // Turned by a quarter: a cube is the same body then.
    for (part, alpha) in [("one", 0), ("two", 90)] {
        kit.part("a", part, "test.block", json!({"size": 10}));
        kit.mate(json!({
            "assembly": "a", "id": part, "mate_type": "face_to_face", "base": "base:top",
            "incoming": format!("{part}:bottom"), "alpha_deg": alpha, "bond": "glued",
        }));
    }
    let report = verified(&mut kit, json!({}));
    let found = of_check(&report, "interference");
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0]["diagnostic"]["code"], "duplicate");
    assert_eq!(
        (&found[0]["verdict"], &found[0]["parts"]),
        (&json!("fail"), &json!(["one", "two"]))
    );
    // The next calls mend it: the mate away, then the part.
    for _ in 0..2 {
        let report = verified(&mut kit, json!({}));
        let found = report["findings"].as_array().unwrap();
        let next = found
            .iter()
            .find(|f| f["diagnostic"]["code"] == "duplicate");
        let Some(next) = next.map(|f| f["diagnostic"]["next"].clone()) else {
            break;
        };
        kit.ok(next["tool"].as_str().unwrap(), next["arguments"].clone());
    }
    let gone = json!({"assembly": "a", "kind": "part", "name": "two"});
    kit.ok("remove", gone);
    assert_eq!(verified(&mut kit, json!({}))["findings"], json!([]));
    // Two cubes of different sizes in one place are a clash.
    kit.part("a", "three", "test.block", json!({"size": 9}));
    kit.mate(json!({
        "assembly": "a", "id": "three", "mate_type": "face_to_face", "base": "base:top",
        "incoming": "three:bottom",
    }));
    let report = verified(&mut kit, json!({}));
    assert_eq!(
        of_check(&report, "interference")[0]["diagnostic"]["code"],
        "clash"
    );
}

#[test]
fn a_threaded_hole_takes_one_screw_and_a_face_many_parts() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "block", "test.tapped", json!({}));
    for (part, depth) in [("one", 10.0), ("two", 8.0)] {
        kit.part("a", part, "test.screw", json!({}));
        kit.mate(json!({
            "assembly": "a", "id": part, "mate_type": "thread_engage", "base": "block:thread",
            "incoming": format!("{part}:thread"), "d_t_mm": depth,
        }));
    }
    for (part, u) in [("left", -15), ("right", 15)] {
        kit.part("a", part, "test.block", json!({"size": 8}));
        kit.mate(json!({
            "assembly": "a", "id": part, "mate_type": "face_to_face", "base": "block:top",
            "incoming": format!("{part}:bottom"), "u_mm": u,
        }));
    }
    let report = verified(&mut kit, json!({}));
    let found = of_check(&report, "port_use");
    assert_eq!(found.len(), 1, "{found:?}");
    let d = &found[0]["diagnostic"];
    assert_eq!(
        (&d["code"], &d["where"]),
        (&json!("port_overused"), &json!("port 'block:thread'"))
    );
    assert_eq!(
        (&found[0]["verdict"], &found[0]["mates"]),
        (&json!("fail"), &json!(["one", "two"]))
    );
    // The later one goes; what is left is in order.
    assert_eq!(d["next"]["arguments"]["name"], "two");
    kit.ok("remove", d["next"]["arguments"].clone());
    assert_eq!(
        of_check(&verified(&mut kit, json!({})), "port_use").len(),
        0
    );
}

#[test]
fn contact_areas_are_those_of_the_closed_form() {
    let mut kit = Kit::new();
    let area = |report: &Value, id: &str| {
        let mates = report["measured"]["mates"].as_array().unwrap();
        let mate = mates.iter().find(|m| m["mate"] == id).unwrap();
        mate["contact_area_mm2"].clone()
    };
    // A cube of 10 mm over the edge of one of 20 mm: u of the centre from 0 to 15, where only the edge is left.
    for u in [0.0_f64, 5.0, 7.5, 14.999] {
        kit.new_assembly("a");
        kit.part("a", "base", "test.block", json!({"size": 20}));
        kit.part("a", "top", "test.block", json!({"size": 10}));
        kit.mate(json!({
            "assembly": "a", "id": "m", "mate_type": "face_to_face", "base": "base:top",
            "incoming": "top:bottom", "u_mm": u,
        }));
        let wanted = 10.0 * 10.0_f64.min(15.0 - u);
        let found = area(&verified(&mut kit, json!({})), "m");
        assert!(near(&found, wanted, 2e-6), "{u}: {found} {wanted}");
        start_anew(&mut kit);
    }
    // A washer of 16 mm over a hole: the ring outside the larger of the two holes. ISO 7089 for M8: 8.4 mm.
    kit.new_assembly("a");
    let plate = json!({"length": 120, "width": 80, "thickness": 12, "bolt_d": 8, "edge": 15});
    kit.part("a", "plate", "base_frame.rect_plate", plate);
    kit.part("a", "washer", "fastener.washer", json!({"d": 8}));
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "coaxial_face",
        "base": "plate:corner_hole_1", "incoming": "washer:seat",
    }));
    let described = verified(&mut kit, json!({}));
    let found = area(&described, "m").as_f64().unwrap();
    // ISO 273, medium fit: 9 mm for M8.
    let wanted = PI / 4.0 * (16.0 * 16.0 - 9.0 * 9.0);
    assert!((found - wanted).abs() < 1e-5, "{found} {wanted}");
}
