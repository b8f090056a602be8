use std::sync::Arc;

use assemcad_model::diagnostic::Code;

use assemcad_model::frame::Frame;
use assemcad_model::freedom::{Motion, Redundant};
use assemcad_model::mates::MateType;
use assemcad_model::ports::{Port, PortType};
use assemcad_model::recipe::Recipe;
use assemcad_model::report::Verdict;
use assemcad_model::spec::{Assembly, End, Mate};
use assemcad_placing::{Made, Resolved, ResolvedMate, ResolvedPart, place};
use proptest::prelude::*;
use serde_json::{Value, json};

use super::{Freedom, Lasting, check, judge};
use crate::results::Results;

/// A plate with faces above and below and a hole, its mates as given.
fn assembly(parts: &[&str], mates: &[(&str, MateType, &str, &str, Value)]) -> Resolved {
    let port = |name: &str, port_type, z: f64, at: f64, params: &[(&str, f64)]| Port {
        name: name.to_owned(),
        port_type,
        frame: Frame::new([0.0, 0.0, at], [0.0, 0.0, z], [1.0, 0.0, 0.0]).unwrap(),
        params: params.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect(),
    };
    let extents = [("extent_x", 40.0), ("extent_y", 40.0)];
    let ports = vec![
        port("top", PortType::FlatFace, 1.0, 10.0, &extents),
        port("bottom", PortType::FlatFace, -1.0, 0.0, &extents),
        port(
            "hole",
            PortType::Bore,
            1.0,
            10.0,
            &[("diameter", 8.0), ("depth", 10.0)],
        ),
        port(
            "pin",
            PortType::Shaft,
            1.0,
            5.0,
            &[("diameter", 8.0), ("length", 10.0)],
        ),
    ];
    let made = Arc::new(Made {
        solid: Recipe {
            format: 2,
            calls: Vec::new(),
            result: 0,
        }
        .into(),
        lines: Vec::new(),
        ports: ports.clone(),
        params: serde_json::Map::new(),
        designation: None,
    });
    let part = |id: &&str| ResolvedPart {
        id: (*id).to_owned(),
        factory: "test.plate".to_owned(),
        made: Arc::clone(&made),
    };
    let index = |id: &str| parts.iter().position(|p| *p == id).unwrap();
    let find = |name: &str| ports.iter().find(|p| p.name == name).unwrap().clone();
    let end = |text: &str| {
        let (part, port) = text.split_once(':').unwrap();
        End {
            part: part.to_owned(),
            port: port.to_owned(),
        }
    };
    let mate = |(id, mate_type, base, incoming, options): &(&str, MateType, &str, &str, Value)| {
        let (base, incoming) = (end(base), end(incoming));
        let options = options.as_object().unwrap().clone();
        ResolvedMate {
            base: index(&base.part),
            incoming: index(&incoming.part),
            base_port: find(&base.port),
            incoming_port: find(&incoming.port),
            options: mate_type.kind().check_options(&options, "options").unwrap(),
            mate: Mate {
                id: (*id).to_owned(),
                mate_type: *mate_type,
                base,
                incoming,
                options,
                axioms: Vec::new(),
                notes: String::new(),
            },
        }
    };
    Resolved {
        parts: parts.iter().map(part).collect(),
        mates: mates.iter().map(mate).collect(),
        root: Some(0),
    }
}

fn checked(resolved: &Resolved, intended: Option<u32>) -> (Option<Freedom>, Results) {
    let mut spec = Assembly::new("a", "");
    spec.intended_mobility = intended;
    let placed = place::assembly(resolved).unwrap();
    let mut results = Results::default();
    let freedom = check(&spec, resolved, &placed, None, &mut results);
    (freedom, results)
}

fn lid(intended: Option<u32>) -> (Option<Freedom>, Results) {
    let resolved = assembly(
        &["base", "lid"],
        &[(
            "on",
            MateType::FaceToFace,
            "base:top",
            "lid:bottom",
            json!({}),
        )],
    );
    checked(&resolved, intended)
}

#[test]
fn a_lid_slides_twice_and_turns_and_that_is_compared() {
    let (freedom, results) = lid(None);
    assert_eq!(freedom.unwrap().mobility, Some(3));
    assert_eq!(
        (results.checks[0].verdict, results.findings.len()),
        (Verdict::Fail, 1)
    );
    assert_eq!(
        results.findings[0].diagnostic.code,
        Code::MobilityDiffers,
        "nothing states that it is meant"
    );
    assert!(results.checks[0].how.ends_with("not stated as intended"));
    assert!(
        results.checks[0]
            .how
            .contains("mobility 3 ('lid' turns about z through [0, 0, 0] | 'lid' slides along ")
    );
    let (_, results) = lid(Some(3));
    assert_eq!(
        (results.checks[0].verdict, results.findings.len()),
        (Verdict::Pass, 0)
    );
    let (_, results) = lid(Some(0));
    let found = &results.findings[0];
    assert_eq!(
        (results.checks[0].verdict, found.verdict),
        (Verdict::Fail, Verdict::Fail)
    );
    assert_eq!(found.diagnostic.found, Some(json!(3)));
    assert!(
        found
            .diagnostic
            .message
            .starts_with("0 motions are intended and 3 are free: 'lid' turns about z")
    );
}

#[test]
fn a_lid_that_is_held_twice_names_its_mates() {
    let resolved = assembly(
        &["base", "lid"],
        &[
            (
                "one",
                MateType::SnapToFace,
                "base:top",
                "lid:bottom",
                json!({}),
            ),
            (
                "two",
                MateType::SnapToFace,
                "base:top",
                "lid:bottom",
                json!({}),
            ),
        ],
    );
    let (freedom, results) = checked(&resolved, Some(1));
    assert_eq!(freedom.unwrap().redundant[0].dispensable, ["one", "two"]);
    let found = &results.findings[0];
    assert_eq!(
        (found.verdict, &found.mates),
        (Verdict::Fail, &vec!["one".to_owned(), "two".to_owned()])
    );
    assert_eq!(
        found.diagnostic.message,
        "1 motion is intended and 0 are free: nothing moves"
    );
    assert_eq!(found.values["redundant_constraints"], 6);
}

#[test]
fn islands_float_and_move_within() {
    let resolved = assembly(
        &["base", "a", "b"],
        &[(
            "turns",
            MateType::Coaxial,
            "a:hole",
            "b:pin",
            json!({"direction": "same"}),
        )],
    );
    let (freedom, results) = checked(&resolved, Some(0));
    // Six as one, and a turn and a slide of one in the other.
    assert_eq!(freedom.unwrap().mobility, Some(8));
    assert_eq!(results.findings[0].diagnostic.found, Some(json!(8)));
}

#[test]
fn mates_that_do_not_hold_leave_it_open() {
    let resolved = assembly(
        &["base", "lid"],
        &[
            (
                "on",
                MateType::FaceToFace,
                "base:top",
                "lid:bottom",
                json!({}),
            ),
            (
                "off",
                MateType::FaceToFace,
                "base:top",
                "lid:bottom",
                json!({"d_n_mm": 1}),
            ),
        ],
    );
    let (freedom, results) = checked(&resolved, None);
    assert_eq!(freedom, None);
    assert_eq!(results.checks[0].verdict, Verdict::Indeterminate);
    assert_eq!(results.findings[0].mates, ["off"]);
}

fn meant(intended: Option<u32>) -> Assembly {
    Assembly {
        intended_mobility: intended,
        ..Assembly::new("a", "")
    }
}

#[test]
fn idle_spins_do_not_pass_for_motions() {
    let motion = |name: &str, idle| Motion {
        name: name.to_owned(),
        count: 1,
        idle,
        lasting: Lasting::True,
        bodies: Vec::new(),
        more_bodies: 0,
    };
    let freedom = |real: usize| Freedom {
        mobility: Some(real + 1),
        idle_spins: 1,
        lasting_mobility: Some(real + 1),
        motions: [motion("'washer' spins idly", true)]
            .into_iter()
            .chain((0..real).map(|_| motion("'crank' turns", false)))
            .collect(),
        redundant: vec![Redundant {
            count: 3,
            mates: vec!["m".to_owned()],
            repeated: vec![3],
            dispensable: Vec::new(),
        }],
        joints: Vec::new(),
        islands: Vec::new(),
    };
    let verdict = |real, intended| judge(&freedom(real), None, &meant(Some(intended))).0;
    assert_eq!(
        (verdict(1, 1), verdict(0, 0)),
        (Verdict::Pass, Verdict::Pass)
    );
    // A mechanism that is stuck does not pass because a washer turns.
    assert_eq!(verdict(0, 1), Verdict::Indeterminate);
    assert_eq!(
        (verdict(0, 2), verdict(2, 1)),
        (Verdict::Fail, Verdict::Fail)
    );
    let mut unknown = freedom(1);
    unknown.lasting_mobility = None;
    assert_eq!(
        judge(&unknown, None, &meant(Some(1))).0,
        Verdict::Indeterminate
    );
    unknown.mobility = None;
    assert_eq!(
        judge(&unknown, None, &meant(None)).0,
        Verdict::Indeterminate
    );
}

/// Mates taken in order, again and again until none reaches a new part: as it is said, and slowly.
fn by_rounds(resolved: &Resolved) -> Vec<Option<usize>> {
    let mut by = vec![None; resolved.parts.len()];
    let mut placed = vec![false; resolved.parts.len()];
    placed[resolved.root.unwrap()] = true;
    loop {
        let mut progress = false;
        for (i, m) in resolved.mates.iter().enumerate() {
            let reached = match (placed[m.base], placed[m.incoming]) {
                (true, false) => m.incoming,
                (false, true) => m.base,
                _ => continue,
            };
            (placed[reached], by[reached], progress) = (true, Some(i), true);
        }
        if !progress {
            return by;
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn parts_are_placed_by_the_mates_that_reach_them_first(
        ends in prop::collection::vec((0..9usize, 0..9usize), 0..16),
    ) {
        let names: Vec<String> = (0..9).map(|i| format!("p{i}")).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let ids: Vec<String> = (0..ends.len()).map(|i| format!("m{i}")).collect();
        let ends: Vec<(String, String)> = ends
            .iter()
            .filter(|(a, b)| a != b)
            .map(|(a, b)| (format!("p{a}:top"), format!("p{b}:bottom")))
            .collect();
        let mates: Vec<_> = ends
            .iter()
            .zip(&ids)
            .map(|((a, b), id)| (id.as_str(), MateType::FaceToFace, a.as_str(), b.as_str(), json!({})))
            .collect();
        let resolved = assembly(&names, &mates);
        let placed = place::assembly(&resolved).unwrap();
        prop_assert_eq!(&placed.placed_by, &by_rounds(&resolved));
        for (i, p) in placed.parts.iter().enumerate() {
            prop_assert_eq!(p.is_some(), placed.placed_by[i].is_some() || resolved.root == Some(i));
        }
    }
}
