//! Short arithmetic over parameters.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_script::expressions;
use serde_json::{Map, Value, json};

fn params() -> Map<String, Value> {
    let all = json!({
        "pin_d": 6.0, "wall": 2.5, "bore_d": 10, "teeth": 3, "a": 3.0, "b": -4.0, "kind": "left",
        "closed": true, "rows": [{"d": 4.5}, {"d": 1.5}], "huge": 1e308,
        "__add": 1.0, "not a name": 1.0,
    });
    all.as_object().unwrap().clone()
}

fn value(text: &str) -> Result<f64, Diagnostic> {
    expressions(&params(), &[text.to_owned()]).remove(0)
}

#[track_caller]
fn refused(text: &str, part: &str) -> Diagnostic {
    let d = value(text).unwrap_err();
    assert_eq!(d.code, Code::ArgumentInvalid);
    assert_eq!(d.place, "expressions[0]");
    assert!(d.message.contains(part), "{d}");
    assert!(d.hint.is_some(), "{d}");
    d
}

#[test]
fn values_as_worked_out_by_hand() {
    for (text, expected) in [
        ("pin_d", 6.0),
        ("bore_d", 10.0),
        (" 2 * wall + bore_d ", 15.0),
        ("min(a, b)", -4.0),
        ("max(a, b, wall)", 3.0),
        ("abs(b) - a", 1.0),
        ("math.sqrt(a * a + b * b)", 5.0),
        ("bore_d / teeth * teeth", 10.0),
        ("bore_d // teeth", 3.0),
        ("bore_d % teeth", 1.0),
        ("rows[0].d - rows[1].d", 3.0),
        ("sum([r.d for r in rows])", 6.0),
        ("a if closed else b", 3.0),
        ("1 if kind == \"left\" else 2", 1.0),
        ("(a +\n b)", -1.0),
        ("round(wall)", 2.0),
        ("(lambda x: x * x)(a)", 9.0),
        ("2 # twice", 2.0),
    ] {
        let found = value(text).unwrap_or_else(|d| panic!("{text}: {d}"));
        assert_eq!(found, expected, "{text}");
    }
    let pi = value("math.pi").unwrap();
    assert_eq!(pi, core::f64::consts::PI);
}

#[test]
fn each_has_its_own_answer_in_order() {
    let texts = ["a", "x", "b"].map(str::to_owned);
    let found = expressions(&params(), &texts);
    assert_eq!((&found[0], &found[2]), (&Ok(3.0), &Ok(-4.0)));
    assert_eq!(found[1].as_ref().unwrap_err().place, "expressions[1]");
}

#[test]
fn unknown_names_with_the_known_ones() {
    let d = refused("2 * wal + 1", "'wal'");
    assert_eq!(d.hint.as_deref(), Some("did you mean wall?"));
    let known = d.expected.unwrap();
    for name in ["pin_d", "wall", "rows"] {
        assert!(known.as_array().unwrap().contains(&json!(name)), "{known}");
    }
    refused("zzzzzzzz", "'zzzzzzzz'");
    refused("math.sqroot(a)", "sqroot");
}

#[test]
fn nothing_but_one_expression() {
    for text in [
        "x = 1",
        "a; b",
        "a\nb",
        "def f(): pass",
        "for i in range(3): pass",
        "if a: b",
        "return a",
        "pass",
        "import math",
        "load(\"x\", \"y\")",
        "a) + (b",
        "a)\nx = (1",
        "(a",
        "a]",
        "",
        "  ",
        "# nothing",
        "a b",
        "__add(a, b)",
        "__import__(\"os\")",
        "open(\"/etc/passwd\")",
        "\0",
    ] {
        refused(text, "");
    }
}

#[test]
fn nothing_but_a_finite_number() {
    for text in [
        "kind",
        "closed",
        "None",
        "rows",
        "(a, b)",
        "a,",
        "[a]",
        "lambda: a",
        "cq.Workplane().box(1, 1, 1)",
        "huge * huge",
        "math.sqrt(b)",
        "a / 0",
        "a // 0",
        "factory",
        "factory(doc = \"\", params = {})",
        "fail(\"x\")",
    ] {
        refused(text, "");
    }
}

#[test]
fn limits_hold() {
    refused(&"1+".repeat(3000), "more than 4096");
    refused(
        &format!("{}1{}", "(".repeat(400), ")".repeat(400)),
        "limit nesting",
    );
    refused(&format!("1{}", "+1".repeat(400)), "limit nesting");
    refused("len(\"x\" * 1000000000)", "limit text_bytes");
    refused(
        "len([0 for i in range(20000) for j in range(20000) if 0])",
        "limit ticks",
    );
    refused("(lambda f: f(f))(lambda f: f(f))", "limit call_depth");
}
