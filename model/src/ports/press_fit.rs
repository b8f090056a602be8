//! `PRESS_FIT`.

use super::{PortKind, PortType};

pub(super) static KIND: PortKind = PortKind {
    port_type: PortType::PressFit,
    name: "PRESS_FIT",
    doc: "An outer cylinder that sits in a hole. Origin: on the axis at half the length; z out of an end.",
    params: &[
        ("diameter", "outer diameter in mm"),
        ("length", "length of the cylinder in mm"),
    ],
};
