//! G-04: gears suit the angle of their axes.

use super::Check;
use crate::gearing::pairs;
use crate::geometry::askew_deg;
use crate::indexed::Indexed;
use crate::ruling::Ruling;

/// Helical gears on axes that are not parallel: the angle of the axes is the sum of the helix angles.
pub struct ShaftAngle;

/// Within this angle, in degrees, the axes suit the helices.
const NEAR_DEG: f64 = 1e-2;

impl Check for ShaftAngle {
    fn id(&self) -> &'static str {
        "shaft_angle"
    }

    fn axiom(&self) -> &'static str {
        "G-04"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for p in pairs(facts) {
            let straight = p.a.straight() && p.b.straight();
            if p.seen.is_none() && !straight {
                out.push(Ruling::unplaced(self.axiom(), p.about()));
            }
            // Straight teeth on such axes are a matter of the tooth system.
            if p.parallel() != Some(false) || straight {
                continue;
            }
            let Some(seen) = p.seen else { continue };
            // Crossed helical gears: the shaft angle is the sum of the helix angles, each with its hand
            // (Shigley, gears - general; ISO 21771). Axes without a sense: from 0 to 90 degrees.
            let sum = (p.a.helix_deg + p.b.helix_deg).abs();
            let wanted = sum.min(180.0 - sum);
            let angle = askew_deg(&seen);
            let holds = !p.inside() && (angle - wanted).abs() <= NEAR_DEG;
            let message = if holds {
                format!("the helices of {} make the angle of their axes", p.names())
            } else {
                format!(
                    "the axes of {} cross at {angle:.3} degrees, and their helices make {wanted:.3}",
                    p.names()
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, p.about(), message)
                    .value("axes_deg", angle)
                    .value("sum_of_helices_deg", wanted),
            );
        }
        out
    }
}
