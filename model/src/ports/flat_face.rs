//! `FLAT_FACE`.

use super::{Allowed, MOST_MM, PortKind, PortParam, PortType, Values, length};
use crate::probe::{NEAR_MM, Probe, Site, Test, probe};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::FlatFace,
    name: "FLAT_FACE",
    doc: "A plane face. Origin: centre of the face, on its material; z its outward normal. A ring about \
          the origin states the hole in it as hole_diameter.",
    params: &[
        PortParam {
            name: "extent_x",
            ..length("extent along the port's x")
        },
        PortParam {
            name: "extent_y",
            ..length("extent along the port's y")
        },
        PortParam {
            name: "hole_diameter",
            unit: "mm",
            allowed: Allowed::Between(0.0, MOST_MM),
            optional: Some(0.0),
            doc: "diameter of the hole about the origin, where the face is a ring",
        },
    ],
    rule,
    evidence,
};

fn rule(v: &Values<'_>) -> Vec<String> {
    let mut out = v.less("hole_diameter", "extent_x");
    out.extend(v.less("hole_diameter", "extent_y"));
    out
}

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let (x, y) = (v.get("extent_x") / 2.0, v.get("extent_y") / 2.0);
    let hole = v.get("hole_diameter") / 2.0;
    if hole > 0.0 {
        site.ring_surface(hole, x.min(y), "the ring face", &mut out);
        for deg in [0.0, 90.0, 180.0, 270.0] {
            let point = site.polar(0.95 * hole, deg, -NEAR_MM);
            out.push(probe("the hole in the ring", Test::Out { point }));
        }
    } else {
        site.surface(0.0, 0.0, 0.0, "the face at the port's origin", &mut out);
    }
    // The face reaches to its stated extents on all four sides; bolt holes may take some of these points.
    for (dx, dy, side) in [
        (1.0, 0.0, "+x"),
        (-1.0, 0.0, "-x"),
        (0.0, 1.0, "+y"),
        (0.0, -1.0, "-y"),
    ] {
        let reach = |half: f64, share: f64| hole + share * (half - hole);
        let of = [0.98, 0.92, 0.86]
            .iter()
            .map(|s| site.plane(dx * reach(x, *s), dy * reach(y, *s), 0.0))
            .collect();
        out.push(probe(
            &format!("the face reaches its extent on the {side} side"),
            Test::AnyOf { of },
        ));
    }
    out
}
