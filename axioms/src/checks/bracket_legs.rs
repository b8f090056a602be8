//! N-06: brackets and channels are joined on their legs.

use super::Check;
use crate::class::Class;
use crate::geometry::askew_deg;
use crate::indexed::Indexed;
use crate::joints::about_part;
use crate::ruling::Ruling;

/// A bracket or channel is joined on two walls that are not parallel.
pub struct BracketLegs;

/// Below this angle, in degrees, two walls count as one direction.
const LEAST_DEG: f64 = 1.0;

impl Check for BracketLegs {
    fn id(&self) -> &'static str {
        "bracket_legs"
    }

    fn axiom(&self) -> &'static str {
        "N-06"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        // A part by itself is no assembly: there is nothing to join it to.
        if facts.parts.len() == 1 {
            return Vec::new();
        }
        let mut out = Vec::new();
        for part in &facts.parts {
            if !matches!(part.class(), Class::Bracket | Class::Channel) {
                continue;
            }
            let mates: Vec<_> = facts.mates_of(&part.id).collect();
            let walls: Vec<_> = mates
                .iter()
                .filter_map(|m| facts.seen_from(&part.id, m))
                .filter_map(|(own, _)| own.port.frame.placement().ok())
                .collect();
            let first = walls.first().map(|w| w.inverse());
            let angle = walls
                .iter()
                .filter_map(|w| Some(askew_deg(&(first? * *w))))
                .fold(0.0, f64::max);
            let holds = angle > LEAST_DEG;
            let message = if holds {
                format!("'{}' is joined on walls at {angle:.1} degrees", part.id)
            } else {
                format!(
                    "'{}' is joined on one wall only, or on parallel ones",
                    part.id
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, about_part(part, mates), message)
                    .value("walls_deg", angle),
            );
        }
        out
    }
}
