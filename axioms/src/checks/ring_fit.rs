//! B-02: a bearing can be mounted.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::{about_part, of_class};
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

/// A bearing is pressed on one of its rings at most.
pub struct RingFit;

impl Check for RingFit {
    fn id(&self) -> &'static str {
        "ring_fit"
    }

    fn axiom(&self) -> &'static str {
        "B-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        of_class(facts, Class::BallBearing)
            .map(|bearing| {
                let mates: Vec<_> = facts.mates_of(&bearing.id).collect();
                let pressed = |wanted: PortType| {
                    mates.iter().any(|m| {
                        let own = facts.seen_from(&bearing.id, m).map(|s| s.0);
                        m.mate_type == MateType::PressFit && own.is_some_and(|o| o.is(wanted))
                    })
                };
                let both = pressed(PortType::Bore) && pressed(PortType::PressFit);
                let message = if both {
                    format!(
                        "'{}' is pressed on its shaft and into its housing",
                        bearing.id
                    )
                } else {
                    format!(
                        "'{}' can be mounted on one ring after the other",
                        bearing.id
                    )
                };
                Ruling::held(self.axiom(), !both, about_part(bearing, mates), message)
            })
            .collect()
    }
}
