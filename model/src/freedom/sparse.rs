//! Vectors of which few entries are not 0.

use nalgebra::{DVector, Vector6};

/// A vector as its entries that are not 0, by their index.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Sparse(Vec<(usize, f64)>);

impl Sparse {
    /// Entries in the order of their indices, each once.
    pub(super) fn new(entries: impl IntoIterator<Item = (usize, f64)>) -> Self {
        Self(entries.into_iter().filter(|(_, x)| *x != 0.0).collect())
    }

    pub(super) fn of(dense: impl IntoIterator<Item = f64>) -> Self {
        Self::new(dense.into_iter().enumerate())
    }

    pub(super) fn dense(&self, n: usize) -> DVector<f64> {
        let mut out = DVector::zeros(n);
        for (i, x) in &self.0 {
            if let Some(entry) = out.get_mut(*i) {
                *entry = *x;
            }
        }
        out
    }

    pub(super) fn entries(&self) -> &[(usize, f64)] {
        &self.0
    }

    pub(super) fn get(&self, index: usize) -> f64 {
        let found = self.0.binary_search_by_key(&index, |(i, _)| *i);
        found
            .ok()
            .and_then(|at| self.0.get(at))
            .map_or(0.0, |(_, x)| *x)
    }

    /// Adds an entry behind the last one.
    pub(super) fn push(&mut self, index: usize, x: f64) {
        if x != 0.0 {
            self.0.push((index, x));
        }
    }

    /// Takes away what does not hold.
    pub(super) fn retain(&mut self, keep: impl Fn(usize, f64) -> bool) {
        self.0.retain(|(i, x)| keep(*i, *x));
    }

    /// The greatest size of an entry.
    pub(super) fn amax(&self) -> f64 {
        self.0.iter().fold(0.0, |most, (_, x)| most.max(x.abs()))
    }

    /// The index of the greatest entry by its size, the first of equals.
    pub(super) fn iamax(&self) -> usize {
        let (mut at, mut most) = (0, 0.0);
        for (i, x) in &self.0 {
            if x.abs() > most {
                (at, most) = (*i, x.abs());
            }
        }
        at
    }

    pub(super) fn divided(&self, by: f64) -> Self {
        Self::new(self.0.iter().map(|(i, x)| (*i, x / by)))
    }

    /// `self - other * by`, without entries up to `noise`.
    pub(super) fn less(&self, other: &Self, by: f64, noise: f64) -> Self {
        let mut out = Vec::with_capacity(self.0.len() + other.0.len());
        let (mut own, mut theirs) = (self.0.iter().peekable(), other.0.iter().peekable());
        loop {
            let (i, x) = match (own.peek(), theirs.peek()) {
                (Some((i, x)), Some((k, y))) if i == k => {
                    let both = (*i, x - y * by);
                    own.next();
                    theirs.next();
                    both
                }
                (Some((i, x)), Some((k, _))) if i < k => {
                    let one = (*i, *x);
                    own.next();
                    one
                }
                (Some((i, x)), None) => {
                    let one = (*i, *x);
                    own.next();
                    one
                }
                (_, Some((k, y))) => {
                    let one = (*k, -(y * by));
                    theirs.next();
                    one
                }
                (None, None) => return Self(out),
            };
            // What is no number is kept, and found out.
            if x.abs() > noise || x.is_nan() {
                out.push((i, x));
            }
        }
    }

    /// The twist of a unit in a motion of all units; the ground has none.
    pub(super) fn twist(&self, unit: Option<usize>) -> Vector6<f64> {
        let mut out = Vector6::zeros();
        let Some(first) = unit.map(|u| 6 * u) else {
            return out;
        };
        let at = self.0.partition_point(|(i, _)| *i < first);
        for (i, x) in self.0.iter().skip(at).take_while(|(i, _)| *i < first + 6) {
            if let Some(entry) = out.get_mut(i - first) {
                *entry = *x;
            }
        }
        out
    }

    /// Adds the twist of a unit behind those of earlier units.
    pub(super) fn push_twist(&mut self, unit: usize, twist: &Vector6<f64>) {
        for (k, x) in twist.iter().enumerate() {
            self.push(6 * unit + k, *x);
        }
    }

    /// The groups of so many entries that are not all 0, in order.
    pub(super) fn groups(&self, width: usize) -> Vec<usize> {
        let mut out: Vec<usize> = self.0.iter().map(|(i, _)| i / width).collect();
        out.dedup();
        out
    }
}

/// Which vectors have an entry in a group of indices.
#[derive(Debug)]
pub(super) struct Touching {
    width: usize,
    by: Vec<Vec<usize>>,
}

impl Touching {
    pub(super) fn new(groups: usize, width: usize, all: &[Sparse]) -> Self {
        let mut out = Self {
            width,
            by: vec![Vec::new(); groups],
        };
        for (k, v) in all.iter().enumerate() {
            out.note(k, v);
        }
        out
    }

    /// Notes where a vector has entries now.
    pub(super) fn note(&mut self, k: usize, v: &Sparse) {
        for group in v.groups(self.width) {
            if let Some(list) = self.by.get_mut(group) {
                list.push(k);
            }
        }
    }

    /// The vectors that have or had an entry in a group, in order.
    pub(super) fn of(&mut self, group: usize) -> Vec<usize> {
        let Some(list) = self.by.get_mut(group) else {
            return Vec::new();
        };
        list.sort_unstable();
        list.dedup();
        list.clone()
    }
}
