//! B-03: a shaft is held along its axis both ways.

use std::collections::BTreeSet;

use super::Check;
use crate::asked::{Carried, shafts_in_bearings};
use crate::facts::{Facts, Stop};
use crate::joints::about_part;
use crate::ruling::{Ruling, Status};
use assemcad_model::mates::MateType;

/// Along its axis, either way, a shaft meets something that is held, within the end play.
pub struct AxialLocation;

/// The most end play at one stop, in mm. Ours: more is no location but a catch.
const PLAY_MM: f64 = 1.0;

impl Check for AxialLocation {
    fn id(&self) -> &'static str {
        "axial_location"
    }

    fn axiom(&self) -> &'static str {
        "B-03"
    }

    fn run(&self, facts: &Facts) -> Vec<Ruling> {
        let thrusts = facts.measured.thrusts.as_deref().unwrap_or_default();
        shafts_in_bearings(facts)
            .into_iter()
            .map(|carried| {
                let shaft = &carried.shaft.part.id;
                let stops = thrusts.iter().find(|t| t.shaft == *shaft);
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
    fn held(&self, facts: &Facts, carried: &Carried<'_>, stops: &[Stop]) -> Ruling {
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
                 within {PLAY_MM} mm",
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
fn held_parts<'a>(facts: &'a Facts, stops: &'a [Stop], along: bool) -> BTreeSet<&'a str> {
    let mut held: BTreeSet<&str> = facts.root().into_iter().collect();
    loop {
        let before = held.len();
        for m in &facts.mates {
            let joins = !matches!(m.mate_type, MateType::Coaxial | MateType::GearMesh);
            let (b, c) = (m.base.part.as_str(), m.incoming.part.as_str());
            if joins && (held.contains(b) || held.contains(c)) {
                held.extend([b, c]);
            }
        }
        for s in stops.iter().filter(|s| s.play_mm <= PLAY_MM) {
            // What stops a part one way is stopped by it the other way.
            let (part, by) = if along {
                (s.part.as_str(), s.by.as_str())
            } else {
                (s.by.as_str(), s.part.as_str())
            };
            if held.contains(by) {
                held.insert(part);
            }
        }
        if held.len() == before {
            return held;
        }
    }
}
