//! `coaxial`: two cylindrical axes on one line. Leaves one spin and one slide free.

use super::{
    Condition, Contact, Joint, MateKind, MateType, Residual, SLIDE_Z, SPIN, along_axis,
    axial_residual_deg, bond, degrees, direction, millimetres, no_overlap, off_axis_mm,
    unless_bonded,
};
use crate::frame::Placement;
use crate::ports::Port;
use crate::ports::PortType::{
    Bore, CboreSeat, ClearanceHole, Hole, PressFit, Shaft, ThreadExternal, ThreadInternal,
};

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::Coaxial,
    name: "coaxial",
    doc: "Puts the two axes on one line, the incoming port's origin d along the base port's z from \
          the base port's origin; z axes opposed unless direction is 'same'.",
    pairs: &[
        // A bore in line with a bore is the paper's own example (housing and gear), and holes in line
        // with holes are how bolt patterns are laid over each other.
        (Bore, Bore),
        (Bore, ClearanceHole),
        (Bore, Hole),
        (Bore, PressFit),
        (Bore, Shaft),
        (Bore, ThreadExternal),
        (Bore, ThreadInternal),
        (CboreSeat, ClearanceHole),
        (CboreSeat, Hole),
        (CboreSeat, ThreadInternal),
        (ClearanceHole, Bore),
        (ClearanceHole, CboreSeat),
        (ClearanceHole, ClearanceHole),
        (ClearanceHole, Hole),
        (ClearanceHole, Shaft),
        (ClearanceHole, ThreadExternal),
        (ClearanceHole, ThreadInternal),
        (Hole, Bore),
        (Hole, CboreSeat),
        (Hole, ClearanceHole),
        (Hole, Hole),
        (Hole, PressFit),
        (Hole, Shaft),
        (Hole, ThreadExternal),
        (Hole, ThreadInternal),
        (PressFit, Bore),
        (PressFit, Hole),
        (Shaft, Bore),
        (Shaft, ClearanceHole),
        (Shaft, Hole),
        (ThreadExternal, Bore),
        (ThreadExternal, ClearanceHole),
        (ThreadExternal, Hole),
        (ThreadInternal, Bore),
        (ThreadInternal, CboreSeat),
        (ThreadInternal, ClearanceHole),
        (ThreadInternal, Hole),
        (ThreadInternal, ThreadInternal),
    ],
    options: || {
        vec![
            millimetres("d_mm", "distance of the origins along the base port's z"),
            degrees("alpha_deg", "turn about the incoming port's z"),
            direction(),
            bond(),
        ]
    },
    relative,
    residual,
    conditions,
    freedom: |j| unless_bonded(j, &[SPIN, SLIDE_Z]),
    // A cylinder as thick as its hole has a seat there; with play it may float.
    contact: |j| (radial_play(j) == Some(0.0)).then_some(Contact::Cylinder),
    overlap: no_overlap,
    radial_play,
};

fn relative(j: &Joint<'_>) -> Placement {
    along_axis(j, j.number("d_mm"))
}

fn residual(j: &Joint<'_>, actual: &Placement) -> Residual {
    Residual {
        distance_mm: off_axis_mm(actual),
        angle_deg: axial_residual_deg(j, actual),
    }
}

/// The hole and what goes into it; none for two holes in line.
fn hole_and_inside<'a>(j: &Joint<'a>) -> Option<(&'a Port, &'a Port)> {
    let inside = |p: &Port| matches!(p.port_type, PressFit | Shaft | ThreadExternal);
    match (inside(j.base), inside(j.incoming)) {
        (true, false) => Some((j.incoming, j.base)),
        (false, true) => Some((j.base, j.incoming)),
        _ => None,
    }
}

/// The outer diameter of what goes inside. A screw is as thick as its nominal diameter.
fn play(j: &Joint<'_>) -> Option<(f64, f64)> {
    let (hole, inside) = hole_and_inside(j)?;
    Some((hole.value("diameter"), inside.value("diameter")))
}

fn radial_play(j: &Joint<'_>) -> Option<f64> {
    play(j).map(|(hole, inside)| (hole - inside) / 2.0)
}

/// What goes inside is not thicker than the hole around it. Fits tighter than that are another mate's.
fn conditions(j: &Joint<'_>) -> Vec<Condition> {
    let (Some((hole, inside)), Some((d_hole, d_inside))) = (hole_and_inside(j), play(j)) else {
        return Vec::new();
    };
    // Written so that an unknown diameter is not taken for a fit.
    if d_inside <= d_hole {
        return Vec::new();
    }
    vec![Condition {
        message: format!(
            "'{}' is {d_inside} mm thick and does not go into '{}' of {d_hole} mm",
            inside.name, hole.name
        ),
        found: d_inside,
        expected: format!("a diameter of at most {d_hole} mm; press_fit allows more"),
    }]
}

#[cfg(test)]
mod tests {
    use crate::mates::tests::{joined, port};
    use crate::ports::Port;
    use crate::ports::PortType::{Bore, Shaft};
    use serde_json::json;

    #[test]
    fn a_shaft_thicker_than_its_bore_is_refused_either_way_round() {
        let bore = port(Bore, &[("diameter", 20.0), ("depth", 10.0)]);
        let shaft = |d: f64| port(Shaft, &[("diameter", d), ("length", 10.0)]);
        let faults =
            |a: &Port, b: &Port| joined("coaxial", a, b, json!({}), |k, j| k.conditions(j).len());
        assert_eq!(faults(&bore, &shaft(20.01)), 1);
        assert_eq!(faults(&shaft(20.01), &bore), 1);
        assert_eq!(faults(&bore, &shaft(20.0)), 0);
        assert_eq!(faults(&bore, &bore), 0);
        // An unknown diameter is not taken for a fit.
        assert_eq!(faults(&bore, &port(Shaft, &[])), 1);
        let play = |d| {
            joined("coaxial", &bore, &shaft(d), json!({}), |k, j| {
                k.radial_play(j)
            })
        };
        assert_eq!(play(19.5), Some(0.25));
        assert_eq!(play(20.0), Some(0.0));
    }
}
