//! The knowledge base: the axioms of the embedded data files.

use std::sync::LazyLock;

use crate::axiom::Axiom;
use crate::load::{DataFault, load};
use crate::validate::order;

/// The embedded data files, by name and text.
pub static FILES: [(&str, &str); 10] = [
    ("bearings.yaml", include_str!("../data/bearings.yaml")),
    ("constraints.yaml", include_str!("../data/constraints.yaml")),
    ("fastening.yaml", include_str!("../data/fastening.yaml")),
    ("foundations.yaml", include_str!("../data/foundations.yaml")),
    ("gears.yaml", include_str!("../data/gears.yaml")),
    ("hinges.yaml", include_str!("../data/hinges.yaml")),
    ("kinematic.yaml", include_str!("../data/kinematic.yaml")),
    ("power.yaml", include_str!("../data/power.yaml")),
    ("sequencing.yaml", include_str!("../data/sequencing.yaml")),
    ("structural.yaml", include_str!("../data/structural.yaml")),
];

/// Axioms, sorted by their ids.
#[derive(Debug)]
pub struct KnowledgeBase {
    axioms: Vec<Axiom>,
    order: Vec<String>,
}

static BUILT_IN: LazyLock<Result<KnowledgeBase, Vec<DataFault>>> =
    LazyLock::new(|| KnowledgeBase::read(&FILES));

impl KnowledgeBase {
    /// The axioms of files, given as name and text.
    ///
    /// # Errors
    /// Everything that is wrong with the data.
    pub fn read(files: &[(&str, &str)]) -> Result<Self, Vec<DataFault>> {
        let axioms = load(files)?;
        let order = order(axioms.iter()).unwrap_or_default();
        Ok(Self { axioms, order })
    }

    /// The embedded axioms.
    ///
    /// # Errors
    /// Faults of the embedded data, which a test of this crate excludes.
    pub fn built_in() -> Result<&'static Self, &'static [DataFault]> {
        BUILT_IN.as_ref().map_err(Vec::as_slice)
    }

    /// The axioms, sorted by their ids.
    #[must_use]
    pub fn axioms(&self) -> &[Axiom] {
        &self.axioms
    }

    /// The axiom of an id.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<&Axiom> {
        self.axioms.iter().find(|a| a.id == id)
    }

    /// The ids in an order in which each comes after those that precede it.
    #[must_use]
    pub fn order(&self) -> &[String] {
        &self.order
    }
}

/// The embedded axioms, sorted by their ids.
#[must_use]
pub fn axioms() -> &'static [Axiom] {
    KnowledgeBase::built_in().map_or(&[], KnowledgeBase::axioms)
}

/// The embedded axiom of an id.
#[must_use]
pub fn axiom(id: &str) -> Option<&'static Axiom> {
    axioms().iter().find(|a| a.id == id)
}
