//! F-05: what is seated touches.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::{Ruling, Status};

/// Mates that mean contact show it on the solids.
pub struct ContactAtSeat;

impl Check for ContactAtSeat {
    fn id(&self) -> &'static str {
        "contact_at_seat"
    }

    fn axiom(&self) -> &'static str {
        "F-05"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for c in facts.measured.contacts.iter().flatten() {
            let Some(m) = facts.mate(&c.mate) else {
                continue;
            };
            let (status, what) = match c.touches {
                Some(true) => (Status::Pass, "touch"),
                Some(false) => (Status::Fail, "do not touch"),
                None => (Status::Indeterminate, "could not be measured"),
            };
            let message = format!("{} and {} {what} at their seats", m.base, m.incoming);
            out.push(Ruling::new(self.axiom(), status, about(m), message));
        }
        out
    }
}
