//! Factories in one line each.
#![allow(
    dead_code,
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests; none of them uses all"
)]

use assemcad_model::diagnostic::Diagnostic;
use assemcad_script::{Evaluated, Factory};
use serde_json::{Value, json};

/// The head of a factory with one parameter.
pub const HEAD: &str = "factory(doc = \"test\", params = {\"a\": number(4, 1, 10, doc = \"a\")})\n";

/// Reads a factory.
pub fn factory(source: &str) -> Result<Factory, Vec<Diagnostic>> {
    Factory::parse("test.part", source)
}

/// Builds a source with parameters.
pub fn build_with(source: &str, params: Value) -> Result<Evaluated, Vec<Diagnostic>> {
    factory(source)?.build(params.as_object().unwrap())
}

/// A factory whose body of `build(p)` begins at line 3.
pub fn body(lines: &str) -> String {
    let body: String = lines.lines().map(|l| format!("    {l}\n")).collect();
    format!("{HEAD}def build(p):\n{body}")
}

/// What a body gives.
pub fn run(lines: &str) -> Evaluated {
    build_with(&body(lines), json!({})).unwrap_or_else(|e| panic!("{e:#?}"))
}

/// The first fault of a body.
pub fn fault(lines: &str) -> Diagnostic {
    build_with(&body(lines), json!({})).unwrap_err().remove(0)
}

/// The calls of a body.
pub fn calls(lines: &str) -> Vec<Value> {
    let recipe = run(lines).recipe;
    recipe
        .calls
        .iter()
        .map(|c| serde_json::to_value(c).unwrap())
        .collect()
}
