//! Unions that come out as one solid, and those that are refused.

use core::f64::consts::PI;

use serde_json::json;

use crate::common::*;

/// The union of two boxes.
fn united(a: ([f64; 3], [f64; 3]), b: ([f64; 3], [f64; 3])) -> (Script, u32) {
    let mut script = Script::new();
    let (a, b) = (script.cuboid(a.0, a.1), script.cuboid(b.0, b.1));
    let both = script.on(a, &[("union", json!({ "toUnion": to(b) }))]);
    (script, both)
}

const CUBE: ([f64; 3], [f64; 3]) = ([0.0; 3], [10.0; 3]);

#[test]
fn overlap() {
    let (script, both) = united(CUBE, ([5.0, 5.0, 5.0], [10.0; 3]));
    near(volume(&script.part(both).solid), 1875.0, 1e-12);
    let (script, both) = united(CUBE, ([2.0; 3], [3.0; 3]));
    near(volume(&script.part(both).solid), 1000.0, 1e-12);
}

#[test]
fn a_whole_face_in_common() {
    let (script, both) = united(CUBE, ([10.0, 0.0, 0.0], [10.0; 3]));
    let part = script.part(both);
    near(volume(&part.solid), 2000.0, 1e-12);
    assert_eq!(part.solid.faces().unwrap().len(), 6);
}

#[test]
fn part_of_a_face_in_common() {
    for corner in [[10.0, 2.0, 3.0], [10.0, 7.0, -2.0]] {
        let (script, both) = united(CUBE, (corner, [5.0; 3]));
        near(volume(&script.part(both).solid), 1125.0, 1e-12);
    }
}

#[test]
fn a_gap_of_five_micrometres_is_closed() {
    // The gap is filled where the two faces look at each other: over 10 x 10, 5 x 5 within, and 3 x 4
    // where the smaller one reaches beyond an edge.
    for (corner, size, area) in [
        ([10.005, 0.0, 0.0], [10.0; 3], 100.0),
        ([10.005, 2.0, 3.0], [5.0; 3], 25.0),
        ([10.005, 7.0, 6.0], [5.0; 3], 12.0),
        ([-5.005, 7.0, 6.0], [5.0; 3], 12.0),
    ] {
        let (script, both) = united(CUBE, (corner, size));
        let sum = 1000.0 + size.iter().product::<f64>();
        near(volume(&script.part(both).solid), sum + area * 0.005, 1e-9);
    }
}

#[test]
fn a_gap_under_every_foot_is_closed() {
    // Four feet that hang 8 micrometres above a plate: all of them are joined to it.
    let mut script = Script::new();
    let feet = script.chain(&[
        ("box", sized([30.0, 30.0, 4.0], [true, true, false])),
        (
            "rarray",
            json!({ "xSpacing": 20.0, "ySpacing": 20.0, "xCount": 2, "yCount": 2 }),
        ),
        ("rect", json!({ "xLen": 4.0, "yLen": 6.0 })),
        ("extrude", json!({ "until": -5.0 })),
    ]);
    let plate = script.cuboid([-20.0, -20.0, -7.008], [40.0, 40.0, 2.0]);
    let both = script.on(feet, &[("union", json!({ "toUnion": to(plate) }))]);
    let expected = 3600.0 + 4.0 * 24.0 * 5.008 + 3200.0;
    near(volume(&script.part(both).solid), expected, 1e-9);
}

#[test]
fn a_gap_of_twenty_micrometres_is_refused() {
    let (script, both) = united(CUBE, ([10.02, 0.0, 0.0], [10.0; 3]));
    script.refused(
        both,
        "Workplane.union",
        &[
            "do not join",
            "2 separate solids",
            "0.020000 mm",
            "(0.000, 0.000, 0.000) to (10.000, 10.000, 10.000)",
            "(10.020, 0.000, 0.000) to (20.020, 10.000, 10.000)",
        ],
    );
    let (script, both) = united(CUBE, ([12.5, 0.0, 0.0], [10.0; 3]));
    script.refused(both, "Workplane.union", &["2.500000 mm"]);
}

#[test]
fn a_gap_under_a_round_side_is_refused() {
    // A roller 5 micrometres above a plate: there are no two plane faces.
    let mut script = Script::new();
    let plate = script.cuboid([-20.0, -20.0, -5.0], [40.0, 40.0, 5.0]);
    let start = script.call("Workplane", None, json!({ "origin": [0.0, 0.0, 3.005] }));
    let roller = script.on(
        start,
        &[(
            "cylinder",
            json!({ "height": 20.0, "radius": 3.0, "direct": [1.0, 0.0, 0.0] }),
        )],
    );
    let both = script.on(plate, &[("union", json!({ "toUnion": to(roller) }))]);
    script.refused(
        both,
        "Workplane.union",
        &["0.005000 mm", "between plane faces"],
    );
}

#[test]
fn touching_along_an_edge_or_in_a_point_is_refused() {
    for corner in [[10.0, 10.0, 0.0], [10.0, 10.0, 10.0]] {
        let (script, both) = united(CUBE, (corner, [10.0; 3]));
        script.refused(
            both,
            "Workplane.union",
            &[
                "2 separate solids",
                "0.000000 mm",
                "only along an edge or in a point",
            ],
        );
    }
}

/// A plate of 60 x 20 x 5 and three posts of radius 4 and height 30 that begin at a height.
fn plate_and_posts(script: &mut Script, height: f64) -> (u32, u32) {
    let plate = script.cuboid([-30.0, -10.0, -5.0], [60.0, 20.0, 5.0]);
    let start = script.call("Workplane", None, json!({ "origin": [0.0, 0.0, height] }));
    let posts = script.on(
        start,
        &[
            (
                "pushPoints",
                json!({ "pntList": [[-20.0, 0.0, 0.0], [0.0, 0.0, 0.0], [20.0, 0.0, 0.0]] }),
            ),
            ("circle", json!({ "radius": 4.0 })),
            ("extrude", json!({ "until": 30.0 })),
        ],
    );
    (plate, posts)
}

#[test]
fn three_posts_and_a_plate() {
    let disc = 16.0 * PI;
    for (height, filled) in [(0.0, 0.0), (-2.0, -2.0), (0.006, 0.006)] {
        let mut script = Script::new();
        let (plate, posts) = plate_and_posts(&mut script, height);
        let ways = [
            script.on(plate, &[("union", json!({ "toUnion": to(posts) }))]),
            script.on(posts, &[("union", json!({ "toUnion": to(plate) }))]),
        ];
        for both in ways {
            let expected = 6000.0 + 3.0 * disc * (30.0 + filled);
            near(volume(&script.part(both).solid), expected, 1e-9);
        }
    }
    let mut script = Script::new();
    let (plate, posts) = plate_and_posts(&mut script, 0.02);
    let both = script.on(plate, &[("union", json!({ "toUnion": to(posts) }))]);
    script.refused(
        both,
        "Workplane.union",
        &["4 separate solids", "0.020000 mm"],
    );
    // The posts alone: three solids are no part.
    let mut script = Script::new();
    let posts = plate_and_posts(&mut script, 0.0).1;
    script.refused(posts, "Workplane.extrude", &["3 separate solids"]);
}

#[test]
fn a_solid_with_itself() {
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let pin = script.on(
        cube,
        &[
            ("faces", json!({ "selector": ">Z" })),
            ("workplane", json!({ "centerOption": "CenterOfMass" })),
            (
                "shaft_port",
                json!({ "name": "pin", "diameter": 4.0, "length": 6.0 }),
            ),
        ],
    );
    let both = script.on(pin, &[("union", json!({ "toUnion": to(pin) }))]);
    let part = script.part(both);
    near(volume(&part.solid), 1000.0 + 24.0 * PI, 1e-10);
    assert_eq!(part.ports.len(), 1);
    // With its own earlier link too.
    let both = script.on(pin, &[("union", json!({ "toUnion": to(cube) }))]);
    let part = script.part(both);
    near(volume(&part.solid), 1000.0 + 24.0 * PI, 1e-10);
    assert_eq!(part.ports.len(), 1);
}

#[test]
fn a_union_of_nothing() {
    let mut script = Script::new();
    let empty = script.chain(&[]);
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let both = script.on(cube, &[("union", json!({ "toUnion": to(empty) }))]);
    script.refused(both, "Workplane.union", &["no solid on its stack"]);
    let mut script = Script::new();
    let empty = script.chain(&[("union", json!({}))]);
    script.refused(empty, "Workplane.union", &["nothing to unite"]);
    // An empty chain takes what it is given.
    let mut script = Script::new();
    let cube = script.cuboid([0.0; 3], [10.0; 3]);
    let both = script.chain(&[("union", json!({ "toUnion": to(cube) }))]);
    near(volume(&script.part(both).solid), 1000.0, 1e-12);
}
