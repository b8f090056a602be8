//! Faults of the data are told with their lines.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use assemcad_axioms::load::load;

const GOOD: &str = "category: F
axioms:
  - id: F-01
    title: one
    statement: It MUST hold.
    decision: part_connected
    scope: {}
    rationale: because
    provenance: {kind: synthesized, justification: ours}
    precedes: [F-02]
    check: {kind: none, why: not here}
  - id: F-02
    title: two
    statement: It MUST NOT fall.
    decision: ground_choice
    scope: {mates: [coaxial], ports: [BORE], classes: [rotary/shaft]}
    rationale: because
    provenance: {kind: anchored, source: a book, topic: a chapter}
    follows: [F-01]
    check: {kind: checked, id: x, needs: [specification]}
";

fn faults(from: &str, to: &str) -> Vec<String> {
    assert!(GOOD.contains(from), "{from}");
    let text = GOOD.replacen(from, to, 1);
    let faults = load(&[("f.yaml", &text)]).err().unwrap_or_default();
    faults.iter().map(ToString::to_string).collect()
}

#[test]
fn good_data_load_sorted() {
    let axioms = load(&[("f.yaml", GOOD)]).unwrap();
    assert_eq!(axioms.len(), 2);
    assert_eq!(axioms[0].id, "F-01");
}

#[test]
fn each_fault_has_its_line() {
    for (from, to, line, part) in [
        ("id: F-01", "id: G-01", 3, "an id here is F-"),
        ("It MUST hold.", "It holds.", 5, "one of MUST"),
        ("It MUST hold.", "It MUST hold for 3 days.", 5, "no digits"),
        ("part_connected", "which_colour", 6, "which_colour"),
        (
            "decision: part_connected",
            "decision: ground_choice",
            15,
            "already",
        ),
        ("scope: {}", "scope: {mates: [glue]}", 7, "glue"),
        ("justification: ours", "source: ours", 9, "justification"),
        ("precedes: [F-02]", "precedes: [F-03]", 10, "no axiom F-03"),
        ("precedes: [F-02]", "precedes: []", 19, "lacks F-02"),
        (
            "classes: [rotary/shaft]",
            "classes: [rotary/axle]",
            16,
            "rotary/axle",
        ),
        (
            "topic: a chapter",
            "justification: none",
            18,
            "anchored takes",
        ),
        ("needs: [specification]", "needs: []", 20, "checked takes"),
        ("title: two", "titel: two", 13, "titel"),
        ("title: one", "title: 'one", 5, ""),
    ] {
        let found = faults(from, to);
        assert!(
            found.iter().any(|f| f.contains(part)
                && (part.is_empty() || f.starts_with(&format!("f.yaml:{line}:")))),
            "{to}: {found:?}"
        );
    }
}

#[test]
fn a_ring_of_precedence_is_a_fault() {
    let ring = GOOD
        .replacen(
            "precedes: [F-02]",
            "precedes: [F-02]\n    follows: [F-02]",
            1,
        )
        .replacen(
            "follows: [F-01]",
            "precedes: [F-01]\n    follows: [F-01]",
            1,
        );
    let faults = load(&[("f.yaml", &ring)]).unwrap_err();
    assert_eq!(faults.len(), 1, "{faults:?}");
    assert!(faults[0].message.contains("precedes itself"));
}
