//! N-01: one load path to ground.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::reached;
use crate::ruling::{About, Ruling};

/// Every part reaches the root over mates.
pub struct LoadPath;

impl Check for LoadPath {
    fn id(&self) -> &'static str {
        "load_path"
    }

    fn axiom(&self) -> &'static str {
        "N-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let Some(root) = facts.root() else {
            return Vec::new();
        };
        let reached = reached(facts, root);
        facts
            .parts
            .iter()
            .filter(|p| p.id != root)
            // What nothing joins at all is another axiom's.
            .filter(|p| facts.mates_of(&p.id).next().is_some())
            .map(|p| {
                let holds = reached.contains(p.id.as_str());
                let message = if holds {
                    format!("'{}' is carried by the ground '{root}'", p.id)
                } else {
                    format!(
                        "no chain of connections leads from '{}' to the ground '{root}'",
                        p.id
                    )
                };
                Ruling::held(self.axiom(), holds, About::parts([&p.id]), message)
            })
            .collect()
    }
}
