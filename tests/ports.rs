//! Ports over the real protocol: solids that do not show what their ports promise are found.

use serde_json::{Value, json};

use crate::kit::Kit;

/// The findings of the check `ports` of a verification.
fn of_ports(report: &Value) -> Vec<Value> {
    let all = report["findings"].as_array().unwrap();
    let own = all.iter().filter(|f| f["check"] == "ports");
    own.cloned().collect()
}

fn check<'a>(report: &'a Value, name: &str) -> &'a Value {
    let all = report["checks"].as_array().unwrap();
    all.iter().find(|c| c["check"] == name).unwrap()
}

#[test]
fn the_ports_of_every_factory_are_there() {
    let mut kit = Kit::new();
    kit.new_assembly("all");
    let listed = kit.ok("list_factories", json!({}));
    let names: Vec<String> = listed["factories"]
        .as_array()
        .unwrap()
        .iter()
        .map(|f| f["factory"].as_str().unwrap().to_owned())
        .filter(|n| {
            !n.starts_with("test.")
                || ["test.screw", "test.cover", "test.tapped"].contains(&n.as_str())
        })
        .collect();
    assert!(names.len() >= 7, "{names:?}");
    for (i, name) in names.iter().enumerate() {
        kit.part("all", &format!("part_{i}"), name, json!({}));
    }
    let report = kit.ok("verify", json!({"assembly": "all"}));
    assert_eq!(of_ports(&report), Vec::<Value>::new());
    let ports = check(&report, "ports");
    assert_eq!(ports["verdict"], "pass");
    assert!(ports["cases"].as_u64().unwrap() > 20, "{ports}");
}

#[test]
fn a_phantom_hole_and_one_of_the_wrong_size_are_found() {
    let mut kit = Kit::new();
    for (params, found) in [
        (json!({"tap": false}), "no cylinder face is about this axis"),
        (
            json!({"drill": 4.9}),
            "the cylinder about this axis is one of diameter 4.9000 mm",
        ),
        (
            json!({"drill": 5.001}),
            "the cylinder about this axis is one of diameter 5.0010 mm",
        ),
    ] {
        kit.new_assembly("a");
        kit.part("a", "block", "test.tapped", params);
        let report = kit.ok("verify", json!({"assembly": "a", "detail": "full"}));
        assert_eq!(report["verdict"], "fail");
        let findings = of_ports(&report);
        assert_eq!(findings.len(), 1, "{findings:?}");
        let f = &findings[0];
        assert_eq!(f["diagnostic"]["code"], "port_evidence");
        assert_eq!(f["diagnostic"]["where"], "part 'block', port 'thread'");
        assert_eq!(f["values"]["port"], "thread");
        assert_eq!(
            f["values"]["first_failed"][0]["shows"],
            "the wall of the hole"
        );
        assert_eq!(f["values"]["first_failed"][0]["found"], *found);
        assert_eq!(
            f["values"]["first_failed"][0]["at_mm"],
            json!([0.0, 0.0, 20.0])
        );
        kit.ok(
            "remove",
            json!({"assembly": "a", "kind": "part", "name": "block"}),
        );
    }
}

#[test]
fn a_seat_a_hundredth_off_is_found() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "cover", "test.cover", json!({"seat_lift": 0.01}));
    let report = kit.ok("verify", json!({"assembly": "a", "detail": "full"}));
    let findings = of_ports(&report);
    assert_eq!(findings.len(), 1, "{findings:?}");
    let told = findings[0]["values"]["first_failed"].to_string();
    assert!(
        told.contains("the nearest plane face with this normal is 0.0100 mm off"),
        "{told}"
    );
}

#[test]
fn gears_of_other_thickness_show_their_teeth() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    for (name, params) in [
        ("wide", json!({"teeth": 12, "profile_shift": 0.6})),
        ("narrow", json!({"teeth": 30, "profile_shift": -0.3})),
        ("thin", json!({"backlash_mm": 0.6})),
    ] {
        kit.part("a", name, "gear.spur", params);
    }
    let report = kit.ok("verify", json!({"assembly": "a"}));
    assert_eq!(of_ports(&report), Vec::<Value>::new());
}
