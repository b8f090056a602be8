//! Why some freedoms are taken twice on purpose: patterns of joints that other axioms demand.

use std::collections::BTreeSet;

use crate::asked::turns;
use crate::class::Class;
use crate::facts::{Facts, MateFacts, PartFacts};
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
pub fn reasons(facts: &Facts) -> Vec<Reason<'_>> {
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
fn fastened(facts: &Facts, mate: &MateFacts) -> Option<String> {
    let ends = [&mate.base.part, &mate.incoming.part];
    let fastener = ends.into_iter().find(|id| {
        let fastens = |p: &PartFacts| p.class().is_fastener();
        facts.part(id).is_some_and(fastens)
    })?;
    Some(format!("'{fastener}' is a fastener (T-01, T-09)"))
}

/// A rotating part or a hinge's pin is carried at two places at least; the first of them is no repetition.
fn carried_again(facts: &Facts, mate: &MateFacts) -> Option<String> {
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
