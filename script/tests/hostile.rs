//! Sources that reach for what is outside, hide something in their bytes, or ask for too much at once:
//! one diagnostic each, at its line.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use core::time::Duration;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_script::{Factory, Limits, script};
use serde_json::Map;

/// A factory whose `build(p)` begins at line 3 with these lines.
fn building(lines: &str) -> String {
    let body: String = lines.lines().map(|l| format!("    {l}\n")).collect();
    format!(
        "factory(doc = \"\", params = {{}})\ndef build(p):\n{body}    return cq.Workplane().box(1, 1, 1)\n"
    )
}

fn evaluate(source: &str) -> Result<(), Vec<Diagnostic>> {
    // Slow machines must not meet the limit on time first.
    let limits = Limits {
        time: Duration::from_secs(300),
        ..Limits::default()
    };
    Factory::parse_within("user.part", source, limits)?
        .build(&Map::new())
        .map(drop)
}

/// The one diagnostic of these lines.
#[track_caller]
fn refused(lines: &str, part: &str) -> Diagnostic {
    let Err(mut found) = evaluate(&building(lines)) else {
        panic!("{lines:?} is taken")
    };
    assert_eq!(found.len(), 1, "{lines}: {found:?}");
    let d = found.remove(0);
    assert_eq!(d.code, Code::FactoryFailed, "{lines}");
    assert!(d.message.contains(part), "{lines}: {d}");
    assert!(d.message.len() < 1000, "{lines}");
    let place = d.place.strip_prefix("factory user.part, line ");
    let line: usize = place.unwrap_or_else(|| panic!("{d}")).parse().unwrap();
    assert!((3..3 + lines.lines().count()).contains(&line), "{d}");
    d
}

#[test]
fn nothing_outside_has_a_name() {
    for name in [
        "open",
        "eval",
        "exec",
        "compile",
        "input",
        "globals",
        "locals",
        "vars",
        "exit",
        "breakpoint",
        "os",
        "sys",
        "environ",
        "subprocess",
        "socket",
        "time",
        "random",
        "json",
        "id",
    ] {
        refused(&format!("x = {name}"), &format!("'{name}'"));
        refused(
            &format!("x = {name}(\"/etc/passwd\")"),
            &format!("'{name}'"),
        );
    }
    for line in [
        "x = __import__(\"os\")",
        "x = __builtins__",
        "x = p.__class__",
        "__x = 1",
    ] {
        refused(line, "do not begin with '__'");
    }
    refused("load(\"//etc:passwd\", \"x\")", "'import'");
    for module in [
        "os",
        "sys",
        "subprocess",
        "socket",
        "time",
        "random",
        "ctypes",
        "builtins",
        "..x",
    ] {
        refused(&format!("import {module}"), "there is no module");
        refused(&format!("from {module} import *"), "there is no module");
    }
}

#[test]
fn no_attribute_leads_outside() {
    for value in [
        "\"\"",
        "[]",
        "{}",
        "()",
        "1",
        "1.5",
        "None",
        "p",
        "cq",
        "math",
        "build",
        "len",
        "cq.Workplane",
        "cq.Workplane()",
        "cq.Vector(0, 0, 0)",
    ] {
        for name in [
            "__class__",
            "__dict__",
            "__globals__",
            "__code__",
            "__subclasses__",
            "mro",
            "environ",
            "system",
        ] {
            refused(&format!("x = getattr({value}, \"{name}\")"), "");
            assert!(
                evaluate(&building(&format!(
                    "if hasattr({value}, \"{name}\"): fail(\"it is there\")"
                )))
                .is_ok()
            );
        }
    }
    for method in ["join", "format", "replace", "extend"] {
        refused(&format!("x = getattr(\"\", \"{method}\")"), "no method");
    }
}

#[test]
fn what_is_printed_goes_nowhere() {
    // Standard output belongs to the protocol; and the text of this one would never end.
    let net = "s = [s, s]\n".repeat(60);
    evaluate(&building(&format!(
        "s = []\n{net}print(s)\nprint(\"x\", s)"
    )))
    .unwrap();
    for line in ["pprint(\"x\")", "x = breakpoint()"] {
        refused(line, "nothing of the name");
    }
}

#[test]
fn bytes_that_hide_something() {
    for (line, part) in [
        ("x = 1\0", ""),
        ("x\0y = 1", ""),
        ("x = \"\\xZZ\"", ""),
        ("x = \"\\ud800\"", ""),
        ("x = \"\\U00110000\"", ""),
        ("x\u{200b} = 1", ""),
        ("x = 1 \u{202e} 2", ""),
        ("\u{ff4f}pen(\"x\")", ""),
        ("x = \u{201c}text\u{201d}", ""),
    ] {
        refused(line, part);
    }
    // Within a text they are only a text; and a text that names no file is never opened as one.
    for line in [
        "x = \"\0\"",
        "x = \"\\0\"",
        "x = \"\\N{BULLET}\"",
        "x = \"\u{202e}\"",
        "x = \"../../etc/passwd\"",
    ] {
        evaluate(&building(line)).unwrap_or_else(|e| panic!("{line:?}: {e:?}"));
    }
}

#[test]
fn a_name_is_shown_and_nothing_more() {
    for name in [
        "user.../../etc/passwd",
        "user.a\0b",
        "",
        "/dev/zero",
        "-",
        "user.x, line 7",
    ] {
        let found = Factory::parse(name, "x = 1\n").unwrap_err();
        for d in found {
            assert_eq!(d.place, format!("factory {name}"));
        }
        let found = script(name, "x = \n").unwrap_err();
        assert_eq!(found[0].place, format!("factory {name}, line 1"));
    }
}

#[test]
fn ten_thousand_of_anything() {
    const N: usize = 10_000;
    for (line, part) in [
        (
            format!("x = {}1{}", "(".repeat(N), ")".repeat(N)),
            "limit nesting",
        ),
        (
            format!("x = {}{}", "[".repeat(N), "]".repeat(N)),
            "limit nesting",
        ),
        (
            format!("x = {}{}", "{1:".repeat(N), "}".repeat(N)),
            "limit nesting",
        ),
        (format!("x = 1{}", "+1".repeat(N)), "limit nesting"),
        (format!("x = 1{}", "*1".repeat(N)), "limit nesting"),
        (format!("x = 1{}", " or 1".repeat(N)), "limit nesting"),
        (format!("x = [0]{}", "[0]".repeat(N)), "limit nesting"),
        (format!("x = range({N}00000)"), "limit list_items"),
        (format!("x = \"x\" * {N}00000"), "limit text_bytes"),
        (
            "x = \" \" * 60000\ny = x.split(\" \")\nz = y * 20000".to_owned(),
            "limit list_items",
        ),
    ] {
        refused(&line, part);
    }
}

#[test]
fn records_within_records() {
    let nested = |n: usize| {
        let inner =
            "r = records(fields = {\"r\": r}, default = [], min_items = 0, max_items = 1)\n";
        format!(
            "r = number(1, 0, 2)\n{}factory(doc = \"\", params = {{\"r\": r}})\n\
             def build(p):\n    return cq.Workplane().box(1, 1, 1)\n",
            inner.repeat(n)
        )
    };
    evaluate(&nested(4)).unwrap();
    for n in [5, 60] {
        let found = evaluate(&nested(n)).unwrap_err();
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].place, "factory user.part, line 6");
        assert!(found[0].message.contains("nested more than 4 deep"));
    }
}

#[test]
fn two_functions_that_call_each_other() {
    let d = refused("def f(g): return g(g)\nf(f)", "limit call_depth");
    assert!(d.hint.unwrap().contains("for loop"));
    refused("f = lambda g: g(g)\nf(f)", "limit call_depth");
    refused(
        "def a(x): return x[1](x)\ndef b(x): return x[0](x)\na([a, b])",
        "limit call_depth",
    );
}

#[test]
fn millions_of_operations() {
    for (lines, part) in [
        (
            "x = 0\nfor i in range(20000):\n    for j in range(20000):\n        x += 1",
            "limit",
        ),
        (
            "x = [j for i in range(20000) for j in range(20000) if False]",
            "limit ticks",
        ),
        (
            "w = cq.Workplane()\nfor i in range(20000):\n    w = w.box(1, 1, 1).translate((1, 0, 0))",
            "limit",
        ),
        (
            "x = sorted(range(20000), key = lambda i: sorted(range(20000))[0])",
            "limit",
        ),
    ] {
        refused(lines, part);
    }
}

#[test]
fn texts_that_never_end() {
    // The lexer does not move on at some of these.
    for line in [
        "x = f\"{\"length along z\"),",
        "x = f\"{\"a\nb\"",
        "x = f\"{'\n",
        "x = f\"{f\"{f\"{",
        "x = \"\"\"",
        "x = f\"\"\"{",
        "x = r\"\\",
        "x = 'a",
    ] {
        let start = std::time::Instant::now();
        let found = evaluate(&building(line)).unwrap_err();
        assert_eq!(found.len(), 1, "{line}: {found:?}");
        assert!(found[0].place.contains(", line "), "{line}: {found:?}");
        assert!(start.elapsed() < Duration::from_secs(5), "{line}");
    }
}
