//! What an assembly is like now: in short, for the answers of tools.

use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::frame::Rows;
use assemcad_model::report::rounded;
use assemcad_model::spec::Assembly;
use assemcad_placing::{Resolved, place};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The state of an assembly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct State {
    /// Name.
    pub assembly: String,
    /// The part that stands still; none while there are no parts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<String>,
    /// The parts, in the order in which they were added.
    pub parts: Vec<PartState>,
    /// Names of the mates, in the order in which they were made.
    pub mates: Vec<String>,
    /// Names of the parts that no mate joins to the root yet.
    pub unplaced: Vec<String>,
    /// SHA-256 of the specification.
    pub specification_sha256: String,
    /// What the change cost, such as comments in the stored file.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Diagnostic>,
}

/// The state of an assembly in a few words, however many parts it has: what a change answers with.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Summary {
    /// Name.
    pub assembly: String,
    /// The part that stands still; none while there are no parts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<String>,
    /// How many parts there are.
    pub parts: usize,
    /// How many mates there are.
    pub mates: usize,
    /// Names of the parts that no mate joins to the root yet, at most 20 of them.
    pub unplaced: Vec<String>,
    /// How many parts that are.
    pub unplaced_total: usize,
    /// SHA-256 of the specification.
    pub specification_sha256: String,
    /// What the change cost, such as comments in the stored file.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Diagnostic>,
}

/// How many names a summary lists.
const MOST_NAMES: usize = 20;

impl From<State> for Summary {
    fn from(state: State) -> Self {
        Self {
            assembly: state.assembly,
            root: state.root,
            parts: state.parts.len(),
            mates: state.mates.len(),
            unplaced_total: state.unplaced.len(),
            unplaced: state.unplaced.into_iter().take(MOST_NAMES).collect(),
            specification_sha256: state.specification_sha256,
            warnings: state.warnings,
        }
    }
}

/// A part, in short.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PartState {
    /// Name.
    pub part: String,
    /// Factory.
    pub factory: String,
    /// The mate that placed it; none for the root and for parts without a place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub placed_by: Option<String>,
    /// Where the origin of its frame is in the world, in mm; none while it has no place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub origin_mm: Option<[f64; 3]>,
}

impl State {
    /// The state of a resolved assembly.
    ///
    /// # Errors
    /// When a port's frame is none.
    pub fn of(spec: &Assembly, resolved: &Resolved) -> Result<Self, Diagnostic> {
        let placements = place::assembly(resolved)?;
        let mut parts = Vec::new();
        let mut unplaced = Vec::new();
        for (i, part) in resolved.parts.iter().enumerate() {
            let by = placements.placed_by.get(i).copied().flatten();
            let origin = placements.of(i).map(|p| {
                let Rows([x, y, z]) = p.into();
                [x, y, z].map(|[.., t]| rounded(t))
            });
            if origin.is_none() {
                unplaced.push(part.id.clone());
            }
            parts.push(PartState {
                part: part.id.clone(),
                factory: part.factory.clone(),
                placed_by: by
                    .and_then(|m| resolved.mates.get(m))
                    .map(|m| m.mate.id.clone()),
                origin_mm: origin,
            });
        }
        Ok(Self {
            assembly: spec.id.clone(),
            root: spec.root().map(str::to_owned),
            parts,
            mates: spec.mates.iter().map(|m| m.id.clone()).collect(),
            unplaced,
            specification_sha256: spec.sha256()?,
            warnings: Vec::new(),
        })
    }
}
