//! What a recipe cannot ask for, in words that say why, at the call that asks for it.

use serde_json::json;

use crate::common::*;

#[test]
fn a_cut_that_removes_nothing() {
    for (corner, size) in [([20.0, 0.0, 0.0], [1.0; 3]), ([10.0, 0.0, 0.0], [10.0; 3])] {
        let mut only = Script::new();
        let (a, b) = (only.cuboid([0.0; 3], [10.0; 3]), only.cuboid(corner, size));
        let cut_only = only.on(a, &[("cut", json!({ "toCut": to(b) }))]);
        let error = only.refused(
            cut_only,
            "Workplane.cut",
            &[
                "removes nothing",
                "(0.000, 0.000, 0.000) to (10.000, 10.000, 10.000)",
            ],
        );
        assert_eq!(error.step, usize::try_from(cut_only).unwrap());
    }
    // By cutBlind the wrong way.
    let mut script = Script::new();
    let away = script.chain(&[
        ("box", sized([10.0; 3], [true; 3])),
        ("faces", json!({ "selector": ">Z" })),
        ("workplane", json!({})),
        ("circle", json!({ "radius": 2.0 })),
        ("cutBlind", json!({ "until": 3.0 })),
    ]);
    script.refused(away, "Workplane.cutBlind", &["removes nothing"]);
}

#[test]
fn a_cut_that_leaves_nothing_or_too_much() {
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let tool = script.cuboid([-1.0; 3], [12.0; 3]);
    let cut = script.on(cube, &[("cut", json!({ "toCut": to(tool) }))]);
    script.refused(cut, "Workplane.cut", &["leaves nothing"]);
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let blade = script.cuboid([4.0, -1.0, -1.0], [2.0, 12.0, 12.0]);
    let cut = script.on(cube, &[("cut", json!({ "toCut": to(blade) }))]);
    script.refused(cut, "Workplane.cut", &["2 separate solids"]);
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let beside = script.cuboid([10.0, 0.0, 0.0], [10.0; 3]);
    let both = script.on(cube, &[("intersect", json!({ "toIntersect": to(beside) }))]);
    script.refused(
        both,
        "Workplane.intersect",
        &["no volume in common", "0.000000 mm"],
    );
}

#[test]
fn dressing_that_does_not_fit() {
    // At 6 mm the kernel makes a solid whose faces cross, and says nothing.
    for radius in [5.0, 6.0, 20.0] {
        for (call, given) in [
            ("fillet", json!({ "radius": radius })),
            ("chamfer", json!({ "length": radius })),
        ] {
            let mut script = Script::new();
            let cube = script.chain(&[
                ("box", sized([10.0; 3], [true; 3])),
                ("edges", json!({})),
                (call, given),
            ]);
            script.refused(
                cube,
                &format!("Workplane.{call}"),
                &[
                    &format!("the {call} of {radius} mm"),
                    "measures only 10.000 mm",
                ],
            );
        }
    }
    let mut script = Script::new();
    let cube = script.chain(&[
        ("box", sized([10.0; 3], [true; 3])),
        ("faces", json!({ "selector": ">Z" })),
        ("shell", json!({ "thickness": -6.0 })),
    ]);
    script.refused(cube, "Workplane.shell", &["wall of -6 mm"]);
}

#[test]
fn outlines_that_cross_themselves() {
    let mut script = Script::new();
    let bow = script.chain(&[
        ("polyline", json!({ "listOfXYTuple": [[0.0, 0.0, 0.0], [4.0, 4.0, 0.0], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0]] })),
        ("close", json!({})),
        ("extrude", json!({ "until": 1.0 })),
    ]);
    script.refused(bow, "Workplane.extrude", &[]);
    let mut script = Script::new();
    let across = script.chain(&[
        ("rect", json!({ "xLen": 3.0, "yLen": 1.0 })),
        ("revolve", json!({})),
    ]);
    script.refused(across, "Workplane.revolve", &[]);
    let mut script = Script::new();
    let open = script.chain(&[
        ("lineTo", json!({ "x": 3.0, "y": 1.0 })),
        ("extrude", json!({ "until": 1.0 })),
    ]);
    script.refused(open, "Workplane.extrude", &["not closed"]);
    let mut script = Script::new();
    let nothing = script.chain(&[("extrude", json!({ "until": 1.0 }))]);
    script.refused(nothing, "Workplane.extrude", &["nothing is drawn"]);
}

#[test]
fn huge_counts() {
    let most = 1_000_000_000;
    for (call, given, words) in [
        (
            "rarray",
            json!({ "xSpacing": 1.0, "ySpacing": 1.0, "xCount": most, "yCount": 1 }),
            "xCount is 1 to 10000",
        ),
        (
            "rarray",
            json!({ "xSpacing": 1.0, "ySpacing": 1.0, "xCount": 1, "yCount": most }),
            "yCount is 1 to 10000",
        ),
        (
            "rarray",
            json!({ "xSpacing": 1.0, "ySpacing": 1.0, "xCount": 10_000, "yCount": 10_000 }),
            "at most 10000 points",
        ),
        (
            "rarray",
            json!({ "xSpacing": 1.0, "ySpacing": 1.0, "xCount": 0, "yCount": 1 }),
            "xCount is 1 to 10000, not 0",
        ),
        (
            "rarray",
            json!({ "xSpacing": 1.0, "ySpacing": 1.0, "xCount": 4_000_000_000_u64, "yCount": 1 }),
            "xCount of Workplane.rarray is a whole number",
        ),
        (
            "polarArray",
            json!({ "radius": 1.0, "startAngle": 0.0, "angle": 360.0, "count": most }),
            "count is 1 to 10000",
        ),
        (
            "polygon",
            json!({ "nSides": most, "diameter": 5.0 }),
            "3 to 10000 sides",
        ),
        ("end", json!({ "n": most }), "the chain has only 2 links"),
        ("item", json!({ "i": most }), "not among them"),
        ("item", json!({ "i": -most }), "not among them"),
    ] {
        let mut script = Script::new();
        let chain = script.chain(&[
            ("center", json!({ "x": 0.0, "y": 0.0 })),
            ("tag", json!({ "name": "t" })),
            ("center", json!({ "x": 0.0, "y": 0.0 })),
            (call, given),
        ]);
        script.refused(chain, &format!("Workplane.{call}"), &[words]);
    }
    // Neighbours of neighbours end where there are no more.
    let mut script = Script::new();
    let far = script.chain(&[
        ("box", sized([10.0; 3], [true; 3])),
        ("faces", json!({ "selector": ">Z" })),
        ("siblings", json!({ "kind": "Edge", "level": i32::MAX })),
    ]);
    near(volume(&script.part(far).solid), 1000.0, 1e-12);
}

#[test]
fn arguments_of_the_wrong_sort() {
    for (call, given, words) in [
        (
            "box",
            json!({ "length": "wide", "width": 1.0, "height": 1.0, "centered": true }),
            "length of Workplane.box is a number",
        ),
        (
            "box",
            json!({ "length": null, "width": 1.0, "height": 1.0, "centered": true }),
            "length of Workplane.box is a number",
        ),
        (
            "box",
            json!({ "width": 1.0, "height": 1.0, "centered": true, "combine": "add", "clean": true }),
            "length of Workplane.box is a number",
        ),
        (
            "box",
            json!({ "length": 1.0, "width": 1.0, "height": 1.0, "centered": [true, false], "combine": "add", "clean": true }),
            "centered of Workplane.box",
        ),
        (
            "box",
            json!({ "length": 1.0, "width": 1.0, "height": 1.0, "centered": true, "combine": "maybe", "clean": true }),
            "combine is add, cut or none",
        ),
        (
            "circle",
            json!({ "radius": {"ref": 0} }),
            "radius of Workplane.circle is a number",
        ),
        (
            "circle",
            json!({ "radius": 1e6 }),
            "radius of Workplane.circle is 1000000 mm",
        ),
        (
            "translate",
            json!({ "vec": [1.0, 2.0] }),
            "vec of Workplane.translate is a point of three numbers",
        ),
        (
            "translate",
            json!({ "vec": [1.0, 2.0, 1e300] }),
            "vec of Workplane.translate",
        ),
        (
            "pushPoints",
            json!({ "pntList": 5 }),
            "takes a list of points",
        ),
        (
            "pushPoints",
            json!({ "pntList": [[1.0, "x", 0.0]] }),
            "pntList of Workplane.pushPoints",
        ),
        (
            "union",
            json!({ "toUnion": 3, "clean": true, "glue": false }),
            "toUnion of Workplane.union",
        ),
        (
            "union",
            json!({ "toUnion": [[{"ref": 0}]], "clean": true, "glue": false }),
            "toUnion of Workplane.union",
        ),
        (
            "faces",
            json!({ "selector": ">Z" }),
            "selector of Workplane.faces",
        ),
        (
            "faces",
            json!({ "selector": { "nth": 3 } }),
            "selector of Workplane.faces",
        ),
        (
            "end",
            json!({ "n": 1.5 }),
            "n of Workplane.end is a whole number",
        ),
        (
            "tag",
            json!({ "name": 7 }),
            "name of Workplane.tag is a text",
        ),
        (
            "workplaneFromTagged",
            json!({ "name": "none" }),
            "no tag 'none'",
        ),
        (
            "polyline",
            json!({ "listOfXYTuple": [1.0, 2.0], "forConstruction": false, "includeCurrent": false }),
            "listOfXYTuple of Workplane.polyline is a list of points",
        ),
        (
            "outline",
            json!({ "outline": { "start": [0.0] } }),
            "outline of Workplane.outline",
        ),
    ] {
        let mut script = Script::new();
        let start = script.chain(&[]);
        let name = format!("Workplane.{call}");
        let wrong = script.raw(&name, Some(start), given);
        script.refused(wrong, &name, &[words]);
    }
}

#[test]
fn numbers_that_are_none() {
    // JSON has no NaN and no infinity; a number may still be beyond what can be held.
    for text in ["1e999", "-1e999"] {
        let number: serde_json::Value = serde_json::from_str(text).unwrap();
        let mut script = Script::new();
        let start = script.chain(&[]);
        let wrong = script.raw("Workplane.circle", Some(start), json!({ "radius": number }));
        script.refused(
            wrong,
            "Workplane.circle",
            &["radius of Workplane.circle is a number"],
        );
        let wrong = json!({ "vec": [0.0, number, 0.0] });
        let mut script = Script::new();
        let start = script.chain(&[]);
        let wrong = script.raw("Workplane.translate", Some(start), wrong);
        script.refused(
            wrong,
            "Workplane.translate",
            &["vec of Workplane.translate"],
        );
    }
    assert!(serde_json::from_str::<serde_json::Value>("NaN").is_err());
    assert_eq!(json!(f64::NAN), json!(null));
}
