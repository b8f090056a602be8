//! `coaxial_face`: axis on axis and seat on seat, as a bolt's head in its counterbore. Leaves the spin
//! free, but none where a fastener is seated: friction holds it.

use super::{
    Condition, Contact, Freedom, Joint, MateKind, MateType, Residual, SPIN, at_most, bond, degrees,
    distance_mm, millimetres, no_overlap, no_play, opposed_residual_deg, over,
};
use crate::frame::Placement;
use crate::ports::Port;
use crate::ports::PortType::{
    BoltSeat, Bore, CboreSeat, ClearanceHole, FlatFace, Hole, ThreadInternal,
};

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::CoaxialFace,
    name: "coaxial_face",
    doc: "Puts axis on axis and seat on seat, z axes opposed, lifted by d along the base port's z.",
    pairs: &[
        (BoltSeat, BoltSeat),
        (BoltSeat, Bore),
        (BoltSeat, CboreSeat),
        (BoltSeat, ClearanceHole),
        (BoltSeat, FlatFace),
        (BoltSeat, Hole),
        (BoltSeat, ThreadInternal),
        (Bore, BoltSeat),
        (CboreSeat, BoltSeat),
        (ClearanceHole, BoltSeat),
        (FlatFace, BoltSeat),
        (FlatFace, FlatFace),
        (Hole, BoltSeat),
        (ThreadInternal, BoltSeat),
    ],
    options: || {
        vec![
            millimetres("d_mm", "gap between the seats along the base port's z"),
            degrees("alpha_deg", "turn about the incoming port's z"),
            bond(),
        ]
    },
    relative,
    residual,
    conditions,
    freedom: |j| {
        if seated(j) || j.bonded() {
            Freedom::none()
        } else {
            Freedom::of(&[SPIN])
        }
    },
    contact: |j| (j.number("d_mm") == 0.0).then_some(Contact::Face),
    overlap: no_overlap,
    radial_play: no_play,
};

/// Whether a fastener sits.
fn seated(j: &Joint<'_>) -> bool {
    j.base.port_type == BoltSeat || j.incoming.port_type == BoltSeat
}

fn relative(j: &Joint<'_>) -> Placement {
    Placement::translation(0.0, 0.0, j.number("d_mm"))
        * Placement::rotation_x(180.0)
        * Placement::rotation_z(j.number("alpha_deg"))
}

/// The turn is not constrained: a round seat holds at any.
fn residual(j: &Joint<'_>, actual: &Placement) -> Residual {
    Residual {
        distance_mm: distance_mm(actual, j.number("d_mm")),
        angle_deg: opposed_residual_deg(actual),
    }
}

/// The seat is wider than the hole that it spans, and goes into its counterbore.
fn conditions(j: &Joint<'_>) -> Vec<Condition> {
    let (seat, other) = match (j.base.port_type, j.incoming.port_type) {
        (BoltSeat, BoltSeat) => return Vec::new(),
        (BoltSeat, _) => (j.base, j.incoming),
        (_, BoltSeat) => (j.incoming, j.base),
        _ => return Vec::new(),
    };
    let hole = match other.port_type {
        CboreSeat => other.value("hole_diameter"),
        FlatFace => other.value("hole_diameter"),
        _ => other.value("diameter"),
    };
    let outer = seat.value("outer_diameter");
    let mut out = Vec::new();
    if !over(outer, hole) {
        out.push(unfit(seat, other, outer, &format!("more than {hole} mm")));
    }
    if other.port_type == CboreSeat {
        let most = other.value("diameter");
        if !at_most(outer, most) {
            out.push(unfit(seat, other, outer, &format!("at most {most} mm")));
        }
    }
    out
}

fn unfit(seat: &Port, other: &Port, outer: f64, expected: &str) -> Condition {
    Condition {
        message: format!(
            "the seat '{}' is {outer} mm wide and does not fit '{}'",
            seat.name, other.name
        ),
        found: outer,
        expected: format!("an outer diameter of {expected}"),
    }
}

#[cfg(test)]
mod tests {
    use crate::mates::tests::{joined, port};
    use crate::ports::PortType::{BoltSeat, CboreSeat, FlatFace};
    use serde_json::json;

    #[test]
    fn a_head_fits_its_counterbore() {
        let floor = port(
            CboreSeat,
            &[("diameter", 11.0), ("depth", 6.0), ("hole_diameter", 6.6)],
        );
        let head = |d: f64| port(BoltSeat, &[("inner_diameter", 6.0), ("outer_diameter", d)]);
        let faults = |d| {
            joined("coaxial_face", &floor, &head(d), json!({}), |k, j| {
                k.conditions(j).len()
            })
        };
        assert_eq!(
            (faults(10.0), faults(11.5), faults(6.6), faults(f64::NAN)),
            (0, 1, 1, 2)
        );
        let free = |a, b| {
            joined("coaxial_face", a, b, json!({}), |k, j| {
                k.freedom(j).twists.len()
            })
        };
        let face = port(FlatFace, &[]);
        assert_eq!((free(&floor, &head(10.0)), free(&face, &face)), (0, 1));
    }
}
