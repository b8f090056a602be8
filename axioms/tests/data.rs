//! The knowledge base as a whole.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use std::collections::{BTreeMap, BTreeSet};

use assemcad_axioms::axiom::{CATEGORIES, Checking, Force, Provenance};
use assemcad_axioms::knowledge::{FILES, axiom};
use assemcad_axioms::{KnowledgeBase, axioms, checks, class, docs};
use assemcad_model::{mates, ports};
use petgraph::algo::is_cyclic_directed;
use petgraph::graph::DiGraph;

#[test]
fn the_data_are_in_order() {
    let faults = KnowledgeBase::built_in().map_err(<[_]>::to_vec).err();
    assert_eq!(faults, None);
}

#[test]
fn sixty_two_in_ten_categories() {
    assert_eq!(axioms().len(), 62);
    for (category, file, _, count) in CATEGORIES {
        let ids: Vec<&str> = axioms()
            .iter()
            .filter(|a| a.category == category)
            .map(|a| a.id.as_str())
            .collect();
        let wanted: Vec<String> = (1..=count)
            .map(|n| format!("{}-{n:02}", category.letter()))
            .collect();
        assert_eq!(ids, wanted);
        assert!(
            FILES
                .iter()
                .any(|(name, _)| *name == format!("{file}.yaml"))
        );
    }
}

#[test]
fn every_file_is_embedded() {
    let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/data")).unwrap();
    let mut files: Vec<String> = files
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    let listed: Vec<&str> = FILES.iter().map(|f| f.0).collect();
    assert_eq!(files, listed);
}

#[test]
fn every_mate_type_port_type_and_class_is_covered() {
    for kind in mates::ALL {
        let n = axioms()
            .iter()
            .filter(|a| a.scope.mates.contains(&kind.mate_type));
        assert!(n.count() > 0, "{}", kind.name);
    }
    for kind in ports::ALL {
        let n = axioms()
            .iter()
            .filter(|a| a.scope.ports.contains(&kind.port_type));
        assert!(n.count() > 0, "{}", kind.name);
    }
    for (class, name) in class::ALL {
        let n = axioms().iter().filter(|a| a.scope.classes.contains(&class));
        assert!(n.count() > 0, "{name}");
    }
}

#[test]
fn scopes_are_disjoint() {
    let decisions: BTreeSet<_> = axioms().iter().map(|a| a.decision).collect();
    assert_eq!(decisions.len(), axioms().len());
    // No word of the vocabulary is left over.
    let schema = assemcad_axioms::entry::file_schema();
    let words = schema
        .pointer("/properties/axioms/items/properties/decision/enum")
        .unwrap();
    assert_eq!(words.as_array().unwrap().len(), decisions.len());
    let statements: BTreeSet<_> = axioms().iter().map(|a| &a.statement).collect();
    assert_eq!(statements.len(), axioms().len());
}

/// Held here with another method than the loader's: a cycle is searched, not an order.
#[test]
fn precedence_is_acyclic_and_told_from_both_sides() {
    let mut graph: DiGraph<&str, ()> = DiGraph::new();
    let nodes: BTreeMap<&str, _> = axioms()
        .iter()
        .map(|a| (a.id.as_str(), graph.add_node(&a.id)))
        .collect();
    let (mut edges, mut back) = (BTreeSet::new(), BTreeSet::new());
    for a in axioms() {
        for b in &a.precedes {
            assert!(axiom(b).is_some(), "{b}");
            graph.add_edge(nodes[a.id.as_str()], nodes[b.as_str()], ());
            edges.insert((a.id.as_str(), b.as_str()));
        }
        for b in &a.follows {
            assert!(axiom(b).is_some(), "{b}");
            back.insert((b.as_str(), a.id.as_str()));
        }
    }
    assert!(!is_cyclic_directed(&graph));
    assert_eq!(edges, back);
    assert!(edges.len() > 30);
    let order = KnowledgeBase::built_in().unwrap().order();
    let place: BTreeMap<&str, usize> = order
        .iter()
        .enumerate()
        .map(|(i, s)| (s.as_str(), i))
        .collect();
    assert!(edges.iter().all(|(a, b)| place[a] < place[b]));
}

#[test]
fn statements_have_their_form() {
    for a in axioms() {
        assert_eq!(Force::of(&a.statement), Some(a.force), "{}", a.id);
        assert!(
            !a.statement.contains(|c: char| c.is_ascii_digit()),
            "{}",
            a.id
        );
        assert!(a.statement.len() < 260, "{}", a.id);
    }
}

#[test]
fn provenance_is_told() {
    let mut anchored = 0;
    for a in axioms() {
        match &a.provenance {
            Provenance::Anchored { source, topic, .. } => {
                anchored += 1;
                assert!(source.len() > 10 && topic.len() > 5, "{}", a.id);
            }
            Provenance::Synthesized { justification } => {
                assert!(justification.len() > 30, "{}", a.id)
            }
        }
    }
    // The count as it is: what is claimed elsewhere is read from here.
    assert_eq!((anchored, axioms().len() - anchored), (45, 17));
}

#[test]
fn at_least_forty_five_are_checkable() {
    let checked: Vec<&str> = axioms().iter().filter_map(|a| a.check.id()).collect();
    assert!(checked.len() >= 45, "{}", checked.len());
    for a in axioms() {
        match &a.check {
            Checking::Checked { id, needs } => assert!(!needs.is_empty(), "{id}"),
            Checking::None { why } => assert!(why.len() > 30, "{}", a.id),
        }
    }
}

#[test]
fn every_check_is_listed_and_belongs_to_its_axiom() {
    let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/checks")).unwrap();
    let mut files: Vec<String> = files
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .filter(|f| f != "mod.rs")
        .map(|f| f.trim_end_matches(".rs").to_owned())
        .collect();
    files.sort();
    let listed: Vec<&str> = checks::ALL.iter().map(|c| c.id()).collect();
    assert_eq!(files, listed);
    for check in checks::ALL {
        let a = axiom(check.axiom()).unwrap();
        assert_eq!(a.check.id(), Some(check.id()), "{}", a.id);
    }
}

/// The ids that drafts and documents of the workspace cite.
#[test]
fn cited_ids_exist() {
    for id in [
        "C-01", "C-02", "P-01", "G-02", "F-01", "F-03", "K-01", "T-01",
    ] {
        assert!(axiom(id).is_some(), "{id}");
    }
}

#[test]
fn the_table_is_that_of_the_data() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/axioms.md");
    let text = docs::markdown();
    if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
        std::fs::write(path, &text).unwrap();
    }
    assert!(
        std::fs::read_to_string(path).unwrap_or_default() == text,
        "docs/axioms.md is not what the data say; accept it with\n  \
         ASSEMCAD_ACCEPT=1 cargo test -p assemcad-axioms table"
    );
}
