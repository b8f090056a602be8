//! Fuse, cut and common: what they must make, and what they must refuse.

use core::f64::consts::PI;

use assemcad_kernel::{Kind, Shape};
use assemcad_model::frame::{Frame, Placement};

use super::common::{at, cuboid, cylinder, near, near3, says, volume};

#[test]
fn boxes_combine() {
    let a = cuboid([0.0; 3], [10.0; 3]);
    let b = cuboid([5.0, 5.0, 5.0], [10.0; 3]);
    near(volume(&a.fuse(&b).unwrap()), 1875.0, 1e-12);
    near(volume(&a.cut(&b).unwrap()), 875.0, 1e-12);
    let common = a.common(&b).unwrap();
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
    let fused = a.fuse(&b).unwrap();
    near(volume(&fused), 2000.0, 1e-12);
    // Joined faces are one face: a box has six.
    assert_eq!(fused.faces().unwrap().len(), 6);
    assert_eq!(fused.edges().unwrap().len(), 12);
}

#[test]
fn what_does_not_join_is_refused_with_the_gap() {
    let a = cuboid([0.0; 3], [10.0; 3]);
    let far = a.fuse(&cuboid([12.5, 0.0, 0.0], [10.0; 3])).unwrap_err();
    assert_eq!(far.kind, Kind::Refused);
    says(
        &far,
        &[
            "do not join",
            "2 separate solids",
            "2.500000 mm",
            "(12.500, 0.000, 0.000)",
        ],
    );
    // An edge in common is no joint.
    let edge = a.fuse(&cuboid([10.0, 10.0, 0.0], [10.0; 3])).unwrap_err();
    says(&edge, &["do not join", "0.000000 mm"]);
    let nothing = a.common(&cuboid([10.0, 0.0, 0.0], [10.0; 3])).unwrap_err();
    says(&nothing, &["no volume in common"]);
}

#[test]
fn cuts_that_do_nothing_or_too_much_are_refused() {
    let a = cuboid([0.0; 3], [10.0; 3]);
    for tool in [
        cuboid([20.0, 0.0, 0.0], [1.0; 3]),
        cuboid([10.0, 0.0, 0.0], [10.0; 3]),
    ] {
        says(
            &a.cut(&tool).unwrap_err(),
            &["does not touch", "removes nothing", "first solid spans"],
        );
    }
    let halved = a
        .cut(&cuboid([4.0, -1.0, -1.0], [2.0, 12.0, 12.0]))
        .unwrap_err();
    says(&halved, &["the cut leaves 2 separate solids"]);
    says(
        &a.cut(&cuboid([-1.0; 3], [12.0; 3])).unwrap_err(),
        &["leaves nothing"],
    );
    says(&a.cut(&a).unwrap_err(), &["leaves nothing"]);
}

#[test]
fn a_solid_with_itself() {
    let a = cylinder([0.0; 3], 5.0, 10.0);
    near(volume(&a.fuse(&a).unwrap()), volume(&a), 1e-12);
    near(volume(&a.common(&a).unwrap()), volume(&a), 1e-12);
}

#[test]
fn drilled_plates() {
    let plate = cuboid([0.0; 3], [40.0, 30.0, 5.0]);
    let mut solid = plate;
    for (x, y) in [(5.0, 5.0), (35.0, 5.0), (35.0, 25.0), (5.0, 25.0)] {
        solid = solid.cut(&cylinder([x, y, -1.0], 2.0, 7.0)).unwrap();
    }
    near(
        volume(&solid),
        40.0 * 30.0 * 5.0 - 4.0 * PI * 4.0 * 5.0,
        1e-12,
    );
    assert_eq!(solid.faces().unwrap().len(), 10);
    // A pin that fills its bore exactly adds up exactly.
    let filled = solid.fuse(&cylinder([5.0, 5.0, 0.0], 2.0, 5.0)).unwrap();
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
    near(volume(&a.common(&b).unwrap()), 16.0 / 3.0 * r.powi(3), 1e-6);
    near(
        volume(&a.fuse(&b).unwrap()),
        2.0 * PI * r * r * 20.0 - 16.0 / 3.0 * r.powi(3),
        1e-6,
    );
    let slim = Shape::cylinder(&turned, 2.0, 20.0).unwrap();
    assert!(a.cut(&slim).unwrap().validity().unwrap().is_valid());
}

#[test]
fn a_ball_in_a_box() {
    let ball = Shape::sphere(&Frame::WORLD, 5.0).unwrap();
    let hollow = cuboid([-10.0; 3], [20.0; 3]).cut(&ball).unwrap();
    near(volume(&hollow), 8000.0 - 500.0 / 3.0 * PI, 1e-10);
    assert!(hollow.validity().unwrap().is_valid());
    let dome = ball
        .common(&cuboid([-10.0, -10.0, 0.0], [20.0, 20.0, 10.0]))
        .unwrap();
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
        near(volume(&b.cut(&s).unwrap()), 1680.0 - ball * part, 1e-9);
        near(volume(&b.common(&s).unwrap()), ball * part, 1e-9);
        near(
            volume(&b.fuse(&s).unwrap()),
            1680.0 + ball * (1.0 - part),
            1e-9,
        );
    }
}
