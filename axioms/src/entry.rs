//! The data files as they are written.

use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;
use assemcad_model::spec::schema;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::axiom::{Category, Need};
use crate::class::Class;
use crate::decision::Decision;

/// A file of axioms of one category.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct File {
    /// The category, with which every id begins.
    pub category: Category,
    /// The axioms, in the order of their ids.
    pub axioms: Vec<Entry>,
}

/// An axiom.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// Id: the category's letter, a dash, two digits.
    #[schemars(regex(pattern = "^[FCKBGNPSTH]-[0-9]{2}$"))]
    pub id: String,
    /// Title, a few words.
    pub title: String,
    /// What holds, with one of MUST, MUST NOT and SHOULD, and without digits.
    pub statement: String,
    /// The single engineering decision that it governs; no other axiom governs the same.
    pub decision: Decision,
    /// What it applies to.
    pub scope: Scope,
    /// Why, in a sentence or two.
    pub rationale: String,
    /// Where it comes from.
    pub provenance: Provenance,
    /// Axioms that build on this one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub precedes: Vec<String>,
    /// Axioms on which this one builds.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub follows: Vec<String>,
    /// How it is checked.
    pub check: CheckEntry,
}

/// What an axiom applies to. A list that is left out leaves that side open.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Scope {
    /// Mate types.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mates: Vec<MateType>,
    /// Port types, of which a mate has one at least.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ports: Vec<PortType>,
    /// Component classes, of which a mate's parts have one at least.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub classes: Vec<Class>,
}

/// Where an axiom comes from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Whether a source stands behind it.
    pub kind: ProvenanceKind,
    /// The source: a standard's number and title, or authors and title of a book. Where anchored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// The chapter's topic in the source. Where anchored.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub topic: Option<String>,
    /// The clause in the source, only where it is certain.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clause: Option<String>,
    /// Why it holds without a source. Where synthesized.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub justification: Option<String>,
}

/// Whether a source stands behind an axiom.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ProvenanceKind {
    /// A standard or textbook has it.
    Anchored,
    /// Written for a component family or a model, with its justification.
    Synthesized,
}

/// How an axiom is checked.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckEntry {
    /// Whether a machine can check it.
    pub kind: CheckKind,
    /// Name of the check. Where checked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// The facts that the check needs. Where checked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub needs: Vec<Need>,
    /// Why there is none. Where not checked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
}

/// Whether a machine can check an axiom.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CheckKind {
    /// It can.
    Checked,
    /// It cannot, for a stated reason.
    None,
}

/// The JSON Schema of a data file.
#[must_use]
pub fn file_schema() -> Value {
    schema::of::<File>()
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_published_schema_is_that_of_the_types() {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../docs/schema/axioms.schema.json"
        );
        let schema = super::file_schema();
        let text = format!("{}\n", serde_json::to_string_pretty(&schema).unwrap());
        if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
            std::fs::write(path, &text).unwrap();
        }
        assert_eq!(
            std::fs::read_to_string(path).unwrap_or_default(),
            text,
            "{path} is not what the types say; accept it with\n  \
             ASSEMCAD_ACCEPT=1 cargo test -p assemcad-axioms published_schema"
        );
    }
}
