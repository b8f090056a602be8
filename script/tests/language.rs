//! What the language does: declarations, operations, ports, faults at their lines.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::ParamKind;
use assemcad_script::{Evaluated, Factory, script};
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

/// The calls of a body.
fn calls(lines: &str) -> Vec<Value> {
    let recipe = run(lines).recipe;
    recipe
        .calls
        .iter()
        .map(|c| serde_json::to_value(c).unwrap())
        .collect()
}

#[test]
fn calls_are_recorded_in_order_with_the_lines_of_their_names() {
    let e = run("base = (\n\
                 \x20   cq.Workplane(\"XY\")\n\
                 \x20   .box(10, 20,\n\
                 \x20       math.floor(30.5))\n\
                 \x20   .edges(\"|Z\")\n\
                 )\n\
                 ball = cq.Workplane().sphere(5)\n\
                 base -= ball\n\
                 return base.fillet(1)");
    let names: Vec<&str> = e.recipe.calls.iter().map(|c| c.call.as_str()).collect();
    assert_eq!(
        names,
        [
            "Workplane",
            "Workplane.box",
            "Workplane.edges",
            "Workplane",
            "Workplane.sphere",
            "Workplane.cut",
            "Workplane.fillet"
        ]
    );
    assert_eq!(e.lines, [4, 5, 7, 9, 9, 10, 11]);
    assert_eq!(e.recipe.result, 6);
    assert_eq!(e.recipe.calls[5].inputs(), [2, 4]);
}

#[test]
fn operators_are_those_of_cadquery() {
    for (text, name, arg) in [
        ("a + b", "Workplane.union", "toUnion"),
        ("a | b", "Workplane.union", "toUnion"),
        ("a - b", "Workplane.cut", "toCut"),
        ("a * b", "Workplane.intersect", "toIntersect"),
        ("a & b", "Workplane.intersect", "toIntersect"),
        ("a / b", "Workplane.split", "splitter"),
        ("a.split(b)", "Workplane.split", "splitter"),
        ("a.val() + b.val()", "Shape.fuse", "toFuse"),
        ("a.val() - b.val()", "Shape.cut", "toCut"),
        ("a.val() * b.val()", "Shape.intersect", "toIntersect"),
    ] {
        let e = run(&format!(
            "a = cq.Workplane()\nb = cq.Workplane()\nreturn {text}"
        ));
        let last = e.recipe.calls.last().unwrap();
        assert_eq!(last.call, name, "{text}");
        let to = if name.starts_with("Shape") { 3 } else { 1 };
        assert_eq!(last.args[arg], json!({"ref": to}), "{text}");
        assert_eq!(*e.lines.last().unwrap(), 5);
    }
    for (text, name) in [
        ("a += b", "Workplane.union"),
        ("a -= b", "Workplane.cut"),
        ("a |= b", "Workplane.union"),
        ("a &= b", "Workplane.intersect"),
    ] {
        let e = run(&format!(
            "a = cq.Workplane()\nb = cq.Workplane()\n{text}\nreturn a"
        ));
        assert_eq!(e.recipe.calls.last().unwrap().call, name, "{text}");
    }
    let d = fault("return cq.Workplane() + 3");
    assert!(d.message.contains("toUnion is"), "{d}");
    // What the chain of vals is of.
    let all = calls("w = cq.Workplane()\nreturn w.vals()[1] + w[2].val()");
    assert_eq!(all[2]["call"], "Workplane.item");
    assert_eq!(
        (&all[2]["on"], &all[2]["args"]["i"]),
        (&json!(0), &json!(1))
    );
    assert_eq!(all[3]["call"], "Workplane.val");
    assert_eq!(all[4]["args"]["i"], json!(2));
}

#[test]
fn functions_of_each_are_called_once() {
    let all = calls(
        "seen = []\n\
         peg = cq.Workplane().circle(1).extrude(2)\n\
         def put(loc):\n\
         \x20   seen.append(1)\n\
         \x20   return peg.val().moved(cq.Location((0, 0, 1))).moved(loc)\n\
         r = cq.Workplane().rarray(1, 1, 5, 5).eachpoint(put, True, combine=\"cut\")\n\
         if len(seen) != 1:\n\
         \x20   fail(\"seen\", seen)\n\
         return r",
    );
    let find = |name: &str| all.iter().position(|c| c["call"] == name).unwrap();
    let (at, each) = (find("eachLocation"), find("Workplane.eachpoint"));
    assert_eq!(all[at]["on"], json!(find("Workplane.rarray")));
    let args = &all[each]["args"];
    assert_eq!(args["variable"], json!({"ref": at}));
    assert_eq!(args["arg"], json!({"ref": each - 1}));
    assert_eq!(all[each - 1]["args"]["loc"], json!({"ref": at}));
    assert_eq!(args["combine"], "cut");
    assert_eq!(args["useLocalCoordinates"], true);

    let all = calls(
        "tooth = cq.Workplane().box(1, 1, 1).val()\n\
         return cq.Workplane().polarArray(9, 0, 360, 8).each(lambda loc: tooth.moved(loc))",
    );
    let each = all.last().unwrap();
    assert_eq!(all[5]["call"], "eachObject");
    assert_eq!(each["args"]["variable"], json!({"ref": 5}));
    assert_eq!(each["args"]["callback"], json!({"ref": 6}));
    let d = fault("return cq.Workplane().eachpoint(lambda loc: loc)");
    assert!(
        d.message.contains("returned a Location and not a shape"),
        "{d}"
    );
    let d = fault("return cq.Workplane().eachpoint(lambda loc: 1 + nothing(loc))");
    assert!(d.message.contains("nothing"), "{d}");
    let d = fault("x = 1\nreturn cq.Workplane().eachpoint(lambda loc: cq.Workplane().box(1, 1))");
    assert_eq!(d.place, "factory test.part:line 4");
}

#[test]
fn values_are_written_as_kinds_say() {
    let all = calls(
        "w = cq.Workplane(cq.Plane.XZ(origin=(0, 1, 0)))\n\
         w.faces(cq.selectors.BoxSelector((0, 0, 0), (1, 2, 3), boundingbox=True))\n\
         w.faces(cq.NearestToPointSelector((1, 2, 3)) + cq.selectors.RadiusNthSelector(0))\n\
         w.faces(-cq.DirectionMinMaxSelector(cq.Vector(0, 0, 1), False))\n\
         w.edges(cq.selectors.CenterNthSelector((1, 0, 0), 2) - cq.TypeSelector(\"circle\"))\n\
         w.edges(cq.selectors.DirectionNthSelector((1, 0, 0), -2) * cq.StringSyntaxSelector(\"|Z\"))\n\
         w.faces()\n\
         w.mirror(w.faces(\">X\"))\n\
         w.rect(1, 2, (False, True))\n\
         w.rect(1, 2, False)\n\
         w.box(1, 2, 3, combine=False)\n\
         w.outline(cq.involute(2, 20))\n\
         return w",
    );
    let frame = json!({"origin": [0.0, 1.0, 0.0], "x": [1.0, 0.0, 0.0], "z": [0.0, -1.0, 0.0]});
    assert_eq!(all[0]["args"]["inPlane"], frame);
    let selector = |i: usize| &all[i]["args"]["selector"];
    assert_eq!(
        selector(1)["box"],
        json!({"from": [0.0, 0.0, 0.0], "to": [1.0, 2.0, 3.0], "whole": true})
    );
    assert_eq!(selector(2)["or"][0], json!({"nearest": [1.0, 2.0, 3.0]}));
    assert_eq!(selector(2)["or"][1]["nth"]["key"], json!("radius"));
    let key = json!({"center": [0.0, 0.0, 1.0]});
    assert_eq!(
        selector(3)["not"]["nth"],
        json!({"key": key, "index": -1, "ascending": false})
    );
    assert_eq!(selector(4)["except"][1], json!({"form": "CIRCLE"}));
    assert_eq!(selector(5)["and"][0]["nth"]["index"], json!(-2));
    assert_eq!(selector(5)["and"][1], json!({"parallel": [0.0, 0.0, 1.0]}));
    assert!(all[6]["args"].get("selector").is_none());
    assert_eq!(all[8]["args"]["mirrorPlane"], json!({"ref": 7}));
    assert_eq!(all[9]["args"]["centered"], json!([false, true]));
    assert_eq!(all[10]["args"]["centered"], json!([false, false]));
    assert_eq!(all[11]["args"]["combine"], "none");
    assert!(all[12]["args"]["outline"]["segments"].is_array());
}

#[test]
fn ports_are_checked_as_far_as_they_are_known() {
    for (call, message, hint) in [
        (
            "bore_port(\"a b\", 3)",
            "'a b' cannot name a port",
            "1 to 64",
        ),
        (
            "bore_port(\"a\", 3, back=\"/\")",
            "'/' cannot name a port",
            "1 to 64",
        ),
        (
            "bore_port(\"a\", -3)",
            "'diameter' of a BORE port is a number from",
            "",
        ),
        ("shaft_port(\"a\", 3, 0)", "'length' of a SHAFT port", ""),
        (
            "port(\"p\", \"HOLLOW\", {})",
            "no port type 'HOLLOW'",
            "FLAT_FACE",
        ),
        (
            "port(\"p\", \"BORE\", {})",
            "needs 'diameter'",
            "diameter, depth",
        ),
        (
            "port(\"p\", \"BORE\", {\"diameter\": 1, \"depth\": 2, \"x\": 3})",
            "has no 'x'",
            "",
        ),
        (
            "port(\"p\", \"BORE\", {\"diameter\": \"1\"})",
            "is a number",
            "",
        ),
        (
            "tapped_hole_with_port(\"t\", 6, 1, hand=\"up\")",
            "hand is not \"up\"",
            "\"left\"",
        ),
        (
            "gear_mesh_port(\"g\", 2, 20, 10, pressure_angle_deg=90)",
            "'pressure_angle_deg'",
            "",
        ),
        ("gear_mesh_port(\"g\", 2, 5, 10, profile_shift=1.5)", "", ""),
    ] {
        let d = fault(&format!("return cq.Workplane().{call}"));
        assert!(d.message.contains(message), "{call}: {d}");
        assert!(
            d.hint.clone().unwrap_or_default().contains(hint),
            "{call}: {d:?}"
        );
        assert_eq!(d.place, "factory test.part:line 3");
    }
    let all = calls("return cq.Workplane().gear_mesh_port(\"g\", 2, 20, 10)");
    let same = calls("return cq.Workplane().outline(cq.involute(2, 20))");
    assert_eq!(all[1]["args"]["outline"], same[1]["args"]["outline"]);
}

#[test]
fn faults_say_the_line_and_what_to_write() {
    for (lines, line, message, hint) in [
        (
            "x = 1\nreturn cqq.Workplane()",
            4,
            "nothing of the name 'cqq'",
            "cq",
        ),
        (
            "return Workplane()",
            3,
            "nothing of the name 'Workplane'",
            "from cadquery import",
        ),
        (
            "return cq.Workplan()",
            3,
            "cq has no 'Workplan'",
            "Workplane",
        ),
        (
            "return cq.Assembly()",
            3,
            "cq has no 'Assembly'",
            "one part",
        ),
        (
            "return cq.selectors.BoxSelecto()",
            3,
            "cq.selectors has no",
            "BoxSelector",
        ),
        (
            "return cq.exporters.export(1, 2)",
            3,
            "writes no files",
            "result",
        ),
        ("return math.sinn(1)", 3, "math has no 'sinn'", "sin"),
        (
            "w = cq.Workplane()\nreturn (w\n    .box(1, 1, 1)\n    .filet(1))",
            6,
            "a Workplane has no 'filet'",
            "fillet",
        ),
        (
            "w = cq.Workplane()\nreturn (w\n    .box(1, 1, 1)\n    .fillet(\"a\"))",
            6,
            "radius is a number, not a string",
            "fillet(radius)",
        ),
        (
            "return cq.Workplane().circle(radius=True)",
            3,
            "radius is a number, not a bool",
            "",
        ),
        (
            "return cq.Workplane().circle(None)",
            3,
            "radius is a number, not None",
            "",
        ),
        (
            "return cq.Workplane().circle(raduis=1)",
            3,
            "no parameter 'raduis'",
            "did you mean 'radius'?",
        ),
        (
            "return cq.Workplane().circle(1, radius=1)",
            3,
            "given 'radius' twice",
            "",
        ),
        (
            "return cq.Workplane().box(1, 1)",
            3,
            "box lacks 'height'",
            "box(length, width, height, centered=True",
        ),
        (
            "return cq.Workplane().polygon(6.0, 2)",
            3,
            "nSides is a whole number, not a float",
            "int(x)",
        ),
        (
            "return cq.Workplane(\"XYZ\")",
            3,
            "inPlane is not \"XYZ\"",
            "\"front\"",
        ),
        (
            "return cq.Workplane().faces(\">Q\")",
            3,
            "the selector '>Q' has no meaning at place 1",
            "",
        ),
        (
            "return cq.Workplane().faces(3)",
            3,
            "selector is a selector",
            "",
        ),
        (
            "return cq.Workplane().pushPoints([(1, 2), (1, 2, 3, 4)])",
            3,
            "pntList[1] is a tuple of 2 or 3 numbers, not of 4",
            "",
        ),
        (
            "return cq.Workplane().rect(1, 1, (True,))",
            3,
            "centered is True, False or 2 of them",
            "",
        ),
        (
            "return cq.Workplane().extrude(1, combine=\"x\")",
            3,
            "combine is True, False",
            "",
        ),
        (
            "return cq.Workplane().extrude(\"nxt\")",
            3,
            "until is a length",
            "",
        ),
        (
            "return cq.Workplane().sweep((0, 1))",
            3,
            "path is a workplane or a shape",
            "",
        ),
        (
            "return cq.Workplane().copyWorkplane(cq.Plane.XY())",
            3,
            "obj is a workplane",
            "",
        ),
        (
            "return cq.Plane((0, 0, 0), (1, 0, 1))",
            3,
            "right angle",
            "xDir",
        ),
        (
            "return cq.Location(1, \"a\")",
            3,
            "Location does not take",
            "rx",
        ),
        (
            "return cq.Workplane().faces().size()",
            3,
            "a Workplane has no 'size'",
            "after the script has run",
        ),
        (
            "return cq.Workplane().val().Center()",
            3,
            "a Shape has no 'Center'",
            "after the script has run",
        ),
        (
            "return cq.Workplane().val().BoundingBox().zmax",
            3,
            "'BoundingBox'",
            "after the script has run",
        ),
        (
            "return cq.Workplane().objects[0]",
            3,
            "'objects'",
            ".item(i)",
        ),
        (
            "return cq.Workplane().text(\"a\", 1, 1)",
            3,
            "there is no 'text'",
            "fonts",
        ),
        (
            "return cq.Workplane().sketch()",
            3,
            "there is no 'sketch'",
            "polyline",
        ),
        (
            "for f in cq.Workplane().faces():\n    pass",
            3,
            "a Workplane has no",
            ".each(",
        ),
        (
            "x = len(cq.Workplane().vals())",
            3,
            "a Shapes has no",
            ".each(",
        ),
        (
            "return 3",
            0,
            "build(p) returned an int and not a workplane",
            "return",
        ),
        ("return p.b", 3, "b", ""),
        ("x = [1][3]\n", 3, "3", ""),
        ("x = math.sqrt(-1)", 3, "no finite value", ""),
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
            d.hint.clone().unwrap_or_default().contains(hint),
            "{lines}: {d:?}"
        );
    }
}

#[test]
fn what_python_has_and_starlark_lacks_is_answered_at_its_line() {
    for (lines, hint) in [
        ("while True:\n    pass", "for i in range"),
        ("try:\n    pass\nexcept:\n    pass", "require(condition"),
        ("class A:\n    pass", "no classes"),
        ("import os", "nothing outside itself"),
        ("import numpy as np", "math.sin"),
        ("from cadquery import Sketch", "there are:"),
        ("load(\"a.star\", \"a\")", "there already"),
        ("x = 2 ** 3", "pow(x, y)"),
        ("x = 0 < p.a < 3", "0 < x and x < 5"),
        ("x = [1 == p.a != 3]", "0 < x and x < 5"),
        ("x = p.a is None", "=="),
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
        ("x = f\"{1:x}\"", "{x:.2f}"),
        ("def f(x: tuple[int, int]):\n    pass", "leave the type out"),
        (
            "if __name__ == \"__main__\":\n    pass",
            "leave the condition out",
        ),
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
    let found = factory("while 1:\n  x = 2 ** 3\nassert 1\n").unwrap_err();
    let places: Vec<&str> = found.iter().map(|d| d.place.as_str()).collect();
    assert_eq!(
        places,
        [
            "factory test.part:line 1",
            "factory test.part:line 2",
            "factory test.part:line 3"
        ]
    );
    // Keyword arguments are not powers, and two comparisons not always a chain.
    run("def f(*a, **k): return k[\"x\"]\n\
         x = [1 < 2, 2 < 3, (1 < 2) == (2 < 3)]\n\
         y = 1 if 1 < 2 else 2 < 3\n\
         z = not 1 < 2 and 2 < 3 or {1 < 2: 3 < 4}\n\
         return cq.Workplane().box(f(1, **{\"x\": 2}), 1, 1)");
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
fn vectors_planes_and_locations_are_pure() {
    run("v = cq.Vector(1, 2, 2)\n\
         u = cq.Vector((3, 0))\n\
         def same(a, b):\n\
         \x20   if a.toTuple() != b:\n\
         \x20       fail(str(a), str(b))\n\
         same(v + u, (4.0, 2.0, 2.0))\n\
         same(v - (1, 1, 1), (0.0, 1.0, 1.0))\n\
         same(2 * v, (2.0, 4.0, 4.0))\n\
         same(v * 2, (2.0, 4.0, 4.0))\n\
         same(-v, (-1.0, -2.0, -2.0))\n\
         same(v.add(u).sub(u).multiply(3), (3.0, 6.0, 6.0))\n\
         same(u.cross(v), (0.0, -6.0, 6.0))\n\
         same(u.normalized(), (1.0, 0.0, 0.0))\n\
         if v.Length != 3 or v.dot(u) != 3 or (v.x, v.y, v.z) != (1, 2, 2):\n\
         \x20   fail(\"numbers\")\n\
         q = cq.Plane.named(\"XZ\", (1, 2, 3))\n\
         same(q.origin, (1.0, 2.0, 3.0))\n\
         same(q.xDir, (1.0, 0.0, 0.0))\n\
         same(q.yDir, (0.0, 0.0, 1.0))\n\
         same(q.zDir, (0.0, -1.0, 0.0))\n\
         return cq.Workplane(q)");
    // Directions that CadQuery 2.8 gives where xDir is None.
    for (normal, x) in [
        ((0, 0, 1), [1.0, 0.0, 0.0]),
        ((0, 0, -1), [-1.0, 0.0, 0.0]),
        ((1, 0, 0), [0.0, 0.0, 1.0]),
        ((0, 1, 0), [0.0, 0.0, 1.0]),
        ((0, -1, 0), [0.0, 0.0, -1.0]),
        (
            (1, 2, 3),
            [0.0, 0.832_050_294_337_843_7, -0.554_700_196_225_229_1],
        ),
        (
            (3, -2, 1),
            [0.554_700_196_225_229_1, 0.832_050_294_337_843_7, 0.0],
        ),
        (
            (-2, 3, 1),
            [0.832_050_294_337_843_7, 0.554_700_196_225_229_1, 0.0],
        ),
        ((1, 1, 1), [HALF, 0.0, -HALF]),
        ((0, 1, 1), [0.0, HALF, -HALF]),
    ] {
        let all = calls(&format!(
            "return cq.Workplane(cq.Plane((0, 0, 0), None, {normal:?}))"
        ));
        near(&all[0]["args"]["inPlane"]["x"], x);
    }
    // Columns x and z and the translation, as CadQuery 2.8 gives them.
    for (text, x, z, at) in [
        (
            "cq.Location(1, 2, 3, 10, 20, 30)",
            [
                0.813_797_681_349_373_7,
                0.469_846_310_392_954_16,
                -0.342_020_143_325_668_7,
            ],
            [
                0.378_522_306_369_792_5,
                0.018_028_311_236_297_28,
                0.925_416_578_398_323_4,
            ],
            [1.0, 2.0, 3.0],
        ),
        (
            "cq.Location((1, 2, 3), (90, 0, 90))",
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 2.0, 3.0],
        ),
        (
            "cq.Location((1, 2, 3), (1, 1, 0), 33)",
            [
                0.919_335_283_972_712,
                0.080_664_716_027_287_99,
                -0.385_117_954_958_023_2,
            ],
            [
                0.385_117_954_958_023_2,
                -0.385_117_954_958_023_2,
                0.838_670_567_945_424,
            ],
            [1.0, 2.0, 3.0],
        ),
        (
            "cq.Location(cq.Plane((1, 2, 3), (0, 1, 0), (1, 0, 0)), (4, 5, 6))",
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [4.0, 5.0, 6.0],
        ),
        (
            "cq.Location(1, 2, 3, 10, 20, 30) * cq.Location((4, 5, 6), (0, 0, 1), 45)",
            [
                0.263_629_257_093_160_76,
                0.956_298_585_754_581_7,
                -0.126_461_969_335_824_82,
            ],
            [
                0.378_522_306_369_792_5,
                0.018_028_311_236_297_28,
                0.925_416_578_398_323_4,
            ],
            [
                4.321_476_510_966_837,
                8.400_375_705_286_528,
                8.000_298_452_919_939,
            ],
        ),
        (
            "cq.Location(1, 2, 3, 10, 20, 30).inverse",
            [
                0.813_797_681_349_373_7,
                -0.440_969_610_529_882_4,
                0.378_522_306_369_792_5,
            ],
            [
                -0.342_020_143_325_668_7,
                0.163_175_911_166_534_82,
                0.925_416_578_398_323_4,
            ],
            [
                -0.727_429_872_158_275_7,
                -1.813_686_361_488_493_3,
                -3.190_828_664_037_357_3,
            ],
        ),
    ] {
        let all = calls(&format!("return cq.Workplane().val().moved({text})"));
        let loc = &all[2]["args"]["loc"];
        near(&loc["x"], x);
        near(&loc["z"], z);
        near(&loc["origin"], at);
    }
    // Multiples of 90 degrees are exact.
    let all = calls("return cq.Workplane().val().moved(cq.Location(0, 0, 0, 90, -90, 180))");
    let loc = &all[2]["args"]["loc"];
    for n in ["x", "z"] {
        let exact = |v: &Value| [0.0, 1.0, -1.0].contains(&v.as_f64().unwrap());
        assert!(loc[n].as_array().unwrap().iter().all(exact), "{loc}");
    }
}

/// The root of a half.
const HALF: f64 = core::f64::consts::FRAC_1_SQRT_2;

#[track_caller]
fn near(found: &Value, expected: [f64; 3]) {
    for (found, expected) in found.as_array().unwrap().iter().zip(expected) {
        let found = found.as_f64().unwrap();
        assert!(
            (found - expected).abs() < 1e-14,
            "{found} and not {expected}"
        );
    }
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
        (Code::FactoryFailed, "factory test.part:line 2")
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
