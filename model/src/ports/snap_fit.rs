//! `SNAP_FIT`.

use super::{PortKind, PortParam, PortType, Values, length, no_rule};
use crate::probe::{NEAR_MM, Probe, Site, Test, probe};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::SnapFit,
    name: "SNAP_FIT",
    doc: "The locking face of a snap hook or of its catch. Origin: centre of the face; z its outward \
          normal; x towards the free edge with which it reaches over its partner.",
    params: &[
        PortParam {
            name: "overlap",
            ..length("how far the locking face reaches, along the port's x")
        },
        PortParam {
            name: "width",
            ..length("width of the locking face, along the port's y")
        },
    ],
    rule: no_rule,
    evidence,
};

fn evidence(v: &Values<'_>, site: &Site) -> Vec<Probe> {
    let mut out = Vec::new();
    let (x, y) = (v.get("overlap") / 2.0, v.get("width") / 2.0);
    for (u, w) in [
        (0.0, 0.0),
        (0.8, 0.8),
        (-0.8, 0.8),
        (0.8, -0.8),
        (-0.8, -0.8),
    ] {
        site.surface(u * x, w * y, 0.0, "the locking face", &mut out);
    }
    // The edge is free: what it hooks over can get past it.
    for w in [-0.8, 0.0, 0.8] {
        let point = site.point(x + NEAR_MM, w * y, -NEAR_MM);
        out.push(probe(
            "the locking face ends in a free edge",
            Test::Out { point },
        ));
    }
    out
}
