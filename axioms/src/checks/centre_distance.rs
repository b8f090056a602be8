//! G-01: operating centre distance.

use super::Check;
use crate::gearing::pairs;
use crate::geometry::NEAR_MM;
use crate::indexed::Indexed;
use crate::ruling::Ruling;
use assemcad_model::angle::sin_cos_deg;

/// The axes stand at the distance of ISO 21771, widened by the backlash that the mate states.
pub struct CentreDistance;

impl Check for CentreDistance {
    fn id(&self) -> &'static str {
        "centre_distance"
    }

    fn axiom(&self) -> &'static str {
        "G-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for p in pairs(facts) {
            if p.seen.is_none() {
                out.push(Ruling::unplaced(self.axiom(), p.about()));
                continue;
            }
            let (Some(actual), Some(tight)) = (p.distance(), p.operating_distance()) else {
                continue;
            };
            // The play j along the pitch circle widens by j / (2 tan alpha), in a ring it narrows
            // (first order; the same formula by which the mate places its gears).
            let (sin, cos) = sin_cos_deg(p.a.pressure_deg);
            let play = p.mate.number("backlash_mm") * cos / (2.0 * sin);
            let wanted = if p.inside() {
                tight - play
            } else {
                tight + play
            };
            let holds = (actual - wanted).abs() <= NEAR_MM;
            let message = if holds {
                format!("{} stand at their operating centre distance", p.names())
            } else {
                format!(
                    "the axes of {} are {actual:.4} mm apart, and {wanted:.4} mm is their operating centre distance",
                    p.names()
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, p.about(), message)
                    .value("distance_mm", actual)
                    .value("operating_distance_mm", wanted)
                    .value("tolerance_mm", NEAR_MM),
            );
        }
        out
    }
}
