//! What an axiom is, once it was read and found in order.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::decision::Decision;
use crate::entry::Scope;

/// The categories, by their letters.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
pub enum Category {
    /// Bearings.
    B,
    /// Constraints.
    C,
    /// Foundations.
    F,
    /// Gears.
    G,
    /// Hinges.
    H,
    /// Kinematic.
    K,
    /// Structural.
    N,
    /// Power and shafts.
    P,
    /// Sequencing.
    S,
    /// Fastening.
    T,
}

/// The categories in the order in which they are told: letter, file, title, number of axioms.
pub static CATEGORIES: [(Category, &str, &str, usize); 10] = [
    (Category::F, "foundations", "Foundations", 5),
    (Category::C, "constraints", "Constraints", 5),
    (Category::K, "kinematic", "Kinematic", 5),
    (Category::B, "bearings", "Bearings", 4),
    (Category::G, "gears", "Gears", 9),
    (Category::N, "structural", "Structural", 7),
    (Category::P, "power", "Power and shafts", 3),
    (Category::S, "sequencing", "Sequencing", 6),
    (Category::T, "fastening", "Fastening", 12),
    (Category::H, "hinges", "Hinges", 6),
];

impl Category {
    /// The letter with which ids begin.
    #[must_use]
    pub fn letter(self) -> char {
        match self {
            Self::B => 'B',
            Self::C => 'C',
            Self::F => 'F',
            Self::G => 'G',
            Self::H => 'H',
            Self::K => 'K',
            Self::N => 'N',
            Self::P => 'P',
            Self::S => 'S',
            Self::T => 'T',
        }
    }
}

/// An engineering axiom.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Axiom {
    /// Id, such as `C-02`.
    pub id: String,
    /// Category.
    pub category: Category,
    /// Title, a few words.
    pub title: String,
    /// What holds.
    pub statement: String,
    /// How strictly.
    pub force: Force,
    /// The single decision that it governs.
    pub decision: Decision,
    /// What it applies to.
    pub scope: Scope,
    /// Why.
    pub rationale: String,
    /// Where it comes from.
    pub provenance: Provenance,
    /// Axioms that build on this one.
    pub precedes: Vec<String>,
    /// Axioms on which this one builds.
    pub follows: Vec<String>,
    /// How it is checked.
    pub check: Checking,
}

/// How strictly an axiom holds, by the word in its statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Force {
    /// Always.
    Must,
    /// Never the contrary.
    MustNot,
    /// Unless there is a reason.
    Should,
}

impl Force {
    /// The word of a statement; none where it has none of them, or more than one.
    #[must_use]
    pub fn of(statement: &str) -> Option<Self> {
        let words: Vec<&str> = statement
            .split(|c: char| !c.is_ascii_alphabetic())
            .filter(|w| !w.is_empty())
            .collect();
        let mut found = None;
        for (i, word) in words.iter().enumerate() {
            let force = match *word {
                "MUST" if words.get(i + 1) == Some(&"NOT") => Self::MustNot,
                "MUST" => Self::Must,
                "SHOULD" => Self::Should,
                _ => continue,
            };
            if found.replace(force).is_some() {
                return None;
            }
        }
        found
    }
}

/// Where an axiom comes from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Provenance {
    /// A standard or textbook has it.
    Anchored {
        /// The standard's number and title, or authors and title of the book.
        source: String,
        /// The chapter's topic.
        topic: String,
        /// The clause, where it is certain.
        #[serde(skip_serializing_if = "Option::is_none")]
        clause: Option<String>,
    },
    /// Written for a component family or a model.
    Synthesized {
        /// Why it holds.
        justification: String,
    },
}

impl Provenance {
    /// Whether a source stands behind it.
    #[must_use]
    pub fn is_anchored(&self) -> bool {
        matches!(self, Self::Anchored { .. })
    }
}

/// How an axiom is checked.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Checking {
    /// A machine can check it.
    Checked {
        /// Name of the check.
        id: String,
        /// The facts that it needs.
        needs: Vec<Need>,
    },
    /// It cannot.
    None {
        /// Why.
        why: String,
    },
}

impl Checking {
    /// The name of the check, where there is one.
    #[must_use]
    pub fn id(&self) -> Option<&str> {
        match self {
            Self::Checked { id, .. } => Some(id),
            Self::None { .. } => None,
        }
    }
}

/// The kinds of facts that checks need.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Need {
    /// Parts, mates and their options.
    Specification,
    /// Ports with their parameters, and their frames in the world.
    PlacedPorts,
    /// What a kernel measures of the solids.
    Geometry,
    /// Freedom and redundancy of the whole assembly.
    Mobility,
    /// Materials of the parts.
    Materials,
}

impl Need {
    /// The name as it is written.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Specification => "specification",
            Self::PlacedPorts => "placed_ports",
            Self::Geometry => "geometry",
            Self::Mobility => "mobility",
            Self::Materials => "materials",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Force;

    #[test]
    fn the_word_of_a_statement() {
        assert_eq!(Force::of("It MUST hold."), Some(Force::Must));
        assert_eq!(Force::of("It MUST NOT fall."), Some(Force::MustNot));
        assert_eq!(Force::of("It SHOULD hold."), Some(Force::Should));
        assert_eq!(Force::of("It must hold."), None);
        assert_eq!(Force::of("It MUST hold and SHOULD stay."), None);
    }
}
