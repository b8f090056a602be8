//! Holes and their ports, on level, upright and slanted faces.

use core::f64::consts::PI;

use assemcad_model::frame::Frame;
use assemcad_model::ports::PortType;
use serde_json::{Value, json};

use crate::common::*;

/// Where the holes are, on the face.
const HERE: [f64; 3] = [8.0, -5.0, 0.0];

fn disc(diameter: f64) -> f64 {
    PI * diameter * diameter / 4.0
}

/// A block with a hole made by a method at [`HERE`]; for each seat.
fn drilled(method: &str, given: &Value) -> Vec<(Frame, assemcad_kernel::replay::Part)> {
    seats()
        .into_iter()
        .map(|seat| {
            let mut script = Script::new();
            let face = block(&mut script, &seat);
            let hole = script.on(
                face,
                &[
                    ("pushPoints", json!({ "pntList": [HERE] })),
                    (method, given.clone()),
                ],
            );
            let part = script.part(hole);
            evident(&part);
            (shifted(&seat, HERE), part)
        })
        .collect()
}

/// The far mouth of a hole through the block.
fn far(mouth: &Frame) -> Frame {
    over(&shifted(mouth, [0.0, 0.0, -20.0]))
}

#[test]
fn a_blind_bore() {
    for (at, part) in drilled(
        "bore_port",
        &json!({ "name": "b", "diameter": 6.0, "depth": 8.0 }),
    ) {
        let params = [("diameter", 6.0), ("depth", 8.0)];
        has(&part, "b", PortType::Bore, &at, &params);
        near(volume(&part.solid), BLOCK - disc(6.0) * 8.0, 1e-10);
        assert_eq!(part.ports.len(), 1);
    }
}

#[test]
fn a_bore_through_all_with_a_back() {
    let given = json!({ "name": "b", "diameter": 6.0, "back": "far" });
    for (at, part) in drilled("bore_port", &given) {
        let params = [("diameter", 6.0), ("depth", 20.0)];
        has(&part, "b", PortType::Bore, &at, &params);
        has(&part, "far", PortType::Bore, &far(&at), &params);
        near(volume(&part.solid), BLOCK - disc(6.0) * 20.0, 1e-10);
    }
}

#[test]
fn a_hole() {
    let given = json!({ "name": "h", "diameter": 5.0, "depth": 12.0 });
    for (at, part) in drilled("hole_with_port", &given) {
        let params = [("diameter", 5.0), ("depth", 12.0)];
        has(&part, "h", PortType::Hole, &at, &params);
        near(volume(&part.solid), BLOCK - disc(5.0) * 12.0, 1e-10);
    }
}

#[test]
fn a_clearance_hole() {
    let given = json!({ "name": "h", "diameter": 6.6, "bolt_diameter": 6.0, "back": "far" });
    for (at, part) in drilled("hole_with_port", &given) {
        let params = [("diameter", 6.6), ("depth", 20.0), ("bolt_diameter", 6.0)];
        has(&part, "h", PortType::ClearanceHole, &at, &params);
        has(&part, "far", PortType::Hole, &far(&at), &params[..2]);
        near(volume(&part.solid), BLOCK - disc(6.6) * 20.0, 1e-10);
    }
}

#[test]
fn a_counterbore() {
    let given = json!({
        "name": "c", "diameter": 6.6, "cboreDiameter": 11.0, "cboreDepth": 7.0, "back": "far",
    });
    for (at, part) in drilled("cbore_hole_with_port", &given) {
        let params = [
            ("diameter", 11.0),
            ("depth", 7.0),
            ("hole_diameter", 6.6),
            ("hole_depth", 13.0),
        ];
        let floor = shifted(&at, [0.0, 0.0, -7.0]);
        has(&part, "c", PortType::CboreSeat, &floor, &params);
        // From the far side the narrow hole ends at the floor.
        let params = [("diameter", 6.6), ("depth", 13.0)];
        has(&part, "far", PortType::Hole, &far(&at), &params);
        let removed = disc(11.0) * 7.0 + disc(6.6) * 13.0;
        near(volume(&part.solid), BLOCK - removed, 1e-10);
    }
}

#[test]
fn a_countersink() {
    // 90 degrees: the cone of diameter 12 is 6 high, and meets the hole of 6 at half its height.
    let given = json!({
        "name": "c", "diameter": 6.0, "cskDiameter": 12.0, "cskAngle": 90.0, "back": "far",
    });
    for (at, part) in drilled("csk_hole_with_port", &given) {
        let below = shifted(&at, [0.0, 0.0, -3.0]);
        let params = [("diameter", 6.0), ("depth", 17.0)];
        has(&part, "c", PortType::Hole, &below, &params);
        has(&part, "far", PortType::Hole, &far(&at), &params);
        let frustum = PI * 3.0 / 3.0 * (36.0 + 9.0 + 18.0);
        near(
            volume(&part.solid),
            BLOCK - frustum - disc(6.0) * 17.0,
            1e-9,
        );
    }
}

#[test]
fn a_tapped_hole() {
    // ISO 724, M8 x 1.25: the minor diameter of the nut's thread is 6.647.
    let minor = 8.0 - 1.25 * 1.082_531_754_730_548;
    near(minor, 6.647, 1e-4);
    for (hand, sign) in [("right", 1.0), ("left", -1.0)] {
        let given = json!({
            "name": "t", "diameter": 8.0, "pitch": 1.25, "depth": 15.0, "hand": hand,
        });
        for (at, part) in drilled("tapped_hole_with_port", &given) {
            let params = [
                ("diameter", 8.0),
                ("pitch", 1.25),
                ("hand", sign),
                ("depth", 15.0),
                ("modelled_diameter", minor),
            ];
            has(&part, "t", PortType::ThreadInternal, &at, &params);
            near(volume(&part.solid), BLOCK - disc(minor) * 15.0, 1e-8);
        }
    }
    let given = json!({
        "name": "t", "diameter": 8.0, "pitch": 1.25, "modelled_diameter": 6.8, "back": "far",
    });
    for (at, part) in drilled("tapped_hole_with_port", &given) {
        let params = [
            ("diameter", 8.0),
            ("pitch", 1.25),
            ("hand", 1.0),
            ("depth", 20.0),
            ("modelled_diameter", 6.8),
        ];
        has(&part, "t", PortType::ThreadInternal, &at, &params);
        has(&part, "far", PortType::ThreadInternal, &far(&at), &params);
        near(volume(&part.solid), BLOCK - disc(6.8) * 20.0, 1e-10);
    }
}

#[test]
fn holes_are_numbered_and_their_depths_measured() {
    // A step of 10 under one half: from above, one hole is 20 deep and the other 30.
    let mut script = Script::new();
    let low = script.cuboid([0.0, 0.0, -30.0], [20.0, 20.0, 30.0]);
    let high = script.cuboid([20.0, 0.0, -20.0], [20.0, 20.0, 20.0]);
    let steps = script.on(
        low,
        &[
            ("union", json!({ "toUnion": to(high) })),
            ("faces", json!({ "selector": ">Z" })),
            ("workplane", json!({ "centerOption": "CenterOfMass" })),
            (
                "rarray",
                json!({ "xSpacing": 20.0, "ySpacing": 1.0, "xCount": 2, "yCount": 1 }),
            ),
            (
                "hole_with_port",
                json!({ "name": "h", "diameter": 4.0, "back": "far", "center": "middle" }),
            ),
        ],
    );
    let part = script.part(steps);
    evident(&part);
    for (index, x, depth) in [(1, 10.0, 30.0), (2, 30.0, 20.0)] {
        let at = Frame {
            origin: [x, 10.0, 0.0],
            ..Frame::WORLD
        };
        let params = [("diameter", 4.0), ("depth", depth)];
        has(&part, &format!("h_{index}"), PortType::Hole, &at, &params);
        let back = over(&shifted(&at, [0.0, 0.0, -depth]));
        has(
            &part,
            &format!("far_{index}"),
            PortType::Hole,
            &back,
            &params,
        );
    }
    let at = Frame {
        origin: [20.0, 10.0, 0.0],
        ..Frame::WORLD
    };
    // Up to the holes along x: 10 - 2 on either side. The whole face along y.
    let params = [("extent_x", 16.0), ("extent_y", 20.0)];
    has(&part, "middle", PortType::FlatFace, &at, &params);
    assert_eq!(part.ports.len(), 5);
}

#[test]
fn a_bore_through_two_walls() {
    // A box tube along y with walls of 3: the first wall is the port's depth, the last one its back's.
    let mut script = Script::new();
    let outside = script.cuboid([-15.0, -20.0, -30.0], [30.0, 40.0, 30.0]);
    let inside = script.cuboid([-12.0, -20.0, -27.0], [24.0, 40.0, 24.0]);
    let bored = script.on(
        outside,
        &[
            ("cut", json!({ "toCut": to(inside) })),
            ("faces", json!({ "selector": ">Z" })),
            ("workplane", json!({ "centerOption": "CenterOfMass" })),
            (
                "bore_port",
                json!({ "name": "b", "diameter": 8.0, "back": "far" }),
            ),
        ],
    );
    let part = script.part(bored);
    evident(&part);
    let params = [("diameter", 8.0), ("depth", 3.0)];
    has(&part, "b", PortType::Bore, &Frame::WORLD, &params);
    let back = over(&shifted(&Frame::WORLD, [0.0, 0.0, -30.0]));
    has(&part, "far", PortType::Bore, &back, &params);
    let tube = 40.0 * (900.0 - 576.0);
    near(volume(&part.solid), tube - 2.0 * disc(8.0) * 3.0, 1e-10);
}

#[test]
fn holes_on_a_circle_and_the_middle_of_it() {
    let mut script = Script::new();
    let plate = script.chain(&[
        ("circle", json!({ "radius": 30.0 })),
        ("circle", json!({ "radius": 10.0 })),
        ("extrude", json!({ "until": 6.0 })),
        ("faces", json!({ "selector": ">Z" })),
        ("workplane", json!({ "centerOption": "CenterOfMass" })),
        (
            "polarArray",
            json!({ "radius": 20.0, "startAngle": 45.0, "angle": 360.0, "count": 4 }),
        ),
        (
            "hole_with_port",
            json!({ "name": "h", "diameter": 4.3, "bolt_diameter": 4.0, "center": "flange" }),
        ),
    ]);
    let part = script.part(plate);
    evident(&part);
    let at = shifted(&Frame::WORLD, [0.0, 0.0, 6.0]);
    let params = [
        ("extent_x", 60.0),
        ("extent_y", 60.0),
        ("hole_diameter", 20.0),
    ];
    has(&part, "flange", PortType::FlatFace, &at, &params);
    let root = 20.0 / 2.0_f64.sqrt();
    near3(named(&part, "h_2").frame.origin, [-root, root, 6.0], 1e-9);
    near(
        volume(&part.solid),
        6.0 * (PI * 800.0 - 4.0 * disc(4.3)),
        1e-9,
    );
}

#[test]
fn what_is_no_hole_is_refused() {
    let cases = [
        // Beside the block; its mouth below; its mouth closed.
        (
            json!({ "pntList": [[100.0, 0.0, 0.0]] }),
            vec![
                "(100.000, 0.000, 20.000)",
                "removes nothing",
                "along (0.000, 0.000, -1.000)",
            ],
        ),
        (
            json!({ "pntList": [[0.0, 0.0, 5.0]] }),
            vec!["begins 5.0000 mm below the workplane"],
        ),
        (
            json!({ "pntList": [[0.0, 0.0, -5.0]] }),
            vec!["begins inside the material"],
        ),
        // One of two misses.
        (
            json!({ "pntList": [[0.0, 0.0, 0.0], [0.0, 50.0, 0.0]] }),
            vec!["(0.000, 50.000, 20.000)", "removes nothing"],
        ),
    ];
    for method in ["bore_port", "hole_with_port", "tapped_hole_with_port"] {
        for (points, words) in &cases {
            let mut given = json!({ "name": "h", "diameter": 6.0 });
            if method == "tapped_hole_with_port" {
                given["pitch"] = json!(1.0);
            }
            let mut script = Script::new();
            let at = shifted(&Frame::WORLD, [0.0, 0.0, 20.0]);
            let face = block(&mut script, &at);
            let hole = script.on(face, &[("pushPoints", points.clone()), (method, given)]);
            script.refused(hole, &format!("Workplane.{method}"), words);
        }
    }
    // The workplane looks into the material.
    let mut script = Script::new();
    let hole = script.chain(&[
        ("box", sized([10.0; 3], [true, true, false])),
        ("workplane", json!({ "invert": true, "offset": -10.0 })),
        ("bore_port", json!({ "name": "b", "diameter": 4.0 })),
    ]);
    script.refused(
        hole,
        "Workplane.bore_port",
        &["removes nothing", "along (0.000, 0.000, 1.000)"],
    );
}

#[test]
fn a_blind_hole_has_no_back() {
    let mut script = Script::new();
    let face = block(&mut script, &Frame::WORLD);
    let given = json!({ "name": "b", "diameter": 6.0, "depth": 8.0, "back": "far" });
    let hole = script.on(face, &[("bore_port", given)]);
    script.refused(
        hole,
        "Workplane.bore_port",
        &["8.000 mm deep", "no far mouth", "'far'"],
    );
    // Given just as deep as the block is, it has one.
    let mut script = Script::new();
    let face = block(&mut script, &Frame::WORLD);
    let given = json!({ "name": "b", "diameter": 6.0, "depth": 20.0, "back": "far" });
    let hole = script.on(face, &[("bore_port", given)]);
    let part = script.part(hole);
    evident(&part);
    let params = [("diameter", 6.0), ("depth", 20.0)];
    has(&part, "far", PortType::Bore, &far(&Frame::WORLD), &params);
    // A hundredth is left: it has none.
    let mut script = Script::new();
    let face = block(&mut script, &Frame::WORLD);
    let given = json!({ "name": "b", "diameter": 6.0, "depth": 19.99, "back": "far" });
    let hole = script.on(face, &[("bore_port", given)]);
    script.refused(hole, "Workplane.bore_port", &["no far mouth"]);
}

#[test]
fn sizes_that_make_no_port_are_refused() {
    let cases = [
        (
            "bore_port",
            json!({ "name": "b", "diameter": 0.0 }),
            "diameter of Workplane.bore_port is 0 mm",
        ),
        (
            "bore_port",
            json!({ "name": "B!", "diameter": 6.0 }),
            "no name for a port",
        ),
        (
            "bore_port",
            json!({ "name": "b", "diameter": 6.0, "depth": -1.0 }),
            "depth of Workplane.bore_port is -1 mm",
        ),
        (
            "hole_with_port",
            json!({ "name": "h", "diameter": 6.0, "bolt_diameter": 8.0 }),
            "bolt_diameter",
        ),
        (
            "cbore_hole_with_port",
            json!({ "name": "c", "diameter": 6.0, "cboreDiameter": 5.0, "cboreDepth": 3.0 }),
            "diameter",
        ),
        (
            "cbore_hole_with_port",
            json!({ "name": "c", "diameter": 6.0, "cboreDiameter": 9.0, "cboreDepth": 3.0, "depth": 2.0 }),
            "hole_depth",
        ),
        (
            "csk_hole_with_port",
            json!({ "name": "c", "diameter": 6.0, "cskDiameter": 5.0, "cskAngle": 90.0 }),
            "no wider than the hole",
        ),
        (
            "csk_hole_with_port",
            json!({ "name": "c", "diameter": 6.0, "cskDiameter": 9.0, "cskAngle": 180.0 }),
            "countersink's whole angle",
        ),
        (
            "tapped_hole_with_port",
            json!({ "name": "t", "diameter": 2.0, "pitch": 2.0 }),
            "cylinder's radius",
        ),
    ];
    for (method, given, words) in cases {
        let mut script = Script::new();
        let face = block(&mut script, &Frame::WORLD);
        let hole = script.on(face, &[(method, given)]);
        script.refused(hole, &format!("Workplane.{method}"), &[words]);
    }
}
