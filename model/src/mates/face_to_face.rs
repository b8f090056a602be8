//! `face_to_face`: two planar faces, normals opposed, with offsets in the base face's plane and along
//! its normal. Leaves two slides and one spin free.

use super::{MateKind, MateType, Options, Residual, degrees, millimetres};
use crate::angle::between_deg;
use crate::frame::Placement;
use crate::ports::PortType::FlatFace;

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::FaceToFace,
    name: "face_to_face",
    doc: "Puts the incoming face on the base face, normals opposed, shifted by u, v in the base \
          face's x, y and lifted by d_n along its normal.",
    pairs: &[(FlatFace, FlatFace)],
    options: || {
        vec![
            millimetres("u_mm", "shift along the base port's x"),
            millimetres("v_mm", "shift along the base port's y"),
            millimetres("d_n_mm", "gap along the base port's normal"),
            degrees("alpha_deg", "turn about the incoming port's normal"),
        ]
    },
    relative,
    residual,
    conditions: |_, _| Vec::new(),
};

fn relative(o: &Options) -> Placement {
    Placement::translation(o.number("u_mm"), o.number("v_mm"), o.number("d_n_mm"))
        * Placement::rotation_x(180.0)
        * Placement::rotation_z(o.number("alpha_deg"))
}

fn residual(o: &Options, actual: &Placement) -> Residual {
    let [_, _, z] = actual.axes();
    Residual {
        distance_mm: (actual.origin().z - o.number("d_n_mm")).abs(),
        angle_deg: between_deg(&z, &-nalgebra::Vector3::z()),
    }
}
