//! What is measured and analysed beyond the specification: solids, contacts, motion.

use serde::{Deserialize, Serialize};

/// What was measured of a solid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Geometry {
    /// Volume in mm3.
    pub volume_mm3: f64,
    /// Centre of mass in the world, in mm.
    pub centre_mm: [f64; 3],
    /// Smallest and largest corner of its box in the world, in mm.
    pub box_mm: [[f64; 3]; 2],
}

/// What was measured between solids; none where nothing was.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// Pairs of parts whose boxes meet. Pairs that are not listed are apart.
    #[serde(default)]
    pub overlaps: Option<Vec<PairOverlap>>,
    /// Mates that mean contact.
    #[serde(default)]
    pub contacts: Option<Vec<MateContact>>,
    /// The walls around bores.
    #[serde(default)]
    pub walls: Option<Vec<Wall>>,
    /// What is in whose way.
    #[serde(default)]
    pub ways: Option<Ways>,
    /// What stands before the heads of fasteners.
    #[serde(default)]
    pub reaches: Option<Vec<Reach>>,
    /// What stops shafts along their axes.
    #[serde(default)]
    pub thrusts: Option<Vec<Thrust>>,
    /// On what the tips of set screws stand.
    #[serde(default)]
    pub tips: Option<Vec<TipSeat>>,
}

/// The wall around a bore.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// The part.
    pub part: String,
    /// The port of the bore.
    pub port: String,
    /// The least wall that was met, in mm; none where no ray met one.
    #[serde(default)]
    pub least_mm: Option<f64>,
    /// How many rays left the bore's axis.
    pub rays: u32,
    /// How many of them met the bore's own wall; the others went out through keyways, cross holes or slots.
    pub met: u32,
}

/// What is in whose way, along a number of axes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ways {
    /// The axes that were looked along. Each stands for both ways.
    pub axes: Vec<Way>,
    /// Parts of which it is not known, and why in a few words.
    #[serde(default)]
    pub open: Vec<Unseen>,
    /// How many rays were cast across the common outline of two parts, along either side.
    pub rays_a_side: u32,
}

/// A part that could not be looked at.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Unseen {
    /// The part.
    pub part: String,
    /// Why.
    pub why: String,
}

/// What is in whose way along one axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Way {
    /// The axis in the world, a unit vector.
    pub axis: [f64; 3],
    /// What stops what along it.
    pub stops: Vec<Stop>,
}

/// A part cannot go all the way along an axis because of another one; nor can the other one go the other way
/// because of this one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stop {
    /// The part that would go.
    pub part: String,
    /// The part that is in its way.
    pub by: String,
    /// How far it can go, in mm; at least, where it is more than the end play that counts; 0 where only the ways
    /// are asked for.
    pub play_mm: f64,
}

/// What stops a shaft and what is on it along the shaft's axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Thrust {
    /// The shaft.
    pub shaft: String,
    /// What stops what along the axis; none where it is not known.
    #[serde(default)]
    pub stops: Option<Vec<Stop>>,
}

/// How far the way to a fastener's head is free for its tool.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reach {
    /// The fastener.
    pub part: String,
    /// How far the tool's cylinder is free from the head on, in mm, up to the length of the tool; none where
    /// it is not known.
    #[serde(default)]
    pub free_mm: Option<f64>,
    /// The part that ends it.
    #[serde(default)]
    pub by: Option<String>,
}

/// On what the tip of a set screw stands.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TipSeat {
    /// The mate that screws it into its hub.
    pub mate: String,
    /// Whether a plane face of the shaft, square to the screw, lies under the tip.
    pub flat: bool,
    /// Whether the tip stands within the shaft's round outline and outside of its material: on a flat or in
    /// a dimple.
    pub sunk: bool,
}

/// What two parts have in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairOverlap {
    /// A part.
    pub a: String,
    /// The other part.
    pub b: String,
    /// The volume in common, in mm3; none where it could not be computed.
    #[serde(default)]
    pub common_mm3: Option<f64>,
    /// The volume in common that their mates mean, in mm3.
    #[serde(default)]
    pub allowed_mm3: f64,
}

/// Whether the parts of a mate touch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MateContact {
    /// The mate.
    pub mate: String,
    /// Whether they do; none where it could not be told.
    #[serde(default)]
    pub touches: Option<bool>,
}

/// What the analysis of motion found.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mobility {
    /// Independent motions of the whole assembly.
    pub freedom: u32,
    /// Constraints that say again what others say.
    #[serde(default)]
    pub redundant: Vec<Redundant>,
    /// Those that are left when the mates that [`crate::reasons`] explains are taken out; none where that was
    /// not analysed.
    #[serde(default)]
    pub unexplained: Option<Vec<Redundant>>,
    /// The motion that is left between the two parts of a mate in the whole assembly.
    #[serde(default)]
    pub joints: Vec<JointMotion>,
}

/// Constraints of one mate that say again what others say.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Redundant {
    /// The mate.
    pub mate: String,
    /// How many of its constraints.
    pub count: u32,
}

/// The motion that is left between the two parts of a mate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JointMotion {
    /// The mate.
    pub mate: String,
    /// Independent rotations without travel.
    pub turns: u32,
    /// Independent translations.
    pub slides: u32,
    /// Independent screw motions.
    #[serde(default)]
    pub screws: u32,
}
