//! What the checks of hinges share. A hinge is what a mate says is one: it cites an axiom of hinges.

use std::collections::BTreeMap;

use assemcad_model::mates::MateType;

use crate::facts::{MateFacts, PartFacts, Side};
use crate::indexed::Indexed;
use crate::joints::{ends, is_cylinder, is_hole, reach_along};
use crate::ruling::About;

/// A knuckle: a bore of a leaf that the pin passes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Knuckle<'a> {
    pub(crate) mate: &'a MateFacts,
    pub(crate) hole: Side<'a>,
    pub(crate) pin: Side<'a>,
}

impl Knuckle<'_> {
    pub(crate) fn pressed(&self) -> bool {
        self.mate.mate_type == MateType::PressFit
    }
}

/// A pin with its knuckles.
#[derive(Debug, Clone)]
pub(crate) struct Hinge<'a> {
    pub(crate) pin: &'a PartFacts,
    pub(crate) knuckles: Vec<Knuckle<'a>>,
}

/// Every hinge: a pin, one of whose mates cites an axiom of hinges, and all the holes that it passes.
pub(crate) fn hinges(facts: &Indexed) -> Vec<Hinge<'_>> {
    let mut out: Vec<Hinge<'_>> = Vec::new();
    let mut by_pin: BTreeMap<&str, usize> = BTreeMap::new();
    for mate in &facts.mates {
        let Some((hole, pin)) = ends(facts, mate, is_hole, is_cylinder) else {
            continue;
        };
        let knuckle = Knuckle { mate, hole, pin };
        let at = *by_pin.entry(&pin.part.id).or_insert(out.len());
        match out.get_mut(at) {
            Some(h) => h.knuckles.push(knuckle),
            None => out.push(Hinge {
                pin: pin.part,
                knuckles: vec![knuckle],
            }),
        }
    }
    let cites = |k: &Knuckle<'_>| k.mate.axioms.iter().any(|a| a.starts_with("H-"));
    out.retain(|h| h.knuckles.iter().any(cites));
    out
}

impl<'a> Hinge<'a> {
    pub(crate) fn about(&self) -> About {
        let mut parts = vec![self.pin.id.clone()];
        parts.extend(self.leaves().iter().map(|s| (*s).to_owned()));
        About {
            parts,
            mates: self.knuckles.iter().map(|k| k.mate.id.clone()).collect(),
        }
    }

    /// The names of the leaves, sorted.
    pub(crate) fn leaves(&self) -> Vec<&'a str> {
        let mut names: Vec<&str> = self
            .knuckles
            .iter()
            .map(|k| k.hole.part.id.as_str())
            .collect();
        names.sort_unstable();
        names.dedup();
        names
    }

    /// The knuckles with their reach along the pin, from one end to the other; none where one has no place.
    pub(crate) fn along(&self) -> Option<Vec<(f64, f64, Knuckle<'a>)>> {
        let pin = self.knuckles.first()?.pin;
        let mut out = Vec::new();
        for k in &self.knuckles {
            let (low, high) = reach_along(&pin, &k.hole)?;
            out.push((low, high, *k));
        }
        out.sort_by(|a, b| a.0.total_cmp(&b.0));
        Some(out)
    }
}
