//! Ports on faces, shafts, gears, hooks, and those that a script only states.

use core::f64::consts::PI;

use assemcad_model::frame::Frame;
use assemcad_model::ports::PortType;
use serde_json::{Value, json};

use crate::common::*;

#[test]
fn a_shaft() {
    for seat in seats() {
        let mut script = Script::new();
        let face = block(&mut script, &seat);
        let shaft = script.on(
            face,
            &[
                ("center", json!({ "x": 3.0, "y": 4.0 })),
                (
                    "shaft_port",
                    json!({ "name": "s", "diameter": 10.0, "length": 30.0 }),
                ),
            ],
        );
        let part = script.part(shaft);
        evident(&part);
        let at = shifted(&seat, [3.0, 4.0, 15.0]);
        let params = [("diameter", 10.0), ("length", 30.0)];
        has(&part, "s", PortType::Shaft, &at, &params);
        near(volume(&part.solid), BLOCK + 750.0 * PI, 1e-10);
    }
    // Alone: there is nothing to join it to.
    let mut script = Script::new();
    let pin = script.chain(&[(
        "shaft_port",
        json!({ "name": "s", "diameter": 4.0, "length": 9.0 }),
    )]);
    let part = script.part(pin);
    evident(&part);
    near(volume(&part.solid), 36.0 * PI, 1e-12);
}

#[test]
fn shafts_and_the_middle_between_them() {
    let mut script = Script::new();
    let face = block(&mut script, &Frame::WORLD);
    let pins = script.on(
        face,
        &[
            (
                "pushPoints",
                json!({ "pntList": [[-10.0, 0.0, 0.0], [10.0, 0.0, 0.0]] }),
            ),
            (
                "shaft_port",
                json!({ "name": "pin", "diameter": 4.0, "length": 6.0, "center": "middle" }),
            ),
        ],
    );
    let part = script.part(pins);
    evident(&part);
    near3(named(&part, "pin_1").frame.origin, [-10.0, 0.0, 3.0], 1e-9);
    near3(named(&part, "pin_2").frame.origin, [10.0, 0.0, 3.0], 1e-9);
    let params = [("extent_x", 16.0), ("extent_y", 40.0)];
    has(&part, "middle", PortType::FlatFace, &Frame::WORLD, &params);
}

#[test]
fn a_face() {
    for seat in seats() {
        let mut script = Script::new();
        let face = block(&mut script, &seat);
        // From the workplane, from the selected face, and at a plane.
        let selector = json!({ "nth": { "key": { "parallel_center": seat.z }, "index": -1, "ascending": true } });
        let at = shifted(&seat, [5.0, 0.0, 0.0]);
        let first = script.on(face, &[("face_port", json!({ "name": "a" }))]);
        let body = script.call("Workplane.findSolid", Some(first), json!({}));
        let ported = script.on(
            first,
            &[
                ("newObject", json!({ "objlist": [to(body)] })),
                ("faces", json!({ "selector": selector })),
                ("face_port", json!({ "name": "b", "extent_y": 12.0 })),
                ("face_port", json!({ "name": "c", "at": at })),
            ],
        );
        let part = script.part(ported);
        evident(&part);
        let whole = [("extent_x", 40.0), ("extent_y", 40.0)];
        has(&part, "a", PortType::FlatFace, &seat, &whole);
        let narrow = [("extent_x", 40.0), ("extent_y", 12.0)];
        has(&part, "b", PortType::FlatFace, &seat, &narrow);
        let beside = [("extent_x", 30.0), ("extent_y", 40.0)];
        has(&part, "c", PortType::FlatFace, &at, &beside);
        near(volume(&part.solid), BLOCK, 1e-11);
    }
}

#[test]
fn a_ring_face() {
    let mut script = Script::new();
    let ring = script.chain(&[
        ("circle", json!({ "radius": 20.0 })),
        ("circle", json!({ "radius": 8.0 })),
        ("extrude", json!({ "until": 5.0 })),
        ("faces", json!({ "selector": ">Z" })),
        ("face_port", json!({ "name": "ring" })),
    ]);
    let part = script.part(ring);
    evident(&part);
    let at = shifted(&Frame::WORLD, [0.0, 0.0, 5.0]);
    let params = [
        ("extent_x", 40.0),
        ("extent_y", 40.0),
        ("hole_diameter", 16.0),
    ];
    has(&part, "ring", PortType::FlatFace, &at, &params);
}

#[test]
fn faces_that_are_none_are_refused() {
    let mut script = Script::new();
    let pin = script.chain(&[
        ("circle", json!({ "radius": 5.0 })),
        ("extrude", json!({ "until": 5.0 })),
        ("faces", json!({ "selector": "%CYLINDER" })),
        ("face_port", json!({ "name": "f" })),
    ]);
    script.refused(pin, "Workplane.face_port", &["not plane"]);
    let mut script = Script::new();
    let above = script.cuboid([0.0; 3], [10.0; 3]);
    let at = shifted(&Frame::WORLD, [5.0, 5.0, 11.0]);
    let above = script.on(above, &[("face_port", json!({ "name": "f", "at": at }))]);
    script.refused(
        above,
        "Workplane.face_port",
        &["no plane face", "(5.000, 5.000, 11.000)"],
    );
    // An angle: the middle of the face is not on it.
    let mut script = Script::new();
    let angle = script.chain(&[
        ("polyline", json!({ "listOfXYTuple": [[0.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 2.0, 0.0], [2.0, 2.0, 0.0], [2.0, 40.0, 0.0], [0.0, 40.0, 0.0]] })),
        ("close", json!({})),
        ("extrude", json!({ "until": 5.0 })),
        ("faces", json!({ "selector": ">Z" })),
        ("face_port", json!({ "name": "f" })),
    ]);
    script.refused(angle, "Workplane.face_port", &["is not on its material"]);
}

/// A gear whose teeth are rectangles, half a pitch wide at the pitch circle.
fn outline(module: f64, teeth: u32) -> Value {
    let radius = module * f64::from(teeth) / 2.0;
    let (root, tip) = (radius - 1.25 * module, radius + module);
    let mut points = Vec::new();
    for k in 0..teeth {
        let pitch = 2.0 * PI / f64::from(teeth);
        for (r, part) in [(root, -0.25), (tip, -0.25), (tip, 0.25), (root, 0.25)] {
            let (sin, cos) = libm::sincos((f64::from(k) + part) * pitch);
            points.push([r * cos, r * sin]);
        }
    }
    let segments: Vec<Value> = points[1..]
        .iter()
        .map(|p| json!({ "line": { "to": p } }))
        .collect();
    json!({ "start": points[0], "segments": segments })
}

/// The area of that outline: triangles about the centre, half a pitch each at tip and root.
fn gear_area(module: f64, teeth: u32) -> f64 {
    let radius = module * f64::from(teeth) / 2.0;
    let (root, tip) = (radius - 1.25 * module, radius + module);
    let (sin, _) = libm::sincos(PI / f64::from(teeth));
    f64::from(teeth) * 0.5 * sin * (root * root + tip * tip)
}

#[test]
fn a_gear() {
    let params = [
        ("module", 2.0),
        ("teeth", 21.0),
        ("pressure_angle_deg", 20.0),
        ("helix_angle_deg", 0.0),
        ("width", 10.0),
        ("internal", 0.0),
        ("profile_shift", 0.0),
        ("thinning", 0.0),
    ];
    let given = json!({
        "name": "mesh", "module": 2.0, "teeth": 21, "width": 10.0, "outline": outline(2.0, 21),
    });
    for seat in seats() {
        let mut script = Script::new();
        let alone = script.call("Workplane", None, json!({ "inPlane": seat }));
        let gear = script.on(alone, &[("gear_mesh_port", given.clone())]);
        let part = script.part(gear);
        evident(&part);
        let middle = shifted(&seat, [0.0, 0.0, 5.0]);
        has(&part, "mesh", PortType::GearMesh, &middle, &params);
        near(volume(&part.solid), 10.0 * gear_area(2.0, 21), 1e-9);
        // On a block: joined to it.
        let mut script = Script::new();
        let face = block(&mut script, &seat);
        let gear = script.on(face, &[("gear_mesh_port", given.clone())]);
        let part = script.part(gear);
        evident(&part);
        has(&part, "mesh", PortType::GearMesh, &middle, &params);
        near(volume(&part.solid), BLOCK + 10.0 * gear_area(2.0, 21), 1e-9);
    }
    // Its front end writes the outline; without it there is no gear.
    let mut script = Script::new();
    let bare = script.chain(&[(
        "gear_mesh_port",
        json!({ "name": "m", "module": 2.0, "teeth": 21, "width": 10.0 }),
    )]);
    script.refused(bare, "Workplane.gear_mesh_port", &["no outline"]);
}

#[test]
fn a_hook() {
    // The nose rises 1 mm at 30 degrees: it is sqrt(3) long.
    let nose = 3.0_f64.sqrt();
    let given =
        json!({ "name": "hook", "overlap": 1.0, "width": 6.0, "length": 20.0, "thickness": 2.0 });
    for seat in seats() {
        let mut script = Script::new();
        let face = block(&mut script, &seat);
        let hook = script.on(face, &[("snap_port", given.clone())]);
        let part = script.part(hook);
        evident(&part);
        let at = over(&shifted(&seat, [1.5, 0.0, 20.0 - nose]));
        has(
            &part,
            "hook",
            PortType::SnapFit,
            &at,
            &[("overlap", 1.0), ("width", 6.0)],
        );
        near(volume(&part.solid), BLOCK + 240.0 + 6.0 * nose / 2.0, 1e-9);
    }
    for (key, value, words) in [
        ("lead_angle_deg", 90.0, "below 90"),
        ("lead_angle_deg", 2.0, "takes 28.636 mm of its length 20 mm"),
        ("overlap", -1.0, "overlap of Workplane.snap_port is -1 mm"),
    ] {
        let mut script = Script::new();
        let face = block(&mut script, &Frame::WORLD);
        let mut wrong = given.clone();
        wrong[key] = json!(value);
        let hook = script.on(face, &[("snap_port", wrong)]);
        script.refused(hook, "Workplane.snap_port", &[words]);
    }
}

#[test]
fn a_port_on_what_is_there() {
    for seat in seats() {
        let mut script = Script::new();
        let face = block(&mut script, &seat);
        let at = shifted(&seat, [-8.0, 2.0, 0.0]);
        let bores = json!({ "type": "BORE", "params": { "diameter": 5.0, "depth": 20.0 } });
        let mut by_points = bores.clone();
        by_points["name"] = json!("p");
        let mut by_plane = bores;
        by_plane["name"] = json!("q");
        by_plane["at"] = json!(at);
        let ported = script.on(
            face,
            &[
                (
                    "pushPoints",
                    json!({ "pntList": [[-8.0, 2.0, 0.0], [8.0, -2.0, 0.0]] }),
                ),
                ("hole", json!({ "diameter": 5.0 })),
                ("end", json!({})),
                ("port", by_points),
            ],
        );
        let part = script.part(ported);
        // Back at the points the solid is the one before the holes: its ports lack their evidence.
        let holds = |solid: &assemcad_kernel::Shape, port: &assemcad_model::ports::Port| {
            let answers = solid.probe(&port.evidence().unwrap()).unwrap();
            answers.iter().all(|answer| answer.held)
        };
        assert!(part.ports.iter().all(|port| !holds(&part.solid, port)));
        let mut script = Script::new();
        let face = block(&mut script, &seat);
        let ported = script.on(
            face,
            &[
                ("pushPoints", json!({ "pntList": [[-8.0, 2.0, 0.0]] })),
                ("hole", json!({ "diameter": 5.0 })),
                ("port", by_plane),
            ],
        );
        let part = script.part(ported);
        evident(&part);
        has(
            &part,
            "q",
            PortType::Bore,
            &at,
            &[("diameter", 5.0), ("depth", 20.0)],
        );
    }
}

#[test]
fn ports_that_cannot_be_are_refused() {
    for (given, words) in [
        (
            json!({ "name": "p", "type": "KEYWAY", "params": {} }),
            "no port type 'KEYWAY'",
        ),
        (
            json!({ "name": "p", "type": "BORE", "params": { "depth": 3.0 } }),
            "needs 'diameter'",
        ),
        (
            json!({ "name": "p", "type": "BORE", "params": { "diameter": 3.0, "depth": 3.0, "width": 1.0 } }),
            "has no 'width'",
        ),
        (
            json!({ "name": "p", "type": "BORE", "params": { "diameter": "wide" } }),
            "params of Workplane.port",
        ),
        (
            json!({ "name": "a b", "type": "BORE", "params": {} }),
            "no name for a port",
        ),
        (
            json!({ "name": "p", "type": "BORE", "params": { "diameter": 3.0, "depth": 3.0 }, "at": "XW" }),
            "no plane 'XW'",
        ),
        (
            json!({ "name": "p", "type": "BORE", "params": { "diameter": 3.0, "depth": 3.0 }, "at": { "origin": [0, 0, 0] } }),
            "at is a plane",
        ),
    ] {
        let mut script = Script::new();
        let cube = script.cuboid([0.0; 3], [10.0; 3]);
        let port = script.on(cube, &[("port", given)]);
        script.refused(port, "Workplane.port", &[words]);
    }
}

#[test]
fn two_ports_of_one_name_are_refused() {
    let mut script = Script::new();
    let face = block(&mut script, &Frame::WORLD);
    let twice = script.on(
        face,
        &[
            ("face_port", json!({ "name": "top" })),
            ("face_port", json!({ "name": "top" })),
        ],
    );
    script.refused(twice, "Workplane.face_port", &["two ports 'top'"]);
    let mut script = Script::new();
    let face = block(&mut script, &Frame::WORLD);
    let same = json!({ "name": "b", "diameter": 4.0, "back": "b" });
    let same = script.on(face, &[("bore_port", same)]);
    script.refused(same, "Workplane.bore_port", &["two ports 'b'"]);
}
