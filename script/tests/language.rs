//! What the language does: declarations, rules, plain scripts, the same recipe every time.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

mod common;

use assemcad_model::diagnostic::Code;
use assemcad_model::param::ParamKind;
use assemcad_script::{Evaluated, script};
use common::{HEAD, body, build_with, calls, factory, fault, run};
use serde_json::{Map, Value, json};

#[test]
fn a_factory_declares_every_kind_of_parameter_in_order() {
    let f = factory(
        r#"
factory(
    doc = """
    All kinds.
    """,
    params = {
        "z": number(80, 1, 1000, doc = "extent"),
        "angle": number(20.5, 0, 45, unit = "deg", doc = "angle"),
        "teeth": integer(17, 5, 500, doc = "count"),
        "hand": choice("left", ["left", "right"], doc = "hand"),
        "hub": flag(True, doc = "whether there is a hub"),
        "rows": records(
            fields = {"d": number(3, 1, 9)},
            default = [{"d": 4}, {}],
            min_items = 1,
            max_items = 3,
            doc = "rows",
        ),
    },
)
def build(p):
    n = p.teeth + len(p.rows) if p.hub and p.hand == "left" else 0
    return cq.Workplane().box(p.z, p.angle, p.rows[1].d * n)
"#,
    )
    .unwrap();
    assert_eq!(f.doc(), "All kinds.");
    let names: Vec<&str> = f.params().iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names, ["z", "angle", "teeth", "hand", "hub", "rows"]);
    let ParamKind::Records { default, .. } = &f.params()[5].kind else {
        panic!()
    };
    assert_eq!(default, &[json!({"d": 4.0}), json!({"d": 3.0})]);
    let built = f.build(&Map::new()).unwrap();
    let args = &built.recipe.calls[1].args;
    assert_eq!(
        [&args["length"], &args["width"], &args["height"]],
        [&json!(80.0), &json!(20.5), &json!(57.0)]
    );
    assert_eq!(f.schema()["properties"]["teeth"]["type"], "integer");
    let faults = f
        .build(json!({"teeth": 4, "hnd": 1}).as_object().unwrap())
        .unwrap_err();
    let codes: Vec<Code> = faults.iter().map(|d| d.code).collect();
    assert_eq!(codes, [Code::ParamUnknown, Code::ParamInvalid]);
}

#[test]
fn declarations_at_fault_are_refused() {
    for (params, part) in [
        ("{\"a\": 3}", "a dict of names and declarations"),
        ("{\"A b\": flag(True)}", "cannot name a parameter"),
        ("{\"a\": number(0, 1, 2)}", "default of 'a' is not valid"),
        ("{\"a\": number(1, 3, 2)}", "min 3 is over max 2"),
        (
            "{\"a\": number(1, 0, 2, unit = \"inch\")}",
            "unit is one of",
        ),
        (
            "{\"a\": choice(\"x\", [\"y\"])}",
            "default of 'a' is not valid",
        ),
        ("{\"a\": integer(1.5, 0, 2)}", "whole number"),
    ] {
        let found = factory(&format!(
            "\nfactory(doc = \"\", params = {params})\ndef build(p): pass"
        ))
        .unwrap_err();
        assert!(found[0].message.contains(part), "{params}: {}", found[0]);
        assert_eq!(
            (found[0].code, found[0].place.as_str()),
            (Code::FactoryFailed, "factory test.part, line 2")
        );
    }
    for (source, part) in [
        ("def build(p): pass\n", "does not call factory"),
        (HEAD, "does not define the function build"),
        (
            &format!("{HEAD}build = 3\n"),
            "does not define the function build",
        ),
        (
            &format!("{HEAD}{HEAD}def build(p): pass\n"),
            "more than once",
        ),
    ] {
        assert!(
            factory(source).unwrap_err()[0].message.contains(part),
            "{source}"
        );
    }
}

#[test]
fn ordinary_python_works() {
    let all = calls(
        "import cadquery as cad\n\
         from math import (\n\
         \x20   floor,  # a comment\n\
         \x20   pi as half_turn,\n\
         )\n\
         def same(w: cq.Workplane, v: cq.Vector = cq.Vector(1, 2)) -> cq.Workplane:\n\
         \x20   return w\n\
         def area(w: float, h = 2, *, scale = 1) -> float:\n\
         \x20   \"\"\"Area.\"\"\"\n\
         \x20   return w * h * scale\n\
         xs = [i * i for i in range(4) if i % 2 == 1]\n\
         xs += [2]\n\
         n = 0\n\
         for x in xs:\n\
         \x20   n += x\n\
         t = \"%s-%s\" % (n, join(\",\", [str(x) for x in xs])) + replace(\"aXa\", \"X\", \"y\")\n\
         t += f\" {n:03d} {p.a:.2f} {t!r} {f'{n}'} {{}}\"\n\
         print(t)\n\
         if t != \"12-1,9,2aya 012 4.00 \\\"12-1,9,2aya\\\" 12 {}\":\n\
         \x20   fail(\"text\", t)\n\
         if [0] * 3 != [0, 0, 0] or 1 << 4 != 16 or divmod(7, 2) != (3, 1) or pow(2, 10) != 1024:\n\
         \x20   fail(\"numbers\")\n\
         if round(2.5) != 2 or round(-3.7) != -4 or round(2.675, 2) != 2.67 or sum([1, 2], 3) != 6:\n\
         \x20   fail(\"rounding\")\n\
         if math.hypot(2, 3, 6) != 7 or not math.isclose(math.tau, 2 * half_turn) or math.gcd(12, 18) != 6:\n\
         \x20   fail(\"math\")\n\
         return same(cad.Workplane()).box(area(3, scale = 2), sum(xs), round(pow(2, 3)) + floor(1.5))",
    );
    let args = &all[1]["args"];
    assert_eq!(
        [&args["length"], &args["width"], &args["height"]],
        [&json!(12.0), &json!(12.0), &json!(9.0)]
    );
}

#[test]
fn plain_scripts_leave_a_result() {
    for source in [
        "import cadquery as cq\nresult = cq.Workplane().box(1, 1, 1)\n",
        "from cadquery import Workplane\nw = Workplane().box(1, 1, 1)\nshow_object(w, name=\"w\")\n",
        "import cadquery\nresult = cadquery.Workplane()\nfor i in range(1):\n    if i == 0:\n        result = result.box(1, 1, 1)\n",
        "def make(n):\n    return cq.Workplane().box(n, n, n)\nresult = make(1).val()\n",
    ] {
        let done = script("plain", source).unwrap_or_else(|e| panic!("{source}: {e:?}"));
        let result = &done.recipe.calls[done.recipe.result as usize];
        assert!(result.call.ends_with("box") || result.call.ends_with("val"));
        assert!(done.params.is_empty());
    }
    for (source, message) in [
        ("x = 1\n", "leaves no `result`"),
        ("result = 3\n", "`result` is an int"),
        ("show_object(3)\n", "show_object takes a workplane"),
        (
            "factory(doc = \"\", params = {})\n",
            "does not call factory",
        ),
    ] {
        let found = script("plain", source).unwrap_err();
        assert!(found[0].message.contains(message), "{source}: {found:?}");
    }
}

#[test]
fn broken_rules_are_errors_of_the_parameters_and_all_reported() {
    let source = body(
        "require(p.a < 3, \"a must be under 3, not %s\" % p.a)\n\
                       require(p.a > 0, \"fine\")\n\
                       require(p.a > 9, \"a must be over\", 9)\n\
                       return cq.Workplane().box(1, 1, None)",
    );
    let found = build_with(&source, json!({"a": 5})).unwrap_err();
    let messages: Vec<&str> = found.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(messages, ["a must be under 3, not 5.0", "a must be over 9"]);
    assert!(
        found
            .iter()
            .all(|d| d.code == Code::ParamInvalid && d.place == "params")
    );
    let d = fault("fail(\"a\", p.a, \"is no good\")");
    assert_eq!(
        (d.place.as_str(), d.message.as_str()),
        ("params", "a 4.0 is no good")
    );
    let d = factory("\nfail(\"never\")").unwrap_err().remove(0);
    assert_eq!(
        (d.code, d.place.as_str()),
        (Code::FactoryFailed, "factory test.part, line 2")
    );
}

#[test]
fn the_same_source_and_parameters_give_the_same_hash() {
    let source = "factory(doc = \"\", params = {\"a\": number(1, 0, 9), \"b\": number(2, 0, 9), \
                  \"c\": number(3, 0, 9)})\n\
                  def build(p):\n\
                  \x20   d = {\"x\": p.a, \"y\": p.b}\n\
                  \x20   s = cq.Workplane().box(p.a + 1, p.b + 1, p.c + 1)\n\
                  \x20   for k in d:\n\
                  \x20       s += cq.Workplane().sphere(d[k] + math.sin(p.c) + 2).rotate((0, 0, 0), (1, 1, 0), 33)\n\
                  \x20   return s.faces(\">Z\").workplane().bore_port(\"b\", 1)\n";
    let text = [
        r#"{"a": 2, "b": 3.5, "c": 0.25}"#,
        r#"{"c": 0.25, "b": 3.50, "a": 2.0}"#,
    ];
    let hash = |text: &str| {
        let params: Value = serde_json::from_str(text).unwrap();
        build_with(source, params).unwrap().recipe.hash().unwrap()
    };
    let first = hash(text[0]);
    assert_eq!(first, hash(text[1]));
    let f = factory(source).unwrap();
    let params: Value = serde_json::from_str(text[1]).unwrap();
    let bytes = |e: Evaluated| serde_json::to_vec(&e.recipe).unwrap();
    let once = bytes(f.build(params.as_object().unwrap()).unwrap());
    for _ in 0..3 {
        f.build(&Map::new()).unwrap();
        assert_eq!(bytes(f.build(params.as_object().unwrap()).unwrap()), once);
    }
    // A moved line is another line, and the same recipe.
    let moved = build_with(&format!("\n\n{source}"), params.clone()).unwrap();
    assert_eq!(moved.recipe.hash().unwrap(), first);
    assert_ne!(
        moved.lines,
        f.build(params.as_object().unwrap()).unwrap().lines
    );
    assert_ne!(
        build_with(source, json!({}))
            .unwrap()
            .recipe
            .hash()
            .unwrap(),
        first
    );
    // The golden value: a change here changes every stored recipe.
    assert_eq!(first, GOLDEN);
}

#[test]
fn recipes_read_back_from_text() {
    // The interpreter turns on serde_json's "arbitrary_precision" for everything it is linked with,
    // under which some shapes of data no longer read back.
    let recipe = run(
        "return cq.Workplane().box(1, 2.5, 1e-7).faces(\">Z or <Z\").cut(cq.Workplane().sphere(3))",
    )
    .recipe;
    let text = serde_json::to_string(&recipe).unwrap();
    let back: assemcad_model::recipe::Recipe = serde_json::from_str(&text).unwrap();
    assert_eq!(back, recipe);
    assert_eq!(back.hash().unwrap(), recipe.hash().unwrap());
}

const GOLDEN: &str = "3ebef7dca1232f9937802147f503bca3df5ee537f69d8ec12fb0909622457e5e";

/// The page is generated from the table of the language: `ASSEMCAD_ACCEPT=1` writes it anew.
#[test]
fn the_page_of_the_language_is_the_published_one() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/language.md");
    let page = assemcad_script::reference();
    if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
        std::fs::write(path, &page).unwrap();
    }
    let published = std::fs::read_to_string(path).unwrap_or_default();
    assert!(
        page == published,
        "ASSEMCAD_ACCEPT=1 cargo test -p assemcad-script page"
    );
}
