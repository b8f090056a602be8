//! A specification in the tree form: the parts as an ordered dictionary by their names.

use indexmap::IndexMap;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::{Accepted, Assembly, FORMAT, Mate, Part, PartMotion};

/// An assembly in the tree form.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Tree {
    /// The version of the format; 1 where it is left out.
    #[serde(default = "super::current_format")]
    #[schemars(range(min = 1, max = 1))]
    pub format: u32,
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
    /// The parts by their names, in their order.
    pub parts_index: IndexMap<String, PartNode>,
    /// The mates, in their order.
    #[serde(default)]
    pub mates: Vec<Mate>,
}

/// A part in the tree form.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartNode {
    /// Name of the factory.
    pub factory: String,
    /// The parameters that were given; the factory's defaults fill in the rest.
    #[serde(default)]
    pub params: Map<String, Value>,
    /// Whether it springs, as a retaining ring, a clip or a seal does: on its way in it may open or close.
    #[serde(default, skip_serializing_if = "super::is_false")]
    pub elastic: bool,
    /// Notes in free text.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub notes: String,
}

impl From<Tree> for Assembly {
    fn from(tree: Tree) -> Self {
        let part = |(id, node): (String, PartNode)| Part {
            id,
            factory: node.factory,
            params: node.params,
            elastic: node.elastic,
            notes: node.notes,
        };
        Self {
            id: tree.id,
            description: tree.description,
            notes: tree.notes,
            root: tree.root,
            intended_mobility: tree.intended_mobility,
            intended_motions: tree.intended_motions,
            free: tree.free,
            accept: tree.accept,
            parts: tree.parts_index.into_iter().map(part).collect(),
            mates: tree.mates,
        }
    }
}

impl From<Assembly> for Tree {
    fn from(assembly: Assembly) -> Self {
        let node = |p: Part| {
            let node = PartNode {
                factory: p.factory,
                params: p.params,
                elastic: p.elastic,
                notes: p.notes,
            };
            (p.id, node)
        };
        Self {
            format: FORMAT,
            id: assembly.id,
            description: assembly.description,
            notes: assembly.notes,
            root: assembly.root,
            intended_mobility: assembly.intended_mobility,
            intended_motions: assembly.intended_motions,
            free: assembly.free,
            accept: assembly.accept,
            parts_index: assembly.parts.into_iter().map(node).collect(),
            mates: assembly.mates,
        }
    }
}
