//! What the data must be as a whole.

use std::collections::{BTreeMap, BTreeSet};

use petgraph::algo::toposort;
use petgraph::graph::DiGraph;

use crate::axiom::{Axiom, Checking, Provenance};
use crate::load::{DataFault, Located};

/// Every fault of the whole.
pub(crate) fn all(axioms: &[Located]) -> Vec<DataFault> {
    let mut out = Vec::new();
    for a in axioms {
        alone(a, &mut out);
    }
    unique(axioms, &mut out);
    references(axioms, &mut out);
    if let Err(ring) = order(axioms.iter().map(|l| &l.axiom)) {
        let at = axioms.iter().find(|l| l.axiom.id == ring);
        out.extend(at.map(|l| l.fault("precedes", "it precedes itself, over others".to_owned())));
    }
    out
}

/// What an axiom must be by itself.
fn alone(l: &Located, out: &mut Vec<DataFault>) {
    let a = &l.axiom;
    let formed = {
        let mut chars = a.id.chars();
        chars.next() == Some(a.category.letter())
            && chars.next() == Some('-')
            && chars.as_str().len() == 2
            && chars.all(|c| c.is_ascii_digit())
    };
    if !formed {
        let message = format!("an id here is {}- and two digits", a.category.letter());
        out.push(l.fault("id", message));
    }
    if a.statement.chars().any(|c| c.is_ascii_digit()) {
        let message = "a statement holds no digits: numbers belong to checks and their sources";
        out.push(l.fault("statement", message.to_owned()));
    }
    if !a.statement.ends_with('.') {
        out.push(l.fault("statement", "a statement is a sentence".to_owned()));
    }
    for (field, text) in [("title", &a.title), ("rationale", &a.rationale)] {
        if text.trim().is_empty() {
            out.push(l.fault(field, format!("'{field}' is empty")));
        }
    }
    let told = match &a.provenance {
        Provenance::Anchored { source, topic, .. } => !source.is_empty() && !topic.is_empty(),
        Provenance::Synthesized { justification } => !justification.is_empty(),
    };
    if !told {
        out.push(l.fault("provenance", "the provenance is empty".to_owned()));
    }
    if let Checking::None { why } = &a.check
        && why.is_empty()
    {
        out.push(l.fault("check", "'why' is empty".to_owned()));
    }
    let twice = |n: usize, distinct: usize| n != distinct;
    let s = &a.scope;
    if twice(s.mates.len(), s.mates.iter().collect::<BTreeSet<_>>().len())
        || twice(s.ports.len(), s.ports.iter().collect::<BTreeSet<_>>().len())
        || twice(
            s.classes.len(),
            s.classes.iter().collect::<BTreeSet<_>>().len(),
        )
    {
        out.push(l.fault("scope", "the scope names something twice".to_owned()));
    }
}

/// No id, no decision and no check belongs to two axioms.
fn unique(axioms: &[Located], out: &mut Vec<DataFault>) {
    let mut seen: BTreeMap<String, &str> = BTreeMap::new();
    for l in axioms {
        let a = &l.axiom;
        let mut keys = vec![
            ("id", format!("the id {}", a.id)),
            ("decision", format!("the decision {:?}", a.decision)),
        ];
        keys.extend(a.check.id().map(|id| ("check", format!("the check {id}"))));
        for (field, key) in keys {
            match seen.get(&key) {
                Some(first) => out.push(l.fault(field, format!("{key} is {first}'s already"))),
                None => {
                    seen.insert(key, &a.id);
                }
            }
        }
    }
}

/// Ids resolve, and precedes and follows say the same.
fn references(axioms: &[Located], out: &mut Vec<DataFault>) {
    let find = |id: &str| axioms.iter().map(|l| &l.axiom).find(|a| a.id == id);
    for l in axioms {
        let a = &l.axiom;
        for (field, list, back, of) in [
            (
                "precedes",
                &a.precedes,
                "follows",
                (|b: &Axiom| b.follows.clone()) as fn(&Axiom) -> Vec<String>,
            ),
            ("follows", &a.follows, "precedes", |b: &Axiom| {
                b.precedes.clone()
            }),
        ] {
            if !list.is_sorted_by(|x, y| x < y) {
                out.push(l.fault(
                    field,
                    format!("'{field}' is sorted and names nothing twice"),
                ));
            }
            for id in list {
                match find(id) {
                    None => out.push(l.fault(field, format!("there is no axiom {id}"))),
                    Some(b) if !of(b).contains(&a.id) => {
                        let message =
                            format!("'{field}' names {id}, whose '{back}' lacks {}", a.id);
                        out.push(l.fault(field, message));
                    }
                    Some(_) => {}
                }
            }
        }
    }
}

/// The ids in an order in which each comes after those that precede it.
///
/// # Errors
/// An id that precedes itself.
pub(crate) fn order<'a>(
    axioms: impl Iterator<Item = &'a Axiom> + Clone,
) -> Result<Vec<String>, String> {
    let mut graph: DiGraph<&str, ()> = DiGraph::new();
    let nodes: BTreeMap<&str, _> = axioms
        .clone()
        .map(|a| (a.id.as_str(), graph.add_node(a.id.as_str())))
        .collect();
    for a in axioms {
        for b in &a.precedes {
            if let (Some(from), Some(to)) = (nodes.get(a.id.as_str()), nodes.get(b.as_str())) {
                graph.add_edge(*from, *to, ());
            }
        }
    }
    let name = |n| {
        graph
            .node_weight(n)
            .map_or_else(String::new, |s| (*s).to_owned())
    };
    match toposort(&graph, None) {
        Ok(order) => Ok(order.into_iter().map(name).collect()),
        Err(ring) => Err(name(ring.node_id())),
    }
}
