//! Lines of the protocol and drafts made worse at random, from fixed seeds, for a bounded time: each is answered, and
//! the session goes on. `ASSEMCAD_FUZZ_SECONDS` and `ASSEMCAD_FUZZ_SEED` make it longer and another.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::kit::Kit;

/// How long each of the two tests goes on where nothing else is said.
const SECONDS: u64 = 6;

fn setting(name: &str, otherwise: u64) -> u64 {
    let value = std::env::var(name).ok();
    value.and_then(|v| v.parse().ok()).unwrap_or(otherwise)
}

/// Numbers that are the same for the same seed (Marsaglia's xorshift).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most.max(1) as u64) as usize
    }
}

/// Pieces that readers stumble over.
const PIECES: [&[u8]; 18] = [
    b"\"",
    b"{",
    b"}",
    b"[",
    b"]",
    b":",
    b",",
    b"\\ud800",
    b"\\u0000",
    b"\xff",
    b"\xf0\x9f",
    b"null",
    b"1e999",
    b"-0",
    b"&a ",
    b"*a",
    b"\x00",
    b"  - ",
];

fn worse(text: &[u8], numbers: &mut Numbers) -> Vec<u8> {
    let mut text = text.to_vec();
    for _ in 0..=numbers.below(3) {
        let at = numbers.below(text.len());
        match numbers.below(6) {
            0 => text.truncate(at),
            1 => drop(text.splice(at..at, PIECES[numbers.below(PIECES.len())].iter().copied())),
            2 => {
                let end = (at + numbers.below(20)).min(text.len());
                text.drain(at..end);
            }
            3 => {
                let end = (at + numbers.below(60)).min(text.len());
                let again = text[at..end].to_vec();
                text.splice(at..at, again);
            }
            4 => {
                let deep = b"[".repeat(numbers.below(300));
                text.splice(at..at, deep);
            }
            _ => {
                if let Some(byte) = text.get_mut(at) {
                    *byte ^= 1 << numbers.below(8);
                }
            }
        }
    }
    text
}

#[test]
fn lines_made_worse_are_answered() {
    let mut kit = Kit::new();
    kit.new_assembly("a");
    let mut numbers = Numbers(setting("ASSEMCAD_FUZZ_SEED", 1) | 1);
    let until = Instant::now() + Duration::from_secs(setting("ASSEMCAD_FUZZ_SECONDS", SECONDS));
    let calls = [
        json!({"name": "get_assembly", "arguments": {"assembly": "a"}}),
        json!({"name": "list_factories", "arguments": {"name_contains": "bearing"}}),
        json!({"name": "find_axioms", "arguments": {"mate_type": "coaxial"}}),
        json!({"name": "validate_draft", "arguments": {"draft": "assembly: {id: x, parts: []}"}}),
    ];
    let mut tried = 0;
    while Instant::now() < until {
        // Ids that no other request of the session has.
        let mut expected = BTreeMap::new();
        for i in 0..20 {
            let id = format!("{tried}-{i}");
            let call = &calls[numbers.below(calls.len())];
            let line = json!({"jsonrpc": "2.0", "id": id, "method": "tools/call", "params": call});
            let line: Vec<u8> = worse(line.to_string().as_bytes(), &mut numbers)
                .into_iter()
                .map(|b| if b == b'\n' { b' ' } else { b })
                .collect();
            kit.session.send_bytes(&line).unwrap();
            // What a reader of its own takes for a request has to be answered by its id.
            let Ok(read) = serde_json::from_slice::<Value>(&line) else {
                continue;
            };
            let request = read["jsonrpc"] == "2.0" && read["method"].is_string();
            if request && let Some(id) = read["id"].as_str() {
                expected.insert(id.to_owned(), String::from_utf8_lossy(&line).into_owned());
            }
        }
        let patience = Instant::now() + Duration::from_secs(20);
        while !expected.is_empty() {
            let left = patience.saturating_duration_since(Instant::now());
            let message = kit.session.message(left);
            let message = message.unwrap_or_else(|e| panic!("{e}: {expected:?} are not answered"));
            if let Some(id) = message["id"].as_str() {
                expected.remove(id);
            }
        }
        tried += 1;
        kit.ok("list_assemblies", json!({}));
    }
    assert!(tried > 5, "{tried}");
}

#[test]
fn drafts_made_worse_are_answered() {
    let mut kit = Kit::with(&["--draft-rounds", "1000000"]);
    let mut numbers = Numbers(setting("ASSEMCAD_FUZZ_SEED", 2) | 1);
    let until = Instant::now() + Duration::from_secs(setting("ASSEMCAD_FUZZ_SECONDS", SECONDS));
    let mut good = Vec::new();
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/drafts")).unwrap()
    {
        let path = entry.unwrap().path();
        let files = std::fs::read_dir(&path)
            .into_iter()
            .flatten()
            .flatten()
            .map(|e| e.path());
        for file in files.chain([path.clone()]).filter(|p| p.is_file()) {
            if file.extension().is_some_and(|e| e == "yaml") {
                good.push(std::fs::read(file).unwrap());
            }
        }
    }
    good.sort();
    assert!(!good.is_empty());
    let mut tried = 0;
    while Instant::now() < until {
        let text = &good[numbers.below(good.len())];
        let draft = String::from_utf8_lossy(&worse(text, &mut numbers)).into_owned();
        let began = Instant::now();
        let answer = kit.ok("validate_draft", json!({"draft": draft}));
        assert!(began.elapsed() < Duration::from_secs(10), "{draft}");
        assert!(answer.to_string().len() < 200_000, "{draft}");
        tried += 1;
    }
    assert!(tried > 20, "{tried}");
}
