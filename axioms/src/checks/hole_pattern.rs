//! N-07: hole patterns of joined parts agree.

use assemcad_model::frame::Placement;
use assemcad_model::mates::MateType;
use assemcad_model::ports::{Port, PortType};

use super::Check;
use crate::facts::Side;
use crate::geometry::{NEAR_DEG, NEAR_MM, askew_deg};
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::Ruling;

/// Where two faces lie on each other, the clearance and threaded holes of the part with fewer of them meet
/// those of the other. Plain holes may be anything and are not compared.
pub struct HolePattern;

/// A hole that opens into a joint: where, and the play that it leaves its bolt.
struct Opening {
    x: f64,
    y: f64,
    play: f64,
}

impl Check for HolePattern {
    fn id(&self) -> &'static str {
        "hole_pattern"
    }

    fn axiom(&self) -> &'static str {
        "N-07"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for m in facts
            .mates
            .iter()
            .filter(|m| m.mate_type == MateType::FaceToFace)
        {
            let Some((base, incoming)) = facts.sides(m) else {
                continue;
            };
            let flat = base.is(PortType::FlatFace) && incoming.is(PortType::FlatFace);
            let parts = [base.part.class(), incoming.part.class()];
            if !flat || parts.iter().any(|c| c.is_fastener()) {
                continue;
            }
            let (Some(a), Some(b)) = (openings(&base, &incoming), openings(&incoming, &base))
            else {
                out.push(Ruling::unplaced(self.axiom(), about(m)));
                continue;
            };
            // Fewer than two holes are no pattern.
            if a.len() < 2 || b.len() < 2 {
                continue;
            }
            // The two faces see the joint mirrored; the world has one view of it.
            let meets = |h: &Opening, k: &Opening| {
                libm::hypot(h.x - k.x, h.y - k.y) <= (h.play + k.play) / 2.0 + NEAR_MM
            };
            let (few, many) = if a.len() <= b.len() {
                (&a, &b)
            } else {
                (&b, &a)
            };
            let met = few
                .iter()
                .filter(|h| many.iter().any(|k| meets(h, k)))
                .count();
            let lacking = few.len() - met;
            let names = format!("'{}' and '{}'", base.part.id, incoming.part.id);
            let message = if lacking == 0 {
                format!("the {met} holes between {names} are in line")
            } else {
                format!(
                    "{lacking} of {} holes between {names} meet no hole",
                    few.len()
                )
            };
            out.push(
                Ruling::held(self.axiom(), lacking == 0, about(m), message)
                    .value("in_line", met as f64)
                    .value("not_in_line", lacking as f64),
            );
        }
        out
    }
}

/// The holes of a side's part that open into the common rectangle of the two faces, in the frame of the
/// face that comes first by its part's name, so that both sides are told alike.
fn openings(side: &Side<'_>, other: &Side<'_>) -> Option<Vec<Opening>> {
    let (own, far) = (side.world()?, other.world()?);
    let view = if side.part.id <= other.part.id {
        own
    } else {
        far
    };
    let mut out = Vec::new();
    for port in &side.part.ports {
        let play = match port.port_type {
            PortType::ClearanceHole => port.value("diameter") - port.value("bolt_diameter"),
            PortType::ThreadInternal => 0.0,
            _ => continue,
        };
        let at = side.part.world(port)?;
        if !opens(port, &(own.inverse() * at)) {
            continue;
        }
        let within = |face: &Side<'_>, frame: &Placement| {
            let o = (frame.inverse() * at).origin();
            let reach = |name| face.port.value(name) / 2.0;
            o.x.abs() <= reach("extent_x") && o.y.abs() <= reach("extent_y")
        };
        if within(side, &own) && within(other, &far) {
            let o = (view.inverse() * at).origin();
            let same = |h: &Opening| libm::hypot(h.x - o.x, h.y - o.y) <= NEAR_MM;
            // The two mouths of one hole may both be ports.
            if !out.iter().any(same) {
                out.push(Opening {
                    x: o.x,
                    y: o.y,
                    play,
                });
            }
        }
    }
    Some(out)
}

/// Whether a hole, seen from a face, has its mouth or its other end in the face.
fn opens(port: &Port, seen: &Placement) -> bool {
    let [_, _, z] = seen.axes();
    let mouth = seen.origin().z;
    let end = mouth - z.z * port.value("depth");
    askew_deg(seen) <= NEAR_DEG && (mouth.abs() <= NEAR_MM || end.abs() <= NEAR_MM)
}
