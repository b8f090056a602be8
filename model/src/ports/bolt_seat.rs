//! `BOLT_SEAT`.

use super::{PortKind, PortParam, PortType, Values, diameter};
use crate::probe::{Probe, Site};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::BoltSeat,
    name: "BOLT_SEAT",
    doc: "The plane ring on which a fastener sits: under a bolt's head, a nut, a washer, or the spot face \
          for them. Origin: on the axis in the ring's plane; z the ring's outward normal.",
    params: &[
        PortParam {
            name: "inner_diameter",
            ..diameter("inner diameter of the ring: the shank or hole within it")
        },
        PortParam {
            name: "outer_diameter",
            ..diameter("outer diameter of the ring")
        },
    ],
    rule,
    evidence,
};

fn rule(v: &Values<'_>) -> Vec<String> {
    v.less("inner_diameter", "outer_diameter")
}

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let (inner, outer) = (v.get("inner_diameter"), v.get("outer_diameter"));
    site.ring_surface(inner / 2.0, outer / 2.0, "the seat's face", &mut out);
    out
}
