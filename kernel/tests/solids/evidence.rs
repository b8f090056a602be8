//! The geometric evidence of every port type: a solid that shows it, and solids that do not.

use assemcad_kernel::Shape;
use assemcad_model::frame::{Frame, Placement};
use assemcad_model::ports::{Port, PortType};

use super::common::{Two, cuboid, cylinder, polygon, prism, slanted};

/// The probes that did not hold, as what they show.
fn missing(shape: &Shape, port: &Port) -> Vec<String> {
    let probes = port.evidence().unwrap();
    assert!(!probes.is_empty());
    let answers = shape.probe(&probes).unwrap();
    assert_eq!(answers.len(), probes.len());
    let mut out: Vec<String> = probes
        .iter()
        .zip(answers)
        .filter(|(_, a)| !a.held)
        .map(|(p, a)| format!("{}: {}", p.shows, a.found))
        .collect();
    out.dedup();
    out
}

fn port(port_type: PortType, at: ([f64; 3], f64), params: &[(&str, f64)]) -> Port {
    let (origin, z) = at;
    Port {
        name: "port".to_owned(),
        port_type,
        frame: Frame::new(origin, [0.0, 0.0, z], [1.0, 0.0, 0.0]).unwrap(),
        params: params.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect(),
    }
}

/// The solid shows the port, upright and slanted, and none of the others.
#[track_caller]
fn shows(solid: &Shape, right: &Port, wrong: &[Port]) {
    assert_eq!(missing(solid, right), Vec::<String>::new());
    let there = slanted().placement().unwrap();
    let (moved, mut moved_port) = (solid.placed(&there).unwrap(), right.clone());
    moved_port.frame = there.frame(&right.frame);
    assert_eq!(missing(&moved, &moved_port), Vec::<String>::new());
    for port in wrong {
        assert!(!missing(solid, port).is_empty(), "{port:?}");
    }
}

/// The port with a parameter changed.
fn with(port: &Port, name: &str, value: f64) -> Port {
    let mut port = port.clone();
    port.params.insert(name.to_owned(), value);
    port
}

/// The port moved in its own frame.
fn moved(port: &Port, x: f64, y: f64, z: f64) -> Port {
    let at = port.frame.placement().unwrap() * Placement::translation(x, y, z);
    Port {
        frame: at.frame(&Frame::WORLD),
        ..port.clone()
    }
}

/// The port turned over in its origin.
fn over(port: &Port) -> Port {
    let at = port.frame.placement().unwrap() * Placement::rotation_x(180.0);
    Port {
        frame: at.frame(&Frame::WORLD),
        ..port.clone()
    }
}

/// A block of 40 x 40 x 20 about the z axis, from z = 0.
fn block() -> Shape {
    cuboid([-20.0, -20.0, 0.0], [40.0, 40.0, 20.0])
}

fn drilled(radius: f64, depth: f64) -> Shape {
    let tool = cylinder([0.0, 0.0, 20.0 - depth], radius, depth);
    block().cut(&tool)
}

#[test]
fn a_hole_of_every_kind() {
    for (port_type, diameter) in [
        (PortType::Bore, "diameter"),
        (PortType::Hole, "diameter"),
        (PortType::ThreadInternal, "modelled_diameter"),
    ] {
        let mut params = vec![("diameter", 10.0), ("depth", 12.0)];
        if port_type == PortType::ThreadInternal {
            params.extend([("pitch", 1.5), ("hand", 1.0), ("modelled_diameter", 10.0)]);
        }
        let right = port(port_type, ([0.0, 0.0, 20.0], 1.0), &params);
        let wider = with(&with(&right, "diameter", 10.001), diameter, 10.001);
        shows(
            &drilled(5.0, 12.0),
            &right,
            &[
                wider,
                with(&right, "depth", 13.0),
                moved(&right, 0.01, 0.0, 0.0),
                moved(&right, 0.0, 0.0, -2.0),
                moved(&right, 0.0, 0.0, 8.0),
                over(&right),
            ],
        );
        // A phantom: the tool missed the solid. A pin where the hole should be.
        let pin = block().fuse(&cylinder([0.0, 0.0, 20.0], 5.0, 12.0));
        assert!(!missing(&block(), &right).is_empty());
        assert!(!missing(&pin, &right).is_empty());
        // A wide counterbore in front leaves the hole too short; a keyway and a chamfer leave it one.
        let wide = drilled(5.0, 12.0).cut(&cylinder([0.0, 0.0, 14.0], 9.0, 6.0));
        assert!(!missing(&wide, &right).is_empty());
        let key = cuboid([0.0, -1.5, 8.0], [7.0, 3.0, 12.0]);
        let keyed = drilled(5.0, 12.0).cut(&key);
        assert_eq!(missing(&keyed, &right), Vec::<String>::new());
        // Filled half its depth.
        let plug = cylinder([0.0, 0.0, 8.0], 5.0, 6.0);
        assert!(!missing(&drilled(5.0, 12.0).fuse(&plug), &right).is_empty());
    }
}

#[test]
fn a_through_hole() {
    let params = [("diameter", 6.6), ("depth", 20.0), ("bolt_diameter", 6.0)];
    let right = port(PortType::ClearanceHole, ([0.0, 0.0, 20.0], 1.0), &params);
    let wrong = [
        with(&right, "diameter", 6.61),
        moved(&right, 0.0, 0.0, -0.01),
        moved(&right, 0.0, 0.0, 0.01),
        over(&right),
    ];
    shows(&drilled(3.3, 20.0), &right, &wrong);
    // One that does not go through.
    assert!(!missing(&drilled(3.3, 19.99), &right).is_empty());
}

#[test]
fn a_counterbore() {
    let solid = drilled(3.3, 20.0).cut(&cylinder([0.0, 0.0, 13.0], 5.5, 7.0));
    let params = [
        ("diameter", 11.0),
        ("depth", 7.0),
        ("hole_diameter", 6.6),
        ("hole_depth", 13.0),
    ];
    let right = port(PortType::CboreSeat, ([0.0, 0.0, 13.0], 1.0), &params);
    let wrong = [
        with(&right, "diameter", 11.01),
        with(&right, "hole_diameter", 6.7),
        moved(&right, 0.0, 0.0, 0.01),
        moved(&right, 0.0, 0.0, 7.0),
        over(&right),
    ];
    shows(&solid, &right, &wrong);
    assert!(!missing(&drilled(3.3, 20.0), &right).is_empty());
}

#[test]
fn a_cylinder_of_every_kind() {
    let solid = block().fuse(&cylinder([0.0, 0.0, 20.0], 5.0, 30.0));
    for port_type in [
        PortType::Shaft,
        PortType::PressFit,
        PortType::ThreadExternal,
    ] {
        let thread = port_type == PortType::ThreadExternal;
        let mut params = vec![("diameter", 10.0), ("length", 30.0)];
        let mut origin = [0.0, 0.0, 35.0];
        let mut named = "diameter";
        if thread {
            params.extend([("pitch", 1.5), ("hand", 1.0), ("modelled_diameter", 10.0)]);
            origin = [0.0, 0.0, 50.0];
            named = "modelled_diameter";
        }
        let right = port(port_type, (origin, 1.0), &params);
        let mut wrong = vec![
            with(&with(&right, "diameter", 10.001), named, 10.001),
            with(&right, "length", 45.0),
            moved(&right, 0.0, 0.01, 0.0),
            moved(&right, 0.0, 0.0, 12.0),
        ];
        if thread {
            // A shaft's port may look either way; a thread's runs from its end.
            wrong.push(over(&right));
        }
        shows(&solid, &right, &wrong);
        // A hole of that size, and nothing at all.
        assert!(!missing(&drilled(5.0, 20.0), &moved(&right, 0.0, 0.0, -30.0)).is_empty());
        assert!(!missing(&block(), &right).is_empty());
        // A tube is a shaft too.
        let tube = solid.cut(&cylinder([0.0, 0.0, 20.0], 4.0, 30.0));
        assert_eq!(missing(&tube, &right), Vec::<String>::new());
        // A collar in the way.
        let collar = solid.fuse(&cylinder([0.0, 0.0, 40.0], 7.0, 5.0));
        assert!(!missing(&collar, &right).is_empty());
    }
}

#[test]
fn a_face() {
    let params = [("extent_x", 40.0), ("extent_y", 40.0)];
    let right = port(PortType::FlatFace, ([0.0, 0.0, 20.0], 1.0), &params);
    let mut tilted = right.clone();
    tilted.frame = Placement::rotation_about([0.0, 0.0, 20.0], [1.0, 0.0, 0.0], 0.1)
        .unwrap()
        .frame(&right.frame);
    let wrong = [
        moved(&right, 0.0, 0.0, 0.01),
        moved(&right, 0.0, 0.0, -0.01),
        moved(&right, 25.0, 0.0, 0.0),
        with(&right, "extent_x", 50.0),
        tilted,
        over(&right),
    ];
    shows(&block(), &right, &wrong);
    // A hole where the origin is: a ring, which says so.
    assert!(!missing(&drilled(5.0, 20.0), &right).is_empty());
    let ring = with(&right, "hole_diameter", 10.0);
    assert_eq!(missing(&drilled(5.0, 20.0), &ring), Vec::<String>::new());
    assert!(!missing(&drilled(6.0, 20.0), &ring).is_empty());
}

#[test]
fn a_seat() {
    // Under the head of a bolt: head of 10 mm above a shank of 6.
    let bolt = cylinder([0.0, 0.0, 0.0], 5.0, 6.0).fuse(&cylinder([0.0, 0.0, -20.0], 3.0, 20.0));
    let params = [("inner_diameter", 6.0), ("outer_diameter", 10.0)];
    let right = port(PortType::BoltSeat, ([0.0, 0.0, 0.0], -1.0), &params);
    let wrong = [
        with(&right, "outer_diameter", 11.0),
        with(&right, "inner_diameter", 5.0),
        moved(&right, 0.0, 0.0, 0.01),
        moved(&right, 0.0, 0.0, -6.0),
        over(&right),
    ];
    shows(&bolt, &right, &wrong);
}

#[test]
fn a_snap_hook() {
    // A beam of 2 x 6 mm along z with a nose that reaches 1 mm over at its end.
    let hook = cuboid([-2.5, -3.0, -20.0], [2.0, 6.0, 20.0])
        .fuse(&cuboid([-2.5, -3.0, 0.0], [3.0, 6.0, 2.0]));
    let params = [("overlap", 1.0), ("width", 6.0)];
    let right = port(PortType::SnapFit, ([0.0, 0.0, 0.0], -1.0), &params);
    let wrong = [
        with(&right, "overlap", 1.5),
        with(&right, "width", 8.0),
        moved(&right, 0.0, 0.0, 0.01),
        moved(&right, -0.5, 0.0, 0.0),
        over(&right),
    ];
    shows(&hook, &right, &wrong);
}

/// A disc with rectangular teeth: half a pitch wide at the pitch circle, which is all that is asked.
fn gear(teeth: u32, internal: bool) -> Shape {
    let pitch_radius = f64::from(teeth);
    let (root, tip) = (pitch_radius - 2.5, pitch_radius + 2.0);
    let step = 2.0 * core::f64::consts::PI / f64::from(teeth);
    let at = |radius: f64, k: f64| {
        let (s, c) = libm::sincos(k * step);
        [radius * c, radius * s]
    };
    let mut points = Vec::new();
    for k in 0..teeth {
        let k = f64::from(k);
        // A ring's teeth are the gaps of the profile that is cut out of it.
        let k = if internal { k + 0.5 } else { k };
        points.extend([
            at(root, k - 0.25),
            at(tip, k - 0.25),
            at(tip, k + 0.25),
            at(root, k + 0.25),
        ]);
    }
    let body = prism(&polygon(&points), &[], 10.0);
    if internal {
        cylinder([0.0; 3], tip + 5.0, 10.0).cut(&body)
    } else {
        body
    }
}

#[test]
fn a_gear_and_a_ring() {
    for internal in [false, true] {
        let params = [
            ("module", 2.0),
            ("teeth", 21.0),
            ("pressure_angle_deg", 20.0),
            ("helix_angle_deg", 0.0),
            ("width", 10.0),
            ("internal", f64::from(u8::from(internal))),
        ];
        let right = port(PortType::GearMesh, ([0.0, 0.0, 5.0], 1.0), &params);
        let mut turned = right.clone();
        let pitch = 360.0 / 21.0;
        turned.frame = Placement::rotation_z(0.5 * pitch).frame(&right.frame);
        let wrong = [
            with(&right, "teeth", 22.0),
            with(&right, "module", 2.5),
            with(&right, "helix_angle_deg", 20.0),
            moved(&right, 0.0, 0.0, 5.0),
            turned,
        ];
        shows(&gear(21, internal), &right, &wrong);
        assert!(!missing(&gear(20, internal), &right).is_empty());
        assert!(!missing(&gear(21, !internal), &right).is_empty());
    }
    // A disc without teeth.
    let disc = cylinder([0.0; 3], 23.0, 10.0);
    let params = [
        ("module", 2.0),
        ("teeth", 21.0),
        ("pressure_angle_deg", 20.0),
        ("helix_angle_deg", 0.0),
        ("width", 10.0),
        ("internal", 0.0),
    ];
    let right = port(PortType::GearMesh, ([0.0, 0.0, 5.0], 1.0), &params);
    assert!(!missing(&disc, &right).is_empty());
}
