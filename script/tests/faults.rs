//! Faults: at their line, with what to write instead.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

mod common;

use assemcad_model::diagnostic::Code;
use common::{calls, factory, fault, run};

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
        assert_eq!(d.place, "factory test.part, line 3");
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
                format!("factory test.part, line {line}"),
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
            d.place.starts_with("factory test.part, line "),
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
            "factory test.part, line 1",
            "factory test.part, line 2",
            "factory test.part, line 3"
        ]
    );
    // Keyword arguments are not powers, and two comparisons not always a chain.
    run("def f(*a, **k): return k[\"x\"]\n\
         x = [1 < 2, 2 < 3, (1 < 2) == (2 < 3)]\n\
         y = 1 if 1 < 2 else 2 < 3\n\
         z = not 1 < 2 and 2 < 3 or {1 < 2: 3 < 4}\n\
         return cq.Workplane().box(f(1, **{\"x\": 2}), 1, 1)");
}
