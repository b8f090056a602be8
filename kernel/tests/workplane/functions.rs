//! Functions of a place or an object: calls that are carried out once for each.

use core::f64::consts::PI;

use serde_json::json;

use crate::common::*;

/// A plate of 60 x 60 x 5 and the places on its top.
fn plate(script: &mut Script, points: &[[f64; 3]]) -> u32 {
    script.chain(&[
        ("box", sized([60.0, 60.0, 5.0], [true, true, false])),
        ("faces", json!({ "selector": ">Z" })),
        ("workplane", json!({ "centerOption": "CenterOfMass" })),
        ("pushPoints", json!({ "pntList": points })),
    ])
}

const POINTS: [[f64; 3]; 3] = [[-20.0, -20.0, 0.0], [0.0, 10.0, 0.0], [20.0, 0.0, 0.0]];

#[test]
fn the_same_shape_at_every_place() {
    let mut script = Script::new();
    let places = plate(&mut script, &POINTS);
    let post = script.call(
        "Solid.makeCylinder",
        None,
        json!({ "radius": 3.0, "height": 8.0 }),
    );
    let given = json!({ "arg": to(post), "useLocalCoordinates": true, "combine": "add" });
    let posts = script.on(places, &[("eachpoint", given)]);
    near(
        volume(&script.part(posts).solid),
        18_000.0 + 3.0 * 72.0 * PI,
        1e-10,
    );
    // Cut instead: the cylinders reach down through the plate.
    let mut script = Script::new();
    let places = plate(&mut script, &POINTS);
    let tool = script.call(
        "Solid.makeCylinder",
        None,
        json!({ "radius": 3.0, "height": 8.0, "dir": [0.0, 0.0, -1.0] }),
    );
    let given = json!({ "arg": to(tool), "useLocalCoordinates": true, "combine": "cut" });
    let holes = script.on(places, &[("eachpoint", given)]);
    near(
        volume(&script.part(holes).solid),
        18_000.0 - 3.0 * 45.0 * PI,
        1e-10,
    );
}

#[test]
fn a_function_of_the_place() {
    let mut script = Script::new();
    let places = plate(&mut script, &POINTS);
    let place = script.raw("eachLocation", Some(places), json!({}));
    let post = script.call(
        "Solid.makeCylinder",
        None,
        json!({ "radius": 3.0, "height": 8.0 }),
    );
    let moved = script.call("Shape.moved", Some(post), json!({ "loc": to(place) }));
    let given = json!({
        "arg": to(moved), "variable": to(place), "useLocalCoordinates": true, "combine": "add",
    });
    let posts = script.on(places, &[("eachpoint", given)]);
    let part = script.part(posts);
    near(volume(&part.solid), 18_000.0 + 3.0 * 72.0 * PI, 1e-10);
    let top = part.solid.bounds().unwrap().max;
    near3(top, [30.0, 30.0, 13.0], 1e-7);
    // The calls of the function have no value outside of it.
    script.refused(moved, "Shape.moved", &["no workplane"]);
}

#[test]
fn a_function_that_begins_a_chain() {
    // lambda place: cq.Workplane("XY").box(4, 4, 6).edges("|Z").fillet(1).val().located(place)
    let mut script = Script::new();
    let places = plate(&mut script, &POINTS);
    let place = script.raw("eachLocation", Some(places), json!({}));
    let block = script.chain(&[
        ("box", sized([4.0, 4.0, 6.0], [true, true, false])),
        ("edges", json!({ "selector": "|Z" })),
        ("fillet", json!({ "radius": 1.0 })),
    ]);
    let body = script.call("Workplane.findSolid", Some(block), json!({}));
    let located = script.call("Shape.located", Some(body), json!({ "loc": to(place) }));
    let given = json!({
        "arg": to(located), "variable": to(place), "useLocalCoordinates": true, "combine": "add",
    });
    let blocks = script.on(places, &[("eachpoint", given)]);
    let one = (16.0 - (4.0 - PI)) * 6.0;
    near(
        volume(&script.part(blocks).solid),
        18_000.0 + 3.0 * one,
        1e-10,
    );
}

#[test]
fn a_function_of_the_object() {
    // A post on each of the six faces of a cube.
    let mut script = Script::new();
    let faces = script.chain(&[("box", sized([10.0; 3], [true; 3])), ("faces", json!({}))]);
    let object = script.raw("eachObject", Some(faces), json!({}));
    let start = script.call("Workplane", None, json!({ "inPlane": to(object) }));
    let post = script.on(
        start,
        &[
            ("workplane", json!({ "centerOption": "CenterOfMass" })),
            ("circle", json!({ "radius": 1.0 })),
            ("extrude", json!({ "until": 5.0 })),
        ],
    );
    let given = json!({ "callback": to(post), "variable": to(object) });
    let posts = script.on(faces, &[("each", given)]);
    let part = script.part(posts);
    near(volume(&part.solid), 1000.0 + 30.0 * PI, 1e-10);
    near3(part.solid.bounds().unwrap().min, [-10.0; 3], 1e-7);
}

#[test]
fn a_function_in_a_function() {
    // At each of two places a row of two posts, the inner function using both places:
    // lambda a: row.eachpoint(lambda b: post.moved(b).moved(a))
    let mut script = Script::new();
    let places = plate(&mut script, &[[-15.0, 0.0, 0.0], [15.0, 0.0, 0.0]]);
    let outer = script.raw("eachLocation", Some(places), json!({}));
    let row = script.chain(&[(
        "pushPoints",
        json!({ "pntList": [[0.0, -8.0, 0.0], [0.0, 8.0, 0.0]] }),
    )]);
    let inner = script.raw("eachLocation", Some(row), json!({}));
    let post = script.call(
        "Solid.makeCylinder",
        None,
        json!({ "radius": 3.0, "height": 8.0 }),
    );
    let once = script.call("Shape.moved", Some(post), json!({ "loc": to(inner) }));
    let twice = script.call("Shape.moved", Some(once), json!({ "loc": to(outer) }));
    let given = json!({ "arg": to(twice), "variable": to(inner), "useLocalCoordinates": true });
    let rows = script.on(row, &[("eachpoint", given)]);
    let given = json!({
        "arg": to(rows), "variable": to(outer), "useLocalCoordinates": true, "combine": "add",
    });
    let all = script.on(places, &[("eachpoint", given)]);
    near(
        volume(&script.part(all).solid),
        18_000.0 + 4.0 * 72.0 * PI,
        1e-10,
    );
}

#[test]
fn functions_that_give_nothing_are_refused() {
    let mut script = Script::new();
    let places = plate(&mut script, &POINTS);
    let place = script.raw("eachLocation", Some(places), json!({}));
    let given = json!({ "arg": to(place), "variable": to(place), "useLocalCoordinates": true });
    let nothing = script.on(places, &[("eachpoint", given)]);
    script.refused(nothing, "Workplane.eachpoint", &["gives no shape"]);
    // What fails in the function fails the call that it is given to.
    let mut script = Script::new();
    let places = plate(&mut script, &POINTS);
    let place = script.raw("eachLocation", Some(places), json!({}));
    let start = script.call("Workplane", None, json!({ "inPlane": to(place) }));
    let wrong = script.on(start, &[("box", sized([1.0, 1.0, 0.0], [true; 3]))]);
    let given = json!({ "arg": to(wrong), "variable": to(place), "useLocalCoordinates": true });
    let all = script.on(places, &[("eachpoint", given)]);
    script.refused(
        all,
        "Workplane.eachpoint",
        &["height of Workplane.box is 0 mm"],
    );
}
