//! `press_fit`: a cylinder in a hole that is no wider. Leaves nothing free: friction holds it.

use core::f64::consts::PI;

use super::{
    Condition, Contact, Freedom, Joint, MateKind, MateType, Overlap, Residual, along_axis, at_most,
    axial_residual_deg, common_length, degrees, direction, distance_mm, millimetres, over,
};
use crate::frame::Placement;
use crate::ports::Port;
use crate::ports::PortType::{Bore, Hole, PressFit, Shaft};

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::PressFit,
    name: "press_fit",
    doc: "Presses a cylinder into a hole that is no wider, the incoming port's origin d along the base \
          port's z from the base port's origin; z axes opposed unless direction is 'same'.",
    pairs: &[
        (Bore, PressFit),
        (Bore, Shaft),
        (Hole, PressFit),
        (Hole, Shaft),
        (PressFit, Bore),
        (PressFit, Hole),
        (Shaft, Bore),
        (Shaft, Hole),
    ],
    options: || {
        vec![
            millimetres("d_mm", "distance of the origins along the base port's z"),
            degrees("alpha_deg", "turn about the incoming port's z"),
            direction(),
        ]
    },
    relative: |j| along_axis(j, j.number("d_mm")),
    residual,
    conditions,
    freedom: |_| Freedom::none(),
    contact: |_| Some(Contact::Cylinder),
    overlap,
    radial_play: |j| {
        let (hole, shaft) = hole_and_shaft(j);
        Some((hole.value("diameter") - shaft.value("diameter")) / 2.0)
    },
};

/// The turn is not constrained: it holds at any.
fn residual(j: &Joint<'_>, actual: &Placement) -> Residual {
    Residual {
        distance_mm: distance_mm(actual, j.number("d_mm")),
        angle_deg: axial_residual_deg(j, actual),
    }
}

fn hole_and_shaft<'a>(j: &Joint<'a>) -> (&'a Port, &'a Port) {
    match j.base.port_type {
        Bore | Hole => (j.base, j.incoming),
        _ => (j.incoming, j.base),
    }
}

fn conditions(j: &Joint<'_>) -> Vec<Condition> {
    let (hole, shaft) = hole_and_shaft(j);
    let (d_hole, d_shaft) = (hole.value("diameter"), shaft.value("diameter"));
    let mut out = Vec::new();
    // Written so that an unknown diameter is not taken for a fit.
    if !at_most(d_hole, d_shaft) {
        out.push(Condition {
            message: format!(
                "'{}' is {d_shaft} mm thick and sits loose in '{}' of {d_hole} mm",
                shaft.name, hole.name
            ),
            found: d_shaft,
            expected: format!("a diameter of at least {d_hole} mm; coaxial allows less"),
        });
    }
    let common = common_length(j, j.number("d_mm"));
    if !over(common, 0.0) {
        out.push(Condition {
            message: format!(
                "at d_mm = {} '{}' is not in '{}' at all",
                j.number("d_mm"),
                shaft.name,
                hole.name
            ),
            found: common,
            expected: "seats that have some of their length in common".to_owned(),
        });
    }
    out
}

/// The ring between the two diameters, over the length that the seats have in common:
/// `pi / 4 (d_s^2 - d_h^2) l`.
fn overlap(j: &Joint<'_>) -> Overlap {
    let (hole, shaft) = hole_and_shaft(j);
    let (h, s) = (hole.value("diameter"), shaft.value("diameter"));
    // As a product, which keeps its digits where the diameters are nearly equal.
    let volume = PI / 4.0 * (s - h) * (s + h) * common_length(j, j.number("d_mm"));
    Overlap {
        least_mm3: volume,
        most_mm3: volume,
        why: "the ring between the diameters of the press fit".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use crate::mates::tests::{joined, port};
    use crate::ports::PortType::{Bore, Hole, PressFit, Shaft};
    use serde_json::json;

    #[test]
    fn the_ring_between_the_diameters() {
        // 20.01 in 20.00 over 10 mm: pi/4 (20.01^2 - 20^2) 10 = pi/4 * 0.4001 * 10.
        let bore = port(Bore, &[("diameter", 20.0), ("depth", 10.0)]);
        let shaft = port(Shaft, &[("diameter", 20.01), ("length", 30.0)]);
        let wanted = core::f64::consts::PI * 1.00025;
        for (a, b, d) in [
            (&bore, &shaft, -5.0),
            (&shaft, &bore, -5.0),
            (&bore, &shaft, 5.0),
        ] {
            for direction in ["opposed", "same"] {
                let o = joined(
                    "press_fit",
                    a,
                    b,
                    json!({"d_mm": d, "direction": direction}),
                    |k, j| (k.overlap(j), k.conditions(j)),
                );
                // Bore from -10 to 0. A shaft of 30 mm about -5 covers it; about 5, too (-10 to 20).
                // Seen from the shaft (-15 to 15) the bore's mouth is at -5: it spans -15 to -5 or, turned
                // over, -5 to 5, both within the shaft.
                assert!((o.0.most_mm3 - wanted).abs() < 1e-9, "{:?}", o.0);
                assert_eq!(o.0.least_mm3, o.0.most_mm3);
                assert!(o.1.is_empty());
            }
        }
        // Half in: the shaft covers -15 + 10 to 25, of which the bore has 5 mm.
        let half = joined("press_fit", &bore, &shaft, json!({"d_mm": 10}), |k, j| {
            k.overlap(j).most_mm3
        });
        assert!((half - wanted / 2.0).abs() < 1e-9);
    }

    #[test]
    fn loose_or_apart_is_refused() {
        let hole = port(Hole, &[("diameter", 20.0), ("depth", 10.0)]);
        let ring = |d: f64| port(PressFit, &[("diameter", d), ("length", 10.0)]);
        let faults = |d, at: f64| {
            joined("press_fit", &hole, &ring(d), json!({"d_mm": at}), |k, j| {
                k.conditions(j).len()
            })
        };
        assert_eq!(
            (faults(20.0, -5.0), faults(19.999, -5.0), faults(20.0, 5.0)),
            (0, 1, 1)
        );
        assert_eq!((faults(f64::NAN, 0.0), faults(19.0, 50.0)), (1, 2));
    }
}
