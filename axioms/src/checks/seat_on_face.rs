//! C-04: a seat lies on its face.

use super::Check;
use crate::facts::Side;
use crate::geometry::NEAR_MM;
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

/// The whole seat lies within the face that carries it.
pub struct SeatOnFace;

/// Half the extents of a face along its x and y.
fn half(side: &Side<'_>) -> Option<(f64, f64)> {
    let (x, y) = match side.port.port_type {
        PortType::FlatFace => ("extent_x", "extent_y"),
        PortType::SnapFit => ("overlap", "width"),
        PortType::BoltSeat => ("outer_diameter", "outer_diameter"),
        _ => return None,
    };
    Some((side.port.value(x) / 2.0, side.port.value(y) / 2.0))
}

impl Check for SeatOnFace {
    fn id(&self) -> &'static str {
        "seat_on_face"
    }

    fn axiom(&self) -> &'static str {
        "C-04"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for m in facts
            .mates
            .iter()
            .filter(|m| m.mate_type == MateType::SnapToFace)
        {
            let Some((face, seat)) = facts.sides(m) else {
                continue;
            };
            let Some(seen) = face.sees(&seat) else {
                out.push(Ruling::unplaced(self.axiom(), about(m)));
                continue;
            };
            let (Some((x, y)), Some((u, v))) = (half(&face), half(&seat)) else {
                continue;
            };
            let (o, [dx, _, _]) = (seen.origin(), seen.axes());
            // The rectangle about the turned seat, along the face's own axes.
            let (along, across) = if seat.is(PortType::BoltSeat) {
                (u, v)
            } else {
                (
                    dx.x.abs() * u + dx.y.abs() * v,
                    dx.y.abs() * u + dx.x.abs() * v,
                )
            };
            let over = (o.x.abs() + along - x).max(o.y.abs() + across - y);
            let holds = over <= NEAR_MM;
            let message = if holds {
                format!("the seat {} lies on {}", m.incoming, m.base)
            } else {
                format!(
                    "the seat {} hangs {over:.3} mm over the edge of {}",
                    m.incoming, m.base
                )
            };
            out.push(
                Ruling::held(self.axiom(), holds, about(m), message)
                    .value("over_the_edge_mm", over.max(0.0)),
            );
        }
        out
    }
}
