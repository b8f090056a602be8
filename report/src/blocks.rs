//! What a page is made of, whatever it looks like.

use assemcad_model::report::Verdict;
use serde_json::Value;

/// A page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Page {
    /// Title.
    pub title: String,
    /// What follows under it.
    pub blocks: Vec<Block>,
}

/// A piece of a page. All texts are plain: what they hold is shown and never taken for markup.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Block {
    /// The verdict of all, and a sentence to it.
    Verdict(Verdict, String),
    /// A heading, of a section (2) or within one (3).
    Heading(u8, String),
    /// A heading of a finding, with its verdict.
    Finding(Verdict, String),
    /// A paragraph.
    Text(String),
    /// A list.
    List(Vec<String>),
    /// Named values.
    Pairs(Vec<(String, String)>),
    /// A table.
    Table(Table),
    /// Something to copy.
    Code(String),
}

/// A table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    /// The heads of the columns.
    pub heads: Vec<&'static str>,
    /// The rows.
    pub rows: Vec<Vec<String>>,
}

/// How a verdict is called.
#[must_use]
pub fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "pass",
        Verdict::Indeterminate => "indeterminate",
        Verdict::Fail => "fail",
    }
}

/// A value without the marks of JSON where it is a plain text.
pub(crate) fn shown(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}
