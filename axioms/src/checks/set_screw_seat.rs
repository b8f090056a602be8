//! T-08: a set screw stands on a flat.

use super::Check;
use crate::asked::tips;
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::{Ruling, Status};

/// Under the tip of a set screw the shaft has a plane face square to the screw, or a dimple.
pub struct SetScrewSeat;

impl Check for SetScrewSeat {
    fn id(&self) -> &'static str {
        "set_screw_seat"
    }

    fn axiom(&self) -> &'static str {
        "T-08"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let seats = facts.measured.tips.as_deref().unwrap_or_default();
        tips(facts)
            .into_iter()
            .map(|tip| {
                let mut about = about(tip.mate);
                about.parts.push(tip.shaft.part.id.clone());
                let (screw, shaft) = (&tip.screw.part.id, &tip.shaft.part.id);
                let Some(seat) = seats.iter().find(|s| s.mate == tip.mate.id) else {
                    let message = format!("on what '{screw}' stands on '{shaft}' was not measured");
                    return Ruling::new(self.axiom(), Status::Indeterminate, about, message);
                };
                let message = if seat.flat {
                    format!("'{screw}' stands on a flat of '{shaft}'")
                } else if seat.sunk {
                    format!("'{screw}' stands in a dimple of '{shaft}'")
                } else {
                    format!("'{screw}' has no flat or dimple of '{shaft}' under its tip")
                };
                Ruling::held(self.axiom(), seat.flat || seat.sunk, about, message)
            })
            .collect()
    }
}
