//! B-01: each ring of a bearing has its seat.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::{about_part, of_class};
use crate::ruling::Ruling;
use assemcad_model::ports::PortType;

/// A bearing has a mate on its inner and one on its outer ring, with two parts.
pub struct RingSeats;

impl Check for RingSeats {
    fn id(&self) -> &'static str {
        "ring_seats"
    }

    fn axiom(&self) -> &'static str {
        "B-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        // A part by itself is no assembly: there is nothing to join it to.
        if facts.parts.len() == 1 {
            return Vec::new();
        }
        of_class(facts, Class::BallBearing)
            .map(|bearing| {
                let mates: Vec<_> = facts.mates_of(&bearing.id).collect();
                let other = |wanted: PortType| {
                    mates.iter().find_map(|m| {
                        let (own, other) = facts.seen_from(&bearing.id, m)?;
                        own.is(wanted).then_some(other.part.id.as_str())
                    })
                };
                let (inner, outer) = (other(PortType::Bore), other(PortType::PressFit));
                let holds = inner.is_some() && outer.is_some() && inner != outer;
                let message = match (inner, outer) {
                    (Some(i), Some(o)) if i == o => {
                        format!("both rings of '{}' sit on '{i}'", bearing.id)
                    }
                    (Some(i), Some(o)) => format!("'{}' sits on '{i}' and in '{o}'", bearing.id),
                    (None, Some(_)) => {
                        format!("the inner ring of '{}' sits on nothing", bearing.id)
                    }
                    (Some(_), None) => {
                        format!("the outer ring of '{}' sits in nothing", bearing.id)
                    }
                    (None, None) => format!("neither ring of '{}' has a seat", bearing.id),
                };
                Ruling::held(self.axiom(), holds, about_part(bearing, mates), message)
            })
            .collect()
    }
}
