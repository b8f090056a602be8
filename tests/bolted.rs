//! Many instances of a few parts: two plates held together by four bolts with washers and nuts.

use serde_json::json;

use crate::kit::{Kit, near};

const PLATE: &str = "base_frame.rect_plate";

/// Bolt length less washer and both plates: what stands out below the plates, in mm.
const BELOW: f64 = 40.0 - 1.6 - 24.0;

/// Height of an M8 nut by ISO 4032, in mm.
const NUT: f64 = 6.8;

#[test]
fn two_plates_and_four_bolts() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    let plate = json!({"length": 120, "width": 80, "thickness": 12, "bolt_d": 8, "edge": 15});
    kit.part("a", "lower", PLATE, plate.clone());
    kit.part("a", "upper", PLATE, plate);
    let mate = |kit: &mut Kit, id: &str, kind: &str, base: &str, incoming: &str, more| {
        let mut call = json!({
            "assembly": "a", "id": id, "mate_type": kind, "base": base, "incoming": incoming,
        });
        let fields = call.as_object_mut().unwrap();
        let serde_json::Value::Object(more) = more else {
            return;
        };
        fields.extend(more);
        kit.mate(call);
    };
    let none = || json!({});
    mate(
        &mut kit,
        "stack",
        "face_to_face",
        "lower:top_face",
        "upper:bottom_face",
        none(),
    );
    for i in 1..=4 {
        let named = |what: &str| format!("{what}_{i}");
        let at = |part: &str, port: &str| format!("{}:{port}", named(part));
        kit.part("a", &named("washer"), "fastener.washer", json!({"d": 8}));
        kit.part(
            "a",
            &named("bolt"),
            "fastener.bolt",
            json!({"d": 8, "length": 40}),
        );
        kit.part("a", &named("nut"), "fastener.nut", json!({"d": 8}));
        let hole = format!("upper:corner_hole_{i}");
        mate(
            &mut kit,
            &named("w"),
            "coaxial_face",
            &hole,
            &at("washer", "seat"),
            none(),
        );
        let (base, seat) = (at("washer", "hole"), at("bolt", "head_seat"));
        mate(&mut kit, &named("b"), "coaxial_face", &base, &seat, none());
        let hole = format!("lower:corner_hole_back_{i}");
        mate(
            &mut kit,
            &named("n"),
            "coaxial_face",
            &hole,
            &at("nut", "face"),
            none(),
        );
    }
    // What is not said is not meant: four threads that nobody has engaged are clashes, and clamp nothing.
    let report = kit.ok("verify", json!({"assembly": "a", "detail": "full"}));
    assert_eq!(report["verdict"], "fail");
    let findings = report["findings"].as_array().unwrap();
    assert_eq!(findings.len(), 8, "{findings:?}");
    let clashes = findings
        .iter()
        .filter(|f| f["diagnostic"]["code"] == "clash");
    assert_eq!(clashes.clone().count(), 4);
    // Each names the call that engages its thread: the very one that is made by hand below.
    for clash in clashes {
        let next = &clash["diagnostic"]["next"];
        let call = &next["arguments"];
        assert_eq!(
            (&next["tool"], &call["mate_type"]),
            (&json!("mate"), &json!("thread_engage"))
        );
        assert!(near(&call["d_t_mm"], NUT, 1e-6), "{call}");
        assert!(near(&call["through_mm"], BELOW - NUT, 1e-6), "{call}");
    }
    let unclamped = findings
        .iter()
        .filter(|f| f["axioms"][0]["axiom"] == "T-01");
    assert_eq!(unclamped.count(), 4);

    // The nut is placed already: its thread closes a loop, and holds to the last digit.
    for i in 1..=4 {
        let depths = json!({"d_t_mm": NUT, "through_mm": BELOW - NUT});
        let (bolt, nut) = (
            format!("bolt_{i}:thread"),
            format!("nut_{i}:thread_internal"),
        );
        mate(
            &mut kit,
            &format!("t_{i}"),
            "thread_engage",
            &bolt,
            &nut,
            depths,
        );
    }
    let report = kit.ok("verify", json!({"assembly": "a"}));
    assert_eq!(report["verdict"], "pass", "{report}");
    let step = kit.ok("export_step", json!({"assembly": "a"}));
    assert_eq!(
        (&step["products"], &step["instances"]),
        (&json!(4), &json!(14))
    );
}

#[test]
fn every_factory_once_and_three_times_in_one_assembly() {
    let mut kit = Kit::new();
    kit.new_assembly("none");
    let empty = kit.refusal("verify", json!({"assembly": "none"}));
    assert_eq!(empty["code"], "assembly_empty");

    kit.new_assembly("many");
    let names = assemcad_factories::Registry::builtin().names();
    assert_eq!(names.len(), 13);
    for name in &names {
        let mut volumes = Vec::new();
        for i in 1..=3 {
            let short = name.replace('.', "_");
            let made = kit.part("many", &format!("{short}_{i}"), name, json!({}));
            volumes.push(made["volume_mm3"].as_f64().unwrap());
        }
        // One recipe, one solid.
        assert!(
            volumes[0] > 0.0 && volumes.iter().all(|v| *v == volumes[0]),
            "{name}"
        );
    }
    let state = kit.ok("get_assembly", json!({"assembly": "many"}));
    assert_eq!(state["state"]["parts"].as_array().map(Vec::len), Some(39));
    let report = kit.ok("verify", json!({"assembly": "many"}));
    let check = |name: &str| {
        let checks = report["checks"].as_array().unwrap();
        checks.iter().find(|c| c["check"] == name).unwrap().clone()
    };
    assert_eq!(check("parts")["verdict"], "pass", "{report}");
    assert_eq!(check("ports")["verdict"], "pass", "{report}");
    // Thirty-eight of them are nowhere, and that is no assembly.
    assert_eq!(check("connectivity")["verdict"], "fail");
}
