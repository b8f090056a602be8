//! Freedom: which motions the mates of placed parts leave.
//!
//! # First order
//!
//! Parts are rigid bodies, the root stands still. Each body has a twist (its turning and the speed of one of
//! its points), each mate holds the difference of two bodies' twists in the span of those it leaves free: its
//! wrenches, the orthogonal complement of that span, do no work on the difference (screw theory: Hunt,
//! *Kinematic Geometry of Mechanisms*, 1978; Davies, *Kirchhoff's circulation law applied to multi-loop
//! kinematic chains*, Mechanism and Machine Theory 16, 1981). The rows of all wrenches make one matrix: its
//! null space is the motions, its rank tells their number, and what the rows have over the rank is redundant.
//! Counting joints alone (Kutzbach) does not see that a loop's constraints may repeat each other (Gogu,
//! *Mobility of mechanisms: a critical review*, Mechanism and Machine Theory 40, 2005).
//!
//! Turns and slides compare by a characteristic length: the farthest joint or part from the middle of the
//! island's joints. A pair of gears is one row: at the pitch point their teeth have one speed along the common
//! tangent, whatever carries their axes.
//!
//! Rigidly joined bodies are one unit of unknowns, and an island falls into blocks that have no loop in common:
//! each is solved alone, by singular values where it is small, else by elimination unit by unit.
//!
//! # Finite steps
//!
//! Where no row is redundant the constraints are independent and the motions finite (implicit functions).
//! Else a motion may be only instantaneous: a flat four-bar turns at first order in two ways and in fact only
//! in one at a time. A small step is made along the motion and brought back onto the constraints by Newton's
//! method. A true motion stays where it went up to the square of the step.

mod blocks;
mod claims;
mod drive;
mod eliminate;
mod finite;
mod from_mate;
mod island;
mod joints;
mod linear;
mod link;
mod model;
mod motion;
mod redundant;
mod rigid;
mod sparse;
mod spins;
mod words;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::frame::Placement;
use crate::mates::Twist;

pub use drive::{Drive, DriveKind, NoDrive, Pose, Stuck};
pub use from_mate::{link_of, spin_axis};
pub use island::IslandFacts;
pub use joints::JointMotion;
pub use linear::{LARGEST_GAP, RANK_TOLERANCE, Rank};
pub use redundant::Redundant;
pub use words::{BodyMotion, Kind, Motion};

/// Bodies and what joins them.
#[derive(Debug, Clone, Default)]
pub struct System {
    /// The bodies.
    pub bodies: Vec<Body>,
    /// What joins them.
    pub links: Vec<Link>,
    /// The index of the body that stands still.
    pub root: Option<usize>,
}

/// A rigid body.
#[derive(Debug, Clone)]
pub struct Body {
    /// Name, unique in the system.
    pub name: String,
    /// A point of the body in the world, in mm: for the characteristic length only.
    pub at: [f64; 3],
    /// An axis about which its turning is no motion of the machine, since it looks and does the same at
    /// every turn.
    pub spin: Option<Axis>,
}

/// A line in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// A point of it, in mm.
    pub point: [f64; 3],
    /// Its unit direction.
    pub direction: [f64; 3],
}

/// What joins two bodies.
#[derive(Debug, Clone)]
pub struct Link {
    /// Name, unique in the system.
    pub name: String,
    /// Index of the body that carries the frame.
    pub base: usize,
    /// Index of the other body.
    pub incoming: usize,
    /// The frame in the world.
    pub frame: Placement,
    /// What it holds.
    pub hold: Hold,
}

/// What a link holds.
#[derive(Debug, Clone)]
pub enum Hold {
    /// All but these motions of the incoming body against the base body, in the frame.
    Free(Vec<Twist>),
    /// The teeth of two gears, the base gear about the frame's z, the incoming gear about a parallel axis.
    Gears {
        /// A point of the incoming gear's axis in the world, in mm.
        incoming_axis: [f64; 3],
        /// Angle of the incoming gear by angle of the base gear, their axes held.
        ratio: f64,
        /// Tangent of the base gear's helix angle, positive for right-handed teeth.
        slope: f64,
    },
}

/// Whether a motion goes on beyond its first instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Lasting {
    /// It does.
    True,
    /// It does not: the constraints stop it at second order or later, or let it go on only together with
    /// another motion.
    Instantaneous,
    /// It could not be told.
    Indeterminate,
}

impl Lasting {
    /// Of a motion that is two motions at once.
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Instantaneous, _) | (_, Self::Instantaneous) => Self::Instantaneous,
            (Self::Indeterminate, _) | (_, Self::Indeterminate) => Self::Indeterminate,
            (Self::True, Self::True) => Self::True,
        }
    }
}

/// What is free and what is held twice.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Freedom {
    /// Independent motions at this pose; none where the ranks cannot be told.
    pub mobility: Option<usize>,
    /// Of these, turns of bodies about axes of their own about which they look the same.
    pub idle_spins: usize,
    /// Independent motions that go on beyond the first instant: the dimension of the set of poses here.
    pub lasting_mobility: Option<usize>,
    /// The motions, each independent of the others; idle spins first.
    pub motions: Vec<Motion>,
    /// Constraints that say again what others say, by the loops in which they do.
    pub redundant: Vec<Redundant>,
    /// What is left between the two parts of each mate, by the mates' names.
    pub joints: Vec<JointMotion>,
    /// Each connected set of bodies.
    pub islands: Vec<IslandFacts>,
}

/// Which motions the links of a system leave. The result does not depend on the order of bodies and links.
#[must_use]
pub fn analyse(system: &System) -> Freedom {
    analyse_as(system, true)
}

/// `merge`: whether rigidly joined bodies are taken as one, which only saves time.
fn analyse_as(system: &System, merge: bool) -> Freedom {
    let islands = island::split(system);
    let mut out = Freedom {
        mobility: Some(0),
        idle_spins: 0,
        lasting_mobility: Some(0),
        motions: Vec::new(),
        redundant: Vec::new(),
        joints: Vec::new(),
        islands: Vec::new(),
    };
    let plus = |sum: Option<usize>, more: Option<usize>| Some(sum? + more?);
    for island in &islands {
        let found = island.analyse(system, merge);
        let floating = if found.facts.floating { 6 } else { 0 };
        out.mobility = plus(out.mobility, found.facts.mobility);
        out.lasting_mobility = plus(out.lasting_mobility, found.lasting.map(|d| d + floating));
        out.idle_spins += found.motions.iter().filter(|m| m.idle).count();
        out.motions.extend(found.motions);
        out.redundant.extend(found.redundant);
        out.joints.extend(found.joints);
        out.islands.push(found.facts);
    }
    out.motions.sort_by_key(|m| !m.idle);
    out.joints.sort_by(|a, b| a.mate.cmp(&b.mate));
    out
}

#[cfg(test)]
mod tests;
