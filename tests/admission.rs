//! What becomes of admitted factories: versions, restarts, edited files, bounded rounds, names.

use serde_json::{Value, json};

use crate::kit::Kit;

/// A disc with a bore, `extra` between the declaration and the solid.
fn disc(extra: &str, thickness: &str) -> String {
    format!(
        "factory(doc = \"A disc with a bore. Frame: on z = 0, axis z. Ports: bore (BORE at the top), back.\", params = {{\n\
         \x20   \"bore_d\": number(8, 4, 12, doc = \"bore\"),\n\
         }})\n\
         {extra}\n\
         def build(p):\n\
         \x20   body = cq.Workplane(\"XY\").circle(20).extrude({thickness})\n\
         \x20   return body.faces(\">Z\").workplane().bore_port(\"bore\", p.bore_d, back = \"back\")\n"
    )
}

fn request(name: &str) -> Value {
    json!({
        "name": name,
        "description": "A disc of 40 mm with a bore; frame on its lower face.",
        "expected_ports": [{"name": "bore", "type": "BORE", "params": {"diameter": "bore_d", "depth": 6}}],
        "params": [{"name": "bore_d", "default": 8, "min": 4, "max": 12, "doc": "bore"}],
    })
}

fn with(mut request: Value, key: &str, value: impl Into<Value>) -> Value {
    request[key] = value.into();
    request
}

fn synthesize(kit: &mut Kit, arguments: Value) -> Value {
    kit.ok("synthesize_factory", arguments)
}

fn volume(bore: f64, thickness: f64) -> f64 {
    core::f64::consts::PI * (400.0 - bore * bore / 4.0) * thickness
}

fn near(found: &Value, expected: f64) {
    let found = found.as_f64().unwrap();
    assert!(
        (found - expected).abs() < 1e-6 * expected,
        "{found} {expected}"
    );
}

#[test]
fn a_request_without_a_source_tells_all_that_is_needed_to_write_it() {
    let mut kit = Kit::new();
    let answer = synthesize(&mut kit, request("user.disc"));
    assert_eq!(answer["status"], "wanted");
    let needed = &answer["to_write"];
    // The page of the language is the one that is held against the code.
    let page = include_str!("../docs/language.md");
    assert!(
        page.contains(needed["language"].as_str().unwrap().trim()),
        "the page"
    );
    let shown: Vec<&str> = needed["ports"][0]["shown_by"]
        .as_array()
        .unwrap()
        .iter()
        .map(|s| s.as_str().unwrap())
        .collect();
    assert!(
        shown.contains(&"the wall of the hole") && shown.contains(&"the hole is open at its mouth"),
        "{shown:?}"
    );
    let examples = needed["examples"].as_array().unwrap();
    assert_eq!(examples.len(), 2);
    for example in examples {
        assert!(
            example["source"].as_str().unwrap().contains("BORE"),
            "{example}"
        );
    }
    // Five thousand tokens of four characters.
    assert!(
        answer.to_string().len() < 20_000,
        "{}",
        answer.to_string().len()
    );
    assert!(!kit.file("factories").exists());
}

#[test]
fn the_hash_of_a_request_is_over_its_parts_each_led_by_its_length() {
    let mut kit = Kit::new();
    let answer = synthesize(&mut kit, request("user.disc"));
    // Computed with Python's hashlib over "assemcad factory request 1\n" and, each as LENGTH:TEXT, the
    // description, [{"name":"bore","params":{"depth":6,"diameter":"bore_d"},"type":"BORE"}] and
    // [{"default":8,"doc":"bore","kind":"number","max":12,"min":4,"name":"bore_d","unit":"mm"}].
    let expected = "73d93584ccff8f724964b7da3e2f8452805248f8921c80d4e17d4b0ed5838203";
    assert_eq!(answer["request_sha256"], expected);
    // The name does not count, nor how a number is written; every word of the description does.
    let same = with(
        request("user.other"),
        "params",
        json!([{"name": "bore_d", "default": 8.0, "min": 4, "max": 12.0, "doc": "bore", "unit": "mm"}]),
    );
    assert_eq!(synthesize(&mut kit, same)["request_sha256"], expected);
    let other = with(
        request("user.disc"),
        "description",
        "A disc of 41 mm with a bore; frame on its lower face.",
    );
    assert_ne!(synthesize(&mut kit, other)["request_sha256"], expected);
}

#[test]
fn what_is_admitted_lasts_and_old_versions_stay_what_they_were() {
    let mut kit = Kit::new();
    let first = synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("", "6")),
    );
    assert_eq!(
        (&first["status"], &first["factory"]),
        (&json!("admitted"), &json!("user.disc@1"))
    );
    near(&first["evidence"]["volume_mm3"], volume(8.0, 6.0));
    kit.new_assembly("a");
    kit.part("a", "old", "user.disc", json!({}));
    let stored =
        |kit: &Kit| std::fs::read_to_string(kit.file("assemblies/a/assembly.yaml")).unwrap();
    assert!(stored(&kit).contains("user.disc@1"), "{}", stored(&kit));

    // The same again changes nothing.
    let before = kit.files();
    let again = synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("", "6")),
    );
    assert_eq!(
        (&again["status"], &again["factory"]),
        (&json!("known"), &json!("user.disc@1"))
    );
    assert_eq!(before, kit.files());

    // Another source for the same request: the next version, from now on the one that is meant.
    let second = synthesize(
        &mut kit,
        with(
            request("user.disc"),
            "source",
            disc("# the same part in other words", "12 / 2"),
        ),
    );
    assert_eq!(
        (&second["status"], &second["factory"]),
        (&json!("admitted"), &json!("user.disc@2"))
    );
    let changed = with(
        request("user.disc"),
        "expected_ports",
        json!([{"name": "bore", "type": "BORE", "params": {"depth": 7}}]),
    );
    let third = synthesize(&mut kit, with(changed, "source", disc("", "7")));
    assert_eq!(third["factory"], "user.disc@3");

    // A server that was killed and started again knows them all.
    let mut kit = kit.killed_and_started_again();
    let known = synthesize(&mut kit, request("user.whatever"));
    assert_eq!(
        (&known["status"], &known["factory"]),
        (&json!("known"), &json!("user.disc@2"))
    );
    let part = kit.part("a", "new", "disc", json!({}));
    near(&part["volume_mm3"], volume(8.0, 7.0));
    let old = kit.part("a", "second_old", "user.disc@1", json!({"bore_d": 10}));
    near(&old["volume_mm3"], volume(10.0, 6.0));
    let text = stored(&kit);
    assert!(
        text.contains("user.disc@1")
            && text.contains("user.disc@3")
            && !text.contains("user.disc@2"),
        "{text}"
    );
    let list = kit.ok("list_factories", json!({"name_contains": "disc"}));
    assert_eq!(list["factories"].as_array().unwrap().len(), 1);
    assert_eq!(list["factories"][0]["factory"], "user.disc@3");
    let described = kit.ok("describe_factory", json!({"factory": "user.disc@1"}));
    assert_eq!(described["factory"], "user.disc@1");
}

#[test]
fn the_same_source_leaves_the_same_files_with_any_number_of_workers() {
    let files = ["1", "2", "4"].map(|workers| {
        let mut kit = Kit::with(&["--workers", workers]);
        synthesize(
            &mut kit,
            with(request("user.disc"), "source", disc("", "6")),
        );
        kit.files()
    });
    assert_eq!(files[0].len(), 2, "{:?}", files[0].keys());
    assert_eq!(files[0], files[1]);
    assert_eq!(files[0], files[2]);
}

#[test]
fn a_source_that_was_edited_is_looked_at_again() {
    let mut kit = Kit::new();
    synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("", "6")),
    );
    let star = kit.file("factories/user.disc@1.star");
    let record = kit.file("factories/user.disc@1.json");
    let before = std::fs::read(&record).unwrap();

    // Good: admitted as it is now, and the record says so.
    std::fs::write(&star, disc("# edited", "3 + 3")).unwrap();
    let mut kit = kit.killed_and_started_again();
    let told = kit.ok("describe_factory", json!({"factory": "user.disc"}));
    let after = std::fs::read(&record).unwrap();
    assert_ne!(before, after);
    let now: Value = serde_json::from_slice(&after).unwrap();
    assert_eq!(now["source_sha256"], told["source_sha256"]);
    assert_eq!(now["version"], 1);

    // Bad: refused with the reason, wherever it is used; the record stays.
    std::fs::write(&star, disc("# edited", "9")).unwrap();
    let mut kit = kit.killed_and_started_again();
    let found = kit.refused("describe_factory", json!({"factory": "user.disc@1"}));
    assert!(
        found[0]["message"].as_str().unwrap().contains("edited"),
        "{}",
        found[0]
    );
    assert!(
        found
            .iter()
            .any(|d| d["message"].as_str().unwrap().contains("'depth'")),
        "{found:?}"
    );
    kit.new_assembly("a");
    kit.refused(
        "add_part",
        json!({"assembly": "a", "part": "p", "factory": "user.disc"}),
    );
    assert_eq!(std::fs::read(&record).unwrap(), after);
    // It is not what was admitted for the request.
    assert_eq!(
        synthesize(&mut kit, request("user.disc"))["status"],
        "wanted"
    );
    // A new version makes it good.
    let mended = synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("", "6")),
    );
    assert_eq!(mended["factory"], "user.disc@2");
    kit.part("a", "p", "user.disc", json!({}));
}

#[test]
fn two_servers_over_one_folder_do_not_take_each_others_versions() {
    let mut kit = Kit::new();
    let mut other =
        crate::harness::Session::start(crate::kit::program(), &kit.root(), &[]).unwrap();
    let theirs = with(request("user.disc"), "source", disc("# theirs", "6"));
    let answer = other.call("synthesize_factory", theirs).unwrap();
    assert_eq!(answer.content["factory"], "user.disc@1");
    let ours = synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("# ours", "6")),
    );
    assert_eq!(ours["factory"], "user.disc@2");
    assert_eq!(kit.files().len(), 4);
}

#[test]
fn what_another_server_admits_edits_or_removes_is_known_at_once() {
    let mut kit = Kit::new();
    let names = |kit: &mut Kit| -> Vec<String> {
        let list = kit.ok("list_factories", json!({"name_contains": "user."}));
        let all = list["factories"].as_array().unwrap().iter();
        all.map(|f| f["factory"].as_str().unwrap().to_owned())
            .collect()
    };
    assert!(names(&mut kit).is_empty());
    let mut other =
        crate::harness::Session::start(crate::kit::program(), &kit.root(), &[]).unwrap();
    for (comment, name) in [("# one", "user.disc@1"), ("# two", "user.disc@2")] {
        let theirs = with(request("user.disc"), "source", disc(comment, "6"));
        let answer = other.call("synthesize_factory", theirs).unwrap();
        assert_eq!(answer.content["factory"], name);
        assert_eq!(names(&mut kit), [name]);
    }
    // What was evaluated of a source is forgotten with it.
    kit.new_assembly("a");
    kit.part("a", "p", "user.disc@2", json!({}));
    let star = kit.file("factories/user.disc@2.star");
    std::fs::write(&star, disc("# edited", "9")).unwrap();
    let found = kit.refused(
        "add_part",
        json!({"assembly": "a", "part": "q", "factory": "user.disc@2"}),
    );
    assert!(
        found[0]["message"].as_str().unwrap().contains("edited"),
        "{found:?}"
    );
    std::fs::write(&star, disc("# two", "6")).unwrap();
    kit.part("a", "q", "user.disc@2", json!({}));
    for extension in ["star", "json"] {
        std::fs::remove_file(kit.file(&format!("factories/user.disc@2.{extension}"))).unwrap();
    }
    assert_eq!(names(&mut kit), ["user.disc@1"]);
}

#[tokio::test]
async fn an_evaluation_of_an_older_source_is_not_kept() {
    use assemcad_factories::{Admitted, Registry, admission::Record};
    use assemcad_script::worker::{Config, Evaluator, LIMITS};
    use std::sync::Arc;

    let mut kit = Kit::new();
    synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("", "6")),
    );
    let record = std::fs::read(kit.file("factories/user.disc@1.json")).unwrap();
    let record: Arc<Record> = Arc::new(serde_json::from_slice(&record).unwrap());
    let evaluator = Arc::new(Evaluator::processes(Config {
        program: crate::kit::program().to_owned(),
        workers: 2,
        limits: LIMITS,
    }));
    let registry = Arc::new(Registry::default());
    let admit = async |source: String| {
        let factory = evaluator.parse("user.disc@1", &source).await.unwrap();
        registry.admit(Admitted {
            factory: Arc::new(factory),
            record: Arc::clone(&record),
            edited: false,
        });
    };
    let length = |made: &assemcad_script::Evaluated| made.recipe.hash().unwrap();
    // The older source takes its time.
    admit(disc(
        "def slow():\n    n = 0\n    for j in range(13):\n        for i in range(20000):\n            n += i\n    return 6\n",
        "slow()",
    ))
    .await;
    let older = {
        let (registry, evaluator) = (Arc::clone(&registry), Arc::clone(&evaluator));
        tokio::spawn(async move {
            let none = serde_json::Map::new();
            let made = registry.build(&evaluator, "user.disc@1", &none);
            made.await.unwrap()
        })
    };
    tokio::time::sleep(std::time::Duration::from_millis(40)).await;
    assert!(!older.is_finished());
    admit(disc("", "7")).await;
    let older = length(&older.await.unwrap());
    let none = serde_json::Map::new();
    let now = registry.build(&evaluator, "user.disc@1", &none);
    assert_ne!(length(&now.await.unwrap()), older);
}

#[test]
fn hints_are_tried_out_for_a_few_ports_only() {
    let mut kit = Kit::new();
    // Faces whose normals look into the material: turned round, the solid would show each.
    let ports: String = (0..30)
        .map(|i| format!("    body = body.face_port(\"f{i}\", 4, 4, at = cq.Plane(origin = ({}, 12, 0), xDir = (1, 0, 0), normal = (0, 0, 1)))\n", i as f64 * 0.4 - 6.0))
        .collect();
    let source = disc("", "6").replace(
        "    return body.faces",
        &format!("{ports}    return body.faces"),
    );
    let answer = synthesize(&mut kit, with(request("user.disc"), "source", source));
    assert_eq!(answer["status"], "refused");
    let told = answer.to_string();
    let tried = told.matches("the solid shows this port where").count();
    assert_eq!(tried, 6, "{told}");
}

#[test]
fn an_edited_source_that_fails_is_looked_at_once() {
    let mut kit = Kit::new();
    let admitted = with(request("user.disc"), "source", disc("", "6"));
    synthesize(&mut kit, admitted);
    let star = kit.file("factories/user.disc@1.star");
    std::fs::write(&star, disc("# edited", "9")).unwrap();
    let draft = |parts: usize| {
        let parts = (0..parts).map(|i| {
            let bore = 8.0 + 0.01 * i as f64;
            format!("  - {{id: p{i}, factory: user.disc@1, params: {{bore_d: {bore}}}}}\n")
        });
        let text = format!(
            "assembly:\n  id: a\n  parts:\n{}",
            parts.collect::<String>()
        );
        json!({"draft": text})
    };
    let began = std::time::Instant::now();
    kit.ok("validate_draft", draft(1));
    let once = began.elapsed();
    for _ in 0..2 {
        let began = std::time::Instant::now();
        let answer = kit.ok("validate_draft", draft(30));
        let again = began.elapsed();
        let most = (once / 2).max(std::time::Duration::from_millis(400));
        assert!(again < most, "{again:?} and {once:?} for one part");
        let found = answer["diagnostics"].as_array().unwrap();
        let edited = found.iter().filter(|d| {
            let message = d["message"].as_str().unwrap();
            message.contains("does not pass the gate")
        });
        assert!(edited.count() >= 10, "{answer}");
    }
    // Mended, it is looked at anew.
    std::fs::write(&star, disc("# mended", "3 + 3")).unwrap();
    kit.new_assembly("a");
    kit.part("a", "p", "user.disc@1", json!({}));
}

#[test]
fn damaged_records_and_foreign_files_cost_only_themselves() {
    let mut kit = Kit::new();
    synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("", "6")),
    );
    synthesize(
        &mut kit,
        with(request("user.plate"), "source", disc("# another", "6")),
    );
    std::fs::write(kit.file("factories/user.disc@1.json"), "{\"format\": 1").unwrap();
    std::fs::write(kit.file("factories/user.stray@1.star"), disc("", "6")).unwrap();
    std::fs::write(kit.file("factories/notes.txt"), "nothing").unwrap();
    let record = std::fs::read_to_string(kit.file("factories/user.plate@1.json")).unwrap();
    std::fs::write(kit.file("factories/user.copy@1.json"), record).unwrap();
    let mut kit = kit.killed_and_started_again();
    let list = kit.ok("list_factories", json!({"name_contains": "user."}));
    let names: Vec<&Value> = list["factories"]
        .as_array()
        .unwrap()
        .iter()
        .map(|f| &f["factory"])
        .collect();
    assert_eq!(names, ["user.plate@1"]);
}

#[test]
fn rounds_are_bounded_by_name_and_request() {
    let mut kit = Kit::new();
    let bad = |n: usize| {
        with(
            request("user.disc"),
            "source",
            disc(&format!("# try {n}"), "5"),
        )
    };
    for n in 1..5 {
        let answer = synthesize(&mut kit, bad(n));
        assert_eq!(
            (&answer["status"], &answer["round"]),
            (&json!("refused"), &json!(n))
        );
    }
    // The same source again is the same round, also for a server started again.
    let mut kit = kit.killed_and_started_again();
    assert_eq!(synthesize(&mut kit, bad(4))["round"], 4);
    let found = kit.refused("synthesize_factory", bad(5));
    assert_eq!(found[0]["code"], "synthesis_failed");
    assert_eq!(found[0]["found"].as_array().unwrap().len(), 5);
    assert!(found.len() > 1, "the last findings are told too");
    // Now not even a good one is looked at.
    let good = with(request("user.disc"), "source", disc("", "6"));
    assert_eq!(
        kit.refusal("synthesize_factory", good.clone())["code"],
        "synthesis_failed"
    );
    // A new name begins anew, and so does a changed request.
    let answer = synthesize(&mut kit, with(bad(5), "name", "user.disc_b"));
    assert_eq!(
        (&answer["status"], &answer["round"]),
        (&json!("refused"), &json!(1))
    );
    let answer = synthesize(
        &mut kit,
        with(
            good,
            "description",
            "A disc of 40 mm, 6 mm thick, with a bore.",
        ),
    );
    assert_eq!(answer["status"], "admitted");
}

#[test]
fn a_factory_that_works_in_a_part_of_its_ranges_is_admitted_for_it_where_that_is_asked() {
    let mut kit = Kit::new();
    // Above 9.5 the bore is another than the port says.
    let source = disc("", "6").replace("p.bore_d,", "min(p.bore_d, 9.5),");
    let strict = synthesize(
        &mut kit,
        with(request("user.disc"), "source", source.clone()),
    );
    assert_eq!(strict["status"], "refused");
    assert_eq!(strict["findings"][0]["at"], json!({"bore_d": 12.0}));
    let shown = with(
        with(request("user.disc"), "source", source),
        "ranges",
        "as_shown",
    );
    let answer = synthesize(&mut kit, shown);
    assert_eq!(answer["status"], "admitted", "{answer}");
    let range = &answer["narrowed"]["bore_d"];
    let high = range[1].as_f64().unwrap();
    assert_eq!(range[0], 4.0);
    assert!(high > 9.0 && high <= 9.5, "{high}");
    let described = kit.ok("describe_factory", json!({"factory": "user.disc"}));
    assert_eq!(
        described["params_schema"]["properties"]["bore_d"]["maximum"],
        json!(high)
    );
    let mut kit = kit.killed_and_started_again();
    kit.new_assembly("a");
    let d = kit.refusal(
        "add_part",
        json!({"assembly": "a", "part": "p", "factory": "user.disc", "params": {"bore_d": 11}}),
    );
    assert_eq!(d["code"], "param_invalid");
}

#[test]
fn everything_that_is_wrong_with_a_request_is_told_at_once() {
    let mut kit = Kit::new();
    let mut wrong = json!({
        "name": "user.../../etc",
        "description": "  ",
        "expected_ports": [
            {"name": "a b", "type": "BORE", "params": {"radius": 4, "depth": true}},
            {"name": "c", "type": "BORE"}, {"name": "c", "type": "HOLE"},
        ],
        "params": [
            {"name": "Width", "default": 1, "min": 0, "max": 2},
            {"name": "n", "kind": "integer", "default": 2.5, "min": 1, "max": 4},
            {"name": "d", "default": 9, "min": 1, "max": 4},
            {"name": "e", "default": 9},
            {"name": "w", "kind": "choice", "default": "x", "choices": ["y"]},
            {"name": "w", "kind": "flag", "default": 1},
        ],
    });
    // The schema finds the one that is of no type at all; the rest is found by meaning.
    let d = kit.refusal("synthesize_factory", wrong.clone());
    assert_eq!(d["where"], "expected_ports.0.params.depth");
    wrong["expected_ports"][0]["params"] = json!({"radius": 4});
    let found = kit.refused("synthesize_factory", wrong);
    let places: Vec<&str> = found.iter().map(|d| d["where"].as_str().unwrap()).collect();
    assert_eq!(
        places,
        [
            "name",
            "description",
            "expected_ports[0].name",
            "expected_ports[0].params.radius",
            "expected_ports[2].name",
            "params[0].name",
            "params[1].default",
            "params[2].default",
            "params[3].min",
            "params[4].default",
            "params[5].name",
            "params[5].default",
        ]
    );
    for name in ["disc", "gear.disc", "user.", "user.a@2", "base_frame.boss"] {
        let d = kit.refusal("synthesize_factory", request(name));
        assert_eq!(
            (&d["code"], &d["where"]),
            (&json!("name_invalid"), &json!("name")),
            "{name}"
        );
    }
    assert!(!kit.file("factories").exists());
}

#[test]
fn prompts_carry_the_language_as_it_is() {
    let mut kit = Kit::new();
    let page = synthesize(&mut kit, request("user.disc"))["to_write"]["language"].clone();
    for (name, arguments, words) in [
        (
            "synthesize",
            json!({"description": "a wing nut {{LANGUAGE}}"}),
            ["a wing nut {{LANGUAGE}}", "BORE"],
        ),
        (
            "repair",
            json!({"source": "def build(p): pass", "findings": "line 1 {{SOURCE}}"}),
            ["def build(p): pass", "line 1 {{SOURCE}}"],
        ),
    ] {
        let answer = kit
            .session
            .request("prompts/get", json!({"name": name, "arguments": arguments}))
            .unwrap();
        let text = answer["result"]["messages"][0]["content"]["text"]
            .as_str()
            .unwrap()
            .to_owned();
        assert!(text.contains(page.as_str().unwrap().trim()), "{name}");
        for word in words {
            assert!(text.contains(word), "{name}: {word}");
        }
        // Four characters to a token.
        assert!(text.len() / 4 < 6000, "{name}: {}", text.len() / 4);
    }
}

/// What a client's model answers to the server's requests, one after the other.
fn answered(
    session: &mut crate::harness::Session,
    call: u64,
    sources: &[String],
) -> (Value, Vec<String>) {
    let (mut asked, mut sources) = (Vec::new(), sources.iter());
    loop {
        let message = session
            .message(std::time::Duration::from_secs(120))
            .unwrap();
        if message["method"] == "sampling/createMessage" {
            asked.push(
                message["params"]["messages"][0]["content"]["text"]
                    .as_str()
                    .unwrap()
                    .to_owned(),
            );
            let text = format!(
                "Here it is:\n```python\n{}```\nIt has the bore.",
                sources.next().unwrap()
            );
            let answer = json!({
                "jsonrpc": "2.0", "id": message["id"],
                "result": {"role": "assistant", "model": "m", "stopReason": "endTurn", "content": {"type": "text", "text": text}},
            });
            session.send(&answer.to_string()).unwrap();
        } else if message["id"] == call && !message["result"].is_null() {
            return (message["result"]["structuredContent"].clone(), asked);
        }
    }
}

#[test]
fn a_client_that_runs_its_model_for_the_server_has_the_whole_loop_in_one_call() {
    let root = tempfile::tempdir().unwrap();
    let mut session =
        crate::harness::Session::spawn(crate::kit::program(), root.path(), &[]).unwrap();
    let hello = json!({
        "protocolVersion": "2025-11-25", "capabilities": {"sampling": {}},
        "clientInfo": {"name": "with_a_model", "version": "1"},
    });
    session.request("initialize", hello).unwrap();
    session
        .send(&json!({"jsonrpc": "2.0", "method": "notifications/initialized"}).to_string())
        .unwrap();
    let arguments = with(request("user.disc"), "write", true);
    let call = session.begin_call("synthesize_factory", arguments).unwrap();
    let (answer, asked) = answered(&mut session, call, &[disc("", "5"), disc("", "6")]);
    assert_eq!(
        (&answer["status"], &answer["factory"]),
        (&json!("admitted"), &json!("user.disc@1")),
        "{answer}"
    );
    assert!(
        asked[0].contains("A disc of 40 mm with a bore")
            && asked[0].contains("# The factory language")
    );
    assert!(
        asked[1].contains("extrude(5)") && asked[1].contains("'depth' of the port 'bore' is 5"),
        "{}",
        asked[1]
    );

    // The agent's own loop leaves the same files.
    let mut kit = Kit::new();
    assert_eq!(
        synthesize(&mut kit, with(request("user.disc"), "write", true))["status"],
        "wanted"
    );
    assert_eq!(
        synthesize(
            &mut kit,
            with(request("user.disc"), "source", disc("", "5"))
        )["status"],
        "refused"
    );
    synthesize(
        &mut kit,
        with(request("user.disc"), "source", disc("", "6")),
    );
    for (name, bytes) in kit.files() {
        assert_eq!(
            std::fs::read(root.path().join(&name)).unwrap(),
            bytes,
            "{name}"
        );
    }
}
