//! Taking an assembly apart along straight ways.
//!
//! A set of parts moves along a direction when nothing outside of the set is in its way. Draw an arrow from a
//! part to each that is in its way: such sets exist, other than all parts together, if and only if not every
//! part reaches every other one along the arrows, and what comes apart are the strongly connected components
//! (R. H. Wilson, J.-C. Latombe, "Geometric reasoning about mechanical assembly", Artificial Intelligence 71,
//! 1994). What comes apart never gets in each other's way again, so that no choice of an order loses
//! anything. The other way along the same axis turns all arrows round and has the same components.

use std::collections::BTreeMap;

use petgraph::algo::tarjan_scc;
use petgraph::graph::{DiGraph, NodeIndex};

use crate::facts::Way;

/// The groups that are left when the parts are taken apart along all axes, again and again until nothing more
/// comes apart: sorted, each in the order of the parts. Where every group is one part, there is an order of
/// assembly.
#[must_use]
pub fn groups(parts: &[String], ways: &[Way]) -> Vec<Vec<String>> {
    let mut groups = vec![parts.to_vec()];
    loop {
        let before = groups.len();
        for way in ways {
            groups = groups.iter().flat_map(|g| split(g, way)).collect();
        }
        if groups.len() == before {
            break;
        }
    }
    groups.retain(|g| !g.is_empty());
    let place = |g: &Vec<String>| parts.iter().position(|p| g.first() == Some(p));
    groups.sort_by_key(place);
    groups
}

/// What a group falls into along one axis.
fn split(group: &[String], way: &Way) -> Vec<Vec<String>> {
    if group.len() < 2 {
        return vec![group.to_vec()];
    }
    let mut graph: DiGraph<&String, ()> = DiGraph::new();
    let nodes: BTreeMap<&String, NodeIndex> =
        group.iter().map(|p| (p, graph.add_node(p))).collect();
    for stop in &way.stops {
        if let (Some(part), Some(by)) = (nodes.get(&stop.part), nodes.get(&stop.by)) {
            graph.add_edge(*part, *by, ());
        }
    }
    let name = |n: NodeIndex| graph.node_weight(n).map(|p| (*p).clone());
    tarjan_scc(&graph)
        .into_iter()
        .map(|mut nodes| {
            nodes.sort();
            nodes.into_iter().filter_map(name).collect()
        })
        .collect()
}

/// A pair of a group that holds each other along every axis, both ways.
#[must_use]
pub fn locked<'a>(group: &'a [String], ways: &[Way]) -> Option<(&'a str, &'a str)> {
    let stopped = |way: &Way, part: &String, by: &String| {
        way.stops.iter().any(|s| s.part == *part && s.by == *by)
    };
    let held = |a: &String, b: &String| {
        let both = |way: &Way| stopped(way, a, b) && stopped(way, b, a);
        !ways.is_empty() && ways.iter().all(both)
    };
    group.iter().enumerate().find_map(|(i, a)| {
        let b = group.iter().skip(i + 1).find(|b| held(a, b))?;
        Some((a.as_str(), b.as_str()))
    })
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
