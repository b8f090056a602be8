//! Reports for people: masses, bill of materials, hashes, and pages that say what the report says.

use serde_json::{Value, json};

use crate::kit::{Kit, near};

fn read(kit: &Kit, assembly: &str, name: &str) -> String {
    std::fs::read_to_string(kit.file(&format!("assemblies/{assembly}/{name}"))).unwrap()
}

fn report(kit: &Kit, assembly: &str) -> Value {
    serde_json::from_str(&read(kit, assembly, "report.json")).unwrap()
}

#[test]
fn fasteners_are_called_what_their_standards_call_them() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    // The second of each is none of the standard: a length of none, a width of its own, no thread of a table.
    let parts = [
        (
            "fastener.bolt",
            json!({"d": 8, "length": 40}),
            Some("ISO 4014 - M8 x 40"),
        ),
        (
            "fastener.bolt",
            json!({"d": 8, "length": 30}),
            Some("ISO 4017 - M8 x 30"),
        ),
        ("fastener.bolt", json!({"d": 8, "length": 41}), None),
        ("fastener.bolt", json!({"d": 8, "length": 300}), None),
        (
            "fastener.bolt",
            json!({"d": 8, "length": 40, "thread_length": 30}),
            None,
        ),
        (
            "fastener.bolt",
            json!({"d": 6, "length": 20, "head": "socket"}),
            Some("ISO 4762 - M6 x 20"),
        ),
        ("fastener.nut", json!({"d": 8}), Some("ISO 4032 - M8")),
        ("fastener.nut", json!({"d": 8, "height": 10}), None),
        ("fastener.washer", json!({"d": 8}), Some("ISO 7089 - 8")),
        ("fastener.washer", json!({"d": 8, "d_o": 24}), None),
        // What the standard has, written out.
        (
            "fastener.washer",
            json!({"d": 8, "d_i": 8.4, "d_o": 16, "thickness": 1.6}),
            Some("ISO 7089 - 8"),
        ),
        // A factory of the folder, which may say what it likes.
        ("test.block", json!({}), None),
    ];
    for (i, (factory, params, _)) in parts.iter().enumerate() {
        kit.part("a", &format!("p{i}"), factory, params.clone());
    }
    kit.ok("verify", json!({"assembly": "a"}));
    let report = report(&kit, "a");
    let lines = report["bill_of_materials"].as_array().unwrap();
    for (i, (_, params, wanted)) in parts.iter().enumerate() {
        let name = json!(format!("p{i}"));
        let line = lines
            .iter()
            .find(|l| l["parts"].as_array().unwrap().contains(&name))
            .unwrap();
        assert_eq!(line["designation"], json!(wanted), "{params}");
    }
}

#[test]
fn equal_parts_are_counted_and_masses_add_up() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "base", "test.block", json!({"size": 20}));
    // Written differently, the same part.
    for (part, size, u) in [("one", json!(10), -5), ("two", json!(1e1), 5)] {
        kit.part("a", part, "test.block", json!({"size": size}));
        kit.mate(json!({
            "assembly": "a", "id": part, "mate_type": "face_to_face", "base": "base:top",
            "incoming": format!("{part}:bottom"), "u_mm": u,
        }));
    }
    let answer = kit.ok("verify", json!({"assembly": "a", "density_kg_m3": 1000}));
    let told = report(&kit, "a");
    let lines = told["bill_of_materials"].as_array().unwrap();
    let counts: Vec<(&Value, &Value)> = lines.iter().map(|l| (&l["count"], &l["parts"])).collect();
    assert_eq!(
        counts,
        [
            (&json!(1), &json!(["base"])),
            (&json!(2), &json!(["one", "two"]))
        ]
    );
    // Water: 8000 mm3 weigh 8 g, 1000 mm3 1 g.
    assert!(near(&told["parts"][0]["mass_kg"], 0.008, 1e-9), "{told}");
    assert!(near(&lines[1]["mass_kg"], 0.001, 1e-9));
    assert!(near(&told["mass"]["total_kg"], 0.010, 1e-9));
    assert_eq!(answer["mass_kg"], told["mass"]["total_kg"]);
    // The large cube's centre at z = 10, the small ones' at z = 25; in x and y the middle of the large one.
    let centre = &told["mass"]["centre_mm"];
    for (k, wanted) in [10.0, 10.0, (8.0 * 10.0 + 2.0 * 25.0) / 10.0]
        .into_iter()
        .enumerate()
    {
        assert!(near(&centre[k], wanted, 1e-6), "{centre}");
    }
    assert_eq!(told["mass"]["density_assumed"], false);
    // Of steel where nothing is stated, and told so.
    kit.ok("verify", json!({"assembly": "a"}));
    let steel = report(&kit, "a");
    assert_eq!(steel["mass"]["density_assumed"], true);
    assert!(
        near(&steel["mass"]["total_kg"], 0.0785, 1e-9),
        "{}",
        steel["mass"]
    );
    assert!(
        read(&kit, "a", "report.md").contains("7850 kg/m3, that of steel, taken for all parts")
    );
    // A part that has no place takes the centre away, and leaves the mass.
    kit.part("a", "loose", "test.block", json!({}));
    kit.ok("verify", json!({"assembly": "a"}));
    let loose = report(&kit, "a");
    assert!(
        near(&loose["mass"]["total_kg"], 0.08635, 1e-9),
        "{}",
        loose["mass"]
    );
    assert!(loose["mass"].get("centre_mm").is_none());
}

#[test]
fn the_pages_say_what_the_report_says() {
    let mut kit = Kit::new();
    kit.stand("stand");
    // Sunk by 2 mm, and with a bearing lacking.
    kit.ok(
        "remove",
        json!({"assembly": "stand", "kind": "mate", "name": "m1"}),
    );
    kit.mate(json!({
        "assembly": "stand", "id": "m1", "mate_type": "face_to_face", "base": "plate:top_face",
        "incoming": "block:bottom_face", "d_n_mm": -2, "axioms": ["C-01"],
    }));
    let answer = kit.ok("verify", json!({"assembly": "stand"}));
    let report = report(&kit, "stand");
    let pages = answer["report_pages"].as_array().unwrap();
    assert_eq!(
        pages,
        &["assemblies/stand/report.md", "assemblies/stand/report.html"]
    );
    let (md, html) = (
        read(&kit, "stand", "report.md"),
        read(&kit, "stand", "report.html"),
    );
    // Taken back to plain text, both hold every finding, check, part, mate and hash.
    let plain = |text: &str| {
        let text = text.replace('\\', "");
        let marks = [
            ("&lt;", "<"),
            ("&gt;", ">"),
            ("&quot;", "\""),
            ("&#58;", ":"),
            ("&#64;", "@"),
            ("&amp;", "&"),
        ];
        marks.iter().fold(text, |t, (mark, c)| t.replace(mark, c))
    };
    for page in [plain(&md), plain(&html)] {
        let holds = |text: &Value| {
            let text = text.as_str().unwrap();
            assert!(page.contains(text), "{text}\n{page}");
        };
        for f in report["findings"].as_array().unwrap() {
            holds(&f["diagnostic"]["message"]);
            holds(&f["diagnostic"]["code"]);
            if let Some(hint) = f["diagnostic"].get("hint") {
                holds(hint);
            }
            if let Some(next) = f["diagnostic"].get("next") {
                let call = format!("{} {}", next["tool"].as_str().unwrap(), next["arguments"]);
                holds(&json!(call));
            }
            for a in f["axioms"].as_array().into_iter().flatten() {
                holds(&a["statement"]);
            }
        }
        for c in report["checks"].as_array().unwrap() {
            holds(&c["how"]);
        }
        for why in report["not_checked"].as_array().unwrap() {
            holds(why);
        }
        for line in report["bill_of_materials"].as_array().unwrap() {
            holds(&line["recipe_sha256"]);
        }
        for m in report["mates"].as_array().unwrap() {
            holds(&m["base"]);
        }
        holds(&report["specification_sha256"]);
        assert!(page.contains("they overlap by"));
    }
    assert!(html.contains("<b class=\"fail\">fail</b>") && md.contains("**Verdict: fail**"));
    // Findings come before what was checked, and that before the rest.
    for page in [&md, &html] {
        let at = |text: &str| page.find(text).unwrap();
        assert!(at("Findings") < at("What was checked"));
        assert!(at("What was checked") < at("What was not checked"));
        assert!(at("What was not checked") < at("Bill of materials"));
    }
    // What it is made of: one file without scripts or anything from elsewhere.
    for foreign in ["<script", "src=", "href=", "http:", "https:", "url("] {
        assert!(!html.contains(foreign), "{foreign}");
    }
}

#[test]
fn report_and_step_file_name_each_other() {
    let mut kit = Kit::new();
    kit.stand("stand");
    let step_of = |kit: &Kit| report(kit, "stand")["step"].clone();
    kit.ok("verify", json!({"assembly": "stand"}));
    assert_eq!(step_of(&kit), Value::Null);
    // The export tells the report.
    let done = kit.ok(
        "export_step",
        json!({"assembly": "stand", "file": "out/other.stp"}),
    );
    let named = step_of(&kit);
    assert_eq!(
        (&named["sha256"], &named["file"]),
        (&done["sha256"], &json!("exports/stand/out/other.stp"))
    );
    for page in ["report.md", "report.html"] {
        assert!(read(&kit, "stand", page).contains(done["sha256"].as_str().unwrap()));
    }
    // The next verification still knows it.
    kit.ok("verify", json!({"assembly": "stand"}));
    assert_eq!(step_of(&kit), named);
    // Of a file that is of another specification nothing is said, nor of one that is gone.
    kit.part("stand", "extra", "test.block", json!({}));
    kit.ok("verify", json!({"assembly": "stand"}));
    assert_eq!(step_of(&kit), Value::Null);
    kit.ok(
        "remove",
        json!({"assembly": "stand", "kind": "part", "name": "extra"}),
    );
    kit.ok("export_step", json!({"assembly": "stand"}));
    kit.ok("verify", json!({"assembly": "stand"}));
    assert_eq!(step_of(&kit)["file"], "assemblies/stand/stand.step");
    std::fs::remove_file(kit.file("assemblies/stand/stand.step")).unwrap();
    kit.ok("verify", json!({"assembly": "stand"}));
    assert_eq!(step_of(&kit), Value::Null);
}

#[test]
fn the_concise_answer_is_short_and_the_report_fits_its_schema() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    kit.part("a", "base", "test.block", json!({"size": 50}));
    for i in 0..12 {
        kit.part("a", &format!("loose_{i}"), "test.block", json!({}));
    }
    let short = kit.ok("verify", json!({"assembly": "a"}));
    assert_eq!(short["findings"].as_array().map(Vec::len), Some(10));
    assert!(short["findings_total"].as_u64().unwrap() >= 12);
    let of = |check: &str| {
        let checks = short["checks"].as_array().unwrap();
        checks.iter().find(|c| c["check"] == check).unwrap().clone()
    };
    assert_eq!(of("connectivity")["findings"], 12);
    assert!(
        short.to_string().len() < 8000,
        "{}",
        short.to_string().len()
    );
    let full = kit.ok("verify", json!({"assembly": "a", "detail": "full"}));
    assert_eq!(
        full["findings"].as_array().map(Vec::len),
        full["findings_total"].as_u64().map(|n| n as usize)
    );
    let schema: Value = serde_json::from_str(include_str!("../docs/schema/report.json")).unwrap();
    let schema = jsonschema::validator_for(&schema).unwrap();
    let faults: Vec<String> = schema
        .iter_errors(&report(&kit, "a"))
        .map(|e| e.to_string())
        .collect();
    assert!(faults.is_empty(), "{faults:?}");
}
