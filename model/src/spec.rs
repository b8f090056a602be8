//! The assembly specification: the text from which everything else is rebuilt.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::canonical;
use crate::diagnostic::{Code, Diagnostic};
use crate::mates::MateType;

pub mod schema;
mod stated;
pub mod text;
pub mod tree;

pub use stated::{Accepted, PartMotion, WorldAxis};

/// The version of the specification's format.
pub const FORMAT: u32 = 1;

/// A specification as a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// The version of the format; 1 where it is left out.
    #[serde(default = "current_format")]
    #[schemars(range(min = 1, max = 1))]
    pub format: u32,
    /// The assembly.
    pub assembly: Assembly,
}

fn current_format() -> u32 {
    FORMAT
}

/// An assembly: typed parts and typed mates between their ports.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Assembly {
    /// Name.
    pub id: String,
    /// What it is, in free text.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub description: String,
    /// Notes in free text: reasons, sources, open questions.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub notes: String,
    /// The part that stands still and carries the others; the first part where none is named.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<String>,
    /// How many independent motions the finished machine is meant to have.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub intended_mobility: Option<u32>,
    /// The motions that the finished machine is meant to have, each by a part that makes it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub intended_motions: Vec<PartMotion>,
    /// The parts that may lie loose, each with the motion that nothing has to stop.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub free: Vec<PartMotion>,
    /// The rules of experience that are broken knowingly.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub accept: Vec<Accepted>,
    /// The parts, in the order in which they were added.
    #[serde(default)]
    pub parts: Vec<Part>,
    /// The mates, in the order in which they were made.
    #[serde(default)]
    pub mates: Vec<Mate>,
}

/// A part: a factory and its parameters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Name, unique in the assembly.
    pub id: String,
    /// Name of the factory.
    pub factory: String,
    /// The parameters that were given; the factory's defaults fill in the rest.
    #[serde(default)]
    pub params: Map<String, Value>,
    /// Whether it springs, as a retaining ring, a clip or a seal does: on its way in it may open or close.
    #[serde(default, skip_serializing_if = "is_false")]
    pub elastic: bool,
    /// Notes in free text.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub notes: String,
}

fn is_false(flag: &bool) -> bool {
    !flag
}

/// A mate between two ports.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mate {
    /// Name, unique in the assembly.
    pub id: String,
    /// Type.
    pub mate_type: MateType,
    /// The port that stays.
    pub base: End,
    /// The port whose part is brought in.
    pub incoming: End,
    /// The options that were given; the mate type's defaults fill in the rest.
    #[serde(default, skip_serializing_if = "Map::is_empty")]
    pub options: Map<String, Value>,
    /// The engineering axioms that justify the mate, by their ids.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub axioms: Vec<String>,
    /// Notes in free text.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub notes: String,
}

/// One end of a mate.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct End {
    /// Name of the part.
    #[serde(rename = "ref")]
    pub part: String,
    /// Name of its port.
    pub port: String,
}

impl core::fmt::Display for End {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}:{}", self.part, self.port)
    }
}

impl Assembly {
    /// An assembly without parts.
    #[must_use]
    pub fn new(id: &str, description: &str) -> Self {
        Self {
            id: id.to_owned(),
            description: description.to_owned(),
            notes: String::new(),
            root: None,
            intended_mobility: None,
            intended_motions: Vec::new(),
            free: Vec::new(),
            accept: Vec::new(),
            parts: Vec::new(),
            mates: Vec::new(),
        }
    }

    /// The name of the part that stands still.
    #[must_use]
    pub fn root(&self) -> Option<&str> {
        self.root
            .as_deref()
            .or_else(|| self.parts.first().map(|p| p.id.as_str()))
    }

    /// The part of a name.
    #[must_use]
    pub fn part(&self, id: &str) -> Option<&Part> {
        self.parts.iter().find(|p| p.id == id)
    }

    /// The mate of a name.
    #[must_use]
    pub fn mate(&self, id: &str) -> Option<&Mate> {
        self.mates.iter().find(|m| m.id == id)
    }

    /// The mates that a part takes part in.
    pub fn mates_of<'a>(&'a self, part: &'a str) -> impl Iterator<Item = &'a Mate> {
        self.mates
            .iter()
            .filter(move |m| m.base.part == part || m.incoming.part == part)
    }

    /// The SHA-256 of the specification's canonical JSON.
    ///
    /// # Errors
    /// When a number is not finite, which nothing read from JSON is.
    pub fn hash(&self) -> Result<String, serde_json::Error> {
        canonical::hash(&Document {
            format: FORMAT,
            assembly: self.clone(),
        })
    }

    /// [`Assembly::hash`] for those who cannot go on without it.
    ///
    /// # Errors
    /// As there: a fault of the server.
    pub fn sha256(&self) -> Result<String, Diagnostic> {
        self.hash()
            .map_err(|e| Diagnostic::error(Code::Internal, &self.id, e.to_string()))
    }
}
