//! Lists of diagnostics that have an end: whoever sends sixty thousand faults is told of some, and how many more.

use crate::diagnostic::{Code, Diagnostic, Faults, Severity};

/// So many diagnostics of one kind of check are made; of more it is only known how many.
pub const MOST_FOUND: usize = 200;

/// So many diagnostics stand in one list of an answer.
pub const MOST_TOLD: usize = 40;

/// Diagnostics up to [`MOST_FOUND`], and how many more there were.
#[derive(Debug, Default)]
pub struct Capped {
    list: Faults,
    more: usize,
}

impl Capped {
    /// None yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds one, which is made only where there is room: hints and lists of what would be valid cost more than the
    /// fault itself.
    pub fn push(&mut self, make: impl FnOnce() -> Diagnostic) {
        if self.list.len() < MOST_FOUND {
            self.list.push(make());
        } else {
            self.more += 1;
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The diagnostics; the last says how many more there were, where there were more.
    #[must_use]
    pub fn told(mut self) -> Faults {
        if self.more > 0 {
            let worst = self.list.iter().map(|d| d.severity).min();
            self.list.push(more(self.more, worst));
        }
        self.list
    }
}

/// The first of a list and, where it is longer than [`MOST_TOLD`], how many more there are; errors first then.
#[must_use]
pub fn first_of(mut all: Faults) -> Faults {
    let total = all.len();
    if total > MOST_TOLD {
        all.sort_by_key(|d| d.severity);
        // Those that say how many more there were count as what they say.
        let rest = all.split_off(MOST_TOLD);
        let worst = rest.iter().map(|d| d.severity).min();
        all.push(more(rest.iter().map(stands_for).sum(), worst));
    }
    all
}

/// How many faults a diagnostic stands for.
#[must_use]
pub fn stands_for(d: &Diagnostic) -> usize {
    let more = || d.found.as_ref()?.as_u64()?.try_into().ok();
    match d.code {
        Code::NotShown => more().unwrap_or(1),
        _ => 1,
    }
}

fn more(count: usize, worst: Option<Severity>) -> Diagnostic {
    let d = Diagnostic {
        severity: worst.unwrap_or(Severity::Note),
        ..Diagnostic::error(
            Code::NotShown,
            "diagnostics",
            format!("{count} more are not shown"),
        )
    };
    d.found(count).hint("mend those that are shown first")
}

#[cfg(test)]
mod tests {
    use super::{Capped, MOST_FOUND, MOST_TOLD, first_of};
    use crate::diagnostic::{Code, Diagnostic, Severity};

    #[test]
    fn what_is_left_out_is_counted() {
        let mut capped = Capped::new();
        for i in 0..MOST_FOUND + 7 {
            capped.push(|| Diagnostic::warning(Code::ParamUnknown, format!("{i}"), "m"));
        }
        let told = capped.told();
        assert_eq!(told.len(), MOST_FOUND + 1);
        let last = told.last().unwrap();
        assert_eq!(
            (last.code, last.severity),
            (Code::NotShown, Severity::Warning)
        );
        assert_eq!(last.found, Some(7.into()));

        let told = first_of(told);
        assert_eq!(told.len(), MOST_TOLD + 1);
        let left = MOST_FOUND + 7 - MOST_TOLD;
        assert_eq!(told.last().unwrap().found, Some(left.into()));
    }

    #[test]
    fn a_short_list_is_as_it_was() {
        let mut capped = Capped::new();
        assert!(capped.is_empty());
        capped.push(|| Diagnostic::error(Code::ParamUnknown, "p", "m"));
        let told = capped.told();
        assert_eq!(first_of(told.clone()), told);
        assert_eq!(told.len(), 1);
    }
}
