//! Drafts: whole specifications as texts, checked at once, with a bounded number of rounds.
//!
//! An oblique port without an x direction, which the paper warns of, cannot arise: a factory must state
//! the x direction of every port, and one that does not is refused when it is evaluated.

use crate::{Faults, Workshop};
use assemcad_model::canonical::sha256;
use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::name;
use assemcad_model::spec::Assembly;
use assemcad_store::{Draft, Round, history};

use crate::verify::not_kept;

mod check;
mod layout;
mod nameless;

pub(crate) use nameless::Nameless;

/// Where the rounds of drafts are counted.
const ROUNDS: &str = ".assemcad/drafts";

/// What there is to say of a draft.
#[derive(Debug)]
pub struct Checked {
    /// Its name, where it has one.
    pub id: Option<String>,
    /// The specification with all factory names written out; none where anything is wrong.
    pub assembly: Option<Assembly>,
    /// Everything that was found, in the order of the lines.
    pub diagnostics: Vec<Diagnostic>,
    /// Which round this was, counted from 1.
    pub round: usize,
}

/// Checks a text against format, factories, ports and mates. Nothing is written or counted.
#[must_use]
pub async fn check(workshop: &Workshop, text: &str) -> Checked {
    let draft = Draft::read(text);
    let mut diagnostics = draft.faults.clone();
    diagnostics.extend(check::check(workshop, &draft).await);
    // Stable: within a line, the order of the checks.
    diagnostics.sort_by_key(line);
    let wrong = diagnostics.iter().any(|d| d.severity == Severity::Error);
    let mut assembly = draft.assembly.filter(|_| !wrong);
    for part in assembly.iter_mut().flat_map(|a| &mut a.parts) {
        if let Ok(factory) = workshop.registry.get(&part.factory) {
            part.factory = factory.name().to_owned();
        }
    }
    Checked {
        id: draft.id,
        assembly,
        diagnostics,
        round: 1,
    }
}

fn line(d: &Diagnostic) -> usize {
    let digits = d.place.strip_prefix("line ").unwrap_or_default();
    let digits = digits.split(',').next().unwrap_or_default();
    digits.parse().unwrap_or(usize::MAX)
}

impl Workshop {
    /// Checks a draft and counts the round. The same text again is the same round.
    ///
    /// # Errors
    /// When the draft was wrong in as many rounds as there are: what was tried, and what is still wrong.
    pub async fn validate_draft(&self, text: &str) -> Result<Checked, Faults> {
        let mut checked = check(self, text).await;
        let round = Round::of(&checked.diagnostics, sha256(text.as_bytes()));
        let valid = checked.assembly.is_some();
        let history = match checked.id.as_deref().filter(|id| name::is_valid(id)) {
            Some(id) => {
                self.nameless.clear();
                let counted = self
                    .store
                    .count_round(ROUNDS, Some(id), round.clone(), valid);
                // What is wrong with the draft is known without the count.
                counted.await.unwrap_or_else(|d| {
                    checked.diagnostics.push(not_kept(d));
                    vec![round]
                })
            }
            // Whoever gives no name has no row on disk: it would be that of all who give none.
            None => self.nameless.count(round),
        };
        checked.round = history.len();
        if valid || history.len() < self.draft_rounds {
            return Ok(checked);
        }
        let mut faults = vec![failed(&checked, &history)];
        faults.append(&mut checked.diagnostics);
        Err(faults)
    }
}

/// The rounds are used up: what was tried.
fn failed(checked: &Checked, tried: &[Round]) -> Diagnostic {
    let first = tried.first().map_or(0, |r| r.errors);
    let last = tried.last().map_or(0, |r| r.errors);
    let mut d = Diagnostic::error(
        Code::DecompositionFailed,
        match &checked.id {
            Some(id) => format!("draft '{}'", assemcad_model::param::clip(id)),
            None => "a draft without a name".to_owned(),
        },
        format!(
            "the draft is still wrong after {} rounds: {first} error(s) in the first, {last} in the last",
            tried.len()
        ),
    );
    // Set whole: it is bounded by itself, and a cut text would be no history.
    d.found = Some(history(tried));
    d.hint(
        "stop and think again about the decomposition: fewer kinds of parts, other factories \
         (describe_factory shows the ports); a draft that is valid, or has another id, begins anew",
    )
}
