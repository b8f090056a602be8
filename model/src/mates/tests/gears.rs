//! `gear_mesh`.

use super::{joined, port};
use crate::frame::Placement;
use crate::ports::Port;
use crate::ports::PortType::GearMesh;
use serde_json::json;

fn gear(teeth: f64, helix: f64, internal: f64) -> Port {
    let p = [
        ("module", 2.0),
        ("teeth", teeth),
        ("pressure_angle_deg", 20.0),
        ("helix_angle_deg", helix),
        ("width", 10.0),
        ("internal", internal),
    ];
    port(GearMesh, &p)
}

fn at(a: &Port, b: &Port, o: serde_json::Value) -> Placement {
    joined("gear_mesh", a, b, o, |k, j| (k.relative)(j))
}

/// Where a point is in a gear's teeth: its fraction of a pitch from a tooth's middle.
fn fraction(p: &Port, at: &Placement, point: [f64; 3]) -> f64 {
    let [x, y, _] = at.inverse().point(point);
    let turns = libm::atan2(y, x) / (2.0 * core::f64::consts::PI) * p.value("teeth");
    turns - libm::floor(turns)
}

/// The phase rests on nothing but the port's meaning: at the pitch point, the one gear's distance from
/// a tooth's middle and the other's make half a pitch, going opposite ways outside and the same inside.
#[test]
fn a_tooth_is_in_a_gap_for_all_parities() {
    for (z1, z2, base_ring, ring) in [
        (20.0, 30.0, 0.0, 0.0),
        (20.0, 31.0, 0.0, 0.0),
        (21.0, 30.0, 0.0, 0.0),
        (21.0, 31.0, 0.0, 0.0),
        (60.0, 20.0, 1.0, 0.0),
        (61.0, 20.0, 1.0, 0.0),
        (60.0, 21.0, 1.0, 0.0),
        (61.0, 21.0, 1.0, 0.0),
        (20.0, 60.0, 0.0, 1.0),
        (21.0, 60.0, 0.0, 1.0),
        (20.0, 61.0, 0.0, 1.0),
        (21.0, 61.0, 0.0, 1.0),
    ] {
        let (a, b) = (gear(z1, 0.0, base_ring), gear(z2, 0.0, ring));
        for angle in [0.0, 17.3, 90.0, -45.0, 180.0, 211.1] {
            let t = at(&a, &b, json!({"angle_deg": angle}));
            let (s, c) = crate::angle::sin_cos_deg(angle);
            // Base radius z1, from which the pitch point is towards the other axis or, in a ring that
            // comes in, away from it.
            let r = if ring == 1.0 { -z1 } else { z1 };
            let pitch_point = [r * c, r * s, 0.0];
            let one = fraction(&a, &Placement::IDENTITY, pitch_point);
            let two = fraction(&b, &t, pitch_point);
            let outside = base_ring + ring == 0.0;
            let off = if outside { one + two } else { one - two };
            let off = off - 0.5 - libm::round(off - 0.5);
            assert!(off.abs() < 1e-9, "{z1} {z2} {angle}: {one} {two}");
            // The axes are where the pitch circles touch.
            let o = t.origin();
            let wanted = if outside { z1 + z2 } else { (z1 - z2).abs() };
            assert!((libm::hypot(o.x, o.y) - wanted).abs() < 1e-12);
        }
    }
}

#[test]
fn known_phases() {
    // Opposite a tooth of the base at angle 0 an even gear stands half a pitch off, an odd one not at all.
    let a = gear(20.0, 0.0, 0.0);
    let turned = |z: f64| at(&a, &gear(z, 0.0, 0.0), json!({})).point([1.0, 0.0, 0.0]);
    let [x, y, _] = turned(21.0);
    assert!((x - 42.0).abs() < 1e-12 && y.abs() < 1e-12);
    // 4 teeth: half a pitch is 45 degrees.
    let [x, y, _] = turned(4.0);
    let half = libm::sqrt(0.5);
    assert!((x - 24.0 - half).abs() < 1e-12 && (y - half).abs() < 1e-12);
}

#[test]
fn helix_and_backlash_in_the_centre_distance() {
    // (20 + 30) 2 / 2 / cos 60 = 100 exactly in the cosine's closed form 1/2.
    let t = at(&gear(20.0, 60.0, 0.0), &gear(30.0, -60.0, 0.0), json!({}));
    assert!((t.origin().x - 100.0).abs() < 1e-9);
    // 0.2 mm / (2 tan 20 deg) = 0.274747741945462... (tan 20 deg = 0.363970234266202...)
    let wider = 0.1 / 0.363_970_234_266_202_4;
    let o = json!({"backlash_mm": 0.2});
    let t = at(&gear(20.0, 0.0, 0.0), &gear(30.0, 0.0, 0.0), o.clone());
    assert!((t.origin().x - 50.0 - wider).abs() < 1e-12);
    let t = at(&gear(60.0, 0.0, 1.0), &gear(20.0, 0.0, 0.0), o);
    assert!((t.origin().x - 40.0 + wider).abs() < 1e-12);
}

#[test]
fn gears_that_do_not_match_are_refused() {
    let faults = |a: &Port, b: &Port, o| joined("gear_mesh", a, b, o, |k, j| k.conditions(j).len());
    let (a, b) = (gear(20.0, 0.0, 0.0), gear(30.0, 0.0, 0.0));
    assert_eq!(faults(&a, &b, json!({"m": 2, "r": 1.5})), 0);
    assert_eq!(faults(&a, &b, json!({"m": 2.5, "r": 0.667})), 2);
    assert_eq!(
        faults(
            &gear(15.0, 0.0, 0.0),
            &gear(35.0, 0.0, 0.0),
            json!({"r": 2.33})
        ),
        0
    );
    // Opposite hands outside, equal hands inside.
    assert_eq!(
        faults(&gear(20.0, 15.0, 0.0), &gear(30.0, -15.0, 0.0), json!({})),
        0
    );
    assert_eq!(
        faults(&gear(20.0, 15.0, 0.0), &gear(30.0, 15.0, 0.0), json!({})),
        1
    );
    assert_eq!(
        faults(&gear(20.0, 15.0, 0.0), &gear(60.0, 15.0, 1.0), json!({})),
        0
    );
    assert_eq!(
        faults(&gear(20.0, 0.0, 1.0), &gear(60.0, 0.0, 1.0), json!({})),
        1
    );
    assert_eq!(
        faults(&gear(60.0, 0.0, 0.0), &gear(20.0, 0.0, 1.0), json!({})),
        1
    );
    let mut other = gear(30.0, 0.0, 0.0);
    other.params.insert("module".to_owned(), 2.5);
    other.params.insert("pressure_angle_deg".to_owned(), 14.5);
    assert_eq!(faults(&a, &other, json!({})), 2);
}

#[test]
fn the_rotations_are_coupled_about_the_pitch_point() {
    for (a, b, pitch_point) in [
        (gear(20.0, 0.0, 0.0), gear(30.0, 0.0, 0.0), 20.0),
        (gear(60.0, 0.0, 1.0), gear(20.0, 0.0, 0.0), 60.0),
        (gear(20.0, 0.0, 0.0), gear(60.0, 0.0, 1.0), -20.0),
    ] {
        let f = joined("gear_mesh", &a, &b, json!({}), |k, j| k.freedom(j));
        // Rolling: the relative motion has no speed at the pitch point, v + w x p = 0.
        let [_, _, w, vx, vy, vz] = f.twists[0].0;
        assert!((vy + w * pitch_point).abs() < 1e-9, "{f:?}");
        assert_eq!((f.twists.len(), vx, vz), (1, 0.0, 0.0));
    }
    let f = joined(
        "gear_mesh",
        &gear(20.0, 0.0, 0.0),
        &gear(30.0, 0.0, 0.0),
        json!({}),
        |k, j| k.freedom(j),
    );
    assert_eq!(f.coupling.unwrap().ratio, -20.0 / 30.0);
}
