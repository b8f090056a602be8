//! A specification as text: its one YAML form.

use serde_json::{Map, Value};

use super::{Assembly, Document, FORMAT};
use crate::canonical;
use crate::yaml;

/// The canonical YAML of an assembly.
///
/// # Errors
/// When a number is not finite, which nothing that was read is.
pub fn write(assembly: &Assembly) -> Result<String, serde_json::Error> {
    let document = Document {
        format: FORMAT,
        assembly: assembly.clone(),
    };
    let value = canonical::normal(serde_json::to_value(document)?);
    let empty = Map::new();
    Ok(yaml::write(value.as_object().unwrap_or(&empty)))
}

impl Assembly {
    /// The assembly with every number in its one form, so that equal values are equal texts.
    #[must_use]
    pub fn normal(mut self) -> Self {
        for part in &mut self.parts {
            normalise(&mut part.params);
        }
        for mate in &mut self.mates {
            normalise(&mut mate.options);
        }
        self
    }
}

/// Puts every number of a map into its one form.
pub fn normalise(map: &mut Map<String, Value>) {
    *map = core::mem::take(map)
        .into_iter()
        .map(|(name, value)| (name, canonical::normal(value)))
        .collect();
}
