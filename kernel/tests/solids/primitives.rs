//! Volume, area, centre, inertia and box of the primitives.

use core::f64::consts::PI;

use assemcad_kernel::query::Side;
use assemcad_kernel::{Kind, Shape};
use assemcad_model::frame::{Frame, Placement};

use super::common::{Two, at, cuboid, cylinder, near, near3, says, slanted};

#[test]
fn a_box_is_exact() {
    let b = cuboid([1.0, 2.0, 3.0], [4.0, 5.0, 6.0]);
    let m = b.mass().unwrap();
    near(m.volume, 120.0, 1e-13);
    near(m.area, 2.0 * (20.0 + 30.0 + 24.0), 1e-13);
    near3(m.center, [3.0, 4.5, 6.0], 1e-12);
    // V (b2 + c2) / 12 about the axis along a.
    near(m.inertia[0][0], 10.0 * (25.0 + 36.0), 1e-12);
    near(m.inertia[1][1], 10.0 * (16.0 + 36.0), 1e-12);
    near(m.inertia[2][2], 10.0 * (16.0 + 25.0), 1e-12);
    near(m.inertia[0][1], 0.0, 1e-6);
    let bounds = b.bounds().unwrap();
    near3(bounds.min, [1.0, 2.0, 3.0], 1e-12);
    near3(bounds.max, [5.0, 7.0, 9.0], 1e-12);
    let validity = b.validity().unwrap();
    assert!(validity.is_valid(), "{validity:?}");
}

#[test]
fn a_cylinder_is_exact() {
    let (r, h) = (3.0_f64, 7.0_f64);
    let c = cylinder([1.0, -2.0, 5.0], r, h);
    let m = c.mass().unwrap();
    let v = PI * r * r * h;
    near(m.volume, v, 1e-12);
    near(m.area, 2.0 * PI * r * (r + h), 1e-12);
    near3(m.center, [1.0, -2.0, 8.5], 1e-11);
    near(m.inertia[2][2], v * r * r / 2.0, 1e-11);
    near(m.inertia[0][0], v * (3.0 * r * r + h * h) / 12.0, 1e-11);
    let bounds = c.bounds().unwrap();
    near3(bounds.min, [-2.0, -5.0, 5.0], 1e-6);
    near3(bounds.max, [4.0, 1.0, 12.0], 1e-6);
}

#[test]
fn cones_are_exact() {
    let (a, b, h) = (4.0_f64, 1.0_f64, 6.0_f64);
    let slant = (h * h + (a - b) * (a - b)).sqrt();
    let m = Shape::cone(&Frame::WORLD, a, b, h).unwrap().mass().unwrap();
    near(m.volume, PI * h / 3.0 * (a * a + a * b + b * b), 1e-12);
    near(m.area, PI * (a + b) * slant + PI * (a * a + b * b), 1e-12);
    let z = h * (a * a + 2.0 * a * b + 3.0 * b * b) / (4.0 * (a * a + a * b + b * b));
    near3(m.center, [0.0, 0.0, z], 1e-11);
    for (base, top, center) in [(4.0, 0.0, 1.5), (0.0, 4.0, 4.5)] {
        let m = Shape::cone(&Frame::WORLD, base, top, h)
            .unwrap()
            .mass()
            .unwrap();
        near(m.volume, PI * 16.0 * h / 3.0, 1e-12);
        near3(m.center, [0.0, 0.0, center], 1e-11);
    }
}

#[test]
fn a_sphere_is_exact() {
    let r = 2.5_f64;
    let s = Shape::sphere(&at(1.0, 2.0, 3.0), r).unwrap();
    let m = s.mass().unwrap();
    let v = 4.0 / 3.0 * PI * r.powi(3);
    near(m.volume, v, 1e-10);
    near(m.area, 4.0 * PI * r * r, 1e-10);
    near3(m.center, [1.0, 2.0, 3.0], 1e-9);
    for i in 0..3 {
        near(m.inertia[i][i], 0.4 * v * r * r, 1e-9);
    }
    let bounds = s.bounds().unwrap();
    near3(bounds.min, [-1.5, -0.5, 0.5], 1e-6);
    near3(bounds.max, [3.5, 4.5, 5.5], 1e-6);
}

#[test]
fn slanted_solids_have_tight_boxes_and_the_same_volume() {
    let frame = slanted();
    let (r, h) = (2.0_f64, 9.0_f64);
    let c = Shape::cylinder(&frame, r, h).unwrap();
    near(c.mass().unwrap().volume, PI * r * r * h, 1e-12);
    let bounds = c.bounds().unwrap();
    // A disc of normal n reaches r sqrt(1 - n_i^2) along axis i.
    for i in 0..3 {
        let reach = r * (1.0 - frame.z[i] * frame.z[i]).sqrt();
        let along = h * frame.z[i];
        near(
            bounds.min[i],
            frame.origin[i] + along.min(0.0) - reach,
            1e-6,
        );
        near(
            bounds.max[i],
            frame.origin[i] + along.max(0.0) + reach,
            1e-6,
        );
    }
}

#[test]
fn moving_bakes_the_geometry() {
    let t = Placement::translation(10.0, 20.0, 30.0) * Placement::rotation_z(90.0);
    let moved = cuboid([0.0; 3], [1.0, 2.0, 3.0]).placed(&t).unwrap();
    assert!(!moved.has_locations().unwrap());
    let bounds = moved.bounds().unwrap();
    near3(bounds.min, [8.0, 20.0, 30.0], 1e-12);
    near3(bounds.max, [10.0, 21.0, 33.0], 1e-12);
    let mut mirror: assemcad_model::frame::Rows = Placement::IDENTITY.into();
    mirror.0[0][0] = -1.0;
    let error = moved.placed(&mirror.into()).unwrap_err();
    says(&error, &["no rigid motion"]);
}

#[test]
fn points_are_classified() {
    let plate = cuboid([0.0; 3], [10.0, 10.0, 2.0]).cut(&cylinder([5.0, 5.0, -1.0], 2.0, 4.0));
    let points = [
        [1.0, 1.0, 1.0],
        [5.0, 5.0, 1.0],
        [7.0, 5.0, 1.0],
        [7.0 + 1e-3, 5.0, 1.0],
        [-1.0, 1.0, 1.0],
        [1.0, 1.0, 2.0],
    ];
    let sides = plate.classify(&points, 1e-6).unwrap();
    assert_eq!(
        sides,
        [
            Side::Inside,
            Side::Outside,
            Side::Boundary,
            Side::Inside,
            Side::Outside,
            Side::Boundary
        ]
    );
}

#[test]
fn bad_numbers_are_refused_in_words() {
    let w = Frame::WORLD;
    let errors = [
        (Shape::cuboid(&w, [0.0, 1.0, 1.0]), "box's x size is 0 mm"),
        (
            Shape::cuboid(&w, [1.0, f64::NAN, 1.0]),
            "not a finite number",
        ),
        (Shape::cuboid(&w, [1.0, 1.0, 2e5]), "must lie between"),
        (Shape::cylinder(&w, -1.0, 1.0), "cylinder's radius is -1 mm"),
        (Shape::cone(&w, 2.0, 2.0, 1.0), "that is a cylinder"),
        (Shape::cone(&w, 2.0, -2.0, 1.0), "radius at the top"),
        (Shape::sphere(&at(1e6, 0.0, 0.0), 1.0), "beyond 100000"),
        (Shape::sphere(&Frame { x: w.z, ..w }, 1.0), "right angle"),
    ];
    for (result, words) in errors {
        let error = result.unwrap_err();
        assert_eq!(error.kind, Kind::Refused);
        says(&error, &[words]);
    }
}

#[test]
fn bytes_come_back_unchanged() {
    let shape = cuboid([0.0; 3], [10.0; 3]).fuse(&cylinder([5.0, 5.0, 0.0], 3.0, 20.0));
    let bytes = shape.to_bytes().unwrap();
    let again = Shape::from_bytes(&bytes).unwrap();
    assert_eq!(again.to_bytes().unwrap(), bytes);
    // A solid that has been meshed, measured and checked is still written the same.
    again.mesh(0.1, 20.0).unwrap();
    again.validity().unwrap();
    again.faces().unwrap();
    assert_eq!(again.to_bytes().unwrap(), bytes);
    assert!(
        !Shape::from_bytes(b"no solid at all")
            .unwrap_err()
            .message
            .is_empty()
    );
    assert!(!Shape::from_bytes(b"").unwrap_err().message.is_empty());
}
