//! `THREAD_EXTERNAL`.

use super::{HAND, MODELLED, PITCH, PortKind, PortType, Values, diameter, length, thread_rule};
use crate::probe::{Probe, Site};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::ThreadExternal,
    name: "THREAD_EXTERNAL",
    doc: "A screw's thread, modelled as a plain cylinder. Origin: on the axis at the free end; z out of \
          that end; the thread runs against z.",
    params: &[
        diameter("nominal diameter"),
        PITCH,
        HAND,
        length("length of the thread from the free end"),
        MODELLED,
    ],
    rule: thread_rule,
    evidence,
};

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let radius = v.get("modelled_diameter") / 2.0;
    site.cylinder(radius, 0.0, -v.get("length"), &mut out);
    out
}
