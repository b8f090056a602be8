//! How often a port can serve.

use super::MateType;
use crate::ports::PortType;

/// Why a port serves one mate of a sort only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Once {
    /// The reason.
    pub why: &'static str,
    /// Whether a second such mate cannot be; else it is unusual, and worth a warning.
    pub never: bool,
}

/// Whether a port of this type serves one mate of this type only; none where it may serve several.
///
/// Several parts sit on one face, on one shaft, in one bore or on one bolt's thread (a nut and its lock
/// nut), and a gear meshes with several: where two of them want the same place they overlap, which the
/// check of interference finds. What is here is at fault whatever the geometry, or looks like a slip.
#[must_use]
pub fn serves_once(port: PortType, mate: MateType) -> Option<Once> {
    use MateType::{CoaxialFace, FaceToFace, SnapToFace, ThreadEngage};
    use PortType::{BoltSeat, CboreSeat, SnapFit, ThreadInternal};
    let (why, never) = match (port, mate) {
        // Both engagements begin at the mouth: the shorter is within the longer.
        (ThreadInternal, ThreadEngage) => (
            "two screws that come in at one mouth want the same turns of its thread",
            true,
        ),
        (BoltSeat, CoaxialFace | FaceToFace | SnapToFace) => {
            ("the seat of one head or nut rests on one part", false)
        }
        (CboreSeat, CoaxialFace) => ("one head sits in a counterbore", false),
        (SnapFit, FaceToFace | SnapToFace) => ("the nose of a hook holds one edge", false),
        _ => return None,
    };
    Some(Once { why, never })
}

#[cfg(test)]
mod tests {
    use super::serves_once;
    use crate::mates::{ALL, MateType};
    use crate::ports::PortType;

    #[test]
    fn what_carries_several_may() {
        for kind in ALL {
            for port in [
                PortType::FlatFace,
                PortType::GearMesh,
                PortType::Shaft,
                PortType::Bore,
                PortType::ThreadExternal,
                PortType::ClearanceHole,
            ] {
                assert_eq!(
                    serves_once(port, kind.mate_type),
                    None,
                    "{port} {}",
                    kind.name
                );
            }
        }
    }

    #[test]
    fn what_is_said_is_about_pairs_that_can_be() {
        for (port, mate, never) in [
            (PortType::ThreadInternal, MateType::ThreadEngage, true),
            (PortType::BoltSeat, MateType::CoaxialFace, false),
            (PortType::CboreSeat, MateType::CoaxialFace, false),
            (PortType::SnapFit, MateType::SnapToFace, false),
        ] {
            assert_eq!(serves_once(port, mate).unwrap().never, never);
            let mut pairs = mate.kind().pairs.iter();
            assert!(pairs.any(|(b, c)| *b == port || *c == port), "{port}");
        }
        // In line with a threaded hole many holes may be.
        assert_eq!(
            serves_once(PortType::ThreadInternal, MateType::Coaxial),
            None
        );
    }
}
