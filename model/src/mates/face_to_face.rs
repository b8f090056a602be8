//! `face_to_face`: two planar faces, normals opposed, with offsets in the base face's plane and along
//! its normal. Leaves two slides and one spin free.

use super::{
    Contact, Joint, MateKind, MateType, Residual, SLIDE_X, SLIDE_Y, SPIN, bond, degrees,
    millimetres, no_conditions, no_overlap, no_play, opposed_residual_deg, unless_bonded,
};
use crate::frame::Placement;
use crate::ports::PortType::{BoltSeat, FlatFace, SnapFit};

pub(super) static KIND: MateKind = MateKind {
    mate_type: MateType::FaceToFace,
    name: "face_to_face",
    doc: "Puts the incoming face on the base face, normals opposed, shifted by u, v in the base \
          face's x, y and lifted by d_n along its normal.",
    pairs: &[
        (BoltSeat, FlatFace),
        (FlatFace, BoltSeat),
        (FlatFace, FlatFace),
        (FlatFace, SnapFit),
        (SnapFit, FlatFace),
        (SnapFit, SnapFit),
    ],
    options: || {
        vec![
            millimetres("u_mm", "shift along the base port's x"),
            millimetres("v_mm", "shift along the base port's y"),
            millimetres("d_n_mm", "gap along the base port's normal"),
            degrees("alpha_deg", "turn about the incoming port's normal"),
            bond(),
        ]
    },
    relative,
    residual,
    conditions: no_conditions,
    freedom: |j| unless_bonded(j, &[SPIN, SLIDE_X, SLIDE_Y]),
    contact: |j| (j.number("d_n_mm") == 0.0).then_some(Contact::Face),
    overlap: no_overlap,
    radial_play: no_play,
};

fn relative(j: &Joint<'_>) -> Placement {
    Placement::translation(j.number("u_mm"), j.number("v_mm"), j.number("d_n_mm"))
        * Placement::rotation_x(180.0)
        * Placement::rotation_z(j.number("alpha_deg"))
}

fn residual(j: &Joint<'_>, actual: &Placement) -> Residual {
    Residual {
        distance_mm: (actual.origin().z - j.number("d_n_mm")).abs(),
        angle_deg: opposed_residual_deg(actual),
    }
}
