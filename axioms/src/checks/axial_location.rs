//! B-03: a shaft is held along its axis both ways.

use std::collections::{BTreeMap, BTreeSet};

use super::Check;
use crate::asked::{Carried, END_PLAY_MM, shafts_in_bearings};
use crate::facts::{MateFacts, Stop, Thrust};
use crate::indexed::Indexed;
use crate::joints::about_part;
use crate::ruling::{Ruling, Status};
use assemcad_model::mates::MateType;

/// Along its axis, either way, a shaft meets something that is held, within the end play.
pub struct AxialLocation;

impl Check for AxialLocation {
    fn id(&self) -> &'static str {
        "axial_location"
    }

    fn axiom(&self) -> &'static str {
        "B-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut thrusts: BTreeMap<&str, &Thrust> = BTreeMap::new();
        for t in facts.measured.thrusts.iter().flatten() {
            thrusts.entry(&t.shaft).or_insert(t);
        }
        shafts_in_bearings(facts)
            .into_iter()
            .map(|carried| {
                let shaft = &carried.shaft.part.id;
                let stops = thrusts.get(shaft.as_str());
                match stops.and_then(|t| t.stops.as_deref()) {
                    Some(stops) => self.held(facts, &carried, stops),
                    None => {
                        let about = about_part(carried.shaft.part, [carried.mate]);
                        let message =
                            format!("what stops '{shaft}' along its axis was not measured");
                        Ruling::new(self.axiom(), Status::Indeterminate, about, message)
                    }
                }
            })
            .collect()
    }
}

impl AxialLocation {
    fn held(&self, facts: &Indexed, carried: &Carried<'_>, stops: &[Stop]) -> Ruling {
        let shaft = carried.shaft.part.id.as_str();
        let ways = [("along its axis", true), ("against its axis", false)];
        let free: Vec<&str> = ways
            .into_iter()
            .filter(|(_, along)| !held_parts(facts, stops, *along).contains(shaft))
            .map(|(way, _)| way)
            .collect();
        let message = if free.is_empty() {
            format!("'{shaft}' is held along its axis both ways")
        } else {
            format!(
                "'{shaft}' can creep out {}: no shoulder, ring or press fit that is held itself stops it \
                 within {END_PLAY_MM} mm",
                free.join(" and ")
            )
        };
        let mates = facts.mates_of(shaft);
        Ruling::held(
            self.axiom(),
            free.is_empty(),
            about_part(carried.shaft.part, mates),
            message,
        )
        .value("ways_held", 2.0 - free.len() as f64)
        .assuming(
            "side fits (coaxial) and gear teeth hold nothing along the axis, every other mate does; an end \
             play of up to 1 mm is a location: a rule of ours",
        )
    }
}

/// The parts that cannot move one way along the axis: the ground, what is joined to such a part other than by
/// a side fit, and what meets such a part.
fn held_parts<'a>(facts: &'a Indexed, stops: &'a [Stop], along: bool) -> BTreeSet<&'a str> {
    let mut stopped: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for s in stops.iter().filter(|s| s.play_mm <= END_PLAY_MM) {
        // What stops a part one way is stopped by it the other way.
        let (part, by) = if along {
            (s.part.as_str(), s.by.as_str())
        } else {
            (s.by.as_str(), s.part.as_str())
        };
        stopped.entry(by).or_default().push(part);
    }
    let mut held: BTreeSet<&str> = facts.root().into_iter().collect();
    let mut open: Vec<&str> = held.iter().copied().collect();
    while let Some(part) = open.pop() {
        let joins = |m: &&MateFacts| !matches!(m.mate_type, MateType::Coaxial | MateType::GearMesh);
        let mates = facts.mates_of(part).filter(joins);
        let ends = mates.flat_map(|m| [m.base.part.as_str(), m.incoming.part.as_str()]);
        let met = stopped.get(part).into_iter().flatten().copied();
        for next in ends.chain(met) {
            if held.insert(next) {
                open.push(next);
            }
        }
    }
    held
}
