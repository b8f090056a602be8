//! T-12: a snap hook reaches over its catch.

use super::Check;
use crate::geometry::{NEAR_DEG, z_angle_deg};
use crate::indexed::Indexed;
use crate::joints::{about, ends};
use crate::ruling::Ruling;
use assemcad_model::ports::PortType;

/// The locking faces of hook and catch face each other and overlap.
pub struct SnapLock;

impl Check for SnapLock {
    fn id(&self) -> &'static str {
        "snap_lock"
    }

    fn axiom(&self) -> &'static str {
        "T-12"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for mate in &facts.mates {
            let snap = |t| t == PortType::SnapFit;
            let Some((a, b)) = ends(facts, mate, snap, snap) else {
                continue;
            };
            let Some(seen) = a.sees(&b) else {
                out.push(Ruling::unplaced(self.axiom(), about(mate)));
                continue;
            };
            let (o, [x, _, _]) = (seen.origin(), seen.axes());
            // Half extents of the other face along this one's x and y: of the rectangle about it.
            let (length, width) = (b.port.value("overlap") / 2.0, b.port.value("width") / 2.0);
            let along = x.x.abs() * length + x.y.abs() * width;
            let across = x.y.abs() * length + x.x.abs() * width;
            let common_x = a.port.value("overlap") / 2.0 + along - o.x.abs();
            let common_y = a.port.value("width") / 2.0 + across - o.y.abs();
            let faces = 180.0 - z_angle_deg(&seen) <= NEAR_DEG;
            let holds = faces && common_x > 0.0 && common_y > 0.0;
            let message = if !faces {
                format!(
                    "the locking faces of '{}' and '{}' do not face each other",
                    a.part.id, b.part.id
                )
            } else if holds {
                format!("'{}' and '{}' hook over each other", a.part.id, b.part.id)
            } else {
                format!(
                    "the locking faces of '{}' and '{}' pass each other by",
                    a.part.id, b.part.id
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, about(mate), message)
                    .value("overlap_mm", common_x)
                    .value("overlap_across_mm", common_y),
            );
        }
        out
    }
}
