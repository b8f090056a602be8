//! `SHAFT`.

use super::{PortKind, PortType};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::Shaft,
    name: "SHAFT",
    doc: "A cylinder that goes into a bore. Origin: on the axis at half the length; z out of an end.",
    params: &[
        ("diameter", "outer diameter in mm"),
        ("length", "length of the seat in mm"),
    ],
};
