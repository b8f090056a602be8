//! `HOLE`.

use super::{PortKind, PortType, Values, depth, diameter, no_rule};
use crate::probe::{Probe, Site};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::Hole,
    name: "HOLE",
    doc: "A plain cylindrical hole, such as a dowel's. Origin: centre of the mouth; z out of the mouth.",
    params: &[diameter("inner diameter"), depth("length of the hole")],
    rule: no_rule,
    evidence,
};

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    site.hole(v.get("diameter") / 2.0, 0.0, -v.get("depth"), &mut out);
    out
}
