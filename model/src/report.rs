//! The report of a verification.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::diagnostic::Diagnostic;
use crate::frame::Rows;
use crate::freedom::Freedom;
use crate::mates::{MateType, Residual};

/// The version of the report's format.
pub const FORMAT: u32 = 1;

/// What a check came to.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Checked, and in order.
    Pass,
    /// Could not be told, for a stated reason.
    Indeterminate,
    /// Checked, and wrong.
    Fail,
}

impl Verdict {
    /// The worse of the two: fail, then indeterminate, then pass.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        self.max(other)
    }
}

/// A verification report.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Report {
    /// [`FORMAT`].
    pub format: u32,
    /// Name of the assembly.
    pub assembly: String,
    /// SHA-256 of the specification that was verified.
    pub specification_sha256: String,
    /// The kernel that answered.
    pub kernel: String,
    /// The worst verdict of all checks.
    pub verdict: Verdict,
    /// What is wrong or could not be told, worst first.
    pub findings: Vec<Finding>,
    /// The checks that were made.
    pub checks: Vec<Check>,
    /// What was not checked, and why.
    pub not_checked: Vec<String>,
    /// The root part.
    pub root: Option<String>,
    /// Common volume above which two parts clash, in mm3.
    pub tau_mm3: f64,
    /// The parts.
    pub parts: Vec<PartFacts>,
    /// The mates.
    pub mates: Vec<MateFacts>,
    /// The pairs of parts whose boxes meet; all other pairs are apart.
    pub pairs: Vec<PairFacts>,
    /// Which motions the mates leave, where that could be told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub freedom: Option<Freedom>,
}

/// One kind of check, over the whole assembly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Check {
    /// Name.
    pub check: String,
    /// The worst verdict of its cases.
    pub verdict: Verdict,
    /// How many cases there were.
    pub cases: usize,
    /// How it was checked.
    pub how: String,
}

/// Something that is wrong or could not be told.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Finding {
    /// `fail` or `indeterminate`.
    pub verdict: Verdict,
    /// The check that found it.
    pub check: String,
    /// The parts it concerns.
    pub parts: Vec<String>,
    /// The mates it concerns.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mates: Vec<String>,
    /// Measured values, with units in their names.
    #[serde(default, skip_serializing_if = "Map::is_empty")]
    pub values: Map<String, Value>,
    /// What is wrong and what would mend it.
    pub diagnostic: Diagnostic,
}

/// What was measured of a part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PartFacts {
    /// Name.
    pub part: String,
    /// Factory.
    pub factory: String,
    /// SHA-256 of its recipe.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub recipe_sha256: Option<String>,
    /// Whether it is one valid solid of positive volume.
    pub verdict: Verdict,
    /// Volume in mm3.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub volume_mm3: Option<f64>,
    /// Centre of mass in the world, in mm, where the part is placed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre_mm: Option<[f64; 3]>,
    /// Smallest and largest corner of a box around it in the world, in mm, where the part is placed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub box_mm: Option<[[f64; 3]; 2]>,
    /// Placement in the world, where it has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub placement: Option<Rows>,
}

/// What was found of a mate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MateFacts {
    /// Name.
    pub mate: String,
    /// Type.
    pub mate_type: MateType,
    /// Base port as `part:port`.
    pub base: String,
    /// Incoming port as `part:port`.
    pub incoming: String,
    /// The axioms that it cites.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub axioms: Vec<String>,
    /// Whether it holds.
    pub verdict: Verdict,
    /// Whether the parts touch, where the mate promises it and both have a place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<Verdict>,
    /// The area over which they touch, in mm2, where the mate promises faces.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_area_mm2: Option<f64>,
    /// The radial play between a hole and what is in it, in mm; negative where it is pressed in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radial_play_mm: Option<f64>,
    /// How far it is from holding, where both parts are placed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub residual: Option<Residual>,
}

/// What was found of a pair of parts whose boxes meet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PairFacts {
    /// First part.
    pub a: String,
    /// Second part.
    pub b: String,
    /// Whether they are free of a clash.
    pub verdict: Verdict,
    /// What kind of overlap it is.
    pub class: Overlapping,
    /// Common volume in mm3, where it could be computed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub common_volume_mm3: Option<f64>,
    /// Common volume that the mates between them mean, in mm3, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub allowed_mm3: Option<f64>,
}

/// The kinds of overlap of two parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Overlapping {
    /// They have nothing in common, or no more than the report's `tau_mm3`.
    None,
    /// They overlap as a mate means it: a press fit, or a thread that stands for itself as a plain cylinder.
    Expected,
    /// They overlap by more than that.
    Clash,
    /// It could not be told.
    Unknown,
}

/// A measured value as it is reported: rounded to a millionth (mm, mm2, mm3), which is below every
/// tolerance here and above the last digits in which two builds of the kernel may differ.
#[must_use]
pub fn rounded(value: f64) -> f64 {
    // Values beyond 2^53 millionths have no millionths to round.
    if value.abs() > 9.0e9 {
        value
    } else {
        libm::round(value * 1e6) / 1e6 + 0.0
    }
}
