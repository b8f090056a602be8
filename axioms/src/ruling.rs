//! What a check comes to.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// What a check came to for one subject.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// There was nothing to check.
    NotApplicable,
    /// Checked, and in order.
    Pass,
    /// Could not be told, for a stated reason.
    Indeterminate,
    /// Checked, and wrong.
    Fail,
}

/// What a ruling is about.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct About {
    /// Parts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<String>,
    /// Mates.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub mates: Vec<String>,
}

impl About {
    /// About parts only.
    pub fn parts<S: Into<String>>(parts: impl IntoIterator<Item = S>) -> Self {
        Self {
            parts: parts.into_iter().map(Into::into).collect(),
            mates: Vec::new(),
        }
    }

    /// About the whole assembly.
    #[must_use]
    pub fn assembly() -> Self {
        Self::default()
    }
}

/// A ruling of a check on one subject.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Ruling {
    /// Id of the axiom.
    pub axiom: String,
    /// What it came to.
    pub status: Status,
    /// What it is about.
    pub about: About,
    /// Measured values and limits, with units in their names.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<String, Value>,
    /// What was found, in one sentence.
    pub message: String,
    /// What was taken for granted because the facts do not say it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub assumption: Option<String>,
}

impl Ruling {
    /// A ruling.
    #[must_use]
    pub fn new(axiom: &str, status: Status, about: About, message: impl Into<String>) -> Self {
        Self {
            axiom: axiom.to_owned(),
            status,
            about,
            values: BTreeMap::new(),
            message: message.into(),
            assumption: None,
        }
    }

    /// Pass or fail.
    #[must_use]
    pub fn held(axiom: &str, holds: bool, about: About, message: impl Into<String>) -> Self {
        let status = if holds { Status::Pass } else { Status::Fail };
        Self::new(axiom, status, about, message)
    }

    /// Indeterminate, because a part has no place.
    #[must_use]
    pub fn unplaced(axiom: &str, about: About) -> Self {
        let message = "not all of the parts have a place";
        Self::new(axiom, Status::Indeterminate, about, message)
    }

    /// With a value, rounded as a report rounds. What is no number is left out.
    #[must_use]
    pub fn value(mut self, name: &str, value: f64) -> Self {
        if value.is_finite() {
            let value = assemcad_model::report::rounded(value);
            self.values.insert(name.to_owned(), value.into());
        }
        self
    }

    /// With what was taken for granted.
    #[must_use]
    pub fn assuming(mut self, what: impl Into<String>) -> Self {
        self.assumption = Some(what.into());
        self
    }
}
