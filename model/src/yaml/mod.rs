//! YAML with the surprises taken out: what is read keeps its lines, and what is written has one form.
//!
//! A plain word is text wherever the format wants text (`id: on`, `id: 1e3`, `id: null`); only where
//! anything may stand (the parameters of a part) does it become a number or a truth value, and then by
//! the rules of JSON. Keys given twice, tags, several documents in one text, deep nesting and aliases
//! that multiply are faults. JSON is read by the same reader.

use serde_json::{Map, Value};

mod entries;
mod read;
mod scalar;
mod write;

pub use entries::Entries;
pub use read::{MOST_BYTES, MOST_DEPTH, MOST_NODES, Read, read};
pub use write::{flow, write};

/// A node with its place in the text.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Line, counted from 1.
    pub line: usize,
    /// What it is.
    pub kind: Kind,
}

/// What a node is.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// A text, plain or quoted.
    Scalar {
        /// The text.
        text: String,
        /// Whether it stands without quotes, so that it may be a number.
        plain: bool,
    },
    /// A sequence.
    List(Vec<Node>),
    /// A mapping, in the order of the text.
    Map(Entries),
}

/// The key of a mapping.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// The key.
    pub name: String,
    /// Its line.
    pub line: usize,
}

/// A step of a path into a document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Step {
    /// Into a mapping.
    Key(String),
    /// Into a sequence, or to the n-th entry of a mapping.
    Index(usize),
}

impl Node {
    /// The value under a key, where this is a mapping that has it.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Self> {
        match &self.kind {
            Kind::Map(entries) => entries.find(name).map(|(_, v)| v),
            _ => None,
        }
    }

    /// The line of what a path leads to, or of the nearest thing around it that is there.
    #[must_use]
    pub fn line_of(&self, path: &[Step]) -> usize {
        let mut node = self;
        let mut line = self.line;
        for step in path {
            let next = match (&node.kind, step) {
                (Kind::Map(entries), Step::Key(name)) => {
                    entries.find(name).map(|(k, v)| (k.line, v))
                }
                (Kind::Map(entries), Step::Index(i)) => entries.get(*i).map(|(k, v)| (k.line, v)),
                (Kind::List(items), Step::Index(i)) => items.get(*i).map(|v| (v.line, v)),
                _ => None,
            };
            let Some((at, found)) = next else { break };
            line = at;
            node = found;
        }
        line
    }

    /// The value, read with the schema of its place: a plain scalar where the schema wants text is text.
    ///
    /// Numbers too large to be held are left as text, which no check takes for a number.
    #[must_use]
    pub fn value(&self, schema: Option<&Value>) -> Value {
        match &self.kind {
            Kind::Scalar { text, plain: false } => Value::String(text.clone()),
            Kind::Scalar { text, plain: true } if text.is_empty() => Value::Null,
            Kind::Scalar { text, .. } if wants_text(schema) => Value::String(text.clone()),
            Kind::Scalar { text, .. } => scalar::resolve(text),
            Kind::List(items) => {
                let inner = schema.and_then(|s| s.get("items"));
                Value::Array(items.iter().map(|n| n.value(inner)).collect())
            }
            Kind::Map(entries) => {
                let mut map = Map::new();
                for (key, node) in entries {
                    let inner = schema.and_then(|s| {
                        s.get("properties")
                            .and_then(|p| p.get(&key.name))
                            .or_else(|| s.get("additionalProperties"))
                    });
                    map.insert(key.name.clone(), node.value(inner));
                }
                Value::Object(map)
            }
        }
    }
}

fn wants_text(schema: Option<&Value>) -> bool {
    let Some(schema) = schema else { return false };
    let is = |t: &Value| t == "string";
    match schema.get("type") {
        Some(Value::Array(types)) => types.iter().any(is),
        Some(t) => is(t),
        // An enumeration of described words.
        None => ["oneOf", "anyOf"].iter().any(|key| {
            schema
                .get(*key)
                .and_then(Value::as_array)
                .is_some_and(|all| all.iter().any(|s| wants_text(Some(s))))
        }),
    }
}

#[cfg(test)]
mod tests;
