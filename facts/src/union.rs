//! Sets of parts that move as one, by the means that joined them.

/// Disjoint sets.
#[derive(Debug, Clone)]
pub(crate) struct Union(Vec<usize>);

impl Union {
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// The least member of a set.
    pub(crate) fn of(&self, mut part: usize) -> usize {
        while let Some(up) = self.0.get(part).copied()
            && up != part
        {
            part = up;
        }
        part
    }

    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        if let Some(slot) = self.0.get_mut(a.max(b)) {
            *slot = a.min(b);
        }
    }

    /// The sets, each in order, in the order of their least members.
    pub(crate) fn sets(&self) -> Vec<Vec<usize>> {
        let mut out: Vec<Vec<usize>> = vec![Vec::new(); self.0.len()];
        for part in 0..self.0.len() {
            if let Some(set) = out.get_mut(self.of(part)) {
                set.push(part);
            }
        }
        out.retain(|set| !set.is_empty());
        out
    }
}
