//! `BORE`.

use super::{PortKind, PortType};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::Bore,
    name: "BORE",
    doc: "A cylindrical hole that receives a shaft. Origin: centre of the mouth; z out of the mouth.",
    params: &[
        ("diameter", "inner diameter in mm"),
        ("depth", "length of the hole in mm"),
    ],
};
