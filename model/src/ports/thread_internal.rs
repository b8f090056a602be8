//! `THREAD_INTERNAL`.

use super::{HAND, MODELLED, PITCH, PortKind, PortType, Values, depth, diameter, thread_rule};
use crate::probe::{Probe, Site};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::ThreadInternal,
    name: "THREAD_INTERNAL",
    doc: "A threaded hole, modelled as a plain hole. Origin: centre of the mouth; z out of the mouth.",
    params: &[
        diameter("nominal diameter"),
        PITCH,
        HAND,
        depth("length of the thread from the mouth"),
        MODELLED,
    ],
    rule: thread_rule,
    evidence,
};

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let radius = v.get("modelled_diameter") / 2.0;
    site.hole(radius, 0.0, -v.get("depth"), &mut out);
    out
}
