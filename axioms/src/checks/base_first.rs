//! S-03: the base comes first.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::{about, reached};
use crate::ruling::{About, Ruling};
use std::collections::BTreeSet;

/// The ground is the first part, and each mate joins a part that has a place already.
pub struct BaseFirst;

impl Check for BaseFirst {
    fn id(&self) -> &'static str {
        "base_first"
    }

    fn axiom(&self) -> &'static str {
        "S-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let (Some(root), Some(first)) = (facts.root(), facts.parts.first()) else {
            return Vec::new();
        };
        let mut out = Vec::new();
        let message = format!("'{}' comes first, and '{root}' is the ground", first.id);
        out.push(Ruling::held(
            self.axiom(),
            first.id == root,
            About::parts([&first.id]),
            message,
        ));
        let mut placed = BTreeSet::from([root]);
        // What never reaches the ground is another axiom's.
        let grounded = reached(facts, root);
        for m in &facts.mates {
            let (b, c) = (m.base.part.as_str(), m.incoming.part.as_str());
            if !grounded.contains(b) {
                continue;
            }
            let holds = placed.contains(b) || placed.contains(c);
            let message = if holds {
                format!("'{}' joins a part that has a place", m.id)
            } else {
                format!("'{}' joins '{b}' and '{c}' before either has a place", m.id)
            };
            out.push(Ruling::held(self.axiom(), holds, about(m), message));
            placed.extend([b, c]);
        }
        out
    }
}
