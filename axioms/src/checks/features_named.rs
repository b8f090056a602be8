//! F-03: connections are constraints between features.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::Ruling;

/// Both ends of every mate are ports of two different parts.
pub struct FeaturesNamed;

impl Check for FeaturesNamed {
    fn id(&self) -> &'static str {
        "features_named"
    }

    fn axiom(&self) -> &'static str {
        "F-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        facts
            .mates
            .iter()
            .map(|m| {
                let lacking: Vec<String> = [&m.base, &m.incoming]
                    .into_iter()
                    .filter(|end| facts.side(end).is_none())
                    .map(ToString::to_string)
                    .collect();
                let same = m.base.part == m.incoming.part;
                let message = if same {
                    format!("'{}' joins '{}' with itself", m.id, m.base.part)
                } else if lacking.is_empty() {
                    format!("'{}' joins '{}' and '{}'", m.id, m.base, m.incoming)
                } else {
                    format!("'{}' names what is not there: {}", m.id, lacking.join(", "))
                };
                Ruling::held(self.axiom(), lacking.is_empty() && !same, about(m), message)
            })
            .collect()
    }
}
