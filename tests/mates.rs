//! The mates over the real protocol: what each places, allows and promises.

use core::f64::consts::PI;

use serde_json::{Value, json};

use crate::kit::{Kit, codes, near};

/// What the geometric checks found: most of these pairs of parts are no machines, and the axioms say so.
fn codes_of(report: &Value) -> Vec<(String, String)> {
    let all = report["findings"].as_array().unwrap();
    all.iter()
        .filter(|f| f["check"] != "axioms" && f["verdict"] != "pass")
        .map(|f| {
            let text = |v: &Value| v.as_str().unwrap().to_owned();
            (text(&f["check"]), text(&f["diagnostic"]["code"]))
        })
        .collect()
}

fn pair<'a>(report: &'a Value, a: &str, b: &str) -> &'a Value {
    let pairs = report["measured"]["pairs"].as_array().unwrap();
    pairs.iter().find(|p| p["a"] == a && p["b"] == b).unwrap()
}

fn mate<'a>(report: &'a Value, id: &str) -> &'a Value {
    let mates = report["measured"]["mates"].as_array().unwrap();
    mates.iter().find(|m| m["mate"] == id).unwrap()
}

fn full(kit: &mut Kit, assembly: &str) -> Value {
    kit.ok("verify", json!({"assembly": assembly, "detail": "full"}))
}

/// A cover on a tapped block, and a screw through the one in the other.
fn screwed() -> Kit {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "block", "test.tapped", json!({}));
    kit.part("a", "cover", "test.cover", json!({}));
    kit.part("a", "screw", "test.screw", json!({}));
    kit.mate(json!({
        "assembly": "a", "id": "lid", "mate_type": "coaxial_face",
        "base": "block:top", "incoming": "cover:bottom",
    }));
    kit.mate(json!({
        "assembly": "a", "id": "head", "mate_type": "coaxial_face",
        "base": "cover:seat", "incoming": "screw:seat",
    }));
    kit
}

fn thread(depth: f64) -> Value {
    json!({
        "assembly": "a", "id": "thread", "mate_type": "thread_engage",
        "base": "block:thread", "incoming": "screw:thread", "d_t_mm": depth,
    })
}

#[test]
fn a_screw_in_its_counterbore_and_thread() {
    let mut kit = screwed();
    // Without the thread's mate the screw overlaps the block: pi/4 (6^2 - 5^2) over 20 - 13 mm.
    let ring = PI / 4.0 * 11.0 * 7.0;
    let report = full(&mut kit, "a");
    assert_eq!(
        codes_of(&report),
        [("interference".to_owned(), "clash".to_owned())]
    );
    assert!(near(
        &pair(&report, "block", "screw")["common_volume_mm3"],
        ring,
        1e-4
    ));
    // The seats are rings: of the head on the floor (10 on 6.6), of the cover on the block (40 x 40 less
    // the clearance hole, which is wider than the tap drill).
    let area = |id: &str| mate(&report, id)["contact_area_mm2"].clone();
    assert!(
        near(&area("head"), PI * (25.0 - 3.3 * 3.3), 1e-4),
        "{}",
        area("head")
    );
    assert!(
        near(&area("lid"), 1600.0 - PI * 3.3 * 3.3, 1e-4),
        "{}",
        area("lid")
    );
    // The thread closes the loop where the screw really ends, and nowhere else.
    let d = kit.refusal("mate", thread(6.0));
    assert_eq!(d["code"], "mate_residual");
    assert!(near(&d["found"]["distance_mm"], 1.0, 1e-6), "{d}");
    kit.mate(thread(7.0));
    let report = full(&mut kit, "a");
    assert_eq!(report["verdict"], "pass");
    assert_eq!(codes_of(&report), []);
    let pair = pair(&report, "block", "screw");
    assert_eq!(pair["class"], "expected");
    assert!(near(&pair["allowed_mm3"], ring, 1e-5), "{pair}");
    assert_eq!(mate(&report, "thread")["contact"], "pass");
}

#[test]
fn threads_that_differ_are_refused() {
    let mut kit = screwed();
    kit.part(
        "a",
        "left",
        "test.screw",
        json!({"hand": "left", "pitch": 0.75}),
    );
    let found = kit.refused(
        "mate",
        json!({
            "assembly": "a", "id": "t", "mate_type": "thread_engage",
            "base": "block:thread", "incoming": "left:thread", "d_t_mm": 16,
        }),
    );
    // Pitch, hand, and a hole of 15 mm.
    assert_eq!(codes(&found), ["mate_incompatible"; 3]);
    let d = kit.refusal(
        "mate",
        json!({
            "assembly": "a", "id": "t", "mate_type": "gear_mesh",
            "base": "block:thread", "incoming": "left:thread",
        }),
    );
    assert_eq!(
        d["found"],
        json!(["gear_mesh", "THREAD_INTERNAL", "THREAD_EXTERNAL"])
    );
}

#[test]
fn a_press_fit_overlaps_by_its_ring() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part(
        "a",
        "block",
        "base_frame.housing_block",
        json!({"bore_d": 20}),
    );
    let shaft = json!({"segments": [{"d": 20.01, "length": 60}]});
    kit.part("a", "pin", "base_frame.stepped_shaft", shaft);
    let call = |mate_type: &str, at: f64| {
        json!({
            "assembly": "a", "id": "p", "mate_type": mate_type, "d_mm": at,
            "base": "block:bore_port", "incoming": "pin:shaft_seat_1",
        })
    };
    assert_eq!(
        kit.refusal("mate", call("coaxial", -20.0))["code"],
        "mate_incompatible"
    );
    assert_eq!(
        kit.refusal("mate", call("press_fit", 31.0))["code"],
        "mate_incompatible"
    );
    // The block is 40 mm deep and the pin 60 mm long: pi/4 (20.01^2 - 20^2) over 40 mm.
    kit.mate(call("press_fit", -20.0));
    let report = full(&mut kit, "a");
    assert_eq!(
        (&report["verdict"], &report["findings"]),
        (&json!("pass"), &json!([]))
    );
    let pair = pair(&report, "block", "pin");
    assert_eq!(pair["class"], "expected");
    assert!(
        near(&pair["common_volume_mm3"], PI * 0.4001 * 10.0, 1e-3),
        "{pair}"
    );
    assert!(near(&mate(&report, "p")["radial_play_mm"], -0.005, 1e-6));
}

#[test]
fn faces_that_share_only_an_edge_do_not_touch() {
    for (shift, area) in [
        (0.0, Some(100.0)),
        (14.0, Some(10.0)),
        (15.0, None),
        (16.0, None),
    ] {
        let mut kit = Kit::new();
        kit.new_assembly("a");
        kit.part("a", "base", "test.block", json!({"size": 20}));
        kit.part("a", "top", "test.block", json!({"size": 10}));
        kit.mate(json!({
            "assembly": "a", "id": "m", "mate_type": "face_to_face",
            "base": "base:top", "incoming": "top:bottom", "u_mm": shift,
        }));
        kit.intent("a", json!({"free": [{"part": "top"}]}));
        let report = full(&mut kit, "a");
        let found = codes_of(&report);
        match area {
            Some(area) => {
                assert_eq!(found, []);
                assert!(near(&mate(&report, "m")["contact_area_mm2"], area, 1e-6));
            }
            None => {
                // What touches nothing does not lie loose either, whatever is stated.
                assert_eq!(
                    found,
                    [
                        ("contact".to_owned(), "contact_missing".to_owned()),
                        ("holding".to_owned(), "not_held".to_owned())
                    ]
                );
                assert_eq!(mate(&report, "m")["contact"], "fail");
            }
        }
    }
}

#[test]
fn a_shaft_pulled_out_of_its_bearing_is_found() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "bearing", "bearing.ball", json!({}));
    kit.part("a", "shaft", "base_frame.stepped_shaft", json!({}));
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "coaxial", "d_mm": 100,
        "base": "bearing:inner_ring", "incoming": "shaft:shaft_seat_1",
    }));
    kit.intent("a", json!({"free": [{"part": "shaft"}]}));
    assert_eq!(
        codes_of(&full(&mut kit, "a")),
        [
            ("contact".to_owned(), "contact_missing".to_owned()),
            ("holding".to_owned(), "not_held".to_owned())
        ]
    );
}

#[test]
fn a_corner_of_a_face() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "base", "test.block", json!({"size": 20}));
    kit.part("a", "top", "test.block", json!({"size": 10}));
    kit.mate(json!({
        "assembly": "a", "id": "m", "mate_type": "snap_to_face",
        "base": "base:top", "incoming": "top:bottom", "u": 0.25, "v": 0.75, "bond": "glued",
    }));
    let report = full(&mut kit, "a");
    assert_eq!(codes_of(&report), []);
    assert!(near(&mate(&report, "m")["contact_area_mm2"], 100.0, 1e-6));
    let part = &report["measured"]["parts"][1];
    // The middle of a cube of 10 mm over the point (5, 15) of one of 20.
    assert_eq!(part["centre_mm"], json!([5.0, 15.0, 25.0]));
}

#[test]
fn gears_mesh_tooth_in_gap_for_all_parities() {
    for (one, two, angle, backlash) in [
        (18, 24, 0.0, 0.0),
        (18, 25, 33.0, 0.1),
        (19, 24, 90.0, 0.0),
        (19, 25, -70.0, 0.0),
    ] {
        let mut kit = Kit::new();
        kit.new_assembly("a");
        let gear = |teeth: i32| json!({"teeth": teeth, "width": 5});
        kit.part("a", "one", "gear.spur", gear(one));
        kit.part("a", "two", "gear.spur", gear(two));
        let call = |incoming: &str, module: f64| {
            json!({
                "assembly": "a", "id": "m", "mate_type": "gear_mesh", "angle_deg": angle, "m": module,
                "base": "one:mesh_point", "incoming": incoming, "backlash_mm": backlash,
            })
        };
        assert_eq!(
            kit.refusal("mate", call("two:mesh_point", 2.5))["found"],
            2.5
        );
        assert_eq!(
            kit.refusal("mate", call("two:bore", 2.0))["where"],
            "mate_type"
        );
        kit.mate(call("two:mesh_point", 2.0));
        kit.intent("a", json!({"free": [{"part": "two"}]}));
        let report = full(&mut kit, "a");
        assert_eq!(codes_of(&report), [], "{report}");
        assert_eq!(mate(&report, "m")["contact"], "pass");
    }
}
