//! In which order a source is tried, how far, what a limit leaves, and what is told of it meanwhile.

use serde_json::{Value, json};

use crate::kit::Kit;

/// Of two ranges: the defaults, two ends of each, the four corners, eight sets between.
const ENDS: u64 = 4;
const CORNERS: u64 = 4;
const SAMPLES: u64 = 8;
const ALL: u64 = 1 + ENDS + CORNERS + SAMPLES;

/// A disc with a bore; `depth` is an expression for its thickness, `thickness` of the parameters for right.
fn disc(depth: &str) -> String {
    format!(
        "factory(doc = \"A disc with a bore. Frame: on z = 0. Ports: bore (BORE at the top).\", params = {{\n\
         \x20   \"bore_d\": number(8, 4, 12, doc = \"bore\"),\n\
         \x20   \"thickness\": number(6, 3, 10, doc = \"along z\"),\n\
         }})\n\
         def build(p):\n\
         \x20   body = cq.Workplane(\"XY\").circle(20).extrude({depth})\n\
         \x20   return body.faces(\">Z\").workplane().bore_port(\"bore\", p.bore_d)\n"
    )
}

const RIGHT: &str = "p.thickness";
const WRONG_AT_DEFAULTS: &str = "p.thickness + 1";
/// Too thick where the bore is at its largest, alone or with others.
const WRONG_AT_AN_END: &str = "p.thickness + (1 if p.bore_d > 11.5 else 0)";
/// Too thick where both are at their largest.
const WRONG_AT_A_CORNER: &str = "p.thickness + (1 if p.bore_d > 11.5 and p.thickness > 9.5 else 0)";

fn asked(source: &str) -> Value {
    json!({
        "name": "user.disc",
        "description": "A disc of 40 mm with a bore; frame on its lower face.",
        "expected_ports": [
            {"name": "bore", "type": "BORE", "params": {"diameter": "bore_d", "depth": "thickness"}},
        ],
        "params": [
            {"name": "bore_d", "default": 8, "min": 4, "max": 12, "doc": "bore"},
            {"name": "thickness", "default": 6, "min": 3, "max": 10, "doc": "along z"},
        ],
        "source": disc(source),
    })
}

fn at(mut arguments: Value, sets: &str) -> Value {
    arguments["sets"] = json!(sets);
    arguments
}

/// The solids that a server has made: each leaves a file.
fn solids(kit: &Kit) -> usize {
    let folder = std::fs::read_dir(kit.file(".assemcad/cache"));
    folder.map_or(0, |files| {
        let names = files.map(|f| f.unwrap().file_name().into_string().unwrap());
        names.filter(|name| name.ends_with(".solid")).count()
    })
}

/// Name, sets, made, failed and left of each stage.
fn stages(told: &Value) -> Vec<(String, [u64; 4])> {
    let each = told.as_array().unwrap().iter();
    each.map(|stage| {
        let counts = ["sets", "made", "failed", "not_tried"].map(|k| stage[k].as_u64().unwrap());
        (stage["stage"].as_str().unwrap().to_owned(), counts)
    })
    .collect()
}

fn expected(counts: [[u64; 4]; 4]) -> Vec<(String, [u64; 4])> {
    let names = ["defaults", "ends", "corners", "samples"].map(str::to_owned);
    names.into_iter().zip(counts).collect()
}

fn left(sets: u64) -> [u64; 4] {
    [sets, 0, 0, sets]
}

fn made(sets: u64) -> [u64; 4] {
    [sets, sets, 0, 0]
}

fn record(kit: &Kit) -> Value {
    let text = std::fs::read_to_string(kit.file("factories/user.disc@1.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

#[test]
fn what_is_wrong_at_the_defaults_is_told_before_anything_else_is_built() {
    let mut kit = Kit::new();
    let answer = kit.ok("synthesize_factory", asked(WRONG_AT_DEFAULTS));
    assert_eq!(answer["status"], "refused");
    let findings = answer["findings"].as_array().unwrap();
    assert_eq!(findings.len(), 1, "{findings:?}");
    assert_eq!(
        (&findings[0]["at"], &findings[0]["port"]),
        (&json!({}), &json!("bore"))
    );
    assert_eq!(answer["tally"]["not_tried"], ALL - 1);
    let told = expected([[1, 0, 1, 0], left(ENDS), left(CORNERS), left(SAMPLES)]);
    assert_eq!(stages(&answer["stages"]), told);
    assert_eq!(solids(&kit), 1);
}

#[test]
fn a_stage_that_fails_is_the_last_one() {
    let mut kit = Kit::new();
    let answer = kit.ok("synthesize_factory", asked(WRONG_AT_AN_END));
    assert_eq!(answer["status"], "refused");
    let findings = answer["findings"].as_array().unwrap();
    assert_eq!(findings.len(), 1, "{findings:?}");
    assert_eq!(
        (&findings[0]["at"], &findings[0]["sets"]),
        (&json!({"bore_d": 12.0}), &json!(1))
    );
    let told = expected([
        made(1),
        [ENDS, ENDS - 1, 1, 0],
        left(CORNERS),
        left(SAMPLES),
    ]);
    assert_eq!(stages(&answer["stages"]), told);
    assert_eq!(solids(&kit) as u64, 1 + ENDS);
}

#[test]
fn the_author_chooses_the_sets_and_the_record_says_which() {
    let mut kit = Kit::new();
    let first = kit.ok(
        "synthesize_factory",
        at(asked(WRONG_AT_A_CORNER), "defaults"),
    );
    assert_eq!(
        (&first["status"], &first["factory"]),
        (&json!("admitted"), &json!("user.disc@1"))
    );
    assert_eq!(solids(&kit), 1);
    let evidence = &record(&kit)["evidence"];
    assert_eq!(
        (&evidence["sets"], &evidence["tally"]["not_tried"]),
        (&json!("defaults"), &json!(ALL - 1))
    );
    assert_eq!(
        stages(&evidence["stages"]),
        expected([made(1), left(ENDS), left(CORNERS), left(SAMPLES)])
    );

    // The same source at more sets: the same version on more evidence.
    let more = kit.ok("synthesize_factory", at(asked(WRONG_AT_A_CORNER), "ends"));
    assert_eq!(
        (&more["status"], &more["factory"]),
        (&json!("admitted"), &json!("user.disc@1"))
    );
    let evidence = record(&kit)["evidence"].clone();
    assert_eq!(
        (&evidence["sets"], &evidence),
        (&json!("ends"), &more["evidence"])
    );
    assert_eq!(
        stages(&evidence["stages"]),
        expected([made(1), made(ENDS), left(CORNERS), left(SAMPLES)])
    );
    // On less it is known already.
    let less = kit.ok(
        "synthesize_factory",
        at(asked(WRONG_AT_A_CORNER), "defaults"),
    );
    assert_eq!(
        (&less["status"], &less["evidence"]),
        (&json!("known"), &evidence)
    );

    // All sets bring out what is wrong; what was admitted stands as it did.
    let refused = kit.ok("synthesize_factory", asked(WRONG_AT_A_CORNER));
    assert_eq!(refused["status"], "refused");
    assert_eq!(
        refused["findings"][0]["at"],
        json!({"bore_d": 12.0, "thickness": 10.0})
    );
    assert_eq!(record(&kit)["evidence"], evidence);

    let right = kit.ok("synthesize_factory", asked(RIGHT));
    assert_eq!(right["factory"], "user.disc@2");
    assert_eq!(right["evidence"]["sets"], "all");
    assert_eq!(
        stages(&right["evidence"]["stages"]),
        expected([made(1), made(ENDS), made(CORNERS), made(SAMPLES)])
    );
}

#[test]
fn an_edited_source_is_tried_at_the_sets_of_its_record() {
    let mut kit = Kit::new();
    kit.ok("synthesize_factory", at(asked(RIGHT), "ends"));
    let star = kit.file("factories/user.disc@1.star");
    let before = record(&kit);
    std::fs::write(&star, disc(WRONG_AT_A_CORNER)).unwrap();
    let mut kit = kit.killed_and_started_again();
    kit.ok("describe_factory", json!({"factory": "user.disc"}));
    let after = record(&kit);
    assert_ne!(before["source_sha256"], after["source_sha256"]);
    assert_eq!(before["evidence"]["stages"], after["evidence"]["stages"]);
    std::fs::write(&star, disc(WRONG_AT_AN_END)).unwrap();
    let mut kit = kit.killed_and_started_again();
    let found = kit.refused("describe_factory", json!({"factory": "user.disc"}));
    assert!(
        found[0]["message"].as_str().unwrap().contains("was edited"),
        "{found:?}"
    );
    assert_eq!(record(&kit), after);
}

#[test]
fn a_record_of_before_stands_on_all_sets() {
    let mut kit = Kit::new();
    kit.ok("synthesize_factory", asked(RIGHT));
    let path = kit.file("factories/user.disc@1.json");
    let mut old = record(&kit);
    let evidence = old["evidence"].as_object_mut().unwrap();
    assert!(evidence.remove("sets").is_some() && evidence.remove("stages").is_some());
    std::fs::write(&path, old.to_string()).unwrap();
    let mut kit = kit.killed_and_started_again();
    let known = kit.ok("synthesize_factory", asked(RIGHT));
    assert_eq!(
        (&known["status"], &known["evidence"]["sets"]),
        (&json!("known"), &json!("all"))
    );
}

#[test]
fn a_limit_tells_how_many_sets_are_left_and_uses_up_no_round() {
    let mut kit = Kit::with(&["--synthesis-s", "0", "--synthesis-rounds", "1"]);
    for _ in 0..3 {
        let answer = kit.ok("synthesize_factory", asked(RIGHT));
        assert_eq!(answer["status"], "unfinished");
        assert_eq!(answer["tally"]["not_tried"], ALL - 1);
        let told = expected([made(1), left(ENDS), left(CORNERS), left(SAMPLES)]);
        assert_eq!(stages(&answer["stages"]), told);
        let next = answer["next"].as_str().unwrap();
        assert!(
            next.contains(&format!("{} of {ALL} sets", ALL - 1)),
            "{next}"
        );
        assert!(
            answer["findings"].is_null() && answer["round"].is_null(),
            "{answer}"
        );
    }
    assert_eq!(solids(&kit), 1);
    assert!(!kit.file("factories").exists());
    // What is wrong at the defaults is told all the same, and what was asked for is done.
    let little = kit.ok("synthesize_factory", at(asked(RIGHT), "defaults"));
    assert_eq!(little["status"], "admitted");
    let mut kit = kit.killed_and_started_again();
    let answer = kit.ok("synthesize_factory", asked(RIGHT));
    assert_eq!(
        (&answer["status"], &answer["factory"]),
        (&json!("admitted"), &json!("user.disc@1"))
    );
    assert_eq!(answer["evidence"]["tally"]["made"], ALL);
}

/// What a call tells of its progress, and its answer.
fn watched(kit: &mut Kit, arguments: Value) -> (Vec<(f64, String)>, Value) {
    let call = json!({
        "name": "synthesize_factory", "arguments": arguments, "_meta": {"progressToken": "sets"},
    });
    let id = kit.session.begin("tools/call", call).unwrap();
    let mut signs = Vec::new();
    loop {
        let message = kit
            .session
            .message(std::time::Duration::from_secs(120))
            .unwrap();
        if message["method"] == "notifications/progress" {
            let params = &message["params"];
            assert_eq!(params["progressToken"], "sets");
            let words = params["message"].as_str().unwrap().to_owned();
            signs.push((params["progress"].as_f64().unwrap(), words));
        } else if message["id"] == id {
            return (signs, message["result"]["structuredContent"].clone());
        }
    }
}

#[test]
fn progress_is_told_in_sets() {
    let mut kit = Kit::new();
    let (signs, answer) = watched(&mut kit, asked(RIGHT));
    assert_eq!(answer["status"], "admitted");
    assert!(signs.windows(2).all(|two| two[0].0 < two[1].0), "{signs:?}");
    let words: Vec<&str> = signs
        .iter()
        .map(|(_, w)| w.as_str())
        .filter(|w| *w != "at work")
        .collect();
    let mut counted = Vec::new();
    for (stage, sets) in [
        ("defaults", 1),
        ("ends", ENDS),
        ("corners", CORNERS),
        ("samples", SAMPLES),
    ] {
        counted.extend((1..=sets).map(|n| format!("{stage} {n}/{sets}")));
    }
    assert_eq!(words, counted);

    let (signs, _) = watched(&mut kit, asked(WRONG_AT_DEFAULTS));
    let words: Vec<&str> = signs
        .iter()
        .map(|(_, w)| w.as_str())
        .filter(|w| *w != "at work")
        .collect();
    assert_eq!(words, ["defaults 1/1"]);
}
