//! `FLAT_FACE`.

use super::{PortKind, PortType};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::FlatFace,
    name: "FLAT_FACE",
    doc: "A planar face. Origin: centre of the face; z its outward normal.",
    params: &[
        ("extent_x", "extent along the port's x in mm"),
        ("extent_y", "extent along the port's y in mm"),
    ],
};
