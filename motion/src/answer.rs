//! What a sweep found.

use assemcad_model::freedom::DriveKind;
use assemcad_model::report::{Verdict, rounded};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a sweep found. Coordinates are in the stated unit, from the pose in which the assembly stands.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Sweep {
    /// Pass: the whole range without a collision. Fail: a collision, or an end of travel in the range.
    /// Indeterminate: something could not be told.
    pub verdict: Verdict,
    /// The result in a sentence.
    pub result: String,
    /// What moves how at the start, in words.
    pub motion: String,
    /// Direction of the driven part's axis or slide, for positive values (right-handed).
    pub direction: [f64; 3],
    /// Free motions of the same links that were held still: what the sweep assumed.
    pub held_still: Vec<String>,
    /// Degrees or millimetres.
    pub unit: Unit,
    /// Where the range begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The step between samples.
    pub step: f64,
    /// How far the sweep came.
    pub reached: f64,
    /// Why the motion went no further; none where it did.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stopped: Option<Stop>,
    /// The first collision.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub collision: Option<Collision>,
    /// The pairs of parts that move against each other.
    pub pairs: Pairs,
    /// How often the kernel was asked for a common volume or for surfaces.
    pub kernel_asked: usize,
}

/// What a coordinate counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Unit {
    /// Degrees of turn.
    Deg,
    /// Millimetres of travel.
    Mm,
}

impl From<DriveKind> for Unit {
    fn from(kind: DriveKind) -> Self {
        match kind {
            DriveKind::Rotate => Self::Deg,
            DriveKind::Slide => Self::Mm,
        }
    }
}

/// Where a motion ended and why.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Stop {
    /// The coordinate.
    pub at: f64,
    /// Why, in words.
    pub why: String,
}

/// The witness of a collision.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Collision {
    /// The coordinate at which the two parts overlap.
    pub at: f64,
    /// The last coordinate at which they do not, `tolerance` before it or less; none where they overlap at the
    /// start.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_until: Option<f64>,
    /// How near the two were brought to each other.
    pub tolerance: f64,
    /// The two parts.
    pub parts: [String; 2],
    /// The mates between them.
    pub mates: Vec<String>,
    /// Their common volume at the witness, in mm3.
    pub common_volume_mm3: f64,
    /// Its centre in the world, in mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre_mm: Option<[f64; 3]>,
}

/// The pairs of parts that move against each other.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Pairs {
    /// How many there are.
    pub moving: usize,
    /// Those that cannot collide at any value.
    pub proven: Vec<Proven>,
    /// How many were compared at every sample only: they may collide between two samples.
    pub sampled: usize,
    /// Those of which something could not be told.
    pub indeterminate: Vec<Open>,
}

/// A pair that cannot collide.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Proven {
    /// The two parts.
    pub parts: [String; 2],
    /// By what.
    pub by: Proof,
}

/// What proves a pair: they only turn against each other about one axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Proof {
    /// One is a solid of revolution about it, so that all poses are alike.
    Revolution,
    /// The rings that their boxes sweep about it are apart.
    Rings,
}

/// A pair of which something could not be told.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Open {
    /// The two parts.
    pub parts: [String; 2],
    /// The first coordinate at which it could not.
    pub at: f64,
    /// Why.
    pub why: String,
}

/// A coordinate as it is reported: degrees or millimetres.
pub(crate) fn shown(kind: DriveKind, value: f64) -> f64 {
    rounded(match kind {
        DriveKind::Rotate => value.to_degrees(),
        DriveKind::Slide => value,
    })
}
