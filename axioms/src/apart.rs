//! Taking an assembly apart along straight ways.
//!
//! A set of parts moves along a direction when nothing outside of the set is in its way. Draw an arrow from a
//! part to each that is in its way: such sets exist, other than all parts together, if and only if not every
//! part reaches every other one along the arrows, and what comes apart are the strongly connected components
//! (R. H. Wilson, J.-C. Latombe, "Geometric reasoning about mechanical assembly", Artificial Intelligence 71,
//! 1994). What comes apart never gets in each other's way again, so that no choice of an order loses
//! anything. The other way along the same axis turns all arrows round and has the same components.

use std::collections::{BTreeMap, BTreeSet};

use petgraph::algo::tarjan_scc;
use petgraph::graph::{DiGraph, NodeIndex};

use crate::facts::Way;

/// The groups that are left when the parts are taken apart along all axes, again and again until nothing more
/// comes apart: sorted, each in the order of the parts. Where every group is one part, there is an order of
/// assembly.
#[must_use]
pub fn groups(parts: &[String], ways: &[Way]) -> Vec<Vec<String>> {
    let place: BTreeMap<&String, usize> = parts.iter().zip(0..).collect();
    let arrows = |way: &Way| {
        let arrow = |part, by| Some((*place.get(part)?, *place.get(by)?));
        let all = way.stops.iter().filter_map(|s| arrow(&s.part, &s.by));
        all.collect::<Vec<_>>()
    };
    let ways: Vec<Vec<(usize, usize)>> = ways.iter().map(arrows).collect();
    let mut apart = Apart::new(parts.len());
    loop {
        let before = apart.groups;
        for way in &ways {
            apart.along(way);
        }
        if apart.groups == before {
            break;
        }
    }
    let name = |i: usize| parts.get(i).cloned();
    let all = apart.each().into_iter();
    all.map(|g| g.into_iter().filter_map(name).collect())
        .collect()
}

/// Parts in groups, by their places, as far as they have come apart.
#[derive(Debug, Clone)]
pub struct Apart {
    /// The group of each part.
    of: Vec<usize>,
    groups: usize,
}

impl Apart {
    /// So many parts, all of them together.
    #[must_use]
    pub fn new(parts: usize) -> Self {
        Self {
            of: vec![0; parts],
            groups: parts.min(1),
        }
    }

    /// The group of a part.
    #[must_use]
    pub fn of(&self, part: usize) -> Option<usize> {
        self.of.get(part).copied()
    }

    /// Whether each part is alone.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.groups == self.of.len()
    }

    /// Takes all groups apart along an axis, by the arrows from parts to those that are in their way. Says whether
    /// any came apart.
    pub fn along(&mut self, arrows: &[(usize, usize)]) -> bool {
        let mut graph: DiGraph<(), ()> = DiGraph::with_capacity(self.of.len(), arrows.len());
        for _ in &self.of {
            graph.add_node(());
        }
        for (part, by) in arrows {
            if self.of.get(*part) == self.of.get(*by) && *part < self.of.len() {
                graph.add_edge(NodeIndex::new(*part), NodeIndex::new(*by), ());
            }
        }
        let before = self.groups;
        let found = tarjan_scc(&graph);
        self.groups = found.len();
        for (group, nodes) in found.into_iter().enumerate() {
            for node in nodes {
                if let Some(of) = self.of.get_mut(node.index()) {
                    *of = group;
                }
            }
        }
        self.groups > before
    }

    /// The groups, by their first parts, each in the order of the parts.
    #[must_use]
    pub fn each(&self) -> Vec<Vec<usize>> {
        let mut at: BTreeMap<usize, usize> = BTreeMap::new();
        let mut out: Vec<Vec<usize>> = Vec::new();
        for (part, group) in self.of.iter().enumerate() {
            let at = *at.entry(*group).or_insert(out.len());
            match out.get_mut(at) {
                Some(list) => list.push(part),
                None => out.push(vec![part]),
            }
        }
        out
    }
}

/// A pair of a group that holds each other along every axis, both ways.
#[must_use]
pub fn locked<'a>(group: &'a [String], ways: &[Way]) -> Option<(&'a str, &'a str)> {
    let place: BTreeMap<&String, usize> = group.iter().zip(0..).collect();
    let mut held: Option<BTreeSet<(usize, usize)>> = None;
    for way in ways {
        let arrow = |part, by| Some((*place.get(part)?, *place.get(by)?));
        let arrows = way.stops.iter().filter_map(|s| arrow(&s.part, &s.by));
        let arrows: BTreeSet<(usize, usize)> = arrows.collect();
        let both = |(a, b): &(usize, usize)| a < b && arrows.contains(&(*b, *a));
        let here: BTreeSet<(usize, usize)> = arrows.iter().copied().filter(both).collect();
        held = Some(match held {
            Some(before) => before.intersection(&here).copied().collect(),
            None => here,
        });
    }
    let (a, b) = held?.first().copied()?;
    Some((group.get(a)?, group.get(b)?))
}

#[cfg(test)]
mod tests {
    use super::{groups, locked};
    use crate::facts::{Stop, Way};

    fn way(stops: &[(&str, &str)]) -> Way {
        let stop = |(part, by): &(&str, &str)| Stop {
            part: (*part).to_owned(),
            by: (*by).to_owned(),
            play_mm: 0.0,
        };
        Way {
            axis: [0.0, 0.0, 1.0],
            stops: stops.iter().map(stop).collect(),
        }
    }

    fn named(names: &[&str]) -> Vec<String> {
        names.iter().map(|n| (*n).to_owned()).collect()
    }

    #[test]
    fn a_stack_comes_apart_and_a_ring_does_not() {
        let parts = named(&["a", "b", "c"]);
        let stack = way(&[("a", "b"), ("b", "c"), ("a", "c")]);
        assert_eq!(groups(&parts, &[stack]).len(), 3);
        let ring = way(&[("a", "b"), ("b", "c"), ("c", "a")]);
        let left = groups(&parts, std::slice::from_ref(&ring));
        assert_eq!(left.len(), 1);
        assert_eq!(left[0], parts);
        // Along another axis one of them comes free, and then the rest along the first.
        let side = way(&[("a", "b"), ("b", "a"), ("a", "c"), ("b", "c")]);
        assert_eq!(groups(&parts, &[ring, side]).len(), 3);
    }

    #[test]
    fn two_parts_that_only_move_together_are_a_group() {
        let parts = named(&["base", "ship", "bottle"]);
        let up = way(&[("ship", "bottle"), ("bottle", "ship"), ("base", "ship")]);
        let left = groups(&parts, std::slice::from_ref(&up));
        assert_eq!(left, [named(&["base"]), named(&["ship", "bottle"])]);
        assert_eq!(
            locked(&left[1], std::slice::from_ref(&up)),
            Some(("ship", "bottle"))
        );
        assert_eq!(locked(&left[1], &[up, way(&[("ship", "bottle")])]), None);
        assert_eq!(locked(&left[1], &[]), None);
    }
}
