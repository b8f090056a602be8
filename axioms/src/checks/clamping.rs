//! T-01: a screw clamps.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::{about_part, of_class};
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

/// Every bolt has a seat for its head and a thread for its end.
pub struct Clamping;

impl Check for Clamping {
    fn id(&self) -> &'static str {
        "clamping"
    }

    fn axiom(&self) -> &'static str {
        "T-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        // A part by itself is no assembly: there is nothing to join it to.
        if facts.parts.len() == 1 {
            return Vec::new();
        }
        of_class(facts, Class::Bolt)
            .map(|bolt| {
                let mates: Vec<_> = facts.mates_of(&bolt.id).collect();
                let own = |m: &&crate::facts::MateFacts, wanted: PortType| {
                    let side = facts.seen_from(&bolt.id, m);
                    side.is_some_and(|(own, _)| own.is(wanted))
                };
                let seated = mates.iter().any(|m| own(m, PortType::BoltSeat));
                let engaged = mates.iter().any(|m| {
                    m.mate_type == MateType::ThreadEngage && own(m, PortType::ThreadExternal)
                });
                let message = match (seated, engaged) {
                    (true, true) => format!("'{}' is seated and engaged", bolt.id),
                    (true, false) => format!(
                        "the thread of '{}' is engaged nowhere: it clamps nothing",
                        bolt.id
                    ),
                    (false, true) => format!(
                        "the head of '{}' is seated nowhere: it clamps nothing",
                        bolt.id
                    ),
                    (false, false) => format!("'{}' is neither seated nor engaged", bolt.id),
                };
                Ruling::held(
                    self.axiom(),
                    seated && engaged,
                    about_part(bolt, mates),
                    message,
                )
            })
            .collect()
    }
}
