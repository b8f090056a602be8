use super::{Kind, MOST_BYTES, Node, Step, read, write};
use crate::diagnostic::{Code, Severity};
use proptest::prelude::*;
use serde_json::{Map, Value, json};

fn node(text: &str) -> Node {
    let r = read(text);
    assert_eq!(r.faults, Vec::new(), "{text}");
    r.node.unwrap()
}

fn faults(text: &str) -> Vec<(String, String)> {
    let told = |d: crate::diagnostic::Diagnostic| (d.place, d.message);
    read(text).faults.into_iter().map(told).collect()
}

#[test]
fn a_plain_word_is_text_where_text_is_wanted() {
    let schema = json!({"properties": {
        "id": {"type": "string"}, "maybe": {"type": ["string", "null"]},
        "list": {"items": {"type": "string"}},
    }});
    for word in ["on", "1e3", "007", "null", "true", "0x10", "3"] {
        let text = format!("{{id: {word}, maybe: {word}, list: [{word}], free: '{word}'}}");
        let wanted = json!({"id": word, "maybe": word, "list": [word], "free": word});
        assert_eq!(node(&text).value(Some(&schema)), wanted, "{text}");
    }
    // Nothing at all is not an empty text.
    assert_eq!(node("id:").value(Some(&schema)), json!({"id": null}));
    assert_eq!(node("id: ''").value(Some(&schema)), json!({"id": ""}));
    assert_eq!(
        node("{a: 1e3, b: on, c: true}").value(None),
        json!({"a": 1000.0, "b": "on", "c": true})
    );
}

#[test]
fn lines_are_those_of_the_text() {
    let n = node("a:\n  b:\n    - x: 1\n      y: 2\n    - {x: 3,\n       y: 4}\n");
    let key = |s: &str| Step::Key(s.to_owned());
    for (path, line) in [
        (vec![], 1),
        (vec![key("a")], 1),
        (vec![key("a"), key("b")], 2),
        (vec![key("a"), key("b"), Step::Index(0)], 3),
        (vec![key("a"), key("b"), Step::Index(0), key("y")], 4),
        (vec![key("a"), key("b"), Step::Index(1), key("y")], 6),
        // What is not there is looked for around it.
        (vec![key("a"), key("b"), Step::Index(1), key("z")], 5),
        (vec![key("a"), key("q"), Step::Index(9)], 1),
    ] {
        assert_eq!(n.line_of(&path), line, "{path:?}");
    }
}

#[test]
fn keys_given_twice_are_all_told_and_the_first_stays() {
    let r = read("a: 1\nb: {c: 1, c: 2}\na: 3\n");
    let told: Vec<&str> = r.faults.iter().map(|d| d.place.as_str()).collect();
    assert_eq!(told, ["line 2", "line 3"]);
    assert_eq!(r.node.unwrap().value(None), json!({"a": 1, "b": {"c": 1}}));
}

#[test]
fn what_multiplies_is_stopped() {
    let mut bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n".to_owned();
    for i in 1..12 {
        let before = format!("*a{}, ", i - 1).repeat(10);
        bomb.push_str(&format!("a{i}: &a{i} [{before}]\n"));
    }
    let r = read(&bomb);
    assert!(r.node.is_none());
    assert!(r.faults[0].message.contains("200000"), "{:?}", r.faults);
    assert!(read(&"[".repeat(100_000)).node.is_none());
    assert!(read(&"- ".repeat(100_000)).node.is_none());
    assert!(read(&"x".repeat(MOST_BYTES + 1)).node.is_none());
    // Depth by aliases: each level wraps the one before.
    let mut deep = "a0: &a0 [x]\n".to_owned();
    for i in 1..40 {
        deep.push_str(&format!("a{i}: &a{i} [*a{}]\n", i - 1));
    }
    assert!(read(&deep).node.is_none());
    assert!(read("a: &a [*a]").node.is_none());
    let n = node("a: &x {r: 1}\nb: *x\n");
    assert_eq!(n.value(None), json!({"a": {"r": 1}, "b": {"r": 1}}));
    assert_eq!(n.line_of(&[Step::Key("b".to_owned())]), 2);
}

#[test]
fn what_has_no_meaning_is_told() {
    for (text, line, word) in [
        ("a: 1\n---\nb: 2\n", "line 2", "one document"),
        ("a: !!str 1\n", "line 1", "tags"),
        ("a: 1\n? [x]\n: 2\n", "line 2", "key"),
        ("a: 1\nb: [1, 2\nc: 3\n", "line 3", "no YAML"),
        ("a:\n\tb: 2\n", "line 2", "no YAML"),
        ("a: *nowhere\n", "line 1", "no YAML"),
        ("", "line 1", "empty"),
        ("# only this\n", "line 1", "empty"),
    ] {
        let found = faults(text);
        assert_eq!(found[0].0, line, "{text}: {found:?}");
        assert!(found[0].1.contains(word), "{text}: {found:?}");
    }
}

#[test]
fn comments_are_lost_with_a_warning_and_nothing_else_is_taken_for_one() {
    for (text, line) in [
        ("# top\na: 1\n", 1),
        ("a: 1 # why\n", 1),
        ("a: \"#x\"\n# end", 2),
        ("a:\n  - b # x\n", 2),
    ] {
        let r = read(text);
        assert_eq!(r.faults.len(), 1, "{text}");
        assert_eq!(r.faults[0].code, Code::CommentLost);
        assert_eq!(r.faults[0].severity, Severity::Warning);
        assert_eq!(r.faults[0].place, format!("line {line}"), "{text}");
    }
    for text in [
        "a: \"x # y\"\n",
        "a: 'x # y'\n",
        "a: x#y\n",
        "a: |\n  x # y\n  # z\nb: 1\n",
        "a: &b#c 1\n",
    ] {
        assert_eq!(faults(text), Vec::new(), "{text}");
    }
}

#[test]
fn json_is_read_by_the_same_reader() {
    let value = json!({"a": [1, 2.5, null, true, "x\u{e9}/\"\\\n"], "b": {}, "c": []});
    for text in [
        value.to_string(),
        serde_json::to_string_pretty(&value).unwrap(),
        serde_json::to_string_pretty(&value)
            .unwrap()
            .replace("  ", "\t"),
    ] {
        assert_eq!(node(&text).value(None), value, "{text}");
    }
}

#[test]
fn the_form_is_one() {
    let document = json!({
        "format": 1,
        "assembly": {
            "id": "on", "description": "a \"b\" # c", "nothing": [], "empty": {},
            "parts": [
                {"id": "p-1", "factory": "base_frame.rect_plate", "params": {"l": 1.50, "k": 3, "s": [{"d": 0.1}]}},
                {"id": "1e3", "params": {}},
            ],
        },
    });
    let text = write(document.as_object().unwrap());
    let wanted = r#"format: 1
assembly:
  id: "on"
  description: "a \"b\" # c"
  nothing: []
  empty: {}
  parts:
    - id: p-1
      factory: base_frame.rect_plate
      params: {l: 1.5, k: 3, s: [{d: 0.1}]}
    - id: "1e3"
      params: {}
"#;
    assert_eq!(text, wanted);
    assert_eq!(node(&text).value(None), document);
}

fn any_text() -> impl Strategy<Value = String> {
    prop_oneof![
        "[a-z]{1,8}",
        any::<String>(),
        prop::sample::select(vec![
            "on",
            "1e3",
            "null",
            "~",
            "",
            " ",
            "- x",
            "a: b",
            "#",
            "*a",
            "&a",
            "!t",
            "%",
            "@",
            "`",
            "|",
            ">",
            "\n",
            "\r\n",
            "\u{85}",
            "\u{2028}",
            "\u{feff}",
            "\u{0}",
            "\u{ffff}",
            "007",
            ".5",
            "{",
            "]",
            "? x",
            "---",
            "...",
            "\t",
            "\"",
            "'",
            "\u{1F600}",
            "=",
            "<<",
        ])
        .prop_map(str::to_owned),
    ]
}

fn any_value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(|b| json!(b)),
        any::<i64>().prop_map(|n| json!(n)),
        prop::num::f64::NORMAL.prop_map(|n| json!(n)),
        (-1000i32..1000).prop_map(|n| json!(f64::from(n) / 10.0)),
        any_text().prop_map(|s| json!(s)),
    ];
    leaf.prop_recursive(3, 24, 4, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..4).prop_map(Value::Array),
            prop::collection::vec((any_text(), inner), 0..4)
                .prop_map(|e| Value::Object(e.into_iter().collect::<Map<_, _>>())),
        ]
    })
}

proptest! {
    #[test]
    fn what_is_written_is_read_back(value in any_value(), top in any_text()) {
        let document: Map<String, Value> = [(top, value)].into_iter().collect();
        let text = write(&document);
        let r = read(&text);
        prop_assert!(r.faults.is_empty(), "{text}\n{:?}", r.faults);
        let read_back = r.node.unwrap().value(None);
        prop_assert_eq!(&read_back, &Value::Object(document), "{}", &text);
        prop_assert_eq!(write(read_back.as_object().unwrap()), text);
    }

    #[test]
    fn no_text_breaks_the_reader(text in "[-a:{}\\[\\], \n\t#&*!|>'\"%@?0-9.~]{0,80}") {
        let r = read(&text);
        prop_assert!(r.node.is_some() || !r.faults.is_empty());
    }
}

#[test]
fn a_quoted_number_stays_text() {
    let n = node("a: \"120\"");
    assert!(matches!(
        n.get("a").unwrap().kind,
        Kind::Scalar { plain: false, .. }
    ));
    assert_eq!(n.value(None), json!({"a": "120"}));
}
