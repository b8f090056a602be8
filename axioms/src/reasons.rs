//! Why some freedoms are taken twice on purpose: patterns of joints that other axioms demand.

use std::collections::BTreeSet;

use crate::asked::turns;
use crate::class::Class;
use crate::facts::{MateFacts, PartFacts};
use crate::indexed::Indexed;
use crate::joints::{is_cylinder, is_hole};

/// A mate that may take freedoms again, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reason<'a> {
    /// The mate.
    pub mate: &'a str,
    /// The pattern, in a few words.
    pub why: String,
}

/// The mates that repeat what others hold because a recognised pattern wants it, in the order of the
/// specification. Without them the rest has to take every freedom once.
#[must_use]
pub fn reasons(facts: &Indexed) -> Vec<Reason<'_>> {
    let by = |mate: &'_ MateFacts| fastened(facts, mate).or_else(|| carried_again(facts, mate));
    let one = |mate| by(mate).map(|why| (mate, why));
    facts
        .mates
        .iter()
        .filter_map(one)
        .map(|(mate, why)| Reason {
            mate: &mate.id,
            why,
        })
        .collect()
}

/// A fastener that joins two parts or more holds them together beside whatever locates them.
fn fastened(facts: &Indexed, mate: &MateFacts) -> Option<String> {
    let ends = [&mate.base.part, &mate.incoming.part];
    let fastener = ends.into_iter().find(|id| {
        let fastens = |p: &PartFacts| p.class().is_fastener();
        facts.part(id).is_some_and(fastens)
    })?;
    Some(format!("'{fastener}' is a fastener (T-01, T-09)"))
}

/// A rotating part or a hinge's pin is carried at two places at least; the first of them is no repetition.
fn carried_again(facts: &Indexed, mate: &MateFacts) -> Option<String> {
    let ends = [&mate.base.part, &mate.incoming.part];
    ends.into_iter().find_map(|id| {
        let part = facts.part(id)?;
        if part.class() != Class::Pin && !turns(facts, part) {
            return None;
        }
        let carries = |m: &&MateFacts| {
            facts.seen_from(id, m).is_some_and(|(own, other)| {
                let bears = other.part.class().is_structure()
                    || matches!(
                        other.part.class(),
                        Class::BallBearing | Class::Custom | Class::HingeLeaf
                    );
                is_cylinder(own.port.port_type) && is_hole(other.port.port_type) && bears
            })
        };
        let places: Vec<&MateFacts> = facts.mates_of(id).filter(carries).collect();
        let at: BTreeSet<&str> = places
            .iter()
            .filter_map(|m| facts.seen_from(id, m))
            .map(|(_, other)| other.part.id.as_str())
            .collect();
        let again = places.iter().skip(1).any(|m| m.id == mate.id);
        (again && at.len() > 1).then(|| format!("'{id}' is carried at {} places (P-01)", at.len()))
    })
}

#[cfg(test)]
mod tests {
    use super::reasons;
    use crate::checks;
    use crate::facts::{Facts, Mobility, Redundant};
    use crate::indexed::Indexed;
    use crate::ruling::{Ruling, Status};
    use serde_json::{Value, json};

    fn port(name: &str, port_type: &str, params: Value) -> Value {
        let frame = json!({"origin": [0, 0, 0], "x": [1, 0, 0], "z": [0, 0, 1]});
        json!({"name": name, "type": port_type, "frame": frame, "params": params})
    }

    /// Two blocks on a plate, a shaft in a bore of each, a bolt through one block and the plate.
    fn stand() -> Facts {
        let bore = || port("bore", "BORE", json!({"diameter": 20, "depth": 10}));
        let face = |name: &str| port(name, "FLAT_FACE", json!({"extent_x": 9, "extent_y": 9}));
        let hole = || port("hole", "CLEARANCE_HOLE", json!({"diameter": 9, "depth": 9}));
        let part = |id: &str, factory: &str, ports: Vec<Value>| json!({"id": id, "factory": factory, "ports": ports});
        let mate = |id: &str, mate_type: &str, [b, p]: [&str; 2], [c, q]: [&str; 2]| {
            json!({
                "id": id, "mate_type": mate_type, "base": {"ref": b, "port": p},
                "incoming": {"ref": c, "port": q},
            })
        };
        serde_json::from_value(json!({
            "root": "plate",
            "parts": [
                part("plate", "rect_plate", vec![face("top"), hole()]),
                part("left", "housing_block", vec![bore(), face("bottom"), hole()]),
                part("right", "housing_block", vec![bore(), face("bottom")]),
                part("shaft", "stepped_shaft", vec![
                    port("seat", "SHAFT", json!({"diameter": 20, "length": 99})),
                ]),
                part("bolt", "fastener.bolt", vec![
                    port("seat", "BOLT_SEAT", json!({"inner_diameter": 8, "outer_diameter": 13})),
                ]),
            ],
            "mates": [
                mate("stand_left", "face_to_face", ["plate", "top"], ["left", "bottom"]),
                mate("stand_right", "face_to_face", ["plate", "top"], ["right", "bottom"]),
                mate("in_left", "coaxial", ["left", "bore"], ["shaft", "seat"]),
                mate("in_right", "coaxial", ["right", "bore"], ["shaft", "seat"]),
                mate("bolt", "coaxial_face", ["left", "hole"], ["bolt", "seat"]),
            ],
        }))
        .unwrap()
    }

    fn judged(redundant: &[&str], unexplained: Option<&[&str]>) -> Ruling {
        let mates = |names: &[&str]| -> Vec<Redundant> {
            let one = |m: &&str| Redundant {
                mate: (*m).to_owned(),
                count: 1,
            };
            names.iter().map(one).collect()
        };
        let mut facts = stand();
        facts.mobility = Some(Mobility {
            redundant: mates(redundant),
            unexplained: unexplained.map(mates),
            ..Mobility::default()
        });
        let all = checks::run_all(&facts);
        all.into_iter().find(|v| v.axiom == "C-05").unwrap()
    }

    #[test]
    fn the_second_place_of_a_shaft_and_what_a_fastener_joins() {
        let facts = stand();
        let told = |facts: &Facts| -> Vec<String> {
            let facts = Indexed::new(facts.clone());
            reasons(&facts).iter().map(|r| r.mate.to_owned()).collect()
        };
        assert_eq!(told(&facts), ["in_right", "bolt"]);
        // Both of them in one block are one place.
        let mut one = facts.clone();
        one.mates[3].base.part = "left".to_owned();
        assert_eq!(told(&one), ["bolt"]);
    }

    #[test]
    fn what_is_explained_is_quiet_and_says_why() {
        let loop_ = ["stand_left", "stand_right", "in_left", "in_right"];
        let quiet = judged(&loop_, Some(&[]));
        assert_eq!(quiet.status, Status::Pass);
        let why = quiet.assumption.unwrap();
        assert!(
            why.contains("'shaft' is carried at 2 places") && !why.contains("bolt"),
            "{why}"
        );
        // Something is left that no pattern explains, and it alone is told of.
        let loud = judged(&loop_, Some(&["stand_left"]));
        assert_eq!(loud.status, Status::Fail);
        assert_eq!(loud.about.mates, ["stand_left"]);
        // Where nothing was left out, nothing is explained.
        assert_eq!(judged(&loop_, None).status, Status::Fail);
    }
}
