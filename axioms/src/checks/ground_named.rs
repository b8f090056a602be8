//! F-02: one part stands still.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling};

/// The root is a part of structure.
pub struct GroundNamed;

impl Check for GroundNamed {
    fn id(&self) -> &'static str {
        "ground_named"
    }

    fn axiom(&self) -> &'static str {
        "F-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let Some(root) = facts.root() else {
            return Vec::new();
        };
        // A part by itself is no assembly: there is nothing to join it to.
        if facts.parts.len() == 1 {
            return Vec::new();
        }
        let about = About::parts([root]);
        let Some(part) = facts.part(root) else {
            let message = format!("the ground '{root}' is no part");
            return vec![Ruling::held(self.axiom(), false, about, message)];
        };
        let class = part.class();
        let holds = class.is_structure() || class == Class::Custom;
        let message = if holds {
            format!("'{root}' stands still")
        } else {
            format!(
                "'{root}' ({class}) stands still, and is no part of structure that could carry others"
            )
        };
        let mut v = Ruling::held(self.axiom(), holds, about, message);
        if facts.root.is_none() {
            v = v.assuming("the first part is the ground: none is named");
        }
        vec![v]
    }
}
