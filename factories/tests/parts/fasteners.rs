//! Fasteners against their standards, and with each other.

use assemcad_model::ports::PortType;
use serde_json::json;

use super::kit::{NZ, X, Z, is, made, port, refused, ring, sound};

/// d, then lengths with and without a shank next to each other, for the hexagon head (the shortest of
/// ISO 4014) and for the socket head (where the rule of the factory draws the line).
const LINES: [(f64, [f64; 2], [f64; 2]); 10] = [
    (3.0, [16.0, 20.0], [20.0, 25.0]),
    (4.0, [20.0, 25.0], [25.0, 30.0]),
    (5.0, [20.0, 25.0], [25.0, 30.0]),
    (6.0, [25.0, 30.0], [30.0, 35.0]),
    (8.0, [35.0, 40.0], [35.0, 40.0]),
    (10.0, [40.0, 45.0], [40.0, 45.0]),
    (12.0, [45.0, 50.0], [50.0, 55.0]),
    (16.0, [60.0, 65.0], [60.0, 65.0]),
    (20.0, [70.0, 80.0], [70.0, 80.0]),
    (24.0, [80.0, 90.0], [80.0, 90.0]),
];

#[test]
fn threads_are_as_long_as_the_standards_say() {
    for (d, hex, socket) in LINES {
        for (head, lines, b) in [
            ("hex", hex, 2.0 * d + 6.0),
            ("socket", socket, 2.0 * d + 12.0),
        ] {
            for (length, shank) in [(lines[0], false), (lines[1], true)] {
                let part = made(
                    "fastener.bolt",
                    &json!({"d": d, "length": length, "head": head}),
                );
                let part = part.unwrap();
                let thread = port(&part.ports, "thread");
                let wanted = if shank { b } else { length };
                assert_eq!(thread.params["length"], wanted, "M{d} x {length} {head}");
                assert_eq!(
                    part.ports.iter().any(|p| p.name == "shank"),
                    shank,
                    "M{d} x {length}"
                );
            }
        }
    }
    for (length, b) in [(120.0, 26.0), (130.0, 32.0), (200.0, 32.0), (220.0, 45.0)] {
        let part = made("fastener.bolt", &json!({"d": 10, "length": length})).unwrap();
        assert_eq!(
            port(&part.ports, "thread").params["length"],
            b,
            "M10 x {length}"
        );
    }
}

#[test]
fn the_ports_of_the_bolt() {
    let part = sound("fastener.bolt", &json!({"d": 10, "length": 60}));
    assert_eq!(part.ports.len(), 5);
    let thread = [
        ("diameter", 10.0),
        ("pitch", 1.5),
        ("hand", 1.0),
        ("length", 26.0),
        ("modelled_diameter", 10.0),
    ];
    let seat = [("inner_diameter", 10.0), ("outer_diameter", 16.0)];
    let shank = [("diameter", 10.0), ("length", 34.0)];
    let e = 16.0 / (3.0_f64.sqrt() / 2.0);
    let p = &part.ports;
    is(
        p,
        "thread",
        PortType::ThreadExternal,
        [0.0, 0.0, -60.0],
        NZ,
        X,
        &thread,
    );
    is(p, "head_seat", PortType::BoltSeat, [0.0; 3], NZ, X, &seat);
    is(
        p,
        "shank",
        PortType::Shaft,
        [0.0, 0.0, -17.0],
        NZ,
        X,
        &shank,
    );
    let top = [("extent_x", 16.0), ("extent_y", e)];
    is(
        p,
        "head_face",
        PortType::FlatFace,
        [0.0, 0.0, 6.4],
        Z,
        X,
        &top,
    );
    let tip = [("extent_x", 10.0), ("extent_y", 10.0)];
    is(
        p,
        "tip_face",
        PortType::FlatFace,
        [0.0, 0.0, -60.0],
        NZ,
        X,
        &tip,
    );

    let part = sound(
        "fastener.bolt",
        &json!({"d": 6, "length": 20, "head": "socket"}),
    );
    assert_eq!(part.ports.len(), 4);
    let p = &part.ports;
    is(
        p,
        "head_face",
        PortType::FlatFace,
        [0.0, 0.0, 6.0],
        Z,
        X,
        &ring(10.0, 6.0),
    );
    let seat = [("inner_diameter", 6.0), ("outer_diameter", 10.0)];
    is(p, "head_seat", PortType::BoltSeat, [0.0; 3], NZ, X, &seat);
    assert_eq!(port(p, "thread").params["length"], 20.0);
}

#[test]
fn the_ports_of_the_nut_and_the_washer() {
    let part = sound("fastener.nut", &json!({"d": 10}));
    assert_eq!(part.ports.len(), 4);
    let minor = 10.0 - 1.5 * 1.25 * 3.0_f64.sqrt() / 2.0;
    let thread = [
        ("diameter", 10.0),
        ("pitch", 1.5),
        ("hand", 1.0),
        ("depth", 8.4),
        ("modelled_diameter", minor),
    ];
    let p = &part.ports;
    let seat = [("inner_diameter", minor), ("outer_diameter", 16.0)];
    is(p, "face", PortType::BoltSeat, [0.0; 3], NZ, X, &seat);
    is(
        p,
        "thread_internal",
        PortType::ThreadInternal,
        [0.0; 3],
        NZ,
        X,
        &thread,
    );
    let top = [0.0, 0.0, 8.4];
    is(
        p,
        "thread_internal_back",
        PortType::ThreadInternal,
        top,
        Z,
        X,
        &thread,
    );
    let e = 16.0 / (3.0_f64.sqrt() / 2.0);
    let face = [
        ("extent_x", 16.0),
        ("extent_y", e),
        ("hole_diameter", minor),
    ];
    is(p, "top_face", PortType::FlatFace, top, Z, X, &face);

    let part = sound("fastener.washer", &json!({"d": 10}));
    assert_eq!(part.ports.len(), 4);
    let p = &part.ports;
    let top = [0.0, 0.0, 2.0];
    is(
        p,
        "top_face",
        PortType::FlatFace,
        top,
        Z,
        X,
        &ring(20.0, 10.5),
    );
    is(
        p,
        "bottom_face",
        PortType::FlatFace,
        [0.0; 3],
        NZ,
        X,
        &ring(20.0, 10.5),
    );
    let seat = [("inner_diameter", 10.5), ("outer_diameter", 20.0)];
    is(p, "seat", PortType::BoltSeat, [0.0; 3], NZ, X, &seat);
    let hole = [("diameter", 10.5), ("depth", 2.0), ("bolt_diameter", 10.0)];
    is(p, "hole", PortType::ClearanceHole, top, Z, X, &hole);
}

#[test]
fn a_size_outside_of_the_tables_is_refused_with_those_that_are() {
    for name in ["fastener.bolt", "fastener.nut", "fastener.washer"] {
        for d in [3.5, 7.0, 14.0] {
            let faults = refused(name, &json!({ "d": d }));
            assert_eq!(faults.len(), 1, "{name} {faults:?}");
            let all = "3, 4, 5, 6, 8, 10, 12, 16, 20, 24";
            assert!(faults[0].message.contains(all), "{name} {faults:?}");
        }
    }
    let faults = refused("base_frame.bolt_circle_flange", &json!({"bolt_d": 7}));
    assert!(faults[0].message.contains("state hole_d"), "{faults:?}");
}

/// What belongs together by the standards goes together: every bolt through its washer and the clearance
/// hole of its size, its head wider than both.
#[test]
fn one_size_fits_itself() {
    for (d, _, _) in LINES {
        let washer = made("fastener.washer", &json!({ "d": d })).unwrap();
        let plate = made("base_frame.rect_plate", &json!({ "bolt_d": d })).unwrap();
        let nut = made("fastener.nut", &json!({ "d": d })).unwrap();
        let inner = port(&washer.ports, "hole").params["diameter"];
        let outer = port(&washer.ports, "seat").params["outer_diameter"];
        let hole = port(&plate.ports, "corner_hole_1").params["diameter"];
        let face = port(&nut.ports, "face").params["outer_diameter"];
        assert!(
            d < inner && inner < hole && hole < face && face <= outer,
            "M{d}"
        );
        for head in ["hex", "socket"] {
            let bolt = made(
                "fastener.bolt",
                &json!({"d": d, "length": 60, "head": head}),
            )
            .unwrap();
            let seat = port(&bolt.ports, "head_seat").params["outer_diameter"];
            assert!(hole < seat && seat <= outer, "M{d} {head}");
            let (outside, inside) = (
                port(&bolt.ports, "thread"),
                port(&nut.ports, "thread_internal"),
            );
            for key in ["diameter", "pitch", "hand"] {
                assert_eq!(outside.params[key], inside.params[key], "M{d} {key}");
            }
        }
    }
}
