//! Areas of contact from skins, held against closed forms and the kernel's booleans of faces.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::print_stdout
)]

use core::f64::consts::PI;

use assemcad_geometry::narrow::{Boundary, touch};
use assemcad_kernel::Shape;
use assemcad_kernel::brep::Topology;
use assemcad_kernel::contact::{self, Where};
use assemcad_model::frame::{Frame, Placement};

fn rod(x: f64, y: f64, z: f64, radius: f64, height: f64) -> Shape {
    let at = Frame {
        origin: [x, y, z],
        ..Frame::WORLD
    };
    Shape::cylinder(&at, radius, height).unwrap()
}

fn cut(of: &Shape, tools: &[&Shape]) -> Shape {
    let left = of.without(tools, None).unwrap().cleaned().unwrap();
    left.parts(Topology::Solid).unwrap().remove(0)
}

fn boundary(shape: &Shape) -> Boundary {
    Boundary::new(shape.skin(0.02, 10.0).unwrap()).unwrap()
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

#[test]
fn washers_on_a_drilled_plate_touch_over_their_rings() {
    let plate = Shape::cuboid(&Frame::WORLD, [60.0, 40.0, 8.0]).unwrap();
    let holes: Vec<Shape> = [10.0, 30.0, 50.0]
        .map(|x| rod(x, 20.0, -1.0, 4.5, 10.0))
        .into();
    let plate = cut(&plate, &holes.iter().collect::<Vec<_>>());
    let washer = cut(
        &rod(0.0, 0.0, 0.0, 8.0, 1.6),
        &[&rod(0.0, 0.0, -1.0, 4.2, 4.0)],
    );
    let (a, b) = (boundary(&plate), boundary(&washer));
    let top = Where::Plane {
        point: [1.0, 2.0, 8.0],
        normal: [0.0, 0.0, -1.0],
    };
    for (x, y, area) in [
        // In the middle of a hole, which is wider than the washer's own.
        (30.0, 20.0, PI * (64.0 - 4.5 * 4.5)),
        // Off the plate by half of the washer: half of its ring.
        (20.0, 0.0, PI * (64.0 - 4.2 * 4.2) / 2.0),
        // Beside the holes.
        (20.0, 20.0, f64::NAN),
        (61.0, 20.0, f64::NAN),
        // Beyond the plate.
        (70.0, 20.0, 0.0),
    ] {
        let at = Placement::translation(x, y, 8.0) * Placement::rotation_z(17.0);
        let found = touch(&a, &b, &at, &top).unwrap();
        assert_eq!((found.faces_a, found.faces_b), (1, 1));
        let exact = contact::touch(&plate, &Placement::IDENTITY, &washer, &at, &top).unwrap();
        near(found.area, exact.area, 1e-6);
        if area.is_finite() {
            near(found.area, area, 1e-9);
        }
        // A micrometre above there is no contact.
        let lifted = Placement::translation(0.0, 0.0, 2e-6) * at;
        let found = touch(&a, &b, &lifted, &top).unwrap();
        assert_eq!((found.faces_b, found.area), (0, 0.0));
    }
}

#[test]
fn a_shaft_in_a_bore_touches_over_their_common_length() {
    let hub = cut(
        &rod(0.0, 0.0, 0.0, 20.0, 30.0),
        &[&rod(0.0, 0.0, -1.0, 10.0, 40.0)],
    );
    let shaft = rod(0.0, 0.0, 0.0, 10.0, 50.0);
    let (a, b) = (boundary(&hub), boundary(&shaft));
    let axis = Where::Axis {
        point: [0.0, 0.0, 3.0],
        direction: [0.0, 0.0, 1.0],
    };
    for (z, common) in [(-10.0, 30.0), (12.5, 17.5), (30.0, 0.0), (-45.0, 5.0)] {
        let at = Placement::translation(0.0, 0.0, z) * Placement::rotation_z(40.0);
        let found = touch(&a, &b, &at, &axis).unwrap();
        near(found.area, 2.0 * PI * 10.0 * common, 1e-9);
        let exact = contact::touch(&hub, &Placement::IDENTITY, &shaft, &at, &axis).unwrap();
        near(found.area, exact.area, 1e-6);
        assert_eq!(
            (found.faces_a, found.faces_b),
            (exact.faces_a, exact.faces_b)
        );
    }
    // Turned by a quarter turn there is none, and where the bore has a keyway the kernel is asked.
    let keyway = Shape::cuboid(
        &Frame {
            origin: [-3.0, 0.0, -1.0],
            ..Frame::WORLD
        },
        [6.0, 12.5, 40.0],
    );
    let keyed = boundary(&cut(&hub, &[&keyway.unwrap()]));
    assert!(touch(&keyed, &b, &Placement::IDENTITY, &axis).is_none());
    let across = touch(&a, &b, &Placement::rotation_x(90.0), &axis).unwrap();
    assert_eq!((across.faces_b, across.area), (0, 0.0));
}
