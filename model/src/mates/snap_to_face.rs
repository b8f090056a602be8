//! `snap_to_face`: a point of a planar face, given as fractions of the face's extents. Leaves nothing free.

use super::{
    Contact, Freedom, Joint, MateKind, MateType, Residual, bond, degrees, millimetres,
    no_conditions, no_overlap, no_play, within,
};
use crate::angle::between_deg;
use crate::frame::Placement;
use crate::ports::Port;
use crate::ports::PortType::{BoltSeat, FlatFace, SnapFit};

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::SnapToFace,
    name: "snap_to_face",
    doc: "Puts the incoming face on a point of the base face, normals opposed: u, v from 0 to 1 over the \
          base face's extents, lifted by d_n along its normal.",
    pairs: &[
        (FlatFace, BoltSeat),
        (FlatFace, FlatFace),
        (FlatFace, SnapFit),
        (SnapFit, FlatFace),
        (SnapFit, SnapFit),
    ],
    options: || {
        let mut u = within(
            "u",
            "where along the base face's x, 0.5 in the middle",
            "",
            0.0,
            1.0,
        );
        let mut v = within(
            "v",
            "where along the base face's y, 0.5 in the middle",
            "",
            0.0,
            1.0,
        );
        for p in [&mut u, &mut v] {
            if let crate::param::ParamKind::Number { default, .. } = &mut p.kind {
                *default = 0.5;
            }
        }
        vec![
            u,
            v,
            millimetres("d_n_mm", "gap along the base port's normal"),
            degrees("alpha_deg", "turn about the incoming port's normal"),
            bond(),
        ]
    },
    relative,
    residual,
    conditions: no_conditions,
    freedom: |_| Freedom::none(),
    contact: |j| (j.number("d_n_mm") == 0.0).then_some(Contact::Face),
    overlap: no_overlap,
    radial_play: no_play,
};

/// The extents of the base face along its x and y.
fn extents(base: &Port) -> (f64, f64) {
    match base.port_type {
        SnapFit => (base.value("overlap"), base.value("width")),
        _ => (base.value("extent_x"), base.value("extent_y")),
    }
}

fn relative(j: &Joint<'_>) -> Placement {
    let (x, y) = extents(j.base);
    Placement::translation(
        (j.number("u") - 0.5) * x,
        (j.number("v") - 0.5) * y,
        j.number("d_n_mm"),
    ) * Placement::rotation_x(180.0)
        * Placement::rotation_z(j.number("alpha_deg"))
}

/// Nothing is free, so everything counts: the distance of the origins, and the larger turn of the two
/// stated axes.
fn residual(j: &Joint<'_>, actual: &Placement) -> Residual {
    let wanted = relative(j);
    let ([x, _, z], [wanted_x, _, wanted_z]) = (actual.axes(), wanted.axes());
    Residual {
        distance_mm: (actual.origin() - wanted.origin()).norm(),
        angle_deg: between_deg(&z, &wanted_z).max(between_deg(&x, &wanted_x)),
    }
}

#[cfg(test)]
mod tests {
    use crate::frame::Placement;
    use crate::mates::tests::{joined, port};
    use crate::ports::PortType::FlatFace;
    use serde_json::json;

    #[test]
    fn fractions_of_the_extents() {
        let face = port(FlatFace, &[("extent_x", 200.0), ("extent_y", 120.0)]);
        let at = |o| joined("snap_to_face", &face, &face, o, |k, j| (k.relative)(j));
        assert_eq!(at(json!({})), Placement::rotation_x(180.0));
        // A quarter and the whole of the extents, from the middle: -50 and 60 mm.
        assert_eq!(
            at(json!({"u": 0.25, "v": 1, "d_n_mm": 2})),
            Placement::translation(-50.0, 60.0, 2.0) * Placement::rotation_x(180.0)
        );
    }
}
