//! C-01: face on face.

use super::Check;
use crate::geometry::{NEAR_DEG, NEAR_MM, z_angle_deg};
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;

/// Opposed normals at the stated gap.
pub struct PlaneAlignment;

impl Check for PlaneAlignment {
    fn id(&self) -> &'static str {
        "plane_alignment"
    }

    fn axiom(&self) -> &'static str {
        "C-01"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for m in facts
            .mates
            .iter()
            .filter(|m| m.mate_type == MateType::FaceToFace)
        {
            let Some((b, c)) = facts.sides(m) else {
                continue;
            };
            let Some(seen) = b.sees(&c) else {
                out.push(Ruling::unplaced(self.axiom(), about(m)));
                continue;
            };
            let (askew, gap) = (180.0 - z_angle_deg(&seen), seen.origin().z);
            let stated = m.number("d_n_mm");
            let holds = askew <= NEAR_DEG && (gap - stated).abs() <= NEAR_MM;
            let message = if holds {
                format!("the faces {} and {} are opposed", m.base, m.incoming)
            } else {
                format!(
                    "the faces {} and {} are {askew:.3} degrees askew and {gap:.3} mm apart; {stated} mm is stated",
                    m.base, m.incoming
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, about(m), message)
                    .value("askew_deg", askew)
                    .value("gap_mm", gap)
                    .value("stated_gap_mm", stated),
            );
        }
        out
    }
}
