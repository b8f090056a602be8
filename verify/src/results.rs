//! What the checks found.

use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::report::{Check, Finding, Verdict};
use serde_json::Map;

/// Findings and checks as they come in.
#[derive(Debug, Default)]
pub struct Results {
    /// What was found.
    pub findings: Vec<Finding>,
    /// What was checked, and what each check came to.
    pub checks: Vec<Check>,
}

impl Results {
    /// Notes a finding about parts.
    pub(crate) fn find(
        &mut self,
        verdict: Verdict,
        check: &str,
        parts: Vec<String>,
        diagnostic: Diagnostic,
    ) {
        self.findings.push(Finding {
            verdict,
            check: check.to_owned(),
            parts,
            mates: Vec::new(),
            values: Map::new(),
            axioms: Vec::new(),
            diagnostic,
        });
    }

    /// Notes what a check came to.
    pub(crate) fn check(&mut self, check: &str, verdict: Verdict, cases: usize, how: &str) {
        self.checks.push(Check {
            check: check.to_owned(),
            verdict,
            cases,
            how: how.to_owned(),
        });
    }
}
