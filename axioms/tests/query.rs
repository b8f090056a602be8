//! Finding axioms and holding them against mates.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_axioms::knowledge::axiom;
use assemcad_axioms::query::{Query, applicable_to, applies, find};
use assemcad_axioms::{Applicability, Class};
use assemcad_model::mates::{self, MateType};
use assemcad_model::ports::PortType::{BoltSeat, Bore, ClearanceHole, FlatFace, GearMesh, Shaft};

fn ids(query: &Query) -> Vec<&'static str> {
    find(query).into_iter().map(|a| a.id.as_str()).collect()
}

#[test]
fn the_paper_s_example_cites_what_applies() {
    let classes = [Class::Housing, Class::SpurGear];
    for id in ["C-02", "P-01"] {
        let a = axiom(id).unwrap();
        assert_eq!(
            applies(a, MateType::Coaxial, Bore, Bore, &classes),
            Applicability::Applies
        );
    }
    let g = axiom("G-02").unwrap();
    let gears = [Class::SpurGear, Class::SpurGear];
    assert!(applies(g, MateType::GearMesh, GearMesh, GearMesh, &gears).holds());
    // A shaft in a bearing, which the paper's text names.
    let c = axiom("C-02").unwrap();
    assert!(
        applies(
            c,
            MateType::Coaxial,
            Bore,
            Shaft,
            &[Class::BallBearing, Class::Shaft]
        )
        .holds()
    );
    let f = axiom("C-01").unwrap();
    assert!(
        applies(
            f,
            MateType::FaceToFace,
            FlatFace,
            FlatFace,
            &[Class::Plate, Class::Housing]
        )
        .holds()
    );
}

#[test]
fn what_does_not_apply_says_why() {
    let a = axiom("G-02").unwrap();
    let at = |m, b, c, k: &[Class]| match applies(a, m, b, c, k) {
        Applicability::Not { reason } => reason,
        Applicability::Applies => String::new(),
    };
    assert!(
        at(MateType::Coaxial, Bore, Shaft, &[Class::Shaft])
            .contains("mates gear_mesh, not coaxial")
    );
    assert!(
        at(MateType::GearMesh, GearMesh, GearMesh, &[Class::Plate]).contains("not structure/plate")
    );
    // A user's part may be a gear.
    assert_eq!(
        at(MateType::GearMesh, GearMesh, GearMesh, &[Class::Custom]),
        ""
    );
    let t = axiom("T-06").unwrap();
    assert!(
        !applies(
            t,
            MateType::Coaxial,
            Bore,
            Shaft,
            &[Class::Plate, Class::Bolt]
        )
        .holds()
    );
}

#[test]
fn every_pair_that_a_mate_joins_has_an_axiom_of_its_own() {
    for kind in mates::ALL {
        for (base, incoming) in kind.pairs {
            let found = applicable_to(
                kind.mate_type,
                *base,
                *incoming,
                &[Class::Custom, Class::Custom],
            );
            assert!(
                found
                    .iter()
                    .any(|a| a.scope.mates.contains(&kind.mate_type)),
                "{} {base} {incoming}",
                kind.name
            );
        }
    }
}

#[test]
fn the_narrowest_come_first() {
    let found = applicable_to(
        MateType::CoaxialFace,
        ClearanceHole,
        BoltSeat,
        &[Class::Plate, Class::Bolt],
    );
    let ids: Vec<&str> = found.iter().map(|a| a.id.as_str()).collect();
    let at = |id: &str| ids.iter().position(|x| *x == id);
    assert!(
        at("T-06") < at("F-03") && at("T-06").is_some() && at("F-03").is_some(),
        "{ids:?}"
    );
    assert!(at("G-02").is_none());
}

#[test]
fn find_by_id_mate_and_words() {
    let id = Query {
        id: Some("g-05".to_owned()),
        ..Query::default()
    };
    assert_eq!(ids(&id), ["G-05"]);
    assert_eq!(find(&Query::default()).len(), 62);
    let gears = Query {
        mate_type: Some(MateType::GearMesh),
        ..Query::default()
    };
    let found = ids(&gears);
    assert_eq!(&found[..3], ["G-01", "G-02", "G-03"]);
    assert!(!found.contains(&"T-01"));
    let words = Query {
        words: "undercut teeth".to_owned(),
        ..Query::default()
    };
    assert_eq!(ids(&words)[0], "G-06");
    let none = Query {
        words: "xylophone".to_owned(),
        ..Query::default()
    };
    assert_eq!(ids(&none).len(), 0);
    let screw = Query {
        words: "clearance".to_owned(),
        port_types: vec![ClearanceHole],
        classes: vec![Class::Bolt],
        ..Query::default()
    };
    assert_eq!(ids(&screw)[0], "T-06");
}
