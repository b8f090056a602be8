//! Every limit, and sources that mean harm: one diagnostic each, and the process lives.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use core::time::Duration;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_script::{Factory, Limits};
use serde_json::Map;

fn evaluate(source: &str, limits: &Limits) -> Result<(), Vec<Diagnostic>> {
    Factory::parse_within("test.part", source, limits.clone())?
        .build(&Map::new())
        .map(drop)
}

/// The one diagnostic of a hostile `build(p)`, under the default limits.
#[track_caller]
fn refused(lines: &str, part: &str) {
    let head = "factory(doc = \"\", params = {})\n";
    let body: String = lines.lines().map(|l| format!("    {l}\n")).collect();
    one(
        &format!("{head}def build(p):\n{body}    return cq.Workplane().box(1, 1, 1)\n"),
        part,
    );
}

#[track_caller]
fn one(source: &str, part: &str) {
    // Slow machines must not meet the limit on time first.
    let limits = Limits {
        time: Duration::from_secs(300),
        ..Limits::default()
    };
    let found = evaluate(source, &limits).unwrap_err();
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].code, Code::FactoryFailed);
    assert!(found[0].message.contains(part), "{}", found[0]);
    assert!(found[0].message.len() < 1000);
}

#[test]
fn long_sources() {
    one(&"x = 1\n".repeat(20_000), "limit source_bytes");
}

#[test]
fn deep_nesting_of_every_kind() {
    const N: usize = 20_000;
    for source in [
        format!("x = {}1{}\n", "(".repeat(N), ")".repeat(N)),
        format!("x = {}{}\n", "[".repeat(N), "]".repeat(N)),
        "(".repeat(60_000),
        format!("x = {}1\n", "-".repeat(N)),
        format!("x = {}1\n", "not ".repeat(N / 2)),
        format!("x = 1{}\n", "+1".repeat(N)),
        format!("x = f{}\n", "()".repeat(N)),
        format!("x = f{}\n", ".a".repeat(N)),
        format!("x = {}1\n", "lambda:".repeat(N / 3)),
        format!("x = {}1\n", "1 if 1 else ".repeat(N / 8)),
        format!("if 1:\n  x = 1\n{}", "elif 1:\n  x = 1\n".repeat(3000)),
        format!("x = [1 {}]\n", "for a in b ".repeat(4000)),
        format!("x = {}1{}\n", "f'{".repeat(N / 2), "}'".repeat(N / 2)),
    ] {
        one(&source, "limit nesting");
    }
    let blocks: String = (0..340)
        .map(|i| format!("{}if 1:\n", " ".repeat(i)))
        .collect();
    one(
        &format!("{blocks}{}x = 1\n", " ".repeat(340)),
        "limit nesting",
    );
}

#[test]
fn nesting_up_to_the_limit_is_carried_out() {
    let n = Limits::default().nesting - 20;
    for value in [
        // A bracket counts twice: it may be a call.
        format!("{}1{}", "(".repeat(n / 2), ")".repeat(n / 2)),
        format!("len({}{})", "[".repeat(n / 2), "]".repeat(n / 2)),
        format!("1{}", "+1".repeat(n)),
        format!("{}1", "1 if 0 else ".repeat(n / 2 - 1)),
        format!("{}1", "- ".repeat(n)),
        format!("1 if {}1 else 1", "not ".repeat(n)),
    ] {
        let source = format!(
            "factory(doc = \"\", params = {{}})\ndef build(p):\n    x = {value}\n    return cq.Workplane().box(1, 1, 1)\n"
        );
        evaluate(&source, &Limits::default()).unwrap_or_else(|e| panic!("{value}: {e:?}"));
    }
}

#[test]
fn huge_values_in_one_step() {
    refused("x = \"x\" * 1000000000", "limit text_bytes");
    refused("x = 1000000000 * \"x\"", "limit text_bytes");
    refused("x = [0] * 1000000000", "limit list_items");
    refused("x = (0,) * 1000000000", "limit list_items");
    refused("x = list(range(2000000000))", "limit list_items");
    refused(
        "x = sorted(range(-2000000000, 2000000000))",
        "limit list_items",
    );
    refused("x = 1 << 1000000000", "62 places");
    refused("x = 1 << 62\nfor i in range(40):\n    x = x * x", "64 bits");
    refused(
        "x = replace(\"a\" * 60000, \"a\", \"b\" * 60000)",
        "limit text_bytes",
    );
    refused(
        "x = join(\"a\" * 60000, [\"b\"] * 20000)",
        "limit text_bytes",
    );
    refused(
        "x = \"%s\" * 1000 % tuple([\"b\" * 60000] * 1000)",
        "limit text_bytes",
    );
    refused("f = getattr(\"\", \"join\")", "no method 'join'");
    refused("x = __mul(\"x\", 3)", "do not begin with");
    refused("x = __text(\"x\", \"y\")", "do not begin with");
    refused("x = \"x\" * 60000\ny = f\"{x}{x}\"", "limit text_bytes");
    refused("x = f\"{[0] * 20000}\"", "limit text_bytes");
}

#[test]
fn growth_without_loops() {
    let doubled = "s = s + s\n".repeat(40);
    refused(&format!("s = \"x\"\n{doubled}"), "limit text_bytes");
    refused(&format!("s = [1]\n{doubled}"), "limit list_items");
    refused(
        &format!("s = [1]\n{}", "s += s\n".repeat(40)),
        "limit heap_bytes",
    );
    refused(
        &format!("s = \"x\"\n{}", "s += s\n".repeat(40)),
        "limit heap_bytes",
    );
    // One list that is a member of the next, twice: 2^40 texts when it is written out.
    let net = "s = [s, s]\n".repeat(40);
    refused(&format!("s = []\n{net}t = str(s)"), "limit text_bytes");
    refused(
        &format!("s = []\n{net}t = \"%s\" % [s]"),
        "limit text_bytes",
    );
    refused(&format!("s = []\n{net}fail(s)"), "limit text_bytes");
    refused(&format!("s = []\n{net}t = f\"{{s}}\""), "limit text_bytes");
    // Selectors join selectors, and are read by recursion.
    let joined = "s = s + s\n".repeat(40);
    refused(
        &format!("s = cq.selectors.TypeSelector(\"PLANE\")\n{joined}"),
        "32 deep",
    );
    refused(
        "s = cq.selectors.TypeSelector(\"PLANE\")\nfor i in range(1000):\n    s = -s",
        "32 deep",
    );
    refused(
        "x = cq.Workplane().faces(\"|Z or \" * 100 + \"|Z\")",
        "32 deep",
    );
    refused(
        "x = cq.Workplane().faces(\"|Z or \" * 1000 + \"|Z\")",
        "1000 characters",
    );
}

#[test]
fn memory_in_loops() {
    refused(
        "x = []\nfor i in range(20000):\n    x.append(\"a\" * 60000)",
        "limit heap_bytes",
    );
    refused(
        "x = [\"a\" * 60000 for i in range(20000)]",
        "limit heap_bytes",
    );
}

#[test]
fn values_nested_as_deep_as_memory_allows() {
    // Faults write the value they refuse, comparing and hashing walk it: all of them by recursion.
    let nest = |open: &str, close: &str, n: usize| {
        let (open, close) = (open.repeat(40), close.repeat(40));
        format!("s = ()\nfor i in range({n}):\n    s = {open}s{close}\n")
    };
    let (lists, tuples) = (nest("[", "]", 3500), nest("(", ",)", 7000));
    for (nested, then, part) in [
        (&lists, "x = str(s)", "limit text_bytes"),
        (&lists, "x = int(s)", ""),
        (&lists, "x = cq.Workplane(origin = s)", ""),
        (&lists, "x = s == [[s]]", ""),
        (&lists, "x = [1, s] < [1, s]", ""),
        (&tuples, "x = {s: 1}", ""),
        (&tuples, "x = {}[s]", ""),
        (&tuples, "x = int(s)", ""),
    ] {
        let source = format!("{nested}{then}\nfail()");
        one(&source, part);
    }
}

#[test]
fn recursion() {
    refused("def f(n): return f(n + 1)\nf(1)", "limit call_depth");
    let source = "factory(doc = \"\", params = {})\n\
                  def f(n):\n    return f(n + 1)\n\
                  def build(p):\n    f(1)\n    return cq.Workplane().box(1, 1, 1)\n";
    one(source, "limit call_depth");
    refused(
        "def f(loc):\n    return cq.Workplane().eachpoint(f)\nf(1)",
        "limit call_depth",
    );
}

#[test]
fn long_loops() {
    refused(
        "for i in range(20000):\n    for j in range(20000):\n        x = i",
        "limit statements",
    );
    refused(
        "x = [0 for i in range(20000) for j in range(20000) if 0]",
        "limit ticks",
    );
    refused(
        "w = cq.Workplane()\nfor i in range(20000):\n    w.box(1, 1, 1)",
        "limit operations",
    );
    refused(
        "b = [(0, 0), (1, 0), (1, 1)] * 1000\nw = cq.Workplane()\nfor i in range(1000):\n    w.polyline(b)",
        "limit pieces",
    );
    refused(
        "t = cq.selectors.TypeSelector(\"LINE\")\nfor i in range(6):\n    t = t + t\nw = cq.Workplane()\nfor i in range(9000):\n    w.edges(t)",
        "limit pieces",
    );
    refused(
        "t = \"t\" * 60000\nw = cq.Workplane()\nfor i in range(1000):\n    w.tag(t)",
        "limit pieces",
    );
}

#[test]
fn time() {
    let limits = Limits {
        time: Duration::from_millis(50),
        statements: u64::MAX,
        ticks: u64::MAX,
        ..Limits::default()
    };
    let source = "factory(doc = \"\", params = {})\n\
                  def build(p):\n    for i in range(20000):\n        for j in range(20000):\n            x = i\n";
    let found = evaluate(source, &limits).unwrap_err();
    assert!(found[0].message.contains("limit time"), "{}", found[0]);
}

#[test]
fn an_evaluation_that_hears_nothing_is_left_behind() {
    let limits = Limits {
        time: Duration::from_millis(100),
        ..Limits::default()
    };
    // Comparing a net of lists with its double: one step of the interpreter, 2^26 comparisons.
    let net = "s = [s, s]\n".repeat(26);
    let twin = "t = [t, t]\n".repeat(26);
    let body: String = format!("s = []\n{net}t = []\n{twin}x = s == t")
        .lines()
        .map(|l| format!("    {l}\n"))
        .collect();
    let source = format!(
        "factory(doc = \"\", params = {{}})\ndef build(p):\n{body}    return cq.Workplane().box(1, 1, 1)\n"
    );
    let started = std::time::Instant::now();
    let found = evaluate(&source, &limits).unwrap_err();
    assert!(found[0].message.contains("limit time"), "{}", found[0]);
    assert!(started.elapsed() < Duration::from_secs(5));
}

#[test]
fn bytes_that_are_no_source() {
    for source in [
        "\0",
        "\u{feff}x",
        "'",
        "\"\"\"",
        "\t\tx",
        "x = 1e999999\n",
        "\\",
        "é",
        ")",
        "def",
        "import",
        "from x",
        "from math import (",
        "import math as __m",
        "f\"{",
        "f\"{a",
        "f\"}\"",
        "x = f\"{a!}\"",
        "x = f\"{}\"",
        "x = f\"{1:d:d}\"",
    ] {
        let _ = evaluate(source, &Limits::default()).unwrap_err();
    }
    let digits = "9".repeat(60_000);
    assert!(evaluate(&format!("x = {digits}\n"), &Limits::default()).is_err());
}
