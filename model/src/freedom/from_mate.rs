//! Mates as links.

use nalgebra::Vector3;

use super::{Axis, Hold, Link};
use crate::angle::sin_cos_deg;
use crate::frame::{FrameError, Placement};
use crate::mates::{Joint, MateType};
use crate::ports::{Port, PortType};

/// The link of a mate between two placed bodies.
///
/// # Errors
/// When a port's frame is none.
pub fn link_of(
    name: &str,
    mate_type: MateType,
    joint: &Joint<'_>,
    (base, at_base): (usize, &Placement),
    (incoming, at_incoming): (usize, &Placement),
) -> Result<Link, FrameError> {
    let frame = *at_base * joint.base.frame.placement()?;
    let other = *at_incoming * joint.incoming.frame.placement()?;
    let freedom = mate_type.kind().freedom(joint);
    let hold = match freedom.coupling {
        Some(coupling) => {
            let (sin, cos) = sin_cos_deg(joint.base.value("helix_angle_deg"));
            Hold::Gears {
                incoming_axis: other.origin().into(),
                ratio: coupling.ratio,
                slope: sin / cos,
            }
        }
        None => Hold::Free(freedom.twists),
    };
    Ok(Link {
        name: name.to_owned(),
        base,
        incoming,
        frame,
        hold,
    })
}

/// The axis about which a part's spin is no motion of the machine, in the part's frame: all its ports are on
/// one line, it has no teeth, and none of its ports is a `shaft`, whose purpose is to turn. So screws, nuts,
/// washers, rings and bushes spin idly, and shafts, gears and plates do not. This is what the ports say of the
/// part, not its solid: a hexagon head is taken for round.
#[must_use]
pub fn spin_axis(ports: &[Port]) -> Option<Axis> {
    let first = ports.first()?;
    let point = Vector3::from(first.frame.origin);
    let direction = Vector3::from(first.frame.z);
    let on_axis = |p: &Port| {
        let off = (Vector3::from(p.frame.origin) - point).cross(&direction);
        let tilt = Vector3::from(p.frame.z).cross(&direction);
        off.norm() <= 1e-6 && tilt.norm() <= 1e-9
    };
    let still = |p: &Port| {
        matches!(
            p.port_type,
            PortType::GearMesh | PortType::Shaft | PortType::SnapFit
        )
    };
    // A part of nothing but faces is a plate or a block: its ports do not say that it is round.
    let round = ports.iter().any(|p| p.port_type != PortType::FlatFace);
    (round && ports.iter().all(|p| on_axis(p) && !still(p))).then_some(Axis {
        point: first.frame.origin,
        direction: first.frame.z,
    })
}
