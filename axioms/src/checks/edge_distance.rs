//! N-03: edge distance of holes.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::of_class;
use crate::ruling::{About, Ruling};
use assemcad_model::ports::PortType;

/// A hole in a plate keeps 1.2 hole diameters between its axis and the edges.
pub struct EdgeDistance;

/// Distance from the hole's axis to the edge, in hole diameters: EN 1993-1-8, table 3.3, least e1 and e2.
const EDGE: f64 = 1.2;

impl Check for EdgeDistance {
    fn id(&self) -> &'static str {
        "edge_distance"
    }

    fn axiom(&self) -> &'static str {
        "N-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        // Plates only: the faces of other parts end at walls and circles too, which is not known here.
        for part in of_class(facts, Class::Plate) {
            let faces = || {
                part.ports
                    .iter()
                    .filter(|p| p.port_type == PortType::FlatFace)
            };
            for hole in part
                .ports
                .iter()
                .filter(|p| p.port_type == PortType::ClearanceHole)
            {
                let d = hole.value("diameter");
                let Ok(at) = hole.frame.placement() else {
                    continue;
                };
                let mut nearest: Option<f64> = None;
                for face in faces() {
                    let Ok(on) = face.frame.placement() else {
                        continue;
                    };
                    let seen = on.inverse() * at;
                    let o = seen.origin();
                    if crate::geometry::z_angle_deg(&seen) > crate::geometry::NEAR_DEG
                        || o.z.abs() > crate::geometry::NEAR_MM
                    {
                        continue;
                    }
                    let x = face.value("extent_x") / 2.0 - o.x.abs();
                    let y = face.value("extent_y") / 2.0 - o.y.abs();
                    let e = x.min(y);
                    nearest = Some(nearest.map_or(e, |n| n.min(e)));
                }
                let Some(e) = nearest else { continue };
                let least = EDGE * d;
                let message = format!(
                    "the axis of '{}' in '{}' is {e:.3} mm from the edge; {least:.3} mm is the least",
                    hole.name, part.id
                );
                out.push(
                    Ruling::held(
                        self.axiom(),
                        e >= least - 1e-9,
                        About::parts([&part.id]),
                        message,
                    )
                    .value("edge_mm", e)
                    .value("least_mm", least),
                );
            }
        }
        out
    }
}
