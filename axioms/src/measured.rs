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
    pub overlaps: Option<Vec<Overlap>>,
    /// Mates that mean contact.
    #[serde(default)]
    pub contacts: Option<Vec<Contact>>,
}

/// What two parts have in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Overlap {
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
pub struct Contact {
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
