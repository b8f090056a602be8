//! In which order sets are tried, how far, and how far one has come.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::gate::Tried;
use super::sets::{Origin, Set};
use super::trial::Outcome;

/// At which sets of parameters a source is tried: the defaults always come first.
#[derive(
    Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Extent {
    /// The defaults alone.
    Defaults,
    /// And each end of each range.
    Ends,
    /// And corners of all ranges together, and sets between.
    #[default]
    All,
}

impl Extent {
    /// Its stages, in order.
    pub(super) fn stages(self) -> &'static [Origin] {
        const ALL: [Origin; 4] = [
            Origin::Defaults,
            Origin::End,
            Origin::Corner,
            Origin::Between,
        ];
        let count = match self {
            Self::Defaults => 1,
            Self::Ends => 2,
            Self::All => ALL.len(),
        };
        ALL.split_at_checked(count).map_or(&ALL, |(first, _)| first)
    }
}

impl Origin {
    /// The stage's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Defaults => "defaults",
            Self::End => "ends",
            Self::Corner => "corners",
            Self::Between => "samples",
        }
    }
}

/// How far a trial has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The stage.
    pub stage: Origin,
    /// How many of its sets have been tried.
    pub done: usize,
    /// How many it has.
    pub of: usize,
}

impl core::fmt::Display for Progress {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} {}/{}", self.stage.name(), self.done, self.of)
    }
}

/// What became of the sets of one stage.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Stage {
    /// 'defaults', 'ends', 'corners' (every parameter at an end) or 'samples' (between).
    pub stage: String,
    /// How many sets it has.
    pub sets: usize,
    /// At how many the part was made and shows everything.
    pub made: usize,
    /// How many the factory's own rules refuse.
    pub refused_by_rules: usize,
    /// How many fail.
    pub failed: usize,
    /// How many are left.
    pub not_tried: usize,
}

/// The stages with what became of their sets; those that have none are left out.
pub(super) fn stages(all: &[(Origin, Set)], tried: &[Tried]) -> Vec<Stage> {
    let of = |stage: &Origin| {
        let own = || tried.iter().filter(|(o, ..)| o == stage);
        let count = |which: fn(&Outcome) -> bool| own().filter(|(_, _, o)| which(o)).count();
        let sets = all.iter().filter(|(o, _)| o == stage).count();
        Stage {
            stage: stage.name().to_owned(),
            sets,
            made: count(|o| matches!(o, Outcome::Made(_))),
            refused_by_rules: count(|o| matches!(o, Outcome::Refused(_))),
            failed: count(|o| matches!(o, Outcome::Failed(_))),
            not_tried: sets - own().count(),
        }
    };
    let each = Extent::All.stages().iter().map(of);
    each.filter(|stage| stage.sets > 0).collect()
}
