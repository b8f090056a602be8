//! Screws in threaded holes that no mate engages.

use assemcad_model::ports::{Port, PortType};
use assemcad_model::report::rounded;
use assemcad_model::spec::Assembly;
use assemcad_placing::Assembled;
use nalgebra::Vector3;
use serde_json::{Value, json};

/// How far the two axes may be off each other, in mm, and their directions, as a sine.
const OFF: f64 = 1e-6;

/// The `mate` call that engages a thread of one part in a threaded hole of the other, as they are placed;
/// none where there are no such threads, or a mate engages them already.
pub(super) fn engage(
    spec: &Assembly,
    assembled: &Assembled<'_>,
    (i, j): (usize, usize),
) -> Option<Value> {
    let (resolved, placements) = (assembled.resolved, assembled.placements);
    for (hole_part, screw_part) in [(i, j), (j, i)] {
        let (with_hole, with_screw) = (
            resolved.parts.get(hole_part)?,
            resolved.parts.get(screw_part)?,
        );
        let (at_hole, at_screw) = (placements.of(hole_part)?, placements.of(screw_part)?);
        for hole in ports(with_hole.ports(), PortType::ThreadInternal) {
            for screw in ports(with_screw.ports(), PortType::ThreadExternal) {
                let (h, s) = (at_hole.frame(&hole.frame), at_screw.frame(&screw.frame));
                let Some((engaged, through)) =
                    depths(hole, screw, (h.origin, h.z), (s.origin, s.z))
                else {
                    continue;
                };
                let base = format!("{}:{}", with_hole.id, hole.name);
                let incoming = format!("{}:{}", with_screw.id, screw.name);
                return Some(json!({
                    "assembly": spec.id, "id": free_name(spec, &with_screw.id), "mate_type": "thread_engage",
                    "base": base, "incoming": incoming, "d_t_mm": rounded(engaged),
                    "through_mm": rounded(through),
                }));
            }
        }
    }
    None
}

fn ports(all: &[Port], port_type: PortType) -> impl Iterator<Item = &Port> {
    all.iter().filter(move |p| p.port_type == port_type)
}

/// Origin and z of a port in the world.
type Axis = ([f64; 3], [f64; 3]);

/// How long the thread is engaged, and how far the screw's end stands out of the far side; none where the
/// threads do not fit or do not reach each other.
fn depths(hole: &Port, screw: &Port, h: Axis, s: Axis) -> Option<(f64, f64)> {
    let value = |p: &Port, name: &str| p.params.get(name).copied();
    for name in ["diameter", "pitch", "hand"] {
        let fits = (value(hole, name)? - value(screw, name)?).abs() <= 1e-9;
        if !fits {
            return None;
        }
    }
    let (out, along) = (Vector3::from(h.1), Vector3::from(s.1));
    let arm = Vector3::from(s.0) - Vector3::from(h.0);
    let inside = -arm.dot(&out);
    let off = (arm + out * inside).norm();
    if off > OFF || along.cross(&out).norm() > OFF || along.dot(&out) > 0.0 {
        return None;
    }
    let engaged = inside.min(value(hole, "depth")?);
    let through = inside - engaged;
    (engaged > 0.0 && inside <= value(screw, "length")? + OFF).then_some((engaged, through))
}

/// A name that no mate has.
fn free_name(spec: &Assembly, screw: &str) -> String {
    let stem: String = format!("{screw}_thread").chars().take(60).collect();
    let mut name = stem.clone();
    let mut n = 1;
    while spec.mate(&name).is_some() {
        n += 1;
        name = format!("{stem}_{n}");
    }
    name
}
