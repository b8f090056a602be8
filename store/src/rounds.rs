//! The rounds of a draft or of a factory's source, counted on disk, so that a server started again goes on
//! counting.

use std::collections::BTreeMap;

use assemcad_model::diagnostic::{Diagnostic, Severity};
use assemcad_model::name;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::root::Store;

/// What a round found.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Round {
    /// SHA-256 of the text that was tried.
    pub text_sha256: String,
    /// How many errors.
    pub errors: usize,
    /// How many warnings.
    pub warnings: usize,
    /// How often each code was found.
    pub codes: BTreeMap<String, usize>,
}

impl Round {
    /// The round in which this was found of a text.
    #[must_use]
    pub fn of(found: &[Diagnostic], text_sha256: String) -> Self {
        let of = |s: Severity| found.iter().filter(|d| d.severity == s).count();
        let mut codes = BTreeMap::new();
        for d in found {
            let code = serde_json::to_value(d.code).ok();
            let code = code.and_then(|c| c.as_str().map(str::to_owned));
            *codes.entry(code.unwrap_or_default()).or_default() += 1;
        }
        Self {
            text_sha256,
            errors: of(Severity::Error),
            warnings: of(Severity::Warning),
            codes,
        }
    }
}

impl Store {
    /// Counts a round of what a folder and a name stand for, and gives all its rounds, this one the last.
    /// A good one is the last of its row: the next begins anew.
    ///
    /// # Errors
    /// When the count cannot be written. A damaged count begins anew.
    pub async fn count_round(
        &self,
        folder: &str,
        id: Option<&str>,
        round: Round,
        valid: bool,
    ) -> Result<Vec<Round>, Diagnostic> {
        let _lock = self.lock_folder(folder).await?;
        let file = count_file(folder, id);
        let before: Vec<Round> = self.read_json(&file).unwrap_or_default();
        let mut rounds = before.clone();
        if rounds.last().map(|r| &r.text_sha256) != Some(&round.text_sha256) {
            rounds.push(round);
        }
        let kept: &[Round] = if valid { &[] } else { &rounds };
        if kept != before {
            self.write_json(&file, &kept)?;
        }
        Ok(rounds)
    }

    /// The rounds so far.
    #[must_use]
    pub fn rounds(&self, folder: &str, id: &str) -> Vec<Round> {
        self.read_json(&count_file(folder, Some(id)))
            .unwrap_or_default()
    }
}

fn count_file(folder: &str, id: Option<&str>) -> String {
    // No valid name begins with a point, so texts without a usable name share one count.
    let name = id.filter(|id| name::is_valid(id)).unwrap_or(".unnamed");
    format!("{folder}/{name}.json")
}

/// The last rounds of a row, as a failure tells them.
#[must_use]
pub fn history(rounds: &[Round]) -> Value {
    let all = rounds.iter().enumerate();
    let told = all.map(|(i, r)| json!({"round": i + 1, "errors": r.errors, "codes": r.codes}));
    // A loop that goes on all the same is told of its last rounds only.
    told.skip(rounds.len().saturating_sub(10)).collect()
}
