//! `coaxial`: two cylindrical axes on one line. Leaves one spin and one slide free.

use nalgebra::Vector3;

use super::{Condition, MateKind, MateType, Options, Residual, degrees, millimetres};
use crate::angle::between_deg;
use crate::frame::Placement;
use crate::param::{ParamKind, ParamSpec};
use crate::ports::Port;
use crate::ports::PortType::{Bore, PressFit, Shaft};

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::Coaxial,
    name: "coaxial",
    doc: "Puts the two axes on one line, the incoming port's origin d along the base port's z from \
          the base port's origin; z axes opposed unless direction is 'same'.",
    // A bore in line with a bore is the paper's own example (housing and gear).
    pairs: &[
        (Bore, Bore),
        (Bore, PressFit),
        (Bore, Shaft),
        (PressFit, Bore),
        (Shaft, Bore),
    ],
    options: || {
        vec![
            millimetres("d_mm", "distance of the origins along the base port's z"),
            degrees("alpha_deg", "turn about the incoming port's z"),
            ParamSpec {
                name: "direction".to_owned(),
                doc: "whether the ports' z axes look against each other or the same way".to_owned(),
                kind: ParamKind::Choice {
                    choices: vec!["opposed".to_owned(), "same".to_owned()],
                    default: "opposed".to_owned(),
                },
            },
        ]
    },
    relative,
    residual,
    conditions,
};

fn same(o: &Options) -> bool {
    o.word("direction") == "same"
}

fn relative(o: &Options) -> Placement {
    let flip = if same(o) {
        Placement::IDENTITY
    } else {
        Placement::rotation_x(180.0)
    };
    Placement::translation(0.0, 0.0, o.number("d_mm"))
        * flip
        * Placement::rotation_z(o.number("alpha_deg"))
}

fn residual(o: &Options, actual: &Placement) -> Residual {
    let [_, _, z] = actual.axes();
    let wanted = if same(o) { Vector3::z() } else { -Vector3::z() };
    let origin = actual.origin();
    Residual {
        distance_mm: libm::hypot(origin.x, origin.y),
        angle_deg: between_deg(&z, &wanted),
    }
}

/// What goes inside is not thicker than the hole around it. Fits tighter than that are another mate's.
fn conditions(base: &Port, incoming: &Port) -> Vec<Condition> {
    let (hole, inside) = match (base.port_type, incoming.port_type) {
        (Bore, Bore) => return Vec::new(),
        (Bore, _) => (base, incoming),
        _ => (incoming, base),
    };
    let diameter = |p: &Port| p.params.get("diameter").copied().unwrap_or(f64::NAN);
    let (d_hole, d_inside) = (diameter(hole), diameter(inside));
    if d_inside <= d_hole {
        return Vec::new();
    }
    vec![Condition {
        message: format!(
            "'{}' is {d_inside} mm thick and does not go into '{}' of {d_hole} mm",
            inside.name, hole.name
        ),
        found: d_inside,
        expected: format!("a diameter of at most {d_hole} mm"),
    }]
}

#[cfg(test)]
mod tests {
    use super::conditions;
    use crate::frame::Frame;
    use crate::ports::{Port, PortType};
    use std::collections::BTreeMap;

    fn port(port_type: PortType, diameter: f64) -> Port {
        Port {
            name: "p".to_owned(),
            port_type,
            frame: Frame::WORLD,
            params: BTreeMap::from([("diameter".to_owned(), diameter)]),
        }
    }

    #[test]
    fn a_shaft_thicker_than_its_bore_is_refused_either_way_round() {
        let (bore, shaft) = (port(PortType::Bore, 20.0), port(PortType::Shaft, 20.01));
        assert_eq!(conditions(&bore, &shaft).len(), 1);
        assert_eq!(conditions(&shaft, &bore).len(), 1);
        assert_eq!(conditions(&bore, &port(PortType::Shaft, 20.0)), Vec::new());
        assert_eq!(conditions(&bore, &port(PortType::Bore, 30.0)), Vec::new());
    }

    #[test]
    fn an_unknown_diameter_is_not_taken_for_a_fit() {
        let mut shaft = port(PortType::Shaft, 1.0);
        shaft.params.clear();
        assert_eq!(conditions(&port(PortType::Bore, 20.0), &shaft).len(), 1);
    }
}
