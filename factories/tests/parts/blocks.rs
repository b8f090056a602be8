//! The ports of plates, brackets and blocks as their factories document them.

use assemcad_model::diagnostic::Code;
use assemcad_model::ports::PortType;
use serde_json::json;

use super::kit::{FLAT, NX, NY, NZ, X, Y, Z, face, is, port, ports, refused};

#[test]
fn the_ports_of_the_plate() {
    let params = json!({"length": 100, "width": 60, "thickness": 10});
    let p = ports("base_frame.rect_plate", params, 6);
    is(
        &p,
        "top_face",
        FLAT,
        [0.0, 0.0, 10.0],
        Z,
        X,
        &face(100.0, 60.0),
    );
    is(&p, "bottom_face", FLAT, [0.0; 3], NZ, X, &face(100.0, 60.0));
    is(
        &p,
        "side_face_x_pos",
        FLAT,
        [50.0, 0.0, 5.0],
        X,
        Y,
        &face(60.0, 10.0),
    );
    is(
        &p,
        "side_face_x_neg",
        FLAT,
        [-50.0, 0.0, 5.0],
        NX,
        Y,
        &face(60.0, 10.0),
    );
    is(
        &p,
        "side_face_y_pos",
        FLAT,
        [0.0, 30.0, 5.0],
        Y,
        X,
        &face(100.0, 10.0),
    );
    is(
        &p,
        "side_face_y_neg",
        FLAT,
        [0.0, -30.0, 5.0],
        NY,
        X,
        &face(100.0, 10.0),
    );

    let params = json!({"length": 100, "width": 60, "thickness": 10, "bolt_d": 6, "edge": 12});
    let p = ports("base_frame.rect_plate", params, 14);
    let hole = [("diameter", 6.6), ("depth", 10.0), ("bolt_diameter", 6.0)];
    let back = [("diameter", 6.6), ("depth", 10.0)];
    for (i, (x, y)) in [(-38.0, -18.0), (38.0, -18.0), (38.0, 18.0), (-38.0, 18.0)]
        .into_iter()
        .enumerate()
    {
        let (front, behind) = (
            format!("corner_hole_{}", i + 1),
            format!("corner_hole_back_{}", i + 1),
        );
        is(
            &p,
            &front,
            PortType::ClearanceHole,
            [x, y, 10.0],
            Z,
            X,
            &hole,
        );
        is(&p, &behind, PortType::Hole, [x, y, 0.0], NZ, X, &back);
    }
}

#[test]
fn the_ports_of_the_housing() {
    let p = ports("base_frame.housing_block", json!({"bore_height": 45}), 8);
    let bore = [("diameter", 47.0), ("depth", 40.0)];
    is(
        &p,
        "bore_port",
        PortType::Bore,
        [0.0, 20.0, 45.0],
        Y,
        X,
        &bore,
    );
    is(
        &p,
        "bore_port_back",
        PortType::Bore,
        [0.0, -20.0, 45.0],
        NY,
        X,
        &bore,
    );
    is(
        &p,
        "side_face_y_pos",
        FLAT,
        [0.0, 20.0, 10.75],
        Y,
        X,
        &face(80.0, 21.5),
    );
    is(
        &p,
        "side_face_y_neg",
        FLAT,
        [0.0, -20.0, 10.75],
        NY,
        X,
        &face(80.0, 21.5),
    );
    is(
        &p,
        "side_face_x_pos",
        FLAT,
        [40.0, 0.0, 40.0],
        X,
        Y,
        &face(40.0, 80.0),
    );
    is(
        &p,
        "side_face_x_neg",
        FLAT,
        [-40.0, 0.0, 40.0],
        NX,
        Y,
        &face(40.0, 80.0),
    );
    is(
        &p,
        "top_face",
        FLAT,
        [0.0, 0.0, 80.0],
        Z,
        X,
        &face(80.0, 40.0),
    );
    is(&p, "bottom_face", FLAT, [0.0; 3], NZ, X, &face(80.0, 40.0));
    let p = ports("base_frame.housing_block", json!({}), 8);
    assert_eq!(port(&p, "bore_port").frame.origin, [0.0, 20.0, 40.0]);
}

#[test]
fn every_thin_wall_is_reported() {
    let params = json!({"length": 48, "bore_d": 47, "bore_height": 24});
    let faults = refused("base_frame.housing_block", &params);
    assert_eq!(faults.len(), 2, "{faults:?}");
    for f in &faults {
        assert_eq!((f.code, f.place.as_str()), (Code::ParamInvalid, "params"));
        assert!(f.message.contains("bore_d"), "{f}");
    }
    assert!(faults[0].message.contains("length") && faults[1].message.contains("bore_height"));
}

#[test]
fn the_ports_of_the_bracket() {
    let plain = json!({"length": 60, "height": 50, "width": 40, "thickness": 6});
    let p = ports("base_frame.l_bracket", plain, 6);
    is(
        &p,
        "face_a",
        FLAT,
        [30.0, 0.0, 0.0],
        NZ,
        X,
        &face(60.0, 40.0),
    );
    is(
        &p,
        "face_b",
        FLAT,
        [0.0, 0.0, 25.0],
        NX,
        Y,
        &face(40.0, 50.0),
    );
    is(
        &p,
        "inner_face_a",
        FLAT,
        [33.0, 0.0, 6.0],
        Z,
        X,
        &face(54.0, 40.0),
    );
    is(
        &p,
        "inner_face_b",
        FLAT,
        [6.0, 0.0, 28.0],
        X,
        Y,
        &face(40.0, 44.0),
    );
    is(
        &p,
        "web_face",
        FLAT,
        [30.0, 20.0, 3.0],
        Y,
        X,
        &face(60.0, 6.0),
    );
    is(
        &p,
        "web_face_back",
        FLAT,
        [30.0, -20.0, 3.0],
        NY,
        X,
        &face(60.0, 6.0),
    );

    // With a fillet of 4 the flat of leg a begins at 10: the row is at 35, the strips end 4.5 before it.
    let holes = json!({
        "length": 60, "height": 50, "width": 40, "thickness": 6, "fillet": 4, "bolt_d": 8, "holes": 2,
    });
    let p = ports("base_frame.l_bracket", holes, 14);
    let hole = [("diameter", 9.0), ("depth", 6.0), ("bolt_diameter", 8.0)];
    let back = [("diameter", 9.0), ("depth", 6.0)];
    for (i, y) in [(1, -10.0), (2, 10.0)] {
        let name = |leg: &str| format!("hole_{leg}_{i}");
        is(
            &p,
            &name("a"),
            PortType::ClearanceHole,
            [35.0, y, 6.0],
            Z,
            X,
            &hole,
        );
        is(
            &p,
            &name("a_back"),
            PortType::Hole,
            [35.0, y, 0.0],
            NZ,
            X,
            &back,
        );
        is(
            &p,
            &name("b"),
            PortType::ClearanceHole,
            [6.0, y, 30.0],
            X,
            Y,
            &hole,
        );
        is(
            &p,
            &name("b_back"),
            PortType::Hole,
            [0.0, y, 30.0],
            NX,
            Y,
            &back,
        );
    }
    is(
        &p,
        "face_a",
        FLAT,
        [15.25, 0.0, 0.0],
        NZ,
        X,
        &face(30.5, 40.0),
    );
    is(
        &p,
        "inner_face_a",
        FLAT,
        [20.25, 0.0, 6.0],
        Z,
        X,
        &face(20.5, 40.0),
    );
    is(
        &p,
        "face_b",
        FLAT,
        [0.0, 0.0, 12.75],
        NX,
        Y,
        &face(40.0, 25.5),
    );
    is(
        &p,
        "inner_face_b",
        FLAT,
        [6.0, 0.0, 17.75],
        X,
        Y,
        &face(40.0, 15.5),
    );
}

#[test]
fn the_ports_of_the_channel() {
    let params = json!({"length": 100, "width": 50, "height": 30, "thickness": 5});
    let p = ports("base_frame.u_channel", params, 8);
    is(
        &p,
        "floor_face",
        FLAT,
        [0.0, 0.0, 5.0],
        Z,
        X,
        &face(100.0, 40.0),
    );
    is(&p, "bottom_face", FLAT, [0.0; 3], NZ, X, &face(100.0, 50.0));
    is(
        &p,
        "wall_face_y_pos",
        FLAT,
        [0.0, 25.0, 15.0],
        Y,
        X,
        &face(100.0, 30.0),
    );
    is(
        &p,
        "wall_face_y_neg",
        FLAT,
        [0.0, -25.0, 15.0],
        NY,
        X,
        &face(100.0, 30.0),
    );
    is(
        &p,
        "inner_face_y_pos",
        FLAT,
        [0.0, 20.0, 17.5],
        NY,
        X,
        &face(100.0, 25.0),
    );
    is(
        &p,
        "inner_face_y_neg",
        FLAT,
        [0.0, -20.0, 17.5],
        Y,
        X,
        &face(100.0, 25.0),
    );
    is(
        &p,
        "end_face_x_pos",
        FLAT,
        [50.0, 0.0, 2.5],
        X,
        Y,
        &face(50.0, 5.0),
    );
    is(
        &p,
        "end_face_x_neg",
        FLAT,
        [-50.0, 0.0, 2.5],
        NX,
        Y,
        &face(50.0, 5.0),
    );
}
