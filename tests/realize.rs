//! Drafts realised: one text and one call, all or nothing.

use serde_json::{Value, json};

use crate::drafts::draft;
use crate::kit::{Kit, near};

const STAGES: [&str; 7] = [
    "validate",
    "resolve_factories",
    "build_parts",
    "check_ports",
    "place",
    "verify",
    "export",
];

/// The verdicts of the stages; null where one was not reached.
fn verdicts(answer: &Value) -> Vec<&str> {
    let stages = answer["stages"].as_array().unwrap();
    let names: Vec<&str> = stages
        .iter()
        .map(|s| s["stage"].as_str().unwrap())
        .collect();
    assert_eq!(names, STAGES);
    stages
        .iter()
        .map(|s| {
            assert_eq!(s.get("elapsed_ms").is_some(), s.get("verdict").is_some());
            s["verdict"].as_str().unwrap_or("-")
        })
        .collect()
}

fn findings(answer: &Value) -> Vec<Value> {
    let found = answer["stages"][5]["findings"].as_array();
    found.cloned().unwrap_or_default()
}

#[test]
fn one_call_makes_what_many_calls_make() {
    let mut kit = Kit::new();
    kit.whole_stand("stand");
    let by_calls = kit.ok("export_step", json!({"assembly": "stand"}));
    let calls_yaml = std::fs::read_to_string(kit.file("assemblies/stand/assembly.yaml")).unwrap();
    kit.ok("verify", json!({"assembly": "stand"}));
    let calls_report = std::fs::read(kit.file("assemblies/stand/report.json")).unwrap();

    // The stored form is a draft itself.
    let mut other = Kit::new();
    let answer = other.ok("realize", json!({"draft": calls_yaml}));
    assert_eq!(answer["realized"], true, "{answer}");
    assert_eq!(answer["replaced"], false);
    let v = verdicts(&answer);
    assert!(!v.contains(&"fail") && !v.contains(&"-"), "{v:?}");
    assert_eq!(answer["step_sha256"], by_calls["sha256"]);
    let read = |name: &str| std::fs::read(other.file(&format!("assemblies/stand/{name}"))).unwrap();
    assert_eq!(read("assembly.yaml"), calls_yaml.as_bytes());
    // Times are in the answer and in nothing that is stored.
    let differing = |a: &[u8], b: &[u8]| {
        let (a, b) = (String::from_utf8_lossy(a), String::from_utf8_lossy(b));
        let mut lines = a.lines().zip(b.lines());
        lines
            .find(|(a, b)| a != b)
            .map(|(a, b)| format!("{a}\n{b}"))
    };
    assert_eq!(differing(&read("report.json"), &calls_report), None);
    assert_eq!(read("report.json").len(), calls_report.len());
    // The report names the STEP file, and the file its specification and recipes.
    let report: Value = serde_json::from_slice(&calls_report).unwrap();
    assert_eq!(report["step"]["sha256"], by_calls["sha256"]);
    let step = String::from_utf8(read("stand.step"))
        .unwrap()
        .replace('\n', "");
    assert!(step.contains(report["specification_sha256"].as_str().unwrap()));
    for line in report["bill_of_materials"].as_array().unwrap() {
        assert!(
            step.contains(line["recipe_sha256"].as_str().unwrap()),
            "{line}"
        );
    }
    let before = other.files();
    let again = other.ok("realize", json!({"draft": calls_yaml}));
    assert_eq!(again["replaced"], false);
    assert_eq!(other.files(), before);
}

#[test]
fn what_fails_leaves_the_assembly_as_it_was() {
    let mut kit = Kit::new();
    let good = draft("good_stand");
    assert_eq!(kit.ok("realize", json!({"draft": good}))["realized"], true);
    let before = kit.files();

    let invalid = good.replace("top_face", "topp_face");
    let answer = kit.ok("realize", json!({"draft": invalid}));
    assert_eq!(verdicts(&answer), ["fail", "-", "-", "-", "-", "-", "-"]);
    assert_eq!(
        answer["stages"][0]["diagnostics"][0]["code"],
        "port_unknown"
    );
    assert_eq!(
        (&answer["realized"], &answer["verdict"]),
        (&json!(false), &json!("fail"))
    );

    // A part that the kernel cannot make.
    let unbuildable = "
assembly:
  id: good_stand
  parts:
    - {id: a, factory: test.impossible_fillet}
";
    let answer = kit.ok("realize", json!({"draft": unbuildable}));
    assert_eq!(
        verdicts(&answer),
        ["pass", "pass", "fail", "-", "-", "-", "-"]
    );
    assert_eq!(
        answer["stages"][2]["diagnostics"][0]["code"],
        "kernel_failed"
    );
    assert_eq!(kit.files(), before);

    // A shaft pushed into the plate: 60 mm of it (segment 1) lie along y through the bearing at z = 55;
    // a block turned upside down instead overlaps the plate by all of its volume beneath the top.
    let clash = good.replace(
        "incoming: {ref: block, port: bottom_face}\n      options: {bond: welded}",
        "incoming: {ref: block, port: bottom_face}\n      options: {d_n_mm: -5, bond: welded}",
    );
    let answer = kit.ok("realize", json!({"draft": clash}));
    let v = verdicts(&answer);
    assert_eq!((v[5], v[6]), ("fail", "-"), "{v:?}");
    assert_eq!(answer["realized"], false);
    let found = findings(&answer);
    let clash_found = found
        .iter()
        .find(|f| f["diagnostic"]["code"] == "clash")
        .unwrap();
    // The block's lowest 5 mm, 80 by 40, lie in the plate.
    assert!(
        near(&clash_found["values"]["common_volume_mm3"], 16000.0, 0.01),
        "{clash_found}"
    );
    assert_eq!(kit.files(), before);

    let answer = kit.ok("realize", json!({"draft": clash, "keep_failed": true}));
    assert_eq!(
        (&answer["realized"], &answer["replaced"]),
        (&json!(true), &json!(true))
    );
    assert_eq!(answer["verdict"], "fail");
    assert_ne!(kit.files(), before);
    let stored = kit.ok("export_step", json!({"assembly": "good_stand"}));
    assert_eq!(
        (&stored["verified"], &stored["sha256"]),
        (&json!("fail"), &answer["step_sha256"])
    );
}

#[test]
fn short_names_are_written_out() {
    let mut kit = Kit::new();
    let answer = kit.ok("realize", json!({"draft": draft("good_short_names")}));
    assert_eq!(answer["realized"], true, "{answer}");
    let path = kit.file("assemblies/good_short_names/assembly.yaml");
    let text = std::fs::read_to_string(path).unwrap();
    assert!(text.contains("factory: base_frame.rect_plate\n"), "{text}");
    // By calls too, and the second time is the same part.
    kit.new_assembly("a");
    for changed in [true, false] {
        let answer = kit.part("a", "p", "rect_plate", json!({"length": 100}));
        assert_eq!(answer["changed"], changed);
    }
}

#[test]
fn axioms_and_notes_are_carried_to_report_and_file() {
    let mut kit = Kit::new();
    assert_eq!(
        kit.ok("realize", json!({"draft": draft("good_stand")}))["realized"],
        true
    );
    let report = std::fs::read(kit.file("assemblies/good_stand/report.json")).unwrap();
    let report: Value = serde_json::from_slice(&report).unwrap();
    assert_eq!(report["mates"][3]["axioms"], json!(["C-02", "P-01"]));
    let answer = kit.ok("realize", json!({"draft": draft("good_everything")}));
    assert_eq!(answer["realized"], true, "{answer}");
    let path = kit.file("assemblies/good_everything/assembly.yaml");
    assert_eq!(
        std::fs::read_to_string(path).unwrap(),
        "format: 1
assembly:
  id: good_everything
  description: \"All that a specification may hold\"
  notes: \"Reasons may take\\nseveral lines.\\n\"
  root: block
  intended_mobility: 3
  intended_motions:
    - part: plate
      slides_along: x
    - part: plate
      slides_along: \"y\"
    - part: plate
      turns_about: z
  free:
    - part: plate
      slides_along: z
      reason: \"it lies on the block\"
  accept:
    - axiom: N-02
      parts: [block]
      reason: \"a thin wall is meant\"
  parts:
    - id: plate
      factory: base_frame.rect_plate
      params: {length: 250, width: 120.5, thickness: 15.0}
      notes: \"the base\"
    - id: block
      factory: base_frame.housing_block
      params: {}
  mates:
    - id: m
      mate_type: face_to_face
      base: {ref: plate, port: top_face}
      incoming: {ref: block, port: bottom_face}
      options: {u_mm: 10, v_mm: -5.25, d_n_mm: 0, alpha_deg: 90}
      axioms: [C-01, F-03]
      notes: \"the block stands across\"
"
    );
}

#[test]
fn the_papers_gear_reducer_loads_and_what_is_wrong_with_it_is_told() {
    let mut kit = Kit::new();
    let text = draft("warn_paper_gear_reducer");
    let answer = kit.ok("realize", json!({"draft": text, "keep_failed": true}));
    // It loads, builds and is placed as it is written.
    let v = verdicts(&answer);
    assert_eq!(
        (v[0], v[1], v[2], v[4]),
        ("pass", "pass", "pass", "pass"),
        "{v:?}"
    );
    assert_eq!(answer["realized"], true);
    // As a machine: the input gear is on no shaft, and nothing but its teeth holds the output gear.
    let told = answer["stages"][0]["diagnostics"].as_array().unwrap();
    let told: Vec<(&str, &str)> = told
        .iter()
        .map(|d| (d["code"].as_str().unwrap(), d["where"].as_str().unwrap()))
        .collect();
    assert_eq!(
        told,
        [
            ("unsupported", "line 8, parts[1]"),
            ("unsupported", "line 11, parts[2]")
        ]
    );

    // Mouth on mouth, the input gear stands before the block (from y = 40 to y = 55), on no shaft. The
    // output gear meshes beside it, 2 * (20 + 40) / 2 = 60 mm away.
    let state = answer["state"]["parts"].as_array().unwrap();
    assert_eq!(state[1]["origin_mm"], json!([0.0, 55.0, 30.0]));
    let to = state[2]["origin_mm"].as_array().unwrap();
    let (x, z) = (to[0].as_f64().unwrap(), to[2].as_f64().unwrap() - 30.0);
    assert!((x * x + z * z - 3600.0).abs() < 1e-3, "{to:?}");

    // Meant inside the housing, as its text has it, the gear (44 mm over its tips) sits in solid metal
    // around a bore of 25 mm: the clash is found, and nothing is stored.
    let inside = text.replace("gear_reducer_v1", "inside").replace(
        "port: bore}\n",
        "port: bore}\n      options: {direction: same}\n",
    );
    let answer = kit.ok("realize", json!({"draft": inside}));
    assert_eq!(
        (&answer["realized"], &answer["verdict"]),
        (&json!(false), &json!("fail"))
    );
    let found = findings(&answer);
    let clash = found
        .iter()
        .find(|f| {
            f["diagnostic"]["code"] == "clash" && f["parts"] == json!(["housing", "input_gear"])
        })
        .unwrap();
    // Between bore and root circle (35 mm) it is all metal, outside the tips there is none.
    let ring = |d: f64| std::f64::consts::PI / 4.0 * (d * d - 25.0 * 25.0) * 15.0;
    let common = clash["values"]["common_volume_mm3"].as_f64().unwrap();
    assert!(ring(35.0) < common && common < ring(44.0), "{common}");
    assert!(!kit.file("assemblies/inside/assembly.yaml").exists());
}
