//! `PRESS_FIT`.

use super::{PortKind, PortType, Values, diameter, length, no_rule};
use crate::probe::{Probe, Site};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::PressFit,
    name: "PRESS_FIT",
    doc: "An outer cylinder that sits in a hole. Origin: on the axis at half the length; z out of an end.",
    params: &[diameter("outer diameter"), length("length of the cylinder")],
    rule: no_rule,
    evidence,
};

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let half = v.get("length") / 2.0;
    site.cylinder(v.get("diameter") / 2.0, half, -half, &mut out);
    out
}
