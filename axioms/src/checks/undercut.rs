//! G-06: no undercut.

use super::Check;
use crate::gearing::Gear;
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling};
use assemcad_model::ports::PortType;

/// Enough teeth, or shift, for the pressure angle.
pub struct Undercut;

/// Height of the rack's straight flank above its pitch line, in modules: 1 by ISO 53. The last 0.006 are
/// let off, so that 17 teeth at 20 degrees count as free of undercut, as the tables of textbooks have it.
const HEIGHT: f64 = 0.994;

impl Check for Undercut {
    fn id(&self) -> &'static str {
        "undercut"
    }

    fn axiom(&self) -> &'static str {
        "G-06"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for part in &facts.parts {
            for port in part
                .ports
                .iter()
                .filter(|p| p.port_type == PortType::GearMesh)
            {
                let g = Gear::of(port);
                // A ring is not cut with a rack.
                if g.internal {
                    continue;
                }
                let sin = libm::sin(g.transverse());
                // A rack of addendum h does not undercut where x >= h - z sin^2(alpha_t) / (2 cos(beta)).
                let needed = HEIGHT - g.teeth * sin * sin / (2.0 * g.cos_helix());
                let holds = g.shift >= needed;
                let message = if holds {
                    format!("the teeth of '{}' are not undercut", part.id)
                } else {
                    format!(
                        "the {} teeth of '{}' are undercut: they need a profile shift of {needed:.3} at least",
                        g.teeth, part.id
                    )
                };
                out.push(
                    Ruling::held(self.axiom(), holds, About::parts([&part.id]), message)
                        .value("teeth", g.teeth)
                        .value("profile_shift", g.shift)
                        .value("least_profile_shift", needed)
                        .assuming("cut with a rack of ISO 53, without the rounding of its tip"),
                );
            }
        }
        out
    }
}
