//! The report of a verification.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::diagnostic::Diagnostic;
use crate::frame::Rows;
use crate::freedom::Freedom;
use crate::mates::{MateType, Residual};

mod bill;
pub mod schema;

pub use bill::{BillLine, Mass, NearMiss, STEEL_KG_M3, StepFile};

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
    /// The STEP file of this very specification, where it was written; it names the specification in turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<StepFile>,
    /// The kernel that answered.
    pub kernel: String,
    /// The worst verdict of all checks.
    pub verdict: Verdict,
    /// What the author accepts knowingly, and whether it was met.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub accepted: Vec<AcceptedFact>,
    /// What is wrong or could not be told, worst first.
    pub findings: Vec<Finding>,
    /// The checks that were made.
    pub checks: Vec<Check>,
    /// What was not checked, and why.
    pub not_checked: Vec<String>,
    /// What the engineering axioms came to.
    pub axioms: Axioms,
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
    /// The clearance that was asked for between parts that do not touch, in mm; absent where none was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clearance_mm: Option<f64>,
    /// The pairs that are nearer to each other than that.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub near_misses: Vec<NearMiss>,
    /// What the assembly weighs.
    pub mass: Mass,
    /// The parts, equal ones counted together.
    pub bill_of_materials: Vec<BillLine>,
    /// Which motions the mates leave, where that could be told.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub freedom: Option<Freedom>,
}

/// A rule that the author breaks knowingly.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct AcceptedFact {
    /// Id of the axiom.
    pub axiom: String,
    /// The parts of which it is accepted.
    pub parts: Vec<String>,
    /// Why, in the author's words.
    pub reason: String,
    /// How many findings it answers; 0 where nothing broke the rule there.
    pub findings: usize,
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
    /// `fail` or `indeterminate`; `pass` for a warning, which is no fault of the assembly.
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
    /// The axioms that it breaks, and those that the mates between its parts cite.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub axioms: Vec<AxiomTrace>,
    /// What is wrong and what would mend it.
    pub diagnostic: Diagnostic,
}

/// What a finding has to do with an axiom.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct AxiomTrace {
    /// Id.
    pub axiom: String,
    /// What holds.
    pub statement: String,
    /// What the finding has to do with it.
    pub role: AxiomRole,
}

/// What a finding has to do with an axiom.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum AxiomRole {
    /// The finding shows it broken.
    Broken,
    /// The finding leaves open whether it holds.
    Open,
    /// A mate between the parts cites it.
    Cited,
}

/// What the engineering axioms came to. Every axiom is counted once, by the worst of its cases.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Axioms {
    /// How many axioms there are.
    pub total: usize,
    /// Held wherever they were checked.
    pub passed: usize,
    /// Broken.
    pub failed: usize,
    /// Broken or left open, but stated as SHOULD: a warning.
    pub warned: usize,
    /// Could not be told.
    pub indeterminate: usize,
    /// There was nothing that they are about.
    pub not_applicable: usize,
    /// Not checked, for a stated reason.
    pub not_checked: usize,
    /// Every axiom, by its id.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub each: Vec<AxiomFacts>,
}

impl Axioms {
    /// Counts an axiom in.
    pub fn count(&mut self, fact: AxiomFacts) {
        self.total += 1;
        *match fact.status {
            AxiomStatus::Pass => &mut self.passed,
            AxiomStatus::Fail => &mut self.failed,
            AxiomStatus::Warning => &mut self.warned,
            AxiomStatus::Indeterminate => &mut self.indeterminate,
            AxiomStatus::NotApplicable => &mut self.not_applicable,
            AxiomStatus::NotChecked => &mut self.not_checked,
        } += 1;
        self.each.push(fact);
    }
}

/// What an axiom came to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct AxiomFacts {
    /// Id.
    pub axiom: String,
    /// What holds.
    pub statement: String,
    /// What it came to.
    pub status: AxiomStatus,
    /// How many cases were looked at.
    pub cases: usize,
    /// The mates that cite it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cited_by: Vec<String>,
    /// Why it was not checked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
    /// What was taken for granted because the specification does not say it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub assumptions: Vec<String>,
}

/// What an axiom came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AxiomStatus {
    /// It holds.
    Pass,
    /// It is broken.
    Fail,
    /// It is broken or left open, and is stated as SHOULD.
    Warning,
    /// It could not be told.
    Indeterminate,
    /// There is nothing that it is about.
    NotApplicable,
    /// It was not checked.
    NotChecked,
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
    /// Mass in kg, by the density of the report's `mass`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass_kg: Option<f64>,
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
