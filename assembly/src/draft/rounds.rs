//! The rounds of a draft, counted on disk, so that a server started again goes on counting.

use std::collections::BTreeMap;

use assemcad_model::diagnostic::{Diagnostic, Severity};
use assemcad_model::name;
use serde::{Deserialize, Serialize};

use crate::store::Store;

const FOLDER: &str = ".assemcad/drafts";

/// What a round found.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Round {
    /// SHA-256 of the draft's text.
    pub text_sha256: String,
    /// How many errors.
    pub errors: usize,
    /// How many warnings.
    pub warnings: usize,
    /// How often each code was found.
    pub codes: BTreeMap<String, usize>,
}

impl Round {
    pub(super) fn of(found: &[Diagnostic], text_sha256: String) -> Self {
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
    /// Counts a round of a draft and gives all its rounds, this one the last. A valid one is the last
    /// of its row: the next begins anew.
    ///
    /// # Errors
    /// When the count cannot be written. A damaged count begins anew.
    pub(super) async fn count_round(
        &self,
        id: Option<&str>,
        round: Round,
        valid: bool,
    ) -> Result<Vec<Round>, Diagnostic> {
        // No valid name begins with a point, so drafts without a usable name share one count.
        let name = id.filter(|id| name::is_valid(id)).unwrap_or(".unnamed");
        let file = format!("{FOLDER}/{name}.json");
        let _lock = self.lock_folder(FOLDER).await?;
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
}
