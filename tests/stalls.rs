//! A request is always answered, and soon: whatever else is asked at the same time.

use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::harness::Session;
use crate::kit::{Kit, program};

#[test]
fn what_cannot_be_read_is_answered_with_its_id() {
    let mut kit = Kit::new();
    let deep = format!("{}1{}", "[".repeat(130), "]".repeat(130));
    for value in [br#""\ud800""#.as_slice(), b"\"\xff\"", deep.as_bytes()] {
        let head = br#"{"jsonrpc":"2.0","id":"asked","method":"tools/call","params":{"name":"get_assembly","arguments":{"assembly":"#;
        let line = [head.as_slice(), value, b"}}}"].concat();
        kit.session.send_bytes(&line).unwrap();
        let answer = kit.session.message(Duration::from_secs(20)).unwrap();
        assert_eq!(answer["id"], "asked", "{answer}");
        assert_eq!(answer["error"]["code"], -32700, "{answer}");
        kit.ok("list_assemblies", json!({}));
    }
}

#[test]
fn a_method_that_is_not_there_is_told_in_words() {
    let root = tempfile::tempdir().unwrap();
    let mut session = Session::spawn(program(), root.path(), &[]).unwrap();
    let meta = json!({
        "io.modelcontextprotocol/protocolVersion": "2026-07-28",
        "io.modelcontextprotocol/clientInfo": {"name": "t", "version": "1"},
        "io.modelcontextprotocol/clientCapabilities": {},
    });
    session
        .request("server/discover", json!({"_meta": meta}))
        .unwrap();
    for method in ["logging/setLevel", "resources/subscribe", "resources/read"] {
        let params = json!({"_meta": meta, "uri": "a://b", "level": "info"});
        let answer = session.request(method, params).unwrap();
        assert_eq!(answer["error"]["code"], -32601, "{answer}");
        let message = answer["error"]["message"].as_str().unwrap();
        let words = message.contains("not support") && message.contains(method);
        assert!(words, "{answer}");
    }
}

/// The longest time that a ping took while calls were running.
fn pings_until(kit: &mut Kit, calls: &[u64]) -> (Duration, Vec<Value>) {
    let mut slowest = Duration::ZERO;
    let mut answers = Vec::new();
    let mut left = calls.to_vec();
    while !left.is_empty() {
        let began = Instant::now();
        kit.session.request("ping", json!({})).unwrap();
        slowest = slowest.max(began.elapsed());
        std::thread::sleep(Duration::from_millis(20));
        left.retain(|id| match kit.session.answered(*id) {
            Some(answer) => {
                answers.push(answer);
                false
            }
            None => true,
        });
    }
    (slowest, answers)
}

#[test]
fn sixty_thousand_unknown_keys_keep_nobody_waiting() {
    let mut kit = Kit::new();
    let keys = |n: usize, from: usize| -> String {
        (from..from + n)
            .map(|i| format!("  key_{i}: 1\n"))
            .collect()
    };
    let unknown = format!("assembly:\n  id: a\n  parts: []\n{}", keys(60_000, 0));
    let twice = format!("assembly:\n  id: b\n{}{}", keys(30_000, 0), keys(30_000, 0));
    assert!(unknown.len() > 700_000);
    let began = Instant::now();
    let calls = [unknown, twice].map(|draft| {
        kit.session
            .begin_call("validate_draft", json!({"draft": draft}))
            .unwrap()
    });
    let (slowest, answers) = pings_until(&mut kit, &calls);
    let took = began.elapsed();
    assert!(slowest < Duration::from_secs(1), "a ping took {slowest:?}");
    assert!(took < Duration::from_secs(30), "the drafts took {took:?}");
    for answer in answers {
        assert!(answer.to_string().len() < 100_000);
        let content = &answer["result"]["structuredContent"];
        assert!(
            content["errors_total"].as_u64().unwrap() >= 60_000,
            "{content}"
        );
        let shown = content["diagnostics"].as_array().unwrap().len() as u64;
        assert_eq!(shown, 40);
        assert!(content["not_shown"].as_u64().unwrap() >= 60_000 - 40);
    }
}

#[test]
fn anchors_within_anchors_copy_no_more_than_the_text_may_hold() {
    let mut kit = Kit::new();
    let leaves = "1, ".repeat(30_000);
    let (open, close) = (
        (0..28).map(|i| format!("&a{i} [")).collect::<String>(),
        "]".repeat(28),
    );
    let draft = format!("assembly: {{id: a, x: {open}{leaves}{close}}}");
    let began = Instant::now();
    let answer = kit.ok("validate_draft", json!({"draft": draft}));
    assert!(
        began.elapsed() < Duration::from_secs(20),
        "{:?}",
        began.elapsed()
    );
    let said = answer["diagnostics"][0]["message"].as_str().unwrap();
    assert!(said.contains("aliases written out"), "{answer}");
}

#[test]
fn a_list_of_diagnostics_has_an_end() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    let params: serde_json::Map<String, Value> =
        (0..20_000).map(|i| (format!("p{i}"), json!(1))).collect();
    let found = kit.refused(
        "add_part",
        json!({"assembly": "a", "part": "p", "factory": "base_frame.rect_plate", "params": params}),
    );
    assert_eq!(found.len(), 41);
    assert_eq!(found[40]["code"], "not_shown");
    assert_eq!(found[40]["found"], 20_000 - 40);
    let arguments: serde_json::Map<String, Value> =
        (0..20_000).map(|i| (format!("p{i}"), json!(1))).collect();
    let found = kit.refused("list_assemblies", Value::Object(arguments));
    assert!(
        found[0]["message"]
            .as_str()
            .unwrap()
            .contains("and 19990 more")
    );
}

#[test]
fn mates_of_parts_that_are_not_there_cost_no_more_than_they_say() {
    let mut kit = Kit::new();
    let parts: String = (0..4000)
        .map(|i| format!("  - {{id: part_{i}, factory: fastener.nut}}\n"))
        .collect();
    let mates: String = (0..4000)
        .map(|i| format!("  - {{id: m{i}, mate_type: coaxial, base: {{ref: prat_{i}, port: a}}, incoming: {{ref: patr_{i}, port: b}}}}\n"))
        .collect();
    let draft = format!("assembly:\n  id: a\n  parts:\n{parts}  mates:\n{mates}");
    let call = kit
        .session
        .begin_call("validate_draft", json!({"draft": draft}))
        .unwrap();
    let began = Instant::now();
    let (slowest, answers) = pings_until(&mut kit, &[call]);
    assert!(slowest < Duration::from_secs(1), "a ping took {slowest:?}");
    assert!(
        began.elapsed() < Duration::from_secs(60),
        "{:?}",
        began.elapsed()
    );
    assert!(answers[0].to_string().len() < 200_000);
}

#[test]
fn a_thousand_gears_are_not_compared_with_each_other() {
    let mut kit = Kit::new();
    let parts: String = (0..1000)
        .map(|i| format!("  - {{id: gear_{i}, factory: gear.spur}}\n"))
        .collect();
    let mates: String = (0..1000)
        .map(|i| format!("  - {{id: m{i}, mate_type: face_to_face, axioms: [C-01], base: {{ref: plate, port: top_face}}, incoming: {{ref: gear_{i}, port: face_bottom}}, options: {{u_mm: {}}}}}\n", i / 2))
        .collect();
    let draft = format!(
        "assembly:\n  id: a\n  parts:\n  - {{id: plate, factory: base_frame.rect_plate}}\n{parts}  mates:\n{mates}"
    );
    let began = Instant::now();
    let answer = kit.ok("validate_draft", json!({"draft": draft}));
    assert!(
        began.elapsed() < Duration::from_secs(20),
        "{:?}",
        began.elapsed()
    );
    let found = answer["diagnostics"].as_array().unwrap();
    assert!(
        answer.to_string().contains("lands in the very place of"),
        "{}",
        found[0]
    );
    // Of each two in one place, the second is told.
    assert_eq!(answer["errors_total"], 500, "{}", found[0]);
}

#[test]
fn where_a_client_is_gone_the_work_ends() {
    let root = tempfile::tempdir().unwrap();
    let mut child = Command::new(program())
        .args(["serve", "--workers", "1", "--factories"])
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/factories"))
        .arg("--root")
        .arg(root.path())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let mut output = BufReader::new(child.stdout.take().unwrap());
    let mut ask = |message: Value| writeln!(input, "{message}").unwrap();
    ask(
        json!({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {
            "protocolVersion": "2025-11-25", "capabilities": {}, "clientInfo": {"name": "t", "version": "1"},
        }}),
    );
    ask(json!({"jsonrpc": "2.0", "method": "notifications/initialized"}));
    for (id, tool, arguments) in [
        (2, "new_assembly", json!({"assembly": "a"})),
        (
            3,
            "add_part",
            json!({"assembly": "a", "part": "slow", "factory": "test.endless"}),
        ),
    ] {
        ask(
            json!({"jsonrpc": "2.0", "id": id, "method": "tools/call", "params": {"name": tool, "arguments": arguments}}),
        );
        let mut line = String::new();
        if id == 2 {
            output.read_line(&mut line).unwrap();
            output.read_line(&mut line).unwrap();
        }
    }
    std::thread::sleep(Duration::from_millis(500));
    // As a client that was killed: neither end of it is there any more.
    drop(input);
    drop(output);
    let until = Instant::now() + Duration::from_secs(15);
    while child.try_wait().unwrap().is_none() {
        assert!(Instant::now() < until, "the server works on for nobody");
        std::thread::sleep(Duration::from_millis(50));
    }
}
