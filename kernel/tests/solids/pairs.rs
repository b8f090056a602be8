//! Distances and common volumes of placed solids.

use core::f64::consts::PI;

use assemcad_kernel::Shape;
use assemcad_kernel::pair::{common, distance, sampled_common};
use assemcad_model::frame::{Frame, Placement};

use super::common::{Two, cuboid, cylinder, near, near3};

const HERE: Placement = Placement::IDENTITY;

#[test]
fn spheres_are_as_far_apart_as_their_centres_less_their_radii() {
    let ball = Shape::sphere(&Frame::WORLD, 2.0).unwrap();
    let there = Placement::translation(6.0, 8.0, 0.0);
    let d = distance(&ball, &HERE, &ball, &there).unwrap();
    near(d.distance, 6.0, 1e-9);
    near3(d.on_a, [1.2, 1.6, 0.0], 1e-4);
    near3(d.on_b, [4.8, 6.4, 0.0], 1e-4);
}

#[test]
fn boxes_touch_overlap_or_stay_apart() {
    let b = cuboid([0.0; 3], [10.0; 3]);
    for (x, apart, volume) in [(10.0, 0.0, 0.0), (10.25, 0.25, 0.0), (7.0, 0.0, 300.0)] {
        let there = Placement::translation(x, 0.0, 0.0);
        near(
            distance(&b, &HERE, &b, &there).unwrap().distance,
            apart,
            1e-9,
        );
        let both = common(&b, &HERE, &b, &there).unwrap();
        near(both.volume, volume, 1e-12);
        assert!(both.warnings.is_empty(), "{both:?}");
        assert_eq!(both.place.is_some(), volume > 0.0);
        if let Some((bounds, center)) = both.place {
            near3(bounds.min, [x, 0.0, 0.0], 1e-9);
            near3(center, [(x + 10.0) / 2.0, 5.0, 5.0], 1e-9);
        }
    }
    let inner = cuboid([4.0; 3], [1.0; 3]);
    near(
        distance(&b, &HERE, &inner, &HERE).unwrap().distance,
        0.0,
        1e-9,
    );
    near(common(&b, &HERE, &inner, &HERE).unwrap().volume, 1.0, 1e-12);
}

#[test]
fn a_press_fit_overlaps_by_its_ring() {
    // A shaft of 20.02 in a bore of 20, 10 long: 10 micrometres on the radius.
    let (inner, outer, l) = (10.0_f64, 10.01_f64, 10.0_f64);
    let hub = cylinder([0.0; 3], 20.0, l).cut(&cylinder([0.0, 0.0, -1.0], inner, l + 2.0));
    let shaft = cylinder([0.0, 0.0, -5.0], outer, l + 10.0);
    let before = hub.to_bytes().unwrap();
    let there = Placement::translation(30.0, -40.0, 50.0) * Placement::rotation_x(90.0);
    for at in [HERE, there] {
        let ring = common(&hub, &at, &shaft, &at).unwrap();
        near(ring.volume, PI * (outer * outer - inner * inner) * l, 1e-8);
    }
    assert_eq!(
        hub.to_bytes().unwrap(),
        before,
        "asking must not change the solid"
    );
    // The same shaft at the bore's own size touches and shares nothing.
    let snug = cylinder([0.0, 0.0, -5.0], inner, l + 10.0);
    near(common(&hub, &HERE, &snug, &HERE).unwrap().volume, 0.0, 1e-9);
    near(
        distance(&hub, &HERE, &snug, &HERE).unwrap().distance,
        0.0,
        1e-9,
    );
    let loose = cylinder([0.0, 0.0, -5.0], 9.9, l + 10.0);
    near(
        distance(&hub, &HERE, &loose, &HERE).unwrap().distance,
        0.1,
        1e-9,
    );
}

#[test]
fn sampling_agrees_with_the_boolean() {
    let b = cuboid([0.0; 3], [10.0; 3]);
    let ball = Shape::sphere(&Frame::WORLD, 6.0).unwrap();
    let there = Placement::translation(10.0, 10.0, 10.0) * Placement::rotation_z(30.0);
    // An eighth of the ball lies in the box's corner.
    let exact = 4.0 / 3.0 * PI * 216.0 / 8.0;
    near(
        common(&b, &HERE, &ball, &there).unwrap().volume,
        exact,
        1e-9,
    );
    let sampled = sampled_common(&b, &HERE, &ball, &there, 2000).unwrap();
    near(sampled.box_volume, 216.0, 1e-6);
    near(sampled.volume(), exact, 0.02);
    assert_eq!(
        sampled_common(&b, &HERE, &ball, &there, 2000).unwrap(),
        sampled
    );
    let away = Placement::translation(100.0, 0.0, 0.0);
    let none = sampled_common(&b, &HERE, &ball, &away, 2000).unwrap();
    assert_eq!((none.inside, none.box_volume), (0, 0.0));
}

#[test]
fn overlapping_spheres_are_at_distance_zero() {
    let ball = Shape::sphere(&Frame::WORLD, 5.0).unwrap();
    let there = Placement::translation(0.0, 6.0, 0.0);
    // Two caps of height 2.
    let lens = 2.0 * PI * 4.0 * (15.0 - 2.0) / 3.0;
    near(
        common(&ball, &HERE, &ball, &there).unwrap().volume,
        lens,
        1e-7,
    );
    near(
        distance(&ball, &HERE, &ball, &there).unwrap().distance,
        0.0,
        1e-6,
    );
}
