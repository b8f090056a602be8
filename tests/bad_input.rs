//! Nonsense: a clear answer each, and nothing written.

use std::time::Duration;

use serde_json::{Value, json};

use crate::kit::Kit;

/// The session still works and no file has changed.
fn unharmed(kit: &mut Kit, before: &std::collections::BTreeMap<String, Vec<u8>>) {
    assert_eq!(
        kit.ok("list_assemblies", json!({}))["assemblies"],
        json!(["stand"])
    );
    assert_eq!(&kit.files(), before);
}

fn kit() -> (Kit, std::collections::BTreeMap<String, Vec<u8>>) {
    let mut kit = Kit::new();
    kit.stand("stand");
    let files = kit.files();
    (kit, files)
}

#[test]
fn malformed_messages() {
    let (mut kit, before) = kit();
    // The first column says which error is answered; a line of nothing and a notification get no answer.
    for (code, line) in [
        (None, ""),
        (Some(-32700), "{"),
        (Some(-32700), "not json at all"),
        (Some(-32600), "[]"),
        (Some(-32600), "null"),
        (Some(-32600), "42"),
        (Some(-32600), r#"{"jsonrpc": "2.0"}"#),
        (
            Some(-32600),
            r#"{"jsonrpc": "1.0", "id": 901, "method": "tools/list"}"#,
        ),
        (
            Some(-32600),
            r#"{"jsonrpc": "2.0", "id": 902, "method": 7}"#,
        ),
        (
            Some(-32600),
            r#"{"jsonrpc": "2.0", "id": {"a": 1}, "method": "tools/list"}"#,
        ),
        (
            None,
            r#"{"jsonrpc": "2.0", "method": "no/such/notification"}"#,
        ),
        (
            Some(-32700),
            "{\"jsonrpc\": \"2.0\", \"id\": 903, \"method\": \"tools/list\"\u{0}}",
        ),
    ] {
        kit.session.send(line).unwrap();
        if let Some(code) = code {
            let answer = kit.session.message(Duration::from_secs(20)).unwrap();
            assert_eq!(answer["error"]["code"], code, "{line}: {answer}");
        }
        unharmed(&mut kit, &before);
    }
}

#[test]
fn malformed_requests_are_answered() {
    let (mut kit, before) = kit();
    for (method, params) in [
        ("no/such/method", json!({})),
        ("tools/call", json!({})),
        ("tools/call", json!({"name": 7, "arguments": {}})),
        ("tools/call", json!({"name": "verify", "arguments": [1, 2]})),
        (
            "tools/call",
            json!({"name": "verify", "arguments": "stand"}),
        ),
    ] {
        let answer = kit.session.request(method, params.clone()).unwrap();
        let message = answer["error"]["message"].as_str();
        assert!(
            message.is_some_and(|m| !m.is_empty()),
            "{method} {params}: {answer}"
        );
        unharmed(&mut kit, &before);
    }
}

#[test]
fn numbers_that_are_none() {
    let (mut kit, before) = kit();
    // NaN and Infinity are no JSON: the line is refused as such, by whoever reads it first.
    for number in ["NaN", "Infinity", "-Infinity"] {
        let line = format!(
            r#"{{"jsonrpc":"2.0","id":950,"method":"tools/call","params":{{"name":"verify","arguments":{{"assembly":"stand","tau_mm3":{number}}}}}}}"#
        );
        kit.session.send(&line).unwrap();
        let answer = kit.session.message(Duration::from_secs(20)).unwrap();
        assert_eq!(answer["error"]["code"], -32700, "{answer}");
        unharmed(&mut kit, &before);
    }
    // 1e999 is JSON, but no number that can be computed with.
    for (place, number) in [
        ("length", "1e999"),
        ("length", "-1e999"),
        ("thickness", "1e400"),
    ] {
        let line = format!(
            r#"{{"jsonrpc":"2.0","id":960,"method":"tools/call","params":{{"name":"add_part","arguments":{{"assembly":"stand","part":"x","factory":"base_frame.rect_plate","params":{{"{place}":{number}}}}}}}}}"#
        );
        kit.session.send(&line).unwrap();
        let answer = loop {
            let message = kit.session.message(Duration::from_secs(20)).unwrap();
            if message["id"] == 960 {
                break message;
            }
        };
        let refused = answer.get("error").is_some() || answer["result"]["isError"] == json!(true);
        assert!(refused, "{answer}");
        unharmed(&mut kit, &before);
    }
    for (field, value) in [
        ("u_mm", json!("NaN")),
        ("u_mm", json!("Infinity")),
        ("u_mm", json!(1e300)),
        ("u_mm", json!(-1e5 - 1.0)),
        ("alpha_deg", json!(361)),
        ("v_mm", json!([1])),
        ("v_mm", json!({})),
        ("d_n_mm", json!(true)),
    ] {
        let mut call = json!({
            "assembly": "stand", "id": "x", "mate_type": "face_to_face",
            "base": "plate:side_face_x_pos", "incoming": "block:side_face_x_neg",
        });
        call[field] = value.clone();
        let d = kit.refusal("mate", call);
        assert!(d["where"].as_str().unwrap().contains(field), "{d}");
        unharmed(&mut kit, &before);
    }
    let d = kit.refusal("verify", json!({"assembly": "stand", "tau_mm3": -1}));
    assert_eq!(
        (&d["code"], &d["where"]),
        (&json!("argument_invalid"), &json!("tau_mm3"))
    );
}

#[test]
fn dimensions_out_of_reason() {
    let (mut kit, before) = kit();
    for value in [
        json!(-5),
        json!(0),
        json!(1e12),
        json!("12"),
        json!(null),
        json!({"mm": 3}),
    ] {
        let d = kit.refusal(
            "add_part",
            json!({
                "assembly": "stand", "part": "x", "factory": "base_frame.rect_plate",
                "params": {"length": value},
            }),
        );
        assert_eq!(
            (&d["code"], &d["where"]),
            (&json!("param_invalid"), &json!("params.length"))
        );
        assert_eq!(d["found"], value);
        assert!(d["expected"].as_str().unwrap().contains("mm"), "{d}");
        unharmed(&mut kit, &before);
    }
}

#[test]
fn names_that_are_paths_or_endless() {
    let (mut kit, before) = kit();
    let long = "x".repeat(10_000);
    for name in [
        "",
        ".",
        "..",
        "../up",
        "/etc/passwd",
        "a/b",
        "a\\b",
        "a b",
        "a:b",
        "a\u{0}b",
        "-a",
        "ä",
        "a\nb",
        &long,
    ] {
        let d = kit.refusal("new_assembly", json!({"assembly": name}));
        assert_eq!(
            (&d["code"], &d["where"]),
            (&json!("name_invalid"), &json!("assembly"))
        );
        let d = kit.refusal(
            "add_part",
            json!({"assembly": "stand", "part": name, "factory": "base_frame.rect_plate"}),
        );
        assert_eq!(
            (&d["code"], &d["where"]),
            (&json!("name_invalid"), &json!("part"))
        );
        for tool in ["verify", "export_step", "get_assembly"] {
            kit.refusal(tool, json!({"assembly": name}));
        }
        kit.refusal("describe_factory", json!({"factory": name}));
        kit.refused(
            "mate",
            json!({
                "assembly": "stand", "id": name, "mate_type": "coaxial",
                "base": format!("{name}:a"), "incoming": format!("plate:{name}"),
            }),
        );
        unharmed(&mut kit, &before);
    }
}

#[test]
fn files_are_written_below_the_root_only() {
    let (mut kit, before) = kit();
    let outside = tempfile::tempdir().unwrap();
    let absolute = outside.path().join("x.step");
    let link = kit.root().join("exports/stand/link");
    std::fs::create_dir_all(link.parent().unwrap()).unwrap();
    std::os::unix::fs::symlink(outside.path(), &link).unwrap();
    for file in [
        "../x.step",
        "a/../../x.step",
        "link/x.step",
        "link/deep/x.step",
        absolute.to_str().unwrap(),
        "",
        "x",
        "x.txt",
        "assemblies/stand/assembly.yaml",
        "a/",
        ".step/..",
    ] {
        let d = kit.refusal("export_step", json!({"assembly": "stand", "file": file}));
        assert_eq!(d["code"], "path_invalid", "{d}");
        assert!(d["found"].as_str().unwrap().ends_with(file), "{d}");
    }
    assert_eq!(std::fs::read_dir(outside.path()).unwrap().count(), 0);
    std::fs::remove_file(link).unwrap();
    unharmed(&mut kit, &before);
}

#[test]
fn arguments_of_every_wrong_type() {
    let (mut kit, before) = kit();
    let tools = kit.session.request("tools/list", json!({})).unwrap();
    let tools = tools["result"]["tools"].as_array().unwrap().clone();
    assert_eq!(tools.len(), 18);
    let wrong = [
        json!(null),
        json!(-1),
        json!([[]]),
        json!({"a": {}}),
        json!(true),
    ];
    for tool in &tools {
        let name = tool["name"].as_str().unwrap();
        let fields: Vec<&String> = tool["inputSchema"]["properties"]
            .as_object()
            .into_iter()
            .flatten()
            .map(|(k, _)| k)
            .collect();
        for value in &wrong {
            let arguments: Value = fields
                .iter()
                .map(|f| ((*f).clone(), value.clone()))
                .collect();
            // A null argument is an absent one: refused only where something is required.
            let required = tool["inputSchema"].get("required").is_some();
            if !fields.is_empty() && (required || !value.is_null()) {
                kit.refused(name, arguments);
            }
        }
        kit.refused(name, json!({"no_such_argument": 1}));
    }
    unharmed(&mut kit, &before);
}
