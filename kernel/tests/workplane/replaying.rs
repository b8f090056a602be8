//! Recipes as a whole: the same bytes every time, and what is no recipe.

use core::f64::consts::PI;

use assemcad_kernel::{Shape, replay};
use assemcad_model::recipe::FORMAT;
use serde_json::json;

use crate::common::*;

/// A bracket of many calls.
fn bracket() -> (Script, u32) {
    let mut script = Script::new();
    let post = script.chain(&[
        ("polygon", json!({ "nSides": 6, "diameter": 12.0 })),
        (
            "twistExtrude",
            json!({ "distance": 20.0, "angleDegrees": 30.0 }),
        ),
    ]);
    let plate = script.chain(&[
        ("rect", json!({ "xLen": 60.0, "yLen": 40.0 })),
        ("extrude", json!({ "until": 6.0 })),
        ("edges", json!({ "selector": "|Z" })),
        ("fillet", json!({ "radius": 4.0 })),
        ("faces", json!({ "selector": ">Z" })),
        ("workplane", json!({ "centerOption": "CenterOfMass" })),
        ("tag", json!({ "name": "top" })),
        ("rarray", json!({ "xSpacing": 44.0, "ySpacing": 24.0, "xCount": 2, "yCount": 2 })),
        ("cbore_hole_with_port", json!({ "name": "bolt", "diameter": 4.5, "cboreDiameter": 8.0, "cboreDepth": 3.0 })),
        ("union", json!({ "toUnion": to(post) })),
        ("rotate", json!({ "axisStartPoint": [0.0, 0.0, 0.0], "axisEndPoint": [1.0, -2.0, 0.5], "angleDegrees": 37.0 })),
    ]);
    (script, plate)
}

#[test]
fn a_recipe_gives_the_same_bytes_every_time() {
    let (script, result) = bracket();
    let recipe = script.recipe(result);
    let mut steps = Vec::new();
    let first = replay(&recipe, &mut |i, call| steps.push((i, call.call.clone()))).unwrap();
    evident(&first);
    assert_eq!(steps.len(), recipe.calls.len());
    assert_eq!(steps[2], (2, "Workplane.twistExtrude".to_owned()));
    let bytes = first.solid.to_bytes().unwrap();
    for _ in 1..10 {
        let again = script.part(result);
        assert!(again.solid.to_bytes().unwrap() == bytes, "the bytes differ");
        assert_eq!(again.ports, first.ports);
    }
    // Reading renormalises slanted directions: written anew, the last digits would wander.
    let again = Shape::from_bytes(&bytes).unwrap();
    assert_eq!(again.to_bytes().unwrap(), bytes);
    assert_eq!(again.mass().unwrap(), first.solid.mass().unwrap());
    assert!(!again.has_locations().unwrap());
}

#[test]
fn the_result_is_the_part() {
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let hole = script.on(
        cube,
        &[
            ("faces", json!({ "selector": ">Z" })),
            ("workplane", json!({ "centerOption": "CenterOfMass" })),
            ("hole", json!({ "diameter": 4.0 })),
        ],
    );
    near(volume(&script.part(hole).solid), 1000.0 - 40.0 * PI, 1e-12);
    // An earlier call, a selection of it, and a shape are parts too.
    near(volume(&script.part(cube).solid), 1000.0, 1e-12);
    near(volume(&script.part(cube + 1).solid), 1000.0, 1e-12);
    let body = script.call("Workplane.findSolid", Some(hole), json!({}));
    near(volume(&script.part(body).solid), 1000.0 - 40.0 * PI, 1e-12);
}

#[test]
fn references_that_are_not_earlier_ones() {
    for to_call in [2, 3, 99, u32::MAX] {
        let mut script = Script::new();
        let cube = script.cuboid([0.0; 3], [10.0; 3]);
        let both = script.on(cube, &[("union", json!({ "toUnion": to(to_call) }))]);
        let words = format!("it refers to call {to_call}, which is not an earlier one");
        let error = script.refused(both, "Workplane.union", &[&words]);
        assert_eq!(error.step, 2);
        let mut script = Script::new();
        script.cuboid([0.0; 3], [10.0; 3]);
        let wrong = script.raw("Workplane.faces", Some(to_call), json!({}));
        script.refused(wrong, "Workplane.faces", &[&words]);
        let mut script = Script::new();
        script.cuboid([0.0; 3], [10.0; 3]);
        let wrong = script.raw(
            "Workplane.eachpoint",
            Some(1),
            json!({ "arg": to(to_call), "variable": to(1) }),
        );
        script.refused(wrong, "Workplane.eachpoint", &[&words]);
    }
    // A reference within a list.
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let both = script.on(cube, &[("union", json!({ "toUnion": [to(cube), to(7)] }))]);
    script.refused(both, "Workplane.union", &["call 7"]);
}

#[test]
fn calls_that_are_unknown() {
    for name in [
        "Workplane.explode",
        "Solid.makeTeapot",
        "Shape.explode",
        "explode",
        "",
        "Workplane.",
        "Workplane.box.box",
        "workplane",
    ] {
        let mut script = Script::new();
        let cube = script.cuboid([0.0; 3], [10.0; 3]);
        let wrong = script.raw(name, Some(cube), json!({}));
        let error = script.refused(wrong, name, &[name]);
        assert_eq!(error.step, 2);
    }
    // A method of a workplane on a shape, on nothing, and the other way round.
    let mut script = Script::new();
    let body = script.call("Solid.makeSphere", None, json!({ "radius": 3.0 }));
    let wrong = script.raw("Workplane.faces", Some(body), json!({}));
    script.refused(wrong, "Workplane.faces", &["a workplane"]);
    let mut script = Script::new();
    let wrong = script.raw("Workplane.faces", None, json!({}));
    script.refused(wrong, "Workplane.faces", &["a workplane"]);
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let wrong = script.raw(
        "Shape.translate",
        Some(cube),
        json!({ "vector": [0.0, 0.0, 1.0] }),
    );
    script.refused(wrong, "Shape.translate", &["a shape"]);
}

#[test]
fn what_is_no_recipe() {
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    for result in [2, 99, u32::MAX] {
        let error = script.refused(result, "recipe", &["call", &result.to_string()]);
        assert_eq!(error.step, usize::try_from(result).unwrap());
    }
    for format in [0, FORMAT - 1, FORMAT + 1] {
        let mut recipe = script.recipe(cube);
        recipe.format = format;
        let error = replay(&recipe, &mut |_, _| panic!("a call is carried out")).unwrap_err();
        assert!(error.error.message.contains(&format!("format {format}")));
    }
    Script::new().refused(0, "recipe", &["0 calls"]);
    // No solid: a plane, points, an outline, a face.
    let mut script = Script::new();
    let plane = script.chain(&[]);
    let points = script.on(
        plane,
        &[("pushPoints", json!({ "pntList": [[0.0, 0.0, 0.0]] }))],
    );
    let circle = script.on(points, &[("circle", json!({ "radius": 1.0 }))]);
    for (result, call) in [
        (plane, "Workplane"),
        (points, "Workplane.pushPoints"),
        (circle, "Workplane.circle"),
    ] {
        script.refused(result, call, &["no solid"]);
    }
}

#[test]
fn a_chain_of_twenty_thousand_links() {
    let mut script = Script::new();
    let mut at = script.cuboid([0.0; 3], [10.0; 3]);
    for _ in 0..20_000 {
        at = script.on(at, &[("center", json!({ "x": 0.0, "y": 0.0 }))]);
    }
    let done = script.on(
        at,
        &[
            ("tag", json!({ "name": "deep" })),
            ("end", json!({ "n": 20_000 })),
        ],
    );
    let part = on_a_small_stack(script, done);
    near(part, 1000.0, 1e-12);
    // Drawn: every edge is another link.
    let mut script = Script::new();
    let mut at = script.chain(&[]);
    let turn = |k: i32| libm::sincos(2.0 * PI * f64::from(k) / 400.0);
    for k in 0..400 {
        let (sin, cos) = turn(k);
        let name = if k == 0 { "moveTo" } else { "lineTo" };
        at = script.on(at, &[(name, json!({ "x": 10.0 * cos, "y": 10.0 * sin }))]);
    }
    let done = script.on(
        at,
        &[("close", json!({})), ("extrude", json!({ "until": 1.0 }))],
    );
    let (sin, _) = turn(1);
    near(on_a_small_stack(script, done), 400.0 * 50.0 * sin, 1e-9);
}

/// The volume of the part, made where the stack is small.
fn on_a_small_stack(script: Script, result: u32) -> f64 {
    std::thread::Builder::new()
        .stack_size(1 << 20)
        .spawn(move || volume(&script.part(result).solid))
        .unwrap()
        .join()
        .unwrap()
}

#[test]
fn tags_stay_in_their_chain() {
    let mut script = Script::new();
    script.chain(&[
        ("box", sized([10.0; 3], [true; 3])),
        ("tag", json!({ "name": "t" })),
    ]);
    let other = script.cuboid([30.0, 0.0, 0.0], [10.0; 3]);
    let wrong = script.on(other, &[("workplaneFromTagged", json!({ "name": "t" }))]);
    script.refused(
        wrong,
        "Workplane.workplaneFromTagged",
        &["no tag 't'", "its tags are []"],
    );
    // What comes in by union or add brings its tags along.
    let mut script = Script::new();
    let tagged = script.chain(&[
        ("box", sized([10.0; 3], [true; 3])),
        ("tag", json!({ "name": "t" })),
    ]);
    let other = script.cuboid([0.0; 3], [20.0; 3]);
    let joined = script.on(
        other,
        &[
            ("union", json!({ "toUnion": to(tagged) })),
            ("faces", json!({ "selector": ">Z", "tag": "t" })),
            ("workplane", json!({ "centerOption": "CenterOfMass" })),
            (
                "shaft_port",
                json!({ "name": "s", "diameter": 2.0, "length": 30.0 }),
            ),
        ],
    );
    let part = script.part(joined);
    // On top of the tagged box, not of the union.
    near3(named(&part, "s").frame.origin, [0.0, 0.0, 20.0], 1e-9);
}
