//! Whole specifications: a folder for each draft, good and bad, with all that must be said of it.
//!
//! `expected.txt` holds `valid` or `invalid` and a line for each diagnostic: severity, code, place, message.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::kit::Kit;

fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/drafts");
    let mut cases: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    cases.sort();
    cases
}

/// A draft of the case folders.
pub fn draft(name: &str) -> String {
    let path = format!("../tests/drafts/{name}/draft.yaml");
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

fn told(answer: &Value) -> String {
    let word = |d: &Value, key: &str| d[key].as_str().unwrap().to_owned();
    let mut lines = vec![
        if answer["valid"] == true {
            "valid"
        } else {
            "invalid"
        }
        .to_owned(),
    ];
    for d in answer["diagnostics"].as_array().unwrap() {
        lines.push(format!(
            "{} {} | {} | {}",
            word(d, "severity"),
            word(d, "code"),
            word(d, "where"),
            word(d, "message")
        ));
    }
    lines.join("\n") + "\n"
}

#[test]
fn every_draft_is_told_what_is_wrong_with_it_and_nothing_else() {
    let mut kit = Kit::with(&["--draft-rounds", "1000"]);
    let mut different = String::new();
    let cases = cases();
    assert!(cases.len() >= 30, "{}", cases.len());
    for case in cases {
        let name = case.file_name().unwrap().to_str().unwrap();
        let text = std::fs::read_to_string(case.join("draft.yaml")).unwrap();
        let expected = std::fs::read_to_string(case.join("expected.txt")).unwrap();
        let answer = kit.ok("validate_draft", json!({"draft": text}));
        let found = told(&answer);
        assert_eq!(answer["not_shown"], 0, "{name}");
        if found != expected {
            different.push_str(&format!(
                "\n{name}\n--- expected\n{expected}--- found\n{found}"
            ));
        }
        // The names say what the cases are, so that a case that flips cannot pass with its golden file.
        let bad = name.starts_with("bad_");
        assert_eq!(answer["valid"] == false, bad, "{name}");
    }
    assert!(different.is_empty(), "{different}");
    // Nothing was made of any of them.
    let none: [&str; 0] = [];
    assert_eq!(
        kit.ok("list_assemblies", json!({}))["assemblies"],
        json!(none)
    );
}

#[test]
fn a_draft_may_be_a_file_below_the_root() {
    let mut kit = Kit::new();
    std::fs::write(kit.file("stand.yaml"), draft("good_stand")).unwrap();
    let answer = kit.ok("validate_draft", json!({"file": "stand.yaml"}));
    assert_eq!(answer["valid"], true);
    assert_eq!(answer["draft"], "good_stand");
    for (call, code) in [
        (json!({"file": "../stand.yaml"}), "path_invalid"),
        (json!({"file": "none.yaml"}), "file_failed"),
        (json!({"file": "assemblies"}), "file_failed"),
        (json!({}), "argument_invalid"),
        (
            json!({"file": "stand.yaml", "draft": "x"}),
            "argument_invalid",
        ),
    ] {
        assert_eq!(kit.refusal("validate_draft", call)["code"], code);
    }
}

#[test]
fn after_so_many_rounds_the_decomposition_has_failed() {
    let mut kit = Kit::with(&["--draft-rounds", "3"]);
    let good = draft("good_stand");
    let bad = |n: usize| good.replace("top_face", &format!("top_{n}"));
    let round = |kit: &mut Kit, text: &str| {
        let answer = kit.ok("validate_draft", json!({"draft": text}));
        (
            answer["valid"].as_bool().unwrap(),
            answer["round"].as_u64().unwrap(),
        )
    };
    assert_eq!(round(&mut kit, &bad(1)), (false, 1));
    // The same text again is no new round; a server started again goes on counting (with its own limit).
    assert_eq!(round(&mut kit, &bad(1)), (false, 1));
    assert_eq!(round(&mut kit, &bad(2)), (false, 2));
    let found = kit.refused("validate_draft", json!({"draft": bad(3)}));
    assert_eq!(found[0]["code"], "decomposition_failed");
    assert_eq!(
        found[0]["found"],
        json!(
            (1..=3)
                .map(|n| json!({"round": n, "errors": 1, "codes": {"port_unknown": 1}}))
                .collect::<Vec<_>>()
        )
    );
    // What is still wrong is told all the same, and realize is bounded by the same count.
    assert_eq!(found[1]["code"], "port_unknown");
    let found = kit.refused("realize", json!({"draft": bad(4)}));
    assert_eq!(found[0]["code"], "decomposition_failed");
    assert_eq!(found[0]["found"].as_array().unwrap().len(), 4);
    // Another id begins anew, and so does this one once it was valid.
    assert_eq!(
        round(&mut kit, &bad(1).replace("good_stand", "other")),
        (false, 1)
    );
    assert!(round(&mut kit, &good).0);
    assert_eq!(round(&mut kit, &bad(5)), (false, 1));
    let mut kit = kit.killed_and_started_again();
    assert_eq!(round(&mut kit, &bad(6)), (false, 2));
}

#[test]
fn the_prompt_tells_what_a_draft_needs() {
    let mut kit = Kit::new();
    let all = kit.session.request("prompts/list", json!({})).unwrap();
    let prompts = all["result"]["prompts"].as_array().unwrap();
    let names: Vec<&Value> = prompts.iter().map(|p| &p["name"]).collect();
    assert_eq!(names, ["decompose", "repair", "synthesize"]);
    assert_eq!(prompts[0]["name"], "decompose");
    assert_eq!(prompts[0]["arguments"][0]["name"], "description");
    assert_eq!(prompts[0]["arguments"][0]["required"], true);
    let get = |kit: &mut Kit, params: Value| kit.session.request("prompts/get", params).unwrap();
    let answer = get(
        &mut kit,
        json!({"name": "decompose", "arguments": {"description": "a winch for 200 kg"}}),
    );
    let message = &answer["result"]["messages"][0];
    assert_eq!(message["role"], "user");
    let text = message["content"]["text"].as_str().unwrap();
    for word in [
        "a winch for 200 kg",
        // A factory of the server's own folder is there too: the tables are made when asked for.
        "test.block(size=10)",
        "validate_draft",
    ] {
        assert!(text.contains(word), "{word}\n{text}");
    }
    // Four characters to a token.
    let tokens = text.chars().count() / 4;
    assert!(tokens < 4500, "{tokens} tokens");
    let names = assemcad_factories::Registry::builtin().names();
    let mates = assemcad_model::mates::ALL
        .iter()
        .map(|k| format!("`{}(", k.name));
    let ports = assemcad_model::ports::ALL
        .iter()
        .map(|k| format!("`{}`", k.name));
    for word in names.into_iter().chain(mates).chain(ports) {
        assert!(text.contains(&word), "{word}");
    }

    // What a caller writes stays as it is.
    let odd = json!({"name": "decompose", "arguments": {"description": "with {{MATES}} in it"}});
    let odd = get(&mut kit, odd);
    let odd = odd["result"]["messages"][0]["content"]["text"]
        .as_str()
        .unwrap();
    assert_eq!(odd.matches("{{").count(), 1, "{odd}");
    assert!(odd.ends_with("with {{MATES}} in it\n"));

    // Its example is a valid draft.
    let example = text.split("```yaml\n").nth(1).unwrap();
    let example = example.split("```").next().unwrap();
    let checked = kit.ok("validate_draft", json!({"draft": example}));
    assert_eq!(checked["valid"], true);
    let codes: Vec<&str> = checked["diagnostics"]
        .as_array()
        .unwrap()
        .iter()
        .map(|d| d["code"].as_str().unwrap())
        .collect();
    // The comment in it, and nothing else.
    assert_eq!(codes, ["comment_lost"]);
    // And it is a machine that holds.
    let made = kit.ok("realize", json!({"draft": example}));
    assert_eq!(
        (&made["realized"], &made["verdict"]),
        (&json!(true), &json!("pass"))
    );
    // Every axiom is told with its title, once.
    for axiom in assemcad_axioms::axioms() {
        let told = format!("{} {}", axiom.id, axiom.title);
        assert_eq!(text.matches(&told).count(), 1, "{told}");
    }

    for params in [
        json!({"name": "compose"}),
        json!({"name": "decompose"}),
        json!({"name": "decompose", "arguments": {"description": 7}}),
    ] {
        assert!(get(&mut kit, params)["error"]["code"].is_i64());
    }
}
