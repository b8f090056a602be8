//! What the language does: declarations, operations, ports, faults at their lines.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::ParamKind;
use assemcad_model::recipe::{EdgeSelector, Op};
use assemcad_script::{Evaluated, Factory};
use serde_json::{Map, Value, json};

const HEAD: &str = "factory(doc = \"test\", params = {\"a\": number(4, 1, 10, doc = \"a\")})\n";

fn factory(source: &str) -> Result<Factory, Vec<Diagnostic>> {
    Factory::parse("test.part", source)
}

fn build_with(source: &str, params: Value) -> Result<Evaluated, Vec<Diagnostic>> {
    factory(source)?.build(params.as_object().unwrap())
}

/// A factory whose body of `build(p)` begins at line 3.
fn body(lines: &str) -> String {
    let body: String = lines.lines().map(|l| format!("    {l}\n")).collect();
    format!("{HEAD}def build(p):\n{body}")
}

fn run(lines: &str) -> Evaluated {
    build_with(&body(lines), json!({})).unwrap_or_else(|e| panic!("{e:#?}"))
}

fn fault(lines: &str) -> Diagnostic {
    build_with(&body(lines), json!({})).unwrap_err().remove(0)
}

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
    return box(p.z, p.angle, p.rows[1].d * n)
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
    assert!(matches!(
        built.recipe.ops[0],
        Op::Box {
            size: [80.0, 20.5, 57.0],
            ..
        }
    ));
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
            (Code::FactoryFailed, "factory test.part:line 2")
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
fn operations_are_recorded_with_their_lines_and_pruned() {
    let e = run("base = box(10, 20, 30)\n\
                 unused = sphere(5)\n\
                 hole = cylinder(\n\
                 \x20   4, 50,\n\
                 \x20   at = frame((5, 5, 0)),\n\
                 )\n\
                 return base.cut(hole).fillet(edges_parallel((0, 0, 2)), 1)");
    let names: Vec<&str> = e.recipe.ops.iter().map(Op::name).collect();
    assert_eq!(names, ["box", "cylinder", "cut", "fillet"]);
    assert_eq!(e.lines, [3, 5, 9, 9]);
    assert_eq!(e.recipe.ops[2], Op::Cut { a: 0, b: 1 });
    let edges = EdgeSelector::Parallel {
        direction: [0.0, 0.0, 2.0],
    };
    assert_eq!(
        e.recipe.ops[3],
        Op::Fillet {
            of: 2,
            edges,
            radius: 1.0
        }
    );
}

#[test]
fn every_builder_records_what_it_says() {
    let e = run(
        "q = profile(rectangle(8, 6), holes = [circle(1, center = (1, 1))], at = plane(\"XZ\"))\n\
                 a = prism(q, -3).fuse(cone(4, 0, 5))\n\
                 b = revolve(profile(path((1, 0), [line((2, 0)), arc((2.5, 1), (2, 2)), line((1, 2))])), angle_deg = 90)\n\
                 c = a.common(b).chamfer(edges_in_plane((0, 0, 1), (0, 0, 1)), 0.5)\n\
                 return c.chamfer(all_edges(), 0.1).translate(1, 2, 3)",
    );
    let ops = serde_json::to_value(&e.recipe.ops).unwrap();
    assert_eq!(
        ops[0]["prism"]["profile"]["at"]["z"],
        json!([0.0, -1.0, 0.0])
    );
    assert_eq!(
        ops[0]["prism"]["profile"]["outer"]["path"]["start"],
        json!([-4.0, -3.0])
    );
    assert_eq!(
        ops[0]["prism"]["profile"]["holes"][0]["circle"]["radius"],
        json!(1.0)
    );
    assert_eq!(ops[0]["prism"]["length"], json!(-3.0));
    assert_eq!(ops[1]["cone"]["radius_base"], json!(2.0));
    assert!(
        ops[3]["revolve"]["profile"]["outer"]["path"]["segments"][1]
            .get("arc")
            .is_some()
    );
    assert_eq!(
        (
            &ops[3]["revolve"]["axis_direction"],
            &ops[3]["revolve"]["angle_deg"]
        ),
        (&json!([0.0, 1.0]), &json!(90.0))
    );
    assert!(ops[5]["chamfer"]["edges"].get("in_plane").is_some());
    assert_eq!(ops[6]["chamfer"]["edges"], json!("all"));
    assert_eq!(ops[7]["place"]["placement"][1], json!([0.0, 1.0, 0.0, 2.0]));
}

#[test]
fn ports_are_carried_through_motions_and_kept_by_their_solid() {
    let e = run("a = box(10, 10, 10)\n\
                 a = a.bore_port(\"hole\", frame((5, 5, 10)), 4, 6)\n\
                 a = a.shaft_port(\"pin\", frame((5, 5, -3), z = (0, 0, -1)), 3, 6)\n\
                 a = a.face_port(\"top\", frame((1, 1, 10)), 2, 2)\n\
                 a = a.port(\"ring\", \"PRESS_FIT\", frame((0, 0, 5)), {\"diameter\": 9, \"length\": 2})\n\
                 other = box(1, 1, 1).face_port(\"lost\", frame(), 1, 1)\n\
                 a = a.cut(other)\n\
                 if a.port_names != [\"hole\", \"pin\", \"top\", \"ring\"]:\n\
                 \x20   fail(\"names\", a.port_names)\n\
                 return a.rotate((0, 0, 0), (1, 0, 0), 90).translate(0, 0, 100)");
    let p = &e.recipe.ports;
    assert_eq!(p[0].frame.origin, [5.0, -10.0, 105.0]);
    assert_eq!(
        (p[0].frame.z, p[0].frame.x),
        ([0.0, -1.0, 0.0], [1.0, 0.0, 0.0])
    );
    assert_eq!((p[0].params["diameter"], p[0].params["depth"]), (4.0, 6.0));
    assert_eq!(p[1].frame.z, [0.0, 1.0, 0.0]);
    assert_eq!(p.len(), 4);
    // Tools end flush with the mouth and at exactly the depth; the pin is centred on its port.
    let Op::Cylinder { at, height, .. } = &e.recipe.ops[1] else {
        panic!()
    };
    assert_eq!((at.origin, *height), ([5.0, 5.0, 4.0], 6.0));
    let Op::Cylinder { at, .. } = &e.recipe.ops[3] else {
        panic!()
    };
    assert_eq!(at.origin, [5.0, 5.0, 0.0]);
    let joined = run("a = box(1, 1, 1).face_port(\"a\", frame(), 1, 1)\n\
                      b = box(1, 1, 1).face_port(\"b\", frame(), 1, 1)\n\
                      return a.fuse(b.without_ports().face_port(\"c\", frame(), 1, 1))");
    let names: Vec<&str> = joined
        .recipe
        .ports
        .iter()
        .map(|p| p.name.as_str())
        .collect();
    assert_eq!(names, ["a", "c"]);
}

#[test]
fn faults_say_the_line_and_what_to_write() {
    let port = "return box(1, 1, 1).port";
    for (lines, line, message, hint) in [
        (
            "x = 1\nreturn bx(1, 1, 1)",
            4,
            "nothing of the name 'bx'",
            "box",
        ),
        ("return box(1, -1, 1)", 3, "y is over 0, not -1", ""),
        (
            "return box(1, \"w\", 1)",
            3,
            "y is a number, not a string",
            "",
        ),
        ("return box(1, 1)", 3, "z", ""),
        ("return 3", 0, "returned a value of type int", "return"),
        ("return box(1, 1, 1).fuse(3)", 3, "Solid", ""),
        ("return box(1, 1, 1).explode()", 3, "explode", ""),
        ("return p.b", 3, "b", ""),
        ("x = [1][3]\n", 3, "3", ""),
        (
            "return box(1, 1, 1, at = frame((0, 0, 0), z = (1, 0, 0)))",
            3,
            "right angle",
            "state z and an x",
        ),
        (
            "return box(1, 1, 1, at = frame((0, 0)))",
            3,
            "a tuple of 3 numbers",
            "(10, 0, 5)",
        ),
        ("x = math.sqrt(-1)", 3, "no finite value", ""),
        (
            &format!("{port}(\"p\", \"HOLLOW\", frame(), {{}})"),
            3,
            "no port type 'HOLLOW'",
            "FLAT_FACE",
        ),
        (
            &format!("{port}(\"p\", \"BORE\", frame(), {{}})"),
            3,
            "needs 'diameter'",
            "",
        ),
        (
            &format!("{port}(\"a b\", \"BORE\", frame(), {{}})"),
            3,
            "cannot name a port",
            "1 to 64",
        ),
        (
            "a = box(1, 1, 1).face_port(\"a\", frame(), 1, 1)\nreturn a.face_port(\"a\", frame(), 1, 1)",
            4,
            "two ports of the name 'a'",
            "",
        ),
        ("x = (1\n", 0, "not Starlark", ""),
        ("p.a = 3", 3, "", ""),
    ] {
        let d = fault(lines);
        assert_eq!(d.code, Code::FactoryFailed, "{lines}: {d}");
        if line > 0 {
            assert_eq!(
                d.place,
                format!("factory test.part:line {line}"),
                "{lines}: {d}"
            );
        }
        assert!(d.message.contains(message), "{lines}: {d}");
        assert!(
            d.hint.unwrap_or_default().contains(hint),
            "{lines}: {}",
            d.message
        );
    }
}

#[test]
fn what_python_has_and_starlark_lacks_is_answered_at_its_line() {
    for (lines, hint) in [
        ("while True:\n    pass", "for i in range"),
        ("try:\n    pass\nexcept:\n    pass", "require(condition"),
        ("class A:\n    pass", "no classes"),
        ("import math", "math and all shapes"),
        ("load(\"a.star\", \"a\")", "math and all shapes"),
        ("x = 2 ** 3", "pow(x, y)"),
        ("x = p.a is None", "=="),
        ("x = f\"a {p.a}\"", "%s"),
        ("x = \"{}\".format(1)", "%s"),
        ("x = \",\".join([])", "join(\", \", items)"),
        ("x = \"a\".replace(\"a\", \"b\")", "replace(text"),
        ("[].extend([1])", "+="),
        ("x = 1\nx *= 2", "x = x * y"),
        ("raise 3", "fail(message)"),
        ("assert p.a > 1", "require("),
        ("x = isinstance(1, 2)", "type(x)"),
        ("x = sin(1)", "math.sin"),
        ("x = map(1, 2)", "for x in items"),
    ] {
        let d = fault(lines);
        assert!(
            d.place.starts_with("factory test.part:line "),
            "{lines}: {d}"
        );
        assert!(
            d.hint.clone().unwrap_or_default().contains(hint),
            "{lines}: {d:?}"
        );
    }
    let found = factory("while 1:\n  x = 2 ** 3\nimport os\n").unwrap_err();
    let places: Vec<&str> = found.iter().map(|d| d.place.as_str()).collect();
    assert_eq!(
        places,
        [
            "factory test.part:line 1",
            "factory test.part:line 2",
            "factory test.part:line 3"
        ]
    );
    // Keyword arguments are not powers.
    run("def f(*a, **k): return k[\"x\"]\nreturn box(f(1, **{\"x\": 2}), 1, 1)");
}

#[test]
fn ordinary_starlark_works() {
    let e = run("def area(w: float, h = 2, *, scale = 1) -> float:\n\
                 \x20   return w * h * scale\n\
                 xs = [i * i for i in range(4) if i % 2 == 1]\n\
                 xs += [2]\n\
                 n = 0\n\
                 for x in xs:\n\
                 \x20   n += x\n\
                 t = \"%s-%s\" % (n, join(\",\", [str(x) for x in xs])) + replace(\"aXa\", \"X\", \"y\")\n\
                 print(t)\n\
                 if t != \"12-1,9,2aya\" or [0] * 3 != [0, 0, 0] or 1 << 4 != 16:\n\
                 \x20   fail(\"text\", t)\n\
                 return box(area(3, scale = 2), sum(xs), round(pow(2, 3)) + math.floor(1.5))");
    assert!(matches!(
        e.recipe.ops[0],
        Op::Box {
            size: [12.0, 12.0, 9.0],
            ..
        }
    ));
}

#[test]
fn broken_rules_are_errors_of_the_parameters_and_all_reported() {
    let source = body(
        "require(p.a < 3, \"a must be under 3, not %s\" % p.a)\n\
                       require(p.a > 0, \"fine\")\n\
                       require(p.a > 9, \"a must be over\", 9)\n\
                       return box(1, 1, -1)",
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
        (Code::FactoryFailed, "factory test.part:line 2")
    );
}

#[test]
fn math_is_the_same_everywhere_and_exact_at_right_angles() {
    let e = run("a = math.cos_deg(90) + math.sin_deg(180)\n\
                 return box(1 + a, math.atan2(1, 1) * 4 / math.pi, math.degrees(math.radians(60)))");
    let Op::Box { size, .. } = e.recipe.ops[0] else {
        panic!()
    };
    assert_eq!(size[0], 1.0);
    assert!((size[1] - 1.0).abs() < 1e-15 && (size[2] - 60.0).abs() < 1e-12);
}

#[test]
fn the_same_source_and_parameters_give_the_same_hash() {
    let source = "factory(doc = \"\", params = {\"a\": number(1, 0, 9), \"b\": number(2, 0, 9), \
                  \"c\": number(3, 0, 9)})\n\
                  def build(p):\n\
                  \x20   d = {\"x\": p.a, \"y\": p.b}\n\
                  \x20   s = box(p.a + 1, p.b + 1, p.c + 1)\n\
                  \x20   for k in d:\n\
                  \x20       s = s.fuse(sphere(d[k] + math.sin(p.c) + 2).rotate((0, 0, 0), (1, 1, 0), 33))\n\
                  \x20   return s.bore_port(\"b\", frame((1, 1, 1)), 1, 1)\n";
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
    for _ in 0..3 {
        f.build(&Map::new()).unwrap();
        assert_eq!(
            f.build(params.as_object().unwrap())
                .unwrap()
                .recipe
                .hash()
                .unwrap(),
            first
        );
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
    let recipe = run("return box(1, 2.5, 1e-7).cut(sphere(3))").recipe;
    let text = serde_json::to_string(&recipe).unwrap();
    let back: assemcad_model::recipe::Recipe = serde_json::from_str(&text).unwrap();
    assert_eq!(back, recipe);
    assert_eq!(back.hash().unwrap(), recipe.hash().unwrap());
}

const GOLDEN: &str = "51e15c6a932770aefe88142c0e34ae44c83e3c407b2c18886fe04aac14afd5b9";
