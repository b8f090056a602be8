//! The rounds of drafts that have no usable name: counted for the clients of this server alone, in memory.

use std::sync::{Mutex, PoisonError};

use assemcad_store::Round;

/// The rounds since the last draft that had a name.
#[derive(Debug, Default)]
pub(crate) struct Nameless(Mutex<Vec<Round>>);

/// So many are remembered: what is told of them is shorter.
const MOST: usize = 100;

impl Nameless {
    /// Counts a round, and gives all of them. The same text again is the same round.
    pub(crate) fn count(&self, round: Round) -> Vec<Round> {
        let mut rounds = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if rounds.last().map(|r| &r.text_sha256) != Some(&round.text_sha256) {
            if rounds.len() >= MOST {
                rounds.remove(0);
            }
            rounds.push(round);
        }
        rounds.clone()
    }

    /// Begins anew: a draft with a name came.
    pub(crate) fn clear(&self) {
        let mut rounds = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        rounds.clear();
    }
}
