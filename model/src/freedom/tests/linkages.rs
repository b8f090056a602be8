//! Known linkages.

use super::{Maker, SLIDE, TURN, X, Y, Z, lasting, numbers};
use crate::freedom::{Hold, Kind, Lasting};
use crate::mates::Twist;

/// A plane four-bar with the joints at these points: ground, crank, coupler, rocker.
pub(super) fn four_bar(p: [[f64; 2]; 4]) -> Maker {
    let at = |i: usize| [p[i][0], p[i][1], 0.0];
    Maker::new(&["ground", "crank", "coupler", "rocker"])
        .turn(0, 1, at(0), Z)
        .turn(1, 2, at(1), Z)
        .turn(2, 3, at(2), Z)
        .turn(0, 3, at(3), Z)
}

/// Kutzbach in space: 6 (4 - 1) - 4 x 5 = -2; in the plane 3 (4 - 1) - 4 x 2 = 1. The difference is redundant.
#[test]
fn a_plane_four_bar_has_one_motion_and_three_redundant_constraints() {
    let f = four_bar([[0.0, 0.0], [10.0, 20.0], [70.0, 45.0], [60.0, 0.0]]).solve();
    assert_eq!(numbers(&f), (1, 3, 1));
    assert_eq!(lasting(&f), [Lasting::True]);
    assert_eq!(f.redundant.len(), 1);
    assert_eq!(f.redundant[0].mates, ["j0", "j1", "j2", "j3"]);
    // No joint is superfluous as a whole: each holds two freedoms in the plane that nothing else does.
    assert!(f.redundant[0].dispensable.is_empty());
    assert_eq!(f.redundant[0].repeated, [3; 4]);
    // The driver is the crank; the angular speed of the rocker follows from the instant centre I of ground and
    // coupler: crank line y = 2 x, rocker line y = 4.5 (x - 60), meeting at x = 108, y = 216. The coupler turns
    // by -|A - O| / |A - I|, and the rocker by that times -(|B - I| / |B - C|); all on lines, so by x alone:
    // coupler = 10 / (10 - 108), rocker = coupler (70 - 108) / (70 - 60).
    let m = &f.motions[0];
    let turn = |b: &str| m.bodies.iter().find(|m| m.body == b).unwrap().turn_rad;
    let coupler = 10.0 / (10.0 - 108.0);
    assert!((turn("crank") - 1.0).abs() < 1e-6);
    assert!((turn("coupler") - coupler).abs() < 1e-6, "{m:?}");
    assert!((turn("rocker") - coupler * (70.0 - 108.0) / 10.0).abs() < 1e-6);
    assert!(
        m.name
            .starts_with("'crank' turns about z through [0, 0, 0]; "),
        "{}",
        m.name
    );
}

/// The flat parallelogram: all joints on one line. At first order crank and rocker are independent; in fact
/// they turn together, with (parallelogram) or against (antiparallelogram) each other: two branches of one
/// motion each that cross here. Driving one and holding the other goes nowhere.
#[test]
fn a_flat_parallelogram_has_two_motions_at_first_order_and_one_in_fact() {
    let f = four_bar([[0.0, 0.0], [30.0, 0.0], [130.0, 0.0], [100.0, 0.0]]).solve();
    assert_eq!(numbers(&f), (2, 4, 1));
    assert_eq!(
        lasting(&f),
        [Lasting::Instantaneous, Lasting::Instantaneous]
    );
    // Off that pose it is a four-bar like any other.
    let f = four_bar([[0.0, 0.0], [0.0, 30.0], [100.0, 30.0], [100.0, 0.0]]).solve();
    assert_eq!(numbers(&f), (1, 3, 1));
}

/// Two bars on one line between fixed points: the joint between them gives way at first order only.
#[test]
fn a_stretched_dyad_gives_way_for_an_instant_only() {
    let f = Maker::new(&["ground", "a", "b"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(1, 2, [50.0, 0.0, 0.0], Z)
        .turn(2, 0, [120.0, 0.0, 0.0], Z)
        .solve();
    assert_eq!(numbers(&f), (1, 4, 0));
    assert_eq!(lasting(&f), [Lasting::Instantaneous]);
}

#[test]
fn a_slider_crank_turns_and_slides() {
    let f = Maker::new(&["ground", "crank", "rod", "slider"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(1, 2, [0.0, 20.0, 0.0], Z)
        .turn(2, 3, [80.0, 0.0, 0.0], Z)
        .slide(0, 3, [80.0, 0.0, 0.0], X)
        .solve();
    assert_eq!(numbers(&f), (1, 3, 1));
    // The crank at a right angle: both ends of the rod move along x, so that it
    // slides as a whole, by -20 mm a radian.
    let m = &f.motions[0];
    let slider = m.bodies.iter().find(|b| b.body == "slider").unwrap();
    assert_eq!((slider.kind, slider.direction), (Kind::Slide, X));
    assert!((slider.travel_mm + 20.0).abs() < 1e-6, "{slider:?}");
    assert_eq!(
        m.name,
        "'crank' turns about z through [0, 0, 0]; 'slider', 'rod' slide along x"
    );
}

/// Bennett (1903): equal opposite sides a, b and twists alpha, beta with a / sin(alpha) = b / sin(beta). The
/// loop's closure: tan(t1 / 2) tan(t2 / 2) = sin((beta + alpha) / 2) / sin((beta - alpha) / 2).
#[test]
fn a_bennett_linkage_has_one_motion_where_kutzbach_counts_minus_two() {
    let bennett = |b_factor: f64| {
        let (alpha, beta) = (0.5f64, 1.1f64);
        let (a, b) = (40.0, 40.0 * libm::sin(beta) / libm::sin(alpha) * b_factor);
        let t1 = 1.2f64;
        let (plus, minus) = ((beta + alpha) / 2.0, (beta - alpha) / 2.0);
        let t2 = 2.0 * libm::atan(libm::sin(plus) / libm::sin(minus) / libm::tan(t1 / 2.0));
        // Denavit and Hartenberg: turn about z, along x, twist about x. Angles t1, t2, -t1, -t2 close the loop.
        let mut frame = crate::frame::Placement::IDENTITY;
        let mut m = Maker::new(&["l0", "l1", "l2", "l3"]);
        let steps = [
            (t1, a, alpha),
            (t2, b, beta),
            (-t1, a, alpha),
            (-t2, b, beta),
        ];
        for (i, (turn, length, twist)) in steps.into_iter().enumerate() {
            let z = frame.axes()[2].into();
            m = m.turn(i, (i + 1) % 4, frame.origin().into(), z);
            frame = frame
                * crate::frame::Placement::rotation_z(turn.to_degrees())
                * crate::frame::Placement::translation(length, 0.0, 0.0)
                * crate::frame::Placement::rotation_x(twist.to_degrees());
        }
        let gap = frame.origin().norm() + (frame.rotation() - nalgebra::Matrix3::identity()).norm();
        (m.solve(), gap)
    };
    let (f, gap) = bennett(1.0);
    assert!(gap < 1e-9, "the loop does not close: {gap}");
    assert_eq!(numbers(&f), (1, 3, 1));
    assert_eq!(lasting(&f), [Lasting::True]);
    // Axes that do not close a Bennett loop, here the same with one length off, are held.
    assert_eq!(bennett(1.2).0.mobility, Some(0));
}

/// Sarrus (1853): two chains of three parallel hinges, the directions at a right angle. The top goes straight
/// up. 6 (6 - 1) - 6 x 5 = 0, one in fact.
#[test]
fn a_sarrus_linkage_lifts_its_top_straight() {
    let f = Maker::new(&["ground", "a1", "a2", "b1", "b2", "top"])
        .turn(0, 1, [50.0, 0.0, 0.0], Y)
        .turn(1, 2, [80.0, 0.0, 20.0], Y)
        .turn(2, 5, [50.0, 0.0, 40.0], Y)
        .turn(0, 3, [0.0, 50.0, 0.0], X)
        .turn(3, 4, [0.0, 80.0, 20.0], X)
        .turn(4, 5, [0.0, 50.0, 40.0], X)
        .solve();
    assert_eq!(numbers(&f), (1, 1, 1));
    let top = f.motions[0]
        .bodies
        .iter()
        .find(|b| b.body == "top")
        .unwrap();
    assert_eq!((top.kind, top.direction), (Kind::Slide, Z));
}

/// A door on three hinges: two too many, five constraints each.
#[test]
fn a_door_on_three_hinges_turns() {
    let mut m = Maker::new(&["frame", "door"]);
    for h in [0.0, 900.0, 1800.0] {
        m = m.turn(0, 1, [0.0, 0.0, h], Z);
    }
    let f = m.solve();
    assert_eq!(numbers(&f), (1, 10, 1));
    assert_eq!(f.redundant[0].dispensable, ["j0", "j1", "j2"]);
    assert_eq!(f.motions[0].name, "'door' turns about z through [0, 0, 0]");
}

/// A rod between two balls spins about the line of the balls: idle if it is round about that line.
#[test]
fn a_rod_between_two_balls_spins_idly() {
    let rod = || {
        Maker::new(&["ground", "crank", "rod", "slider"])
            .turn(0, 1, [0.0; 3], Z)
            .ball(1, 2, [20.0, 0.0, 10.0])
            .ball(2, 3, [80.0, 50.0, 10.0])
            .slide(0, 3, [80.0, 50.0, 10.0], X)
    };
    let f = rod().solve();
    assert_eq!((numbers(&f), f.idle_spins), ((2, 0, 2), 0));
    let along = nalgebra::Vector3::new(60.0, 50.0, 0.0).normalize();
    let f = rod().round(2, [20.0, 0.0, 10.0], along.into()).solve();
    assert_eq!((numbers(&f), f.idle_spins), ((2, 0, 2), 1));
    assert!(
        f.motions[0].idle
            && f.motions[0]
                .name
                .starts_with("'rod' spins idly about [0.768, 0.64, 0]")
    );
    // The other motion is the mechanism's.
    assert!(
        f.motions[1].name.starts_with("'crank' turns about z"),
        "{}",
        f.motions[1].name
    );
}

#[test]
fn parts_that_nothing_holds_float() {
    let f = Maker::new(&["ground", "a", "b", "c"])
        .turn(1, 2, [5.0, 0.0, 0.0], Z)
        .solve();
    // The island of a and b has a turn besides, c is alone.
    assert_eq!(numbers(&f), (13, 0, 13));
    let names: Vec<&str> = f.motions.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "'a', 'b' float as one: nothing holds them to the root",
            "'b' turns about z through [5, 0, 0]",
            "'c' floats: nothing holds it to the root",
        ]
    );
}

/// A spindle drive: the nut screws on the spindle and is kept from turning by a guide: turn and travel of
/// 5 mm pitch are one motion.
#[test]
fn a_spindle_drives_its_nut() {
    let advance = 5.0 / (2.0 * core::f64::consts::PI);
    let screw = Hold::Free(vec![Twist([0.0, 0.0, 1.0, 0.0, 0.0, advance])]);
    let f = Maker::new(&["ground", "spindle", "nut"])
        .turn(0, 1, [0.0; 3], Z)
        .link(1, 2, [0.0, 0.0, 40.0], Z, screw)
        .slide(0, 2, [30.0, 0.0, 40.0], Z)
        .solve();
    // Turn, screw and slide along one direction: 12 unknowns, 15 constraints, 1 motion.
    assert_eq!(numbers(&f), (1, 4, 1));
    let nut = f.motions[0]
        .bodies
        .iter()
        .find(|b| b.body == "nut")
        .unwrap();
    assert_eq!(nut.kind, Kind::Slide);
    // The nut moves against the spindle's turn, which goes the other way round in its own frame.
    assert!((nut.travel_mm + advance).abs() < 1e-6, "{nut:?}");
    let left: Vec<_> = f
        .joints
        .iter()
        .map(|j| (j.turns, j.slides, j.screws))
        .collect();
    assert_eq!(left, [(1, 0, 0), (0, 0, 1), (0, 1, 0)]);
}

#[test]
fn a_chain_is_named_joint_by_joint() {
    let f = Maker::new(&["ground", "arm", "hand"])
        .turn(0, 1, [0.0; 3], Z)
        .free(1, 2, [100.0, 0.0, 0.0], X, &[TURN, SLIDE])
        .solve();
    let names: Vec<&str> = f.motions.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "'arm', 'hand' turn about z through [0, 0, 0]",
            "'hand' turns about x through [0, 0, 0]",
            "'hand' slides along x",
        ]
    );
    let left: Vec<_> = f
        .joints
        .iter()
        .map(|j| (j.turns, j.slides, j.screws))
        .collect();
    assert_eq!(left, [(1, 0, 0), (1, 1, 0)]);
}

/// A cross of two axes is no group of motions: what it does at a finite step is not known from its twists.
#[test]
fn a_joint_that_is_no_group_leaves_the_finite_step_open() {
    let cross = [
        [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
    ];
    let f = Maker::new(&["ground", "a"])
        .free(0, 1, [0.0; 3], Z, &cross)
        .free(0, 1, [0.0; 3], Z, &cross)
        .solve();
    assert_eq!((f.mobility, f.lasting_mobility), (Some(2), None));
    assert_eq!(lasting(&f), [Lasting::Indeterminate; 2]);
}
