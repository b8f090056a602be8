//! Recipes: what a factory yields, and all that the kernel needs to make a solid and its ports.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::canonical;

/// The version of the recipe format. Part of every hash: a changed meaning is a changed recipe.
pub const FORMAT: u32 = 2;

/// The calls of the modelling language in the order in which they were made.
///
/// A call refers to earlier ones by index, so that a recipe cannot be circular. What a selector means
/// and where a port sits is found out by the kernel: the recipe says it in the language's own words.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// [`FORMAT`].
    pub format: u32,
    /// The calls, in order. All that were made: calls on one chain share what is drawn and not yet
    /// used.
    pub calls: Vec<Call>,
    /// The call whose result is the part.
    pub result: Ref,
}

impl Recipe {
    /// The SHA-256 of the canonical JSON: the name of the part in every cache.
    ///
    /// # Errors
    /// When a number is not finite, which a checked recipe never holds.
    pub fn hash(&self) -> Result<String, serde_json::Error> {
        canonical::hash(self)
    }
}

/// The index of a call in [`Recipe::calls`].
pub type Ref = u32;

/// One call of a function or method that [`crate::language`] lists.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Call {
    /// Full name, such as `Workplane.box`.
    pub call: String,
    /// The call whose result the method is called on; none for a function.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub on: Option<Ref>,
    /// Every argument by its name, defaults filled in, as [`crate::language::Kind`] says; what is
    /// None is left out. A result of an earlier call is written `{"ref": INDEX}`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub args: BTreeMap<String, Value>,
}

impl Call {
    /// The calls that this one uses: the one it is called on first.
    #[must_use]
    pub fn inputs(&self) -> Vec<Ref> {
        let mut found: Vec<Ref> = self.on.into_iter().collect();
        let mut rest: Vec<&Value> = self.args.values().collect();
        while let Some(value) = rest.pop() {
            if let Some(input) = reference(value) {
                found.push(input);
            } else if let Value::Array(items) = value {
                rest.extend(items);
            }
        }
        found
    }
}

/// How a result of an earlier call is written as an argument.
#[must_use]
pub fn referring(to: Ref) -> Value {
    serde_json::json!({ "ref": to })
}

/// The call that an argument refers to.
#[must_use]
pub fn reference(value: &Value) -> Option<Ref> {
    let fields = value.as_object().filter(|fields| fields.len() == 1)?;
    Ref::try_from(fields.get("ref")?.as_u64()?).ok()
}
