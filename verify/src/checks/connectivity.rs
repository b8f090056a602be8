//! The check `connectivity`: the root holds every part over mates.

use std::collections::BTreeSet;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::Verdict;
use assemcad_model::spec::Assembly;
use assemcad_placing::Resolved;
use petgraph::graph::{NodeIndex, UnGraph};
use petgraph::visit::Bfs;

use crate::results::Results;

/// Parts that no chain of mates joins to the root, one finding for each island.
pub(crate) fn check(spec: &Assembly, resolved: &Resolved, results: &mut Results) {
    let mut graph = UnGraph::<(), ()>::new_undirected();
    let nodes: Vec<NodeIndex> = resolved.parts.iter().map(|_| graph.add_node(())).collect();
    for m in &resolved.mates {
        if let (Some(a), Some(b)) = (nodes.get(m.base), nodes.get(m.incoming)) {
            graph.add_edge(*a, *b, ());
        }
    }
    let mut seen = vec![false; nodes.len()];
    let mut reach = |from: usize| -> Vec<usize> {
        let mut island = Vec::new();
        if let Some(start) = nodes.get(from) {
            let mut walk = Bfs::new(&graph, *start);
            while let Some(node) = walk.next(&graph) {
                if let Some(s) = seen.get_mut(node.index()) {
                    *s = true;
                }
                island.push(node.index());
            }
        }
        island.sort_unstable();
        island
    };
    let mut islands = Vec::new();
    let root = resolved.root.map(&mut reach);
    let mut joined: BTreeSet<usize> = root.into_iter().flatten().collect();
    for i in 0..nodes.len() {
        if !joined.contains(&i) {
            let island = reach(i);
            joined.extend(&island);
            islands.push(island);
        }
    }
    let verdict = if islands.is_empty() {
        Verdict::Pass
    } else {
        Verdict::Fail
    };
    let root = spec.root().unwrap_or_default();
    for island in islands {
        let names: Vec<String> = island
            .iter()
            .filter_map(|i| resolved.parts.get(*i))
            .map(|p| p.id.clone())
            .collect();
        let listed = names
            .iter()
            .map(|n| format!("'{n}'"))
            .collect::<Vec<_>>()
            .join(", ");
        let d = Diagnostic::error(
            Code::Unconnected,
            format!("part {listed}"),
            format!("no mate joins {listed} to the root '{root}'"),
        )
        .hint("join it with the mate tool, or take it away with the remove tool");
        results.find(Verdict::Fail, "connectivity", names, d);
    }
    results.check(
        "connectivity",
        verdict,
        nodes.len(),
        "every part reached from the root over mates",
    );
}
