//! What a mate does to its parts: the freedom it leaves, the contact it promises, the overlap it allows.

use serde::Serialize;

/// A small motion of the incoming part against the base part, in the base port's frame: angular part
/// (radians), then the linear part (mm) of the point at the frame's origin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Twist(pub [f64; 6]);

pub(super) const SPIN: Twist = Twist([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
pub(super) const SLIDE_X: Twist = Twist([0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
pub(super) const SLIDE_Y: Twist = Twist([0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
pub(super) const SLIDE_Z: Twist = Twist([0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);

/// The motion that a mate leaves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Freedom {
    /// A basis of the motions of the incoming part against the base part.
    pub twists: Vec<Twist>,
    /// Two rotations about axes that something else holds, of which one drives the other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coupling: Option<Coupling>,
}

/// Two coupled rotations: where the base part turns by 1, the incoming part turns by the ratio.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Coupling {
    /// The base part's rotation about its axis.
    pub base: Twist,
    /// The incoming part's rotation about its axis.
    pub incoming: Twist,
    /// Angle of the incoming part by angle of the base part, both right-handed about the base port's z.
    pub ratio: f64,
}

impl Freedom {
    pub(super) fn none() -> Self {
        Self::of(&[])
    }

    pub(super) fn of(twists: &[Twist]) -> Self {
        Self {
            twists: twists.to_vec(),
            coupling: None,
        }
    }
}

/// The contact that a mate promises at its ports.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Contact {
    /// Plane faces of the two parts share some area in the plane through the incoming port's origin,
    /// across its z.
    Face,
    /// Cylinder faces of the two parts about the base port's z share some area, or overlap where one
    /// is thicker than the other.
    Cylinder,
    /// The flanks of two gears: free as they are, they meet when the incoming gear is turned about its
    /// axis either way by this many degrees.
    Flanks(f64),
}

/// The volume that two mated parts may have in common, and must.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Overlap {
    /// At least this much, in mm3.
    pub least_mm3: f64,
    /// At most this much, in mm3.
    pub most_mm3: f64,
    /// What overlaps; empty where nothing may.
    pub why: String,
}

impl Overlap {
    pub(super) fn none() -> Self {
        Self {
            least_mm3: 0.0,
            most_mm3: 0.0,
            why: String::new(),
        }
    }
}
