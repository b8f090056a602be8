//! Driven mechanisms against their closed forms.

use core::f64::consts::PI;

use super::linkages::four_bar;
use super::{Maker, SLIDE, TURN, X, Y, Z};
use crate::freedom::{Drive, DriveKind, Hold, Kind, NoDrive, Pose, Stuck};
use crate::mates::Twist;

fn drive(m: &Maker, body: usize, kind: Option<DriveKind>) -> Drive {
    Drive::new(&m.0, body, kind).unwrap()
}

/// The turn about z of a body that turns about parallels of it.
fn angle(d: &Drive, pose: &Pose, body: usize) -> f64 {
    let x = d.moved(pose, body).direction([1.0, 0.0, 0.0]);
    assert!(x[2].abs() < 1e-9, "it tilts: {x:?}");
    libm::atan2(x[1], x[0])
}

/// Equal up to whole turns.
fn same_angle(a: f64, b: f64) -> bool {
    libm::remainder(a - b, 2.0 * PI).abs() < 1e-8
}

fn degrees(d: &Drive, stuck: (Pose, Stuck)) -> (f64, Stuck) {
    assert_eq!(d.kind, DriveKind::Rotate);
    (stuck.0.value.to_degrees(), stuck.1)
}

/// In line at first, crank r, rod l: x = r cos t + sqrt(l^2 - r^2 sin^2 t), through both dead centres.
fn slider_crank(r: f64, l: f64) -> Maker {
    Maker::new(&["ground", "crank", "rod", "slider"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(1, 2, [0.0, r, 0.0], Z)
        .turn(2, 3, [libm::sqrt(l * l - r * r), 0.0, 0.0], Z)
        .slide(0, 3, [libm::sqrt(l * l - r * r), 0.0, 0.0], X)
}

#[test]
fn a_slider_follows_its_crank_through_both_dead_centres() {
    let (r, l) = (20.0, 70.0);
    let m = slider_crank(r, l);
    let d = drive(&m, 1, None);
    assert_eq!(
        (d.kind, d.part.kind, d.part.direction),
        (DriveKind::Rotate, Kind::Turn, Z)
    );
    assert_eq!(d.still, [] as [&str; 0]);
    let mut pose = d.start();
    for i in 1..=72 {
        let turned = f64::from(i) * 5.0f64.to_radians();
        pose = d.advance(&pose, 5.0f64.to_radians()).unwrap();
        assert!((pose.value - turned).abs() < 1e-12);
        // The crank starts at a right angle.
        let (s, c) = libm::sincos(PI / 2.0 + turned);
        let x = r * c + libm::sqrt(l * l - r * r * s * s);
        let was = libm::sqrt(l * l - r * r);
        let now = d.moved(&pose, 3).point([was, 0.0, 0.0]);
        assert!(
            (now[0] - x).abs() < 1e-8 && now[1].abs() < 1e-8,
            "{i}: {now:?}, not {x}"
        );
        // The rod: l sin(phi) = -r sin(t).
        let phi = libm::asin(-r * s / l) - libm::asin(-r / l);
        assert!(same_angle(angle(&d, &pose, 2), phi));
    }
}

/// Driven by its slider the crank comes to its dead centres: r + l and l - r.
#[test]
fn a_driven_slider_stops_at_the_dead_centres() {
    let (r, l) = (20.0, 70.0);
    let m = slider_crank(r, l);
    let d = drive(&m, 3, None);
    assert_eq!((d.kind, d.part.direction), (DriveKind::Slide, X));
    let was = libm::sqrt(l * l - r * r);
    for (by, end) in [(60.0, r + l), (-60.0, l - r)] {
        let (pose, why) = d.advance(&d.start(), by).unwrap_err();
        assert_eq!(why, Stuck::Limit);
        assert!(
            (was + pose.value - end).abs() < 1e-5,
            "{} {end}",
            was + pose.value
        );
    }
    // Short of it, it goes there and back.
    let there = d.advance(&d.start(), 20.0).unwrap();
    let back = d.advance(&there, -20.0).unwrap();
    assert!(angle(&d, &back, 1).abs() < 1e-9);
}

/// The rocker of a crank-rocker from the triangles that the diagonal makes: law of cosines, twice.
#[test]
fn a_four_bar_follows_the_law_of_cosines() {
    let (a, b, c, g) = (20.0, 65.0, 46.0, 60.0);
    // The diagonal from the crank's end to the rocker's joint is f; open configuration.
    let rocker = |t: f64| {
        let f = libm::sqrt(a * a + g * g - 2.0 * a * g * libm::cos(t));
        let beta = libm::atan2(a * libm::sin(t), g - a * libm::cos(t));
        PI - beta - libm::acos((f * f + c * c - b * b) / (2.0 * f * c))
    };
    let (t0, p0) = (1.0, rocker(1.0));
    let m = four_bar([
        [0.0, 0.0],
        [a * libm::cos(t0), a * libm::sin(t0)],
        [g + c * libm::cos(p0), c * libm::sin(p0)],
        [g, 0.0],
    ]);
    let d = drive(&m, 1, Some(DriveKind::Rotate));
    let mut pose = d.start();
    for i in 1..=80 {
        pose = d.advance(&pose, 0.1).unwrap();
        let wanted = rocker(t0 + 0.1 * f64::from(i)) - p0;
        let found = angle(&d, &pose, 3);
        assert!(same_angle(found, wanted), "{i}: {found} {wanted}");
    }
}

/// A double rocker: its shorter arm turns until the two others are in line, b + c from the far joint.
#[test]
fn a_double_rocker_stops_where_its_bars_are_in_line() {
    let (a, b, c, g) = (40.0, 30.0, 30.0, 60.0);
    // The coupler's end by two circles of one radius.
    let t0 = 0.5;
    let from = [a * libm::cos(t0), a * libm::sin(t0)];
    let (dx, dy) = (g - from[0], -from[1]);
    let f = libm::hypot(dx, dy);
    let h = libm::sqrt(b * b - f * f / 4.0);
    let top = [
        from[0] + dx / 2.0 - dy / f * h,
        from[1] + dy / 2.0 + dx / f * h,
    ];
    let m = four_bar([[0.0, 0.0], from, top, [g, 0.0]]);
    let d = drive(&m, 1, None);
    let (deg, why) = degrees(&d, d.advance(&d.start(), PI).unwrap_err());
    // (b + c)^2 = a^2 + g^2 - 2 a g cos(t).
    let t = libm::acos((a * a + g * g - (b + c) * (b + c)) / (2.0 * a * g));
    assert_eq!(why, Stuck::Limit);
    assert!((deg - (t - t0).to_degrees()).abs() < 1e-4, "{deg}");
}

/// A parallelogram comes to lie flat, where it may go on as one or as an antiparallelogram. Steps do not pass that
/// over, whether they meet it or not.
#[test]
fn a_parallelogram_does_not_choose_at_its_change_point() {
    let m = four_bar([[0.0, 0.0], [0.0, 30.0], [100.0, 30.0], [100.0, 0.0]]);
    let d = drive(&m, 1, None);
    for step in [5.0f64, 3.7] {
        let mut pose = d.start();
        let found = loop {
            match d.advance(&pose, step.to_radians()) {
                Ok(next) => pose = next,
                Err(stuck) => break stuck,
            }
        };
        assert!((angle(&d, &pose, 3) - pose.value).abs() < 1e-9);
        let (deg, why) = degrees(&d, found);
        assert_eq!(why, Stuck::Branches);
        // It is told from the last pose before it.
        assert!(deg <= 90.0 + 1e-6 && deg > 87.0, "{deg}");
    }
    // Braced by a third crank it goes round.
    let third = m.turn(2, 0, [50.0, 30.0, 0.0], Z).0;
    let mut m = Maker(third);
    m.0.links.pop();
    m.0.bodies.push(crate::freedom::Body {
        name: "third".to_owned(),
        at: [0.0; 3],
        spin: None,
    });
    let m = m
        .turn(0, 4, [50.0, -20.0, 0.0], Z)
        .turn(4, 2, [50.0, 10.0, 0.0], Z);
    let d = drive(&m, 1, None);
    let pose = d.advance(&d.start(), 2.0 * PI).unwrap();
    assert!(
        d.moved(&pose, 3)
            .point([1.0, 2.0, 3.0])
            .iter()
            .zip([1.0, 2.0, 3.0])
            .all(|(a, b)| (a - b).abs() < 1e-6)
    );
}

#[test]
fn gears_keep_their_ratio_over_many_turns() {
    // 20, 40 and, on the second shaft, 15 into 45 teeth: -1/2, then 1/6.
    let m = Maker::new(&["housing", "s1", "s2", "s3"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(0, 2, [30.0, 0.0, 0.0], Z)
        .turn(0, 3, [30.0, 30.0, 20.0], Z)
        .mesh(1, 2, [0.0; 3], [30.0, 0.0, 0.0], -0.5)
        .mesh(2, 3, [30.0, 0.0, 20.0], [30.0, 30.0, 20.0], -1.0 / 3.0);
    let d = drive(&m, 1, None);
    let pose = d.advance(&d.start(), 7.3 * PI).unwrap();
    for (body, ratio) in [(1, 1.0), (2, -0.5), (3, 1.0 / 6.0)] {
        assert!(same_angle(angle(&d, &pose, body), 7.3 * PI * ratio));
        assert!(d.hinge(0, body).is_some());
    }
    assert!(d.hinge(1, 2).is_none());
}

/// Willis: the ring held, the planets roll; the sun turns 1 + 52/20 times as fast as the carrier.
#[test]
fn planets_roll_round_their_sun() {
    let at = [18.0, 0.0, 0.0];
    let m = Maker::new(&["housing", "sun", "carrier", "planet"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(0, 2, [0.0; 3], Z)
        .turn(2, 3, at, Z)
        .mesh(1, 3, [0.0; 3], at, -20.0 / 16.0)
        .mesh(0, 3, [0.0; 3], at, 52.0 / 16.0);
    let d = drive(&m, 2, None);
    let pose = d.advance(&d.start(), 2.5).unwrap();
    assert!(same_angle(angle(&d, &pose, 1), 2.5 * 3.6));
    assert!(same_angle(angle(&d, &pose, 3), 2.5 * (1.0 - 52.0 / 16.0)));
    let centre = d.moved(&pose, 3).point(at);
    assert!((centre[0] - 18.0 * libm::cos(2.5)).abs() < 1e-8);
    // Sun and carrier turn about one axis of the housing, the planet about one of the carrier.
    assert!(d.hinge(1, 2).is_some() && d.hinge(2, 3).is_some() && d.hinge(0, 3).is_none());
}

#[test]
fn a_spindle_moves_its_nut_by_its_lead() {
    let advance = 5.0 / (2.0 * PI);
    let m = Maker::new(&["ground", "spindle", "nut"])
        .turn(0, 1, [0.0; 3], Z)
        .link(
            1,
            2,
            [0.0, 0.0, 40.0],
            Z,
            Hold::Free(vec![Twist([0.0, 0.0, 1.0, 0.0, 0.0, advance])]),
        )
        .slide(0, 2, [30.0, 0.0, 40.0], Z);
    let d = drive(&m, 2, None);
    assert_eq!(d.kind, DriveKind::Slide);
    let pose = d.advance(&d.start(), 12.0).unwrap();
    assert!((d.moved(&pose, 2).origin().z - 12.0).abs() < 1e-9);
    assert!(same_angle(angle(&d, &pose, 1), -12.0 / advance));
}

/// What has a turn and a slide does one of them while the other is held; a chain's hand moves without its arm, and
/// its arm takes the hand along.
#[test]
fn other_motions_stand_still() {
    let m = Maker::new(&["ground", "arm", "hand"])
        .turn(0, 1, [0.0; 3], Z)
        .free(1, 2, [100.0, 0.0, 0.0], X, &[TURN, SLIDE]);
    let d = drive(&m, 2, Some(DriveKind::Slide));
    let pose = d.advance(&d.start(), -7.0).unwrap();
    assert_eq!((d.carried(1), d.still.len()), (None, 1));
    assert!((d.moved(&pose, 2).origin() - nalgebra::Vector3::new(-7.0, 0.0, 0.0)).norm() < 1e-9);
    let d = drive(&m, 2, None);
    assert_eq!((d.kind, d.part.direction), (DriveKind::Rotate, X));
    // Its slide being held, it turns about an axis and nothing else.
    assert!(d.hinge(1, 2).is_some() && d.hinge(0, 2).is_some());
    let d = drive(&m, 1, None);
    let pose = d.advance(&d.start(), PI / 2.0).unwrap();
    assert_eq!(d.carried(1), d.carried(2));
    let hand = d.moved(&pose, 2).point([100.0, 0.0, 0.0]);
    assert!((hand[1] - 100.0).abs() < 1e-9);
}

/// A differential: two motions. The driven sun turns while the carrier, another motion's driver, stands.
#[test]
fn a_differential_is_driven_with_the_rest_held() {
    let at = [18.0, 0.0, 0.0];
    let m = Maker::new(&["housing", "sun", "carrier", "planet", "ring"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(0, 2, [0.0; 3], Z)
        .turn(2, 3, at, Z)
        .turn(0, 4, [0.0; 3], Z)
        .mesh(1, 3, [0.0; 3], at, -20.0 / 16.0)
        .mesh(4, 3, [0.0; 3], at, 52.0 / 16.0);
    let d = drive(&m, 1, None);
    let pose = d.advance(&d.start(), 4.0).unwrap();
    let turns = [1, 2, 4].map(|b| angle(&d, &pose, b));
    assert!(
        same_angle(turns[0], 4.0) && turns[1].abs() < 1e-9,
        "{turns:?}"
    );
    assert!(same_angle(turns[2], -4.0 * 20.0 / 52.0));
    assert_eq!(d.still.len(), 1);
}

/// Bodies on a driven one come along, round ones too.
#[test]
fn what_is_loose_on_a_driven_part_comes_along() {
    let m = Maker::new(&["ground", "wheel", "bolt"])
        .turn(0, 1, [0.0; 3], Z)
        .turn(1, 2, [30.0, 0.0, 0.0], Z)
        .round(2, [30.0, 0.0, 0.0], Z);
    let d = drive(&m, 1, None);
    let pose = d.advance(&d.start(), 1.0).unwrap();
    assert_eq!(d.carried(1), d.carried(2));
    assert!(same_angle(angle(&d, &pose, 2), 1.0));
}

/// A shaft in two bearings that lie loose in their block: what is locked stands with the block, exactly, and the
/// shaft turns about a hinge on the block's axis.
#[test]
fn what_is_locked_stands() {
    let m = Maker::new(&["block", "front", "back", "shaft"])
        .free(0, 1, [0.0; 3], Z, &[TURN, SLIDE])
        .free(0, 2, [0.0, 0.0, 40.0], Z, &[TURN, SLIDE])
        .free(1, 3, [0.0, 0.0, 5.0], Z, &[TURN, SLIDE])
        .free(2, 3, [0.0, 0.0, 45.0], Z, &[TURN, SLIDE]);
    let d = drive(&m, 3, None);
    let pose = d.advance(&d.start(), 2.0).unwrap();
    assert_eq!(
        [0, 1, 2, 3].map(|b| d.carried(b).is_some()),
        [false, false, false, true]
    );
    assert_eq!(d.moved(&pose, 1), crate::frame::Placement::IDENTITY);
    assert!(same_angle(angle(&d, &pose, 3), 2.0));
    assert!([0, 1, 2].iter().all(|b| d.hinge(*b, 3).is_some()));
    assert_eq!(d.still.len(), 5);
}

#[test]
fn what_cannot_move_is_refused() {
    let m = Maker::new(&["ground", "fixed", "door", "loose"])
        .free(0, 1, [0.0; 3], Z, &[])
        .turn(1, 2, [0.0, 0.0, 9.0], Y);
    let why = |body: usize, kind| Drive::new(&m.0, body, kind).unwrap_err();
    assert_eq!(why(1, None), NoDrive::Held(vec![2]));
    assert_eq!(why(0, None), NoDrive::Held(vec![2]));
    assert_eq!(why(2, Some(DriveKind::Slide)), NoDrive::Held(vec![2]));
    assert_eq!(why(3, None), NoDrive::Floats);
}
