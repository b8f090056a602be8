//! What calls record: order, lines, arguments, values.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

mod common;

use common::{calls, fault, run};
use serde_json::{Value, json};

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
    assert_eq!(d.place, "factory test.part, line 4");
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
