//! Gear trains against their ratios (Willis for planetary stages).

use super::{Maker, TURN, Z, numbers};
use crate::freedom::{Freedom, Hold};

fn turn(f: &Freedom, motion: usize, body: &str) -> f64 {
    let found = f.motions[motion].bodies.iter().find(|b| b.body == body);
    found.map_or(0.0, |b| b.turn_rad)
}

#[test]
fn a_pair_and_a_train_have_one_motion() {
    // 20 and 40 teeth of module 1, then 15 on the second shaft and 45: -1/2 and -1/3.
    let pair = || {
        Maker::new(&["housing", "s1", "s2", "s3"])
            .turn(0, 1, [0.0; 3], Z)
            .turn(0, 2, [30.0, 0.0, 0.0], Z)
            .mesh(1, 2, [0.0; 3], [30.0, 0.0, 0.0], -0.5)
    };
    let mut one = pair();
    one.0.bodies.truncate(3);
    let f = one.solve();
    assert_eq!(numbers(&f), (1, 0, 1));
    assert!((turn(&f, 0, "s2") / turn(&f, 0, "s1") + 0.5).abs() < 1e-9);
    assert_eq!(
        f.motions[0].name,
        "'s1' turns about z through [0, 0, 0]; 's2' turns about z through [30, 0, 0], -0.5 times"
    );
    let f = pair()
        .turn(0, 3, [30.0, 30.0, 20.0], Z)
        .mesh(2, 3, [30.0, 0.0, 20.0], [30.0, 30.0, 20.0], -1.0 / 3.0)
        .solve();
    assert_eq!(numbers(&f), (1, 0, 1));
    assert!((turn(&f, 0, "s3") / turn(&f, 0, "s1") - 1.0 / 6.0).abs() < 1e-6);
}

/// Sun 20, planets 16, ring 52 = 20 + 2 x 16 teeth of module 1; the centre distance is 18.
fn planetary(planets: usize, ring_is_fixed: bool) -> Maker {
    let names = ["housing", "sun", "carrier", "ring", "p0", "p1", "p2"];
    let mut m = Maker::new(&names[..4 + planets])
        .turn(0, 1, [0.0; 3], Z)
        .turn(0, 2, [0.0; 3], Z)
        .free(0, 3, [0.0; 3], Z, if ring_is_fixed { &[] } else { &[TURN] });
    for i in 0..planets {
        let angle = i as f64 * core::f64::consts::TAU / 3.0;
        let at = [18.0 * libm::cos(angle), 18.0 * libm::sin(angle), 0.0];
        m = m
            .turn(2, 4 + i, at, Z)
            .mesh(1, 4 + i, [0.0; 3], at, -20.0 / 16.0);
        m = m.mesh(3, 4 + i, [0.0; 3], at, 52.0 / 16.0);
    }
    m
}

#[test]
fn a_planetary_stage_follows_willis() {
    for planets in [1, 3] {
        // Each planet after the first brings its turn and two meshes: one redundant constraint.
        let f = planetary(planets, true).solve();
        assert_eq!(numbers(&f), (1, planets - 1, 1), "{planets}");
        // Fixed ring: sun by carrier 1 + 52/20 = 3.6.
        assert!(
            (turn(&f, 0, "sun") / turn(&f, 0, "carrier") - 3.6).abs() < 1e-4,
            "{f:#?}"
        );
        // The planet rolls in the ring: 1 - 52/16 = -2.25 of the carrier.
        assert!((turn(&f, 0, "p0") / turn(&f, 0, "carrier") + 2.25).abs() < 1e-4);
        let f = planetary(planets, false).solve();
        assert_eq!(numbers(&f), (2, planets - 1, 2), "{planets}");
        // 20 w_sun + 52 w_ring = 72 w_carrier in every motion.
        for i in 0..2 {
            let sum = 20.0 * turn(&f, i, "sun") + 52.0 * turn(&f, i, "ring");
            assert!((sum - 72.0 * turn(&f, i, "carrier")).abs() < 1e-3);
        }
    }
}

/// The pinion as base and the ring as incoming gear are the same pair.
#[test]
fn a_ring_may_be_base_or_incoming() {
    for ring_is_base in [true, false] {
        let m = Maker::new(&["housing", "pinion", "ring"])
            .turn(0, 1, [10.0, 0.0, 0.0], Z)
            .turn(0, 2, [0.0; 3], Z);
        let f = if ring_is_base {
            m.mesh(2, 1, [0.0; 3], [10.0, 0.0, 0.0], 30.0 / 10.0)
        } else {
            m.mesh(1, 2, [10.0, 0.0, 0.0], [0.0; 3], 10.0 / 30.0)
        }
        .solve();
        assert_eq!(numbers(&f), (1, 0, 1));
        assert!((turn(&f, 0, "ring") / turn(&f, 0, "pinion") - 1.0 / 3.0).abs() < 1e-6);
    }
}

/// Two trains between the same shafts lock unless their ratios agree.
#[test]
fn a_closed_train_of_two_ratios_is_locked() {
    let closed = |second: f64| {
        Maker::new(&["housing", "s1", "s2"])
            .turn(0, 1, [0.0; 3], Z)
            .turn(0, 2, [30.0, 0.0, 0.0], Z)
            .mesh(1, 2, [0.0; 3], [30.0, 0.0, 0.0], -0.5)
            .mesh(1, 2, [0.0, 0.0, 50.0], [30.0, 0.0, 50.0], second)
            .solve()
    };
    assert_eq!(numbers(&closed(-0.5)), (1, 1, 1));
    assert_eq!(numbers(&closed(-1.0)), (0, 0, 0));
}

/// A helical pair of 30 degrees whose pinion may slide: a slide by s turns the other gear as the tooth trace
/// moves along the pitch circle, by s tan(30 degrees) / r.
#[test]
fn a_sliding_helical_pinion_turns_its_wheel() {
    let slope = libm::tan(30.0f64.to_radians());
    let f = Maker::new(&["housing", "pinion", "wheel"])
        .free(0, 1, [0.0; 3], Z, &[[0.0, 0.0, 0.0, 0.0, 0.0, 1.0]])
        .turn(0, 2, [30.0, 0.0, 0.0], Z)
        .link(
            1,
            2,
            [0.0; 3],
            Z,
            Hold::Gears {
                incoming_axis: [30.0, 0.0, 0.0],
                ratio: -0.5,
                slope,
            },
        )
        .solve();
    assert_eq!(numbers(&f), (1, 0, 1));
    // Right-handed teeth that rise by s: what was at height -s comes to 0, where the trace is at -s tan(30)
    // along the pinion's tangent +y. The wheel of radius 20 at x = 30 turns by +s tan(30) / 20.
    assert!((turn(&f, 0, "wheel") - slope / 20.0).abs() < 1e-6, "{f:#?}");
}
