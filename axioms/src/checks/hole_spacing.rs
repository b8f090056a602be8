//! N-04: spacing of holes.

use super::Check;
use crate::geometry::{NEAR_DEG, NEAR_MM, askew_deg};
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling};
use assemcad_model::ports::PortType;

/// Clearance holes side by side in a part are 2.2 hole diameters apart.
pub struct HoleSpacing;

/// Distance of hole axes in hole diameters: EN 1993-1-8, table 3.3, least p1 (p2 across the load is 2.4; the
/// direction of the load is not known here).
const SPACING: f64 = 2.2;

impl Check for HoleSpacing {
    fn id(&self) -> &'static str {
        "hole_spacing"
    }

    fn axiom(&self) -> &'static str {
        "N-04"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for part in &facts.parts {
            let holes: Vec<_> = part
                .ports
                .iter()
                .filter(|p| p.port_type == PortType::ClearanceHole)
                .filter_map(|p| Some((p.value("diameter"), p.frame.placement().ok()?)))
                .collect();
            let mut nearest: Option<(f64, f64)> = None;
            for (i, (a, at)) in holes.iter().enumerate() {
                let back = at.inverse();
                for (b, other) in holes.iter().skip(i + 1) {
                    let [x, y, _] = back.point(other.origin().into());
                    let apart = libm::hypot(x, y);
                    let least = SPACING * a.max(*b);
                    // The two mouths of one hole, and holes in other walls, are no neighbours.
                    if apart > NEAR_MM
                        && nearest.is_none_or(|(d, l)| apart - least < d - l)
                        && askew_deg(&(back * *other)) <= NEAR_DEG
                    {
                        nearest = Some((apart, least));
                    }
                }
            }
            let Some((apart, least)) = nearest else {
                continue;
            };
            let message = format!(
                "holes of '{}' are {apart:.3} mm apart; {least:.3} mm is the least",
                part.id
            );
            out.push(
                Ruling::held(
                    self.axiom(),
                    apart >= least - 1e-9,
                    About::parts([&part.id]),
                    message,
                )
                .value("apart_mm", apart)
                .value("least_mm", least),
            );
        }
        out
    }
}
