//! Facts in which parts, ports and mates are found by name at once.

use std::collections::BTreeMap;

use crate::facts::{Facts, MateFacts, Measured, Mobility, PartFacts, Side};
use assemcad_model::ports::Port;
use assemcad_model::spec::End;

/// Facts whose parts and mates do not change any more, with indices over them. The methods answer as those of
/// [`Facts`] do: of two of one name the first is meant.
#[derive(Debug, Clone)]
pub struct Indexed {
    facts: Facts,
    parts: BTreeMap<String, usize>,
    mates: BTreeMap<String, usize>,
    /// The ports of each part by name.
    ports: Vec<BTreeMap<String, usize>>,
    /// The mates that name a part at an end.
    of: BTreeMap<String, Vec<usize>>,
    /// Part and port of base and incoming end of each mate, where they exist.
    ends: Vec<Option<[(usize, usize); 2]>>,
}

impl core::ops::Deref for Indexed {
    type Target = Facts;

    fn deref(&self) -> &Facts {
        &self.facts
    }
}

impl Indexed {
    /// Facts with their indices.
    #[must_use]
    pub fn new(facts: Facts) -> Self {
        let mut out = Self {
            parts: by_name(facts.parts.iter().map(|p| &p.id)),
            mates: by_name(facts.mates.iter().map(|m| &m.id)),
            ports: facts
                .parts
                .iter()
                .map(|p| by_name(p.ports.iter().map(|p| &p.name)))
                .collect(),
            of: BTreeMap::new(),
            ends: Vec::new(),
            facts,
        };
        for (i, m) in out.facts.mates.iter().enumerate() {
            for part in [&m.base.part, &m.incoming.part] {
                let list = out.of.entry(part.clone()).or_default();
                if list.last() != Some(&i) {
                    list.push(i);
                }
            }
        }
        let ends = |m: &MateFacts| Some([out.found(&m.base)?, out.found(&m.incoming)?]);
        out.ends = out.facts.mates.iter().map(ends).collect();
        out
    }

    /// What was measured, to be filled in.
    pub fn measured_mut(&mut self) -> &mut Measured {
        &mut self.facts.measured
    }

    /// What the analysis of motion found, to be filled in.
    pub fn mobility_mut(&mut self) -> Option<&mut Mobility> {
        self.facts.mobility.as_mut()
    }

    /// The place of a part among the parts.
    #[must_use]
    pub fn place(&self, id: &str) -> Option<usize> {
        self.parts.get(id).copied()
    }

    /// The part of a name.
    #[must_use]
    pub fn part(&self, id: &str) -> Option<&PartFacts> {
        self.facts.parts.get(self.place(id)?)
    }

    /// The mate of a name.
    #[must_use]
    pub fn mate(&self, id: &str) -> Option<&MateFacts> {
        self.facts.mates.get(*self.mates.get(id)?)
    }

    /// The mates of a part.
    pub fn mates_of(&self, part: &str) -> impl Iterator<Item = &MateFacts> {
        let of = self.of.get(part).into_iter().flatten();
        of.filter_map(|i| self.facts.mates.get(*i))
    }

    fn found(&self, end: &End) -> Option<(usize, usize)> {
        let part = self.place(&end.part)?;
        Some((part, *self.ports.get(part)?.get(&end.port)?))
    }

    fn at(&self, (part, port): (usize, usize)) -> Option<Side<'_>> {
        let part = self.facts.parts.get(part)?;
        let port: &Port = part.ports.get(port)?;
        Some(Side { part, port })
    }

    /// One end, where its part and port exist.
    #[must_use]
    pub fn side(&self, end: &End) -> Option<Side<'_>> {
        self.at(self.found(end)?)
    }

    /// Base and incoming end, where their parts and ports exist.
    #[must_use]
    pub fn sides(&self, mate: &MateFacts) -> Option<(Side<'_>, Side<'_>)> {
        let own = |i: &usize| {
            let found = self.facts.mates.get(*i);
            found.is_some_and(|m| core::ptr::eq(m, mate))
        };
        match self.mates.get(&mate.id).filter(|i| own(i)) {
            Some(i) => {
                let [base, incoming] = (*self.ends.get(*i)?)?;
                Some((self.at(base)?, self.at(incoming)?))
            }
            // One that is not of these facts, or the second of its name.
            None => Some((self.side(&mate.base)?, self.side(&mate.incoming)?)),
        }
    }

    /// The ends of a mate, that of a part first.
    #[must_use]
    pub fn seen_from(&self, part: &str, mate: &MateFacts) -> Option<(Side<'_>, Side<'_>)> {
        let (base, incoming) = self.sides(mate)?;
        Some(if base.part.id == part {
            (base, incoming)
        } else {
            (incoming, base)
        })
    }
}

/// The place of each name, of equal ones the first.
fn by_name<'a>(names: impl Iterator<Item = &'a String>) -> BTreeMap<String, usize> {
    let mut out = BTreeMap::new();
    for (i, name) in names.enumerate() {
        out.entry(name.clone()).or_insert(i);
    }
    out
}
