//! `CBORE_SEAT`.

use super::{PortKind, PortParam, PortType, Values, depth, diameter};
use crate::probe::{Probe, Site};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::CboreSeat,
    name: "CBORE_SEAT",
    doc: "The floor of a counterbore, on which a bolt's head sits. Origin: on the axis in the floor's \
          plane; z out of the counterbore.",
    params: &[
        diameter("diameter of the counterbore"),
        depth("depth of the counterbore, from its mouth to the floor"),
        PortParam {
            name: "hole_diameter",
            ..diameter("diameter of the hole in the floor")
        },
        PortParam {
            name: "hole_depth",
            ..depth("length of the hole, from the floor on")
        },
    ],
    rule,
    evidence,
};

fn rule(v: &Values<'_>) -> Vec<String> {
    v.less("hole_diameter", "diameter")
}

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let (wide, narrow) = (v.get("diameter") / 2.0, v.get("hole_diameter") / 2.0);
    site.ring_surface(narrow, wide, "the counterbore's floor", &mut out);
    site.hole(wide, v.get("depth"), 0.0, &mut out);
    site.hole(narrow, 0.0, -v.get("hole_depth"), &mut out);
    out
}
