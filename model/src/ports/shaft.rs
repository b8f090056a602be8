//! `SHAFT`.

use super::{PortKind, PortType, Values, diameter, length, no_rule};
use crate::probe::{Probe, Site};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::Shaft,
    name: "SHAFT",
    doc: "A cylinder that goes into a bore. Origin: on the axis at half the length; z out of an end.",
    params: &[diameter("outer diameter"), length("length of the seat")],
    rule: no_rule,
    evidence,
};

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let half = v.get("length") / 2.0;
    site.cylinder(v.get("diameter") / 2.0, half, -half, &mut out);
    out
}
