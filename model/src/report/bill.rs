//! What a report says beside its checks: masses, the bill of materials, the STEP file, near misses.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The density of steel in kg/m3, where none is stated.
pub const STEEL_KG_M3: f64 = 7850.0;

/// What an assembly weighs, by one density for all its parts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Mass {
    /// The density that was reckoned with, in kg/m3.
    pub density_kg_m3: f64,
    /// Whether it was taken because none was stated.
    pub density_assumed: bool,
    /// The mass of all parts in kg; absent where a part could not be made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub total_kg: Option<f64>,
    /// The centre of mass in the assembly's frame, in mm; absent where a part could not be made or has no
    /// place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre_mm: Option<[f64; 3]>,
}

/// Equal parts: of one factory and one recipe.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BillLine {
    /// How many.
    pub count: usize,
    /// What a standard calls it, where its factory states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub designation: Option<String>,
    /// Factory.
    pub factory: String,
    /// Its parameters, with defaults filled in.
    pub params: Map<String, Value>,
    /// SHA-256 of its recipe.
    pub recipe_sha256: String,
    /// Mass of one in kg; absent where it could not be made.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass_kg: Option<f64>,
    /// The parts.
    pub parts: Vec<String>,
}

/// A STEP file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct StepFile {
    /// Its path below the server's root folder.
    pub file: String,
    /// Its length.
    pub bytes: usize,
    /// Its SHA-256.
    pub sha256: String,
}

/// Two parts that no mate joins and that do not touch, nearer to each other than was asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearMiss {
    /// First part.
    pub a: String,
    /// Second part.
    pub b: String,
    /// Their smallest distance in mm.
    pub distance_mm: f64,
}
