//! F-01: parts are joined pair by pair.

use super::Check;
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling};

/// Every part has a mate with another part.
pub struct PartConnected;

impl Check for PartConnected {
    fn id(&self) -> &'static str {
        "part_connected"
    }

    fn axiom(&self) -> &'static str {
        "F-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        if facts.parts.len() < 2 {
            return Vec::new();
        }
        facts
            .parts
            .iter()
            .map(|p| {
                let n = facts
                    .mates_of(&p.id)
                    .filter(|m| m.base.part != m.incoming.part)
                    .count();
                let message = if n > 0 {
                    format!("'{}' is joined by {n} mates", p.id)
                } else {
                    format!("nothing joins '{}'", p.id)
                };
                Ruling::held(self.axiom(), n > 0, About::parts([&p.id]), message)
                    .value("mates", n as f64)
            })
            .collect()
    }
}
