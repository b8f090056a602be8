//! Axes that a mate lays on one line: the shaft is guided by the hole, or the mate says more than is there.

use assemcad_axioms::Class;
use assemcad_facts::{PairMeetings, guides};
use assemcad_geometry::narrow::meet::{About, Kind};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::MateType;
use assemcad_model::ports::{Port, PortType};
use assemcad_model::report::{Finding, MateFacts, Verdict, rounded};
use assemcad_placing::{Assembled, ResolvedMate};
use nalgebra::Vector3;
use serde_json::{Map, json};

type V = Vector3<f64>;

/// How far the axis of a contact may be off the mate's, in mm and as a sine.
const ON_AXIS: (f64, f64) = (0.5, 1e-3);

/// The least share of the shorter of two seats that they have in common. Ours.
const LEAST_SHARE: f64 = 0.4;

/// The widest play of a bearing's ring on its seat, in mm on the diameter: more than any seat of ISO 286 for bearings.
const RING_MM: f64 = 0.1;

/// The length of the shorter of a mate's two seats.
fn shorter(m: &ResolvedMate) -> f64 {
    let of = |p: &Port| {
        let named = ["depth", "length"];
        let length = named.iter().find_map(|n| p.params.get(*n).copied());
        length.unwrap_or(f64::INFINITY)
    };
    let least = of(&m.base_port).min(of(&m.incoming_port));
    if least.is_finite() { least } else { 0.0 }
}

/// Holes that guide nothing: of mates of a shaft in a bore or a hole. A clearance hole is wide on purpose, and holds
/// nothing by itself.
pub(super) fn told(
    assembled: &Assembled<'_>,
    pairs: &[PairMeetings],
    facts: &[MateFacts],
) -> Vec<Finding> {
    let mates = assembled.resolved.mates.iter();
    mates
        .zip(facts)
        // Where the contact that the mate promises is missing, that was told.
        .filter(|(_, f)| f.contact != Some(Verdict::Fail))
        .map(|(m, _)| m)
        .filter(|m| guiding(m) && !guided(assembled, m, pairs))
        .filter_map(finding)
        .collect()
}

fn guiding(m: &ResolvedMate) -> bool {
    use PortType::{Bore, Hole, PressFit, Shaft};
    let types = (m.base_port.port_type, m.incoming_port.port_type);
    let fits = matches!(
        types,
        (Bore | Hole, Shaft | PressFit) | (Shaft | PressFit, Bore | Hole)
    );
    fits && matches!(m.mate.mate_type, MateType::Coaxial | MateType::PressFit)
}

fn guided(assembled: &Assembled<'_>, m: &ResolvedMate, pairs: &[PairMeetings]) -> bool {
    let Some(at) = assembled.placements.of(m.base) else {
        return true;
    };
    let frame = at.frame(&m.base_port.frame);
    let (point, axis) = (V::from(frame.origin), V::from(frame.z));
    let on_axis = |about: &About| {
        let arm = V::from(about.point) - point;
        (arm - axis * arm.dot(&axis)).norm() <= ON_AXIS.0
            && V::from(about.direction).cross(&axis).norm() <= ON_AXIS.1
    };
    let rings = [m.base, m.incoming].iter().any(|p| {
        let part = assembled.resolved.parts.get(*p);
        part.is_some_and(|p| Class::of_factory(&p.factory) == Class::BallBearing)
    });
    let play_mm = if rings { RING_MM } else { f64::INFINITY };
    let ends = [(m.base, m.incoming), (m.incoming, m.base)];
    let own = pairs.iter().filter(|p| ends.contains(&(p.a, p.b)));
    own.flat_map(|p| &p.meetings).any(|meeting| {
        let far_enough = |about: &About| {
            let [from, to] = about.range;
            to - from >= LEAST_SHARE * shorter(m)
        };
        meeting.kind == Kind::Cylinder
            && meeting
                .about
                .as_ref()
                .is_some_and(|a| on_axis(a) && far_enough(a))
            && guides(meeting)
            && 2.0 * meeting.gap_mm <= play_mm
    })
}

fn finding(m: &ResolvedMate) -> Option<Finding> {
    let (hole, shaft) = match m.base_port.port_type {
        PortType::Bore | PortType::Hole => (&m.base_port, &m.incoming_port),
        _ => (&m.incoming_port, &m.base_port),
    };
    let (wide, thick) = (hole.params.get("diameter")?, shaft.params.get("diameter")?);
    let mut values = Map::new();
    values.insert("hole_diameter_mm".to_owned(), json!(rounded(*wide)));
    values.insert("shaft_diameter_mm".to_owned(), json!(rounded(*thick)));
    let d = Diagnostic::error(
        Code::NotHeld,
        format!("mate '{}'", m.mate.id),
        format!(
            "'{}' and '{}' do not guide each other: no cylinder of the one ({} mm) lies in a hole of the other ({} mm) \
             with less play than the loosest running fit",
            m.mate.base,
            m.mate.incoming,
            rounded(*thick),
            rounded(*wide)
        ),
    )
    .found(rounded(wide - thick))
    .expected("diameters that differ by no more than H11/a11 of ISO 286 has play, and some length in common")
    .hint("make the hole and what is in it fit (H7/g6 to turn, H7/h6 to locate), or see whether they reach each other");
    Some(Finding {
        verdict: Verdict::Fail,
        check: super::CHECK.to_owned(),
        parts: vec![m.mate.base.part.clone(), m.mate.incoming.part.clone()],
        mates: vec![m.mate.id.clone()],
        values,
        axioms: Vec::new(),
        diagnostic: d,
    })
}
