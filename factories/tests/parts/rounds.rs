//! The ports of shafts, hubs, flanges and bearings as their factories document them.

use assemcad_model::ports::PortType;
use serde_json::json;

use super::kit::{FLAT, NZ, X, Y, Z, face, is, made, port, ports, refused, ring, sound};

#[test]
fn the_ports_of_the_shaft() {
    let p = ports("base_frame.stepped_shaft", json!({}), 5);
    let seat = |d: f64, length: f64| [("diameter", d), ("length", length)];
    let shaft = PortType::Shaft;
    is(
        &p,
        "shaft_seat_1",
        shaft,
        [0.0, 0.0, 30.0],
        Z,
        X,
        &seat(20.0, 60.0),
    );
    is(
        &p,
        "shaft_seat_2",
        shaft,
        [0.0, 0.0, 65.0],
        Z,
        X,
        &seat(25.0, 10.0),
    );
    is(
        &p,
        "shaft_seat_3",
        shaft,
        [0.0, 0.0, 90.0],
        Z,
        X,
        &seat(20.0, 40.0),
    );
    is(
        &p,
        "end_face_start",
        FLAT,
        [0.0; 3],
        NZ,
        X,
        &face(20.0, 20.0),
    );
    is(
        &p,
        "end_face_end",
        FLAT,
        [0.0, 0.0, 110.0],
        Z,
        X,
        &face(20.0, 20.0),
    );
}

#[test]
fn equal_neighbours_make_one_cylinder_and_near_ones_are_refused() {
    let segments = json!({"segments": [{"d": 10, "length": 5}, {"d": 10, "length": 7}]});
    let part = sound("base_frame.stepped_shaft", &segments);
    assert_eq!(part.ports.len(), 4);
    assert_eq!(part.solid.faces().unwrap().len(), 3);
    let near = json!({"segments": [{"d": 10, "length": 5}, {"d": 10.001, "length": 7}]});
    let faults = refused("base_frame.stepped_shaft", &near);
    assert!(faults[0].message.contains("segments[1].d"), "{faults:?}");
}

#[test]
fn the_ports_of_the_bearing() {
    let p = ports("bearing.ball", json!({}), 5);
    let bore = [("diameter", 20.0), ("depth", 14.0)];
    is(
        &p,
        "inner_ring",
        PortType::Bore,
        [0.0, 0.0, 14.0],
        Z,
        X,
        &bore,
    );
    is(
        &p,
        "inner_ring_back",
        PortType::Bore,
        [0.0; 3],
        NZ,
        X,
        &bore,
    );
    let press = [("diameter", 47.0), ("length", 14.0)];
    is(
        &p,
        "outer_ring",
        PortType::PressFit,
        [0.0, 0.0, 7.0],
        Z,
        X,
        &press,
    );
    // h = 13.5: origin at 23.5 - 0.15 * 13.5, extents 0.3 * 13.5.
    is(
        &p,
        "face_front",
        FLAT,
        [21.475, 0.0, 14.0],
        Z,
        X,
        &face(4.05, 4.05),
    );
    is(
        &p,
        "face_back",
        FLAT,
        [21.475, 0.0, 0.0],
        NZ,
        X,
        &face(4.05, 4.05),
    );
    let faults = refused("bearing.ball", &json!({"d_i": 47}));
    let message = &faults[0].message;
    assert!(
        message.contains("d_o") && message.contains("d_i"),
        "{faults:?}"
    );
}

#[test]
fn the_ports_of_the_boss() {
    let p = ports("base_frame.boss", json!({}), 5);
    let bore = [("diameter", 10.0), ("depth", 20.0)];
    is(
        &p,
        "bore_port",
        PortType::Bore,
        [0.0, 0.0, 20.0],
        Z,
        X,
        &bore,
    );
    is(&p, "bore_port_back", PortType::Bore, [0.0; 3], NZ, X, &bore);
    is(
        &p,
        "top_face",
        FLAT,
        [0.0, 0.0, 20.0],
        Z,
        X,
        &ring(30.0, 10.0),
    );
    is(&p, "base_face", FLAT, [0.0; 3], NZ, X, &ring(30.0, 10.0));
    let outer = [("diameter", 30.0), ("length", 20.0)];
    is(&p, "outer", PortType::Shaft, [0.0, 0.0, 10.0], Z, X, &outer);
    let p = ports("base_frame.boss", json!({"bore_depth": 15}), 4);
    let bore = [("diameter", 10.0), ("depth", 15.0)];
    is(
        &p,
        "bore_port",
        PortType::Bore,
        [0.0, 0.0, 20.0],
        Z,
        X,
        &bore,
    );
    assert_eq!(port(&p, "base_face").value("hole_diameter"), 0.0);
}

#[test]
fn the_ports_of_the_flange() {
    let p = ports(
        "base_frame.bolt_circle_flange",
        json!({"bolt_count": 4}),
        14,
    );
    let hole = [("diameter", 9.0), ("depth", 12.0), ("bolt_diameter", 8.0)];
    let back = [("diameter", 9.0), ("depth", 12.0)];
    let spots = [(35.0, 0.0), (0.0, 35.0), (-35.0, 0.0), (0.0, -35.0)];
    for (i, (x, y)) in spots.into_iter().enumerate() {
        let name = format!("bolt_hole_{}", i + 1);
        is(
            &p,
            &name,
            PortType::ClearanceHole,
            [x, y, 12.0],
            Z,
            X,
            &hole,
        );
        let name = format!("bolt_hole_back_{}", i + 1);
        is(&p, &name, PortType::Hole, [x, y, 0.0], NZ, X, &back);
    }
    // Between the bore and the holes: 70 - 9.
    is(
        &p,
        "top_face",
        FLAT,
        [0.0, 0.0, 12.0],
        Z,
        X,
        &ring(61.0, 40.0),
    );
    is(&p, "bottom_face", FLAT, [0.0; 3], NZ, X, &ring(61.0, 40.0));
    is(
        &p,
        "bolt_circle",
        FLAT,
        [0.0, 0.0, 12.0],
        Z,
        X,
        &ring(61.0, 40.0),
    );
    let bore = [("diameter", 40.0), ("depth", 12.0)];
    is(
        &p,
        "bore_port",
        PortType::Bore,
        [0.0, 0.0, 12.0],
        Z,
        X,
        &bore,
    );
    is(&p, "bore_port_back", PortType::Bore, [0.0; 3], NZ, X, &bore);
    let rim = [("diameter", 100.0), ("length", 12.0)];
    is(&p, "outer", PortType::Shaft, [0.0, 0.0, 6.0], Z, X, &rim);
}

#[test]
fn the_ports_of_the_hub() {
    let params = json!({"keyway": true, "set_screw_d": 5});
    let p = ports("base_frame.coupling_hub", params, 6);
    let bore = [("diameter", 20.0), ("depth", 30.0)];
    is(
        &p,
        "shaft_seat",
        PortType::Bore,
        [0.0, 0.0, 30.0],
        Z,
        X,
        &bore,
    );
    is(
        &p,
        "shaft_seat_back",
        PortType::Bore,
        [0.0; 3],
        NZ,
        X,
        &bore,
    );
    is(&p, "face", FLAT, [0.0, 0.0, 30.0], Z, X, &ring(40.0, 20.0));
    is(&p, "face_back", FLAT, [0.0; 3], NZ, X, &ring(40.0, 20.0));
    let minor = 5.0 - 1.25 * 3.0_f64.sqrt() / 2.0 * 0.8;
    // The bore's wall is a little farther away beside the screw's axis.
    let depth = 20.0 - (100.0 - minor * minor / 4.0).sqrt();
    let thread = [
        ("diameter", 5.0),
        ("pitch", 0.8),
        ("hand", 1.0),
        ("depth", depth),
        ("modelled_diameter", minor),
    ];
    is(
        &p,
        "set_screw",
        PortType::ThreadInternal,
        [20.0, 0.0, 15.0],
        X,
        Y,
        &thread,
    );
    for params in [
        json!({"keyway": true, "bore_d": 5}),
        json!({"set_screw_d": 7}),
    ] {
        assert!(
            made("base_frame.coupling_hub", &params).is_err(),
            "{params}"
        );
    }
}
