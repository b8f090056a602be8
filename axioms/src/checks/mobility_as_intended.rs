//! K-03: mobility as intended.

use super::Check;
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling, Status};

/// As many motions as are meant.
pub struct MobilityAsIntended;

impl Check for MobilityAsIntended {
    fn id(&self) -> &'static str {
        "mobility_as_intended"
    }

    fn axiom(&self) -> &'static str {
        "K-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let Some(wanted) = facts.intended_mobility else {
            return Vec::new();
        };
        let Some(mobility) = &facts.mobility else {
            let message = "the motion of the assembly was not analysed";
            return vec![Ruling::new(
                self.axiom(),
                Status::Indeterminate,
                About::assembly(),
                message,
            )];
        };
        let found = mobility.freedom;
        let message =
            format!("the assembly has {found} independent motions, and {wanted} are intended");
        vec![
            Ruling::held(self.axiom(), found == wanted, About::assembly(), message)
                .value("mobility", f64::from(found))
                .value("intended", f64::from(wanted)),
        ]
    }
}
