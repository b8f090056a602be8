//! Ports go where their geometry goes.

use core::f64::consts::PI;

use assemcad_model::frame::Frame;
use assemcad_model::ports::PortType;
use serde_json::json;

use crate::common::*;

const BORE: [(&str, f64); 2] = [("diameter", 6.0), ("depth", 20.0)];

/// The block at the origin with a bore through it at (8, -5).
fn bored(script: &mut Script) -> u32 {
    let face = block(script, &Frame::WORLD);
    script.on(
        face,
        &[
            ("center", json!({ "x": 8.0, "y": -5.0 })),
            ("bore_port", json!({ "name": "b", "diameter": 6.0 })),
        ],
    )
}

#[test]
fn translated_and_turned() {
    let mut script = Script::new();
    let part = bored(&mut script);
    let moved = script.on(part, &[("translate", json!({ "vec": [1.0, 2.0, 3.0] }))]);
    let part = script.part(moved);
    evident(&part);
    let at = shifted(&Frame::WORLD, [9.0, -3.0, 3.0]);
    has(&part, "b", PortType::Bore, &at, &BORE);

    let mut script = Script::new();
    let part = bored(&mut script);
    // A quarter turn about the x axis through (0, 0, 10): y to z, z to -y.
    let turned = script.on(
        part,
        &[(
            "rotate",
            json!({ "axisStartPoint": [0.0, 0.0, 10.0], "axisEndPoint": [1.0, 0.0, 10.0], "angleDegrees": 90.0 }),
        )],
    );
    let part = script.part(turned);
    evident(&part);
    let at = Frame {
        origin: [8.0, 10.0, 5.0],
        x: [1.0, 0.0, 0.0],
        z: [0.0, -1.0, 0.0],
    };
    has(&part, "b", PortType::Bore, &at, &BORE);

    let mut script = Script::new();
    let part = bored(&mut script);
    let slanted = script.on(
        part,
        &[(
            "rotateAboutCenter",
            json!({ "axisEndPoint": [1.0, 2.0, 3.0], "angleDegrees": 37.0 }),
        )],
    );
    evident(&script.part(slanted));
}

#[test]
fn mirrored() {
    let mut script = Script::new();
    let part = bored(&mut script);
    let image = script.on(
        part,
        &[(
            "mirror",
            json!({ "mirrorPlane": "YZ", "basePointVector": [50.0, 0.0, 0.0] }),
        )],
    );
    let part = script.part(image);
    evident(&part);
    let at = Frame {
        origin: [92.0, -5.0, 0.0],
        x: [-1.0, 0.0, 0.0],
        z: [0.0, 0.0, 1.0],
    };
    has(&part, "b", PortType::Bore, &at, &BORE);
    // In a slanted plane, and over the face that is looked at.
    let mut script = Script::new();
    let part = bored(&mut script);
    let image = script.on(
        part,
        &[("mirror", json!({ "mirrorPlane": [1.0, 2.0, 2.0] }))],
    );
    let part = script.part(image);
    evident(&part);
    near(volume(&part.solid), BLOCK - 180.0 * PI, 1e-9);
}

#[test]
fn a_mirrored_helix_turns_the_other_way() {
    let mut script = Script::new();
    let params = json!({
        "module": 2.0, "teeth": 20, "pressure_angle_deg": 20.0, "helix_angle_deg": 15.0,
        "width": 10.0, "internal": 0.0,
    });
    let port = script.chain(&[
        ("box", sized([10.0; 3], [true; 3])),
        (
            "port",
            json!({ "name": "mesh", "type": "GEAR_MESH", "params": params }),
        ),
        ("mirror", json!({ "mirrorPlane": "XZ" })),
    ]);
    let part = script.part(port);
    assert_eq!(named(&part, "mesh").params["helix_angle_deg"], -15.0);
}

#[test]
fn united() {
    let mut script = Script::new();
    let left = bored(&mut script);
    let right = script.cuboid([20.0, -20.0, -20.0], [30.0, 40.0, 20.0]);
    let right = face_of(&mut script, right, [1.0, 0.0, 0.0]);
    let right = script.on(
        right,
        &[(
            "shaft_port",
            json!({ "name": "s", "diameter": 8.0, "length": 12.0 }),
        )],
    );
    let both = script.on(left, &[("union", json!({ "toUnion": to(right) }))]);
    let part = script.part(both);
    evident(&part);
    assert_eq!(part.ports.len(), 2);
    let at = Frame {
        origin: [56.0, 0.0, -10.0],
        x: [0.0, 1.0, 0.0],
        z: [1.0, 0.0, 0.0],
    };
    has(
        &part,
        "s",
        PortType::Shaft,
        &at,
        &[("diameter", 8.0), ("length", 12.0)],
    );
    let expected = BLOCK - 180.0 * PI + 24_000.0 + 192.0 * PI;
    near(volume(&part.solid), expected, 1e-9);
}

#[test]
fn a_union_of_two_ports_of_one_name_is_refused() {
    let mut script = Script::new();
    let left = bored(&mut script);
    let right = script.on(left, &[("translate", json!({ "vec": [40.0, 0.0, 0.0] }))]);
    let both = script.on(left, &[("union", json!({ "toUnion": to(right) }))]);
    script.refused(both, "Workplane.union", &["two ports 'b'", "without_ports"]);
    // Without its ports it joins, and leaves those of the other.
    let mut script = Script::new();
    let left = bored(&mut script);
    let right = script.on(left, &[("translate", json!({ "vec": [40.0, 0.0, 0.0] }))]);
    let bare = script.on(right, &[("without_ports", json!({}))]);
    let both = script.on(left, &[("union", json!({ "toUnion": to(bare) }))]);
    let part = script.part(both);
    evident(&part);
    assert_eq!(part.ports.len(), 1);
    near(volume(&part.solid), 2.0 * (BLOCK - 180.0 * PI), 1e-10);
    // And with a prefix they come back.
    let named_anew = script.on(
        both,
        &[(
            "with_ports_of",
            json!({ "other": to(right), "prefix": "right_" }),
        )],
    );
    let part = script.part(named_anew);
    evident(&part);
    let at = shifted(&Frame::WORLD, [48.0, -5.0, 0.0]);
    has(&part, "right_b", PortType::Bore, &at, &BORE);
}

#[test]
fn dropped() {
    let mut script = Script::new();
    let part = bored(&mut script);
    let bare = script.on(part, &[("without_ports", json!({}))]);
    assert!(script.part(bare).ports.is_empty());
    // The earlier link keeps them.
    assert_eq!(script.part(part).ports.len(), 1);
}
