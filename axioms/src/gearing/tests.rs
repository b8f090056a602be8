use std::collections::BTreeMap;

use super::{Pair, inverse_involute, involute, pairs};
use crate::facts::{Facts, MateFacts, PartFacts};
use crate::indexed::Indexed;
use assemcad_model::frame::{Frame, Placement};
use assemcad_model::mates::MateType;
use assemcad_model::ports::{Port, PortType};
use assemcad_model::spec::End;

fn gear(id: &str, teeth: f64, helix: f64, internal: f64, shift: f64, at: f64) -> PartFacts {
    let params = [
        ("module", 2.0),
        ("teeth", teeth),
        ("pressure_angle_deg", 20.0),
        ("helix_angle_deg", helix),
        ("width", 15.0),
        ("internal", internal),
        ("profile_shift", shift),
    ];
    PartFacts {
        id: id.to_owned(),
        factory: "user.gear".to_owned(),
        class: None,
        params: serde_json::Map::new(),
        elastic: false,
        ports: vec![Port {
            name: "teeth".to_owned(),
            port_type: PortType::GearMesh,
            frame: Frame::WORLD,
            params: BTreeMap::from(params.map(|(k, v)| (k.to_owned(), v))),
        }],
        placement: Some(Placement::translation(at, 0.0, 0.0)),
        material: None,
        geometry: None,
    }
}

fn with<T>(a: PartFacts, b: PartFacts, f: impl Fn(&Pair<'_>) -> T) -> T {
    let end = |p: &PartFacts| End {
        part: p.id.clone(),
        port: "teeth".to_owned(),
    };
    let mate = MateFacts {
        id: "m".to_owned(),
        mate_type: MateType::GearMesh,
        base: end(&a),
        incoming: end(&b),
        options: serde_json::Map::new(),
        axioms: Vec::new(),
        reason_stated: false,
    };
    let facts = Facts {
        parts: vec![a, b],
        mates: vec![mate],
        ..Facts::default()
    };
    f(&pairs(&Indexed::new(facts))[0])
}

/// Two derivations meet: the operating distance comes from the sum of the shifts, the play from the tooth
/// thicknesses. Teeth that are not thinned have no play at the operating distance, with any shifts.
#[test]
fn no_play_at_the_operating_distance() {
    for (helix, other, internal) in [
        (0.0, 0.0, 0.0),
        (15.0, -15.0, 0.0),
        (0.0, 0.0, 1.0),
        (15.0, 15.0, 1.0),
    ] {
        for (x, y) in [(0.0, 0.0), (0.3, 0.1), (0.5, -0.2), (0.1, 0.6)] {
            let (a, b) = (
                gear("a", 20.0, helix, 0.0, x, 0.0),
                gear("b", 60.0, other, internal, y, 1.0),
            );
            for (p, q) in [(a.clone(), b.clone()), (b, a)] {
                let play = with(p, q, |p| {
                    let d = p.operating_distance().unwrap();
                    (
                        p.circular_play(d).unwrap(),
                        p.circular_play(p.reference_distance() * 1.05),
                    )
                });
                assert!(play.0.abs() < 1e-9, "{helix} {internal} {x} {y}: {play:?}");
                // Outer gears loosen when they part, a ring's pinion tightens.
                if x == 0.0 {
                    assert_eq!(play.1.unwrap() > 0.0, internal == 0.0, "{play:?}");
                }
            }
        }
    }
}

#[test]
fn the_involute_function_and_its_inverse() {
    // inv 20 degrees = 0.014904, of every table of the function.
    let a = 20.0_f64.to_radians();
    assert!((involute(a) - 0.014_904).abs() < 1e-6);
    for deg in [1.0, 14.5, 20.0, 30.0, 45.0, 55.0_f64] {
        let a = deg.to_radians();
        assert!((inverse_involute(involute(a)).unwrap() - a).abs() < 1e-9);
    }
    assert_eq!(inverse_involute(-0.1), None);
}
