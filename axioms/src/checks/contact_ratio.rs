//! G-05: a tooth pair takes over before the last lets go.

use super::Check;
use crate::gearing::{BASIC_RACK, Pair, pairs};
use crate::indexed::Indexed;
use crate::ruling::Ruling;
use assemcad_model::angle::sin_cos_deg;
use core::f64::consts::PI;

/// The contact ratio has a margin over 1.
pub struct ContactRatio;

/// The least contact ratio. Budynas and Nisbett, Shigley's Mechanical Engineering Design, gears - general:
/// gears are not designed with less than about 1.2, for errors of mounting take some of it away.
const LEAST: f64 = 1.2;

/// Length of the path of contact by base pitch (ISO 21771), and the overlap of helical teeth:
/// `eps = (sqrt(ra1^2 - rb1^2) + sqrt(ra2^2 - rb2^2) - a sin(alpha_wt)) / (pi m_t cos(alpha_t))
/// + b sin(beta) / (pi m_n)`; the signs of the ring's terms turn.
fn ratio(p: &Pair<'_>, distance: f64) -> Option<f64> {
    let w = p.working_angle(distance)?;
    let (pinion, other) = p.ring_last();
    let sign = if other.internal { -1.0 } else { 1.0 };
    let reach = |tip: f64, base: f64| (tip > base).then(|| libm::sqrt(tip * tip - base * base));
    let path = reach(pinion.tip_radius(), pinion.base_radius())?
        + sign * reach(other.tip_radius(), other.base_radius())?
        - sign * distance * libm::sin(w);
    let pitch = 2.0 * PI * pinion.base_radius() / pinion.teeth;
    let overlap = pinion.width.min(other.width) * sin_cos_deg(pinion.helix_deg).0.abs()
        / (PI * pinion.module);
    Some(path / pitch + overlap)
}

impl Check for ContactRatio {
    fn id(&self) -> &'static str {
        "contact_ratio"
    }

    fn axiom(&self) -> &'static str {
        "G-05"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for p in pairs(facts) {
            if p.seen.is_none() {
                out.push(Ruling::unplaced(self.axiom(), p.about()));
                continue;
            }
            let Some(distance) = p.distance() else {
                continue;
            };
            let ratio = ratio(&p, distance);
            // Nothing meets where the axes are too far apart or too close.
            let total = ratio.unwrap_or(0.0);
            let holds = total >= LEAST;
            let message = format!(
                "{} have {total:.3} tooth pairs in contact on average; {LEAST} is the least",
                p.names()
            );
            out.push(
                Ruling::held(self.axiom(), holds, p.about(), message)
                    .value("contact_ratio", total)
                    .value("least", LEAST)
                    .assuming(BASIC_RACK),
            );
        }
        out
    }
}
