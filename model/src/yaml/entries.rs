//! The entries of a mapping, found by name without looking at all of them.

use std::collections::BTreeMap;
use std::ops::Deref;

use super::{Key, Node};

/// A mapping of up to so many entries is looked through; a longer one has an index.
const FEW: usize = 16;

/// The entries of a mapping, in the order of the text; no name twice.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Entries {
    list: Vec<(Key, Node)>,
    /// Where each name stands in the list; empty while there are few.
    places: BTreeMap<String, usize>,
}

impl Entries {
    /// Where a name stands.
    #[must_use]
    pub fn position(&self, name: &str) -> Option<usize> {
        if self.list.len() <= FEW {
            self.list.iter().position(|(k, _)| k.name == name)
        } else {
            self.places.get(name).copied()
        }
    }

    /// The entry of a name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&(Key, Node)> {
        self.list.get(self.position(name)?)
    }

    /// Adds an entry at the end; gives the line of the one that has its name already, which stays.
    pub(super) fn add(&mut self, key: Key, node: Node) -> Result<(), (Key, usize)> {
        if let Some((first, _)) = self.find(&key.name) {
            let line = first.line;
            return Err((key, line));
        }
        if self.list.len() > FEW {
            self.places.insert(key.name.clone(), self.list.len());
        }
        self.list.push((key, node));
        if self.list.len() == FEW + 1 {
            let names = self.list.iter().enumerate();
            self.places = names.map(|(i, (k, _))| (k.name.clone(), i)).collect();
        }
        Ok(())
    }
}

impl Deref for Entries {
    type Target = [(Key, Node)];

    fn deref(&self) -> &Self::Target {
        &self.list
    }
}

impl<'a> IntoIterator for &'a Entries {
    type Item = &'a (Key, Node);
    type IntoIter = core::slice::Iter<'a, (Key, Node)>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.iter()
    }
}
