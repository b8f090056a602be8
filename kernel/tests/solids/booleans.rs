//! Union, difference and intersection of two solids, against closed forms.

use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_model::frame::{Frame, Placement};

use super::common::{Two, at, cuboid, cylinder, near, near3, volume};

#[test]
fn boxes_combine() {
    let a = cuboid([0.0; 3], [10.0; 3]);
    let b = cuboid([5.0, 5.0, 5.0], [10.0; 3]);
    near(volume(&a.fuse(&b)), 1875.0, 1e-12);
    near(volume(&a.cut(&b)), 875.0, 1e-12);
    let common = a.common(&b);
    near(volume(&common), 125.0, 1e-12);
    near3(common.bounds().unwrap().min, [5.0; 3], 1e-12);
    // The inputs are as they were.
    near(volume(&a), 1000.0, 1e-13);
    assert!(a.validity().unwrap().is_valid());
}

#[test]
fn boxes_that_share_a_face_fuse_to_one_box() {
    let a = cuboid([0.0; 3], [10.0; 3]);
    let b = cuboid([10.0, 0.0, 0.0], [10.0; 3]);
    let fused = a.fuse(&b);
    near(volume(&fused), 2000.0, 1e-12);
    // Joined faces are one face: a box has six.
    assert_eq!(fused.faces().unwrap().len(), 6);
    assert_eq!(fused.edges().unwrap().len(), 12);
}

#[test]
fn a_solid_with_itself() {
    let a = cylinder([0.0; 3], 5.0, 10.0);
    near(volume(&a.fuse(&a)), volume(&a), 1e-12);
    near(volume(&a.common(&a)), volume(&a), 1e-12);
}

#[test]
fn drilled_plates() {
    let plate = cuboid([0.0; 3], [40.0, 30.0, 5.0]);
    let mut solid = plate;
    for (x, y) in [(5.0, 5.0), (35.0, 5.0), (35.0, 25.0), (5.0, 25.0)] {
        solid = solid.cut(&cylinder([x, y, -1.0], 2.0, 7.0));
    }
    near(
        volume(&solid),
        40.0 * 30.0 * 5.0 - 4.0 * PI * 4.0 * 5.0,
        1e-12,
    );
    assert_eq!(solid.faces().unwrap().len(), 10);
    // A pin that fills its bore exactly adds up exactly.
    let filled = solid.fuse(&cylinder([5.0, 5.0, 0.0], 2.0, 5.0));
    near(
        volume(&filled),
        40.0 * 30.0 * 5.0 - 3.0 * PI * 4.0 * 5.0,
        1e-12,
    );
}

#[test]
fn crossing_cylinders_make_the_bicylinder() {
    let r = 3.0_f64;
    let a = cylinder([0.0, 0.0, -10.0], r, 20.0);
    let turned = Placement::rotation_x(90.0).frame(&at(0.0, 0.0, -10.0));
    let b = Shape::cylinder(&turned, r, 20.0).unwrap();
    near(volume(&a.common(&b)), 16.0 / 3.0 * r.powi(3), 1e-6);
    near(
        volume(&a.fuse(&b)),
        2.0 * PI * r * r * 20.0 - 16.0 / 3.0 * r.powi(3),
        1e-6,
    );
    let slim = Shape::cylinder(&turned, 2.0, 20.0).unwrap();
    assert!(a.cut(&slim).validity().unwrap().is_valid());
}

#[test]
fn a_ball_in_a_box() {
    let ball = Shape::sphere(&Frame::WORLD, 5.0).unwrap();
    let hollow = cuboid([-10.0; 3], [20.0; 3]).cut(&ball);
    near(volume(&hollow), 8000.0 - 500.0 / 3.0 * PI, 1e-10);
    assert!(hollow.validity().unwrap().is_valid());
    let dome = ball.common(&cuboid([-10.0, -10.0, 0.0], [20.0, 20.0, 10.0]));
    near(volume(&dome), 250.0 / 3.0 * PI, 1e-10);
}

#[test]
fn balls_at_corners_edges_and_faces() {
    // The kernel warns at most of these, and is right all the same.
    let b = cuboid([0.0; 3], [10.0, 12.0, 14.0]);
    let ball = 500.0 / 3.0 * PI;
    for (center, part) in [
        ([10.0, 12.0, 14.0], 0.125),
        ([10.0, 12.0, 7.0], 0.25),
        ([5.0, 12.0, 14.0], 0.25),
        ([10.0, 6.0, 7.0], 0.5),
        ([5.0, 6.0, 14.0], 0.5),
    ] {
        let s = Shape::sphere(&at(center[0], center[1], center[2]), 5.0).unwrap();
        near(volume(&b.cut(&s)), 1680.0 - ball * part, 1e-9);
        near(volume(&b.common(&s)), ball * part, 1e-9);
        near(volume(&b.fuse(&s)), 1680.0 + ball * (1.0 - part), 1e-9);
    }
}
