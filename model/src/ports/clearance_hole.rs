//! `CLEARANCE_HOLE`.

use super::{PortKind, PortParam, PortType, Values, depth, diameter};
use crate::probe::{NEAR_MM, Probe, Site, Test, probe};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::ClearanceHole,
    name: "CLEARANCE_HOLE",
    doc: "A through hole that a bolt passes with play, with a plane mouth on which its head can sit. \
          Origin: centre of the mouth; z out of the mouth.",
    params: &[
        diameter("diameter of the hole"),
        depth("length of the hole, through the material"),
        PortParam {
            name: "bolt_diameter",
            ..diameter("nominal diameter of the bolt it is for")
        },
    ],
    rule,
    evidence,
};

fn rule(v: &Values<'_>) -> Vec<String> {
    v.less("bolt_diameter", "diameter")
}

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let (radius, depth) = (v.get("diameter") / 2.0, v.get("depth"));
    site.hole(radius, 0.0, -depth, &mut out);
    let point = site.point(0.0, 0.0, -depth - NEAR_MM);
    out.push(probe("the hole goes through", Test::Out { point }));
    out.push(site.mouth(radius));
    out
}
