//! The table of the axioms for people, made from the data.

use crate::axiom::{Axiom, CATEGORIES, Checking, Provenance};
use crate::checks;
use crate::knowledge::axioms;

/// The document, as Markdown.
#[must_use]
pub fn markdown() -> String {
    let all = axioms();
    let anchored = all.iter().filter(|a| a.provenance.is_anchored()).count();
    let checkable = all.iter().filter(|a| a.check.id().is_some()).count();
    let made = all.iter().filter(|a| checks::of(a).is_some()).count();
    let mut out = format!(
        "# The engineering axioms\n\n\
         Made from `axioms/data/`; a test holds it. {} axioms: {anchored} anchored in a standard or textbook, \
         {} synthesized with their justification. {checkable} can be checked by the machine; the checks of \
         {made} are written.\n\n\
         Scope: mates, ports and classes to which an axiom applies; a side that is not named is open. \
         Checked: name of the check and the facts that it needs.\n",
        all.len(),
        all.len() - anchored,
    );
    for (category, _, title, _) in &CATEGORIES {
        out.push_str(&format!(
            "\n## {}: {title}\n\n| id | statement | scope | provenance | checked |\n|---|---|---|---|---|\n",
            category.letter()
        ));
        for a in all.iter().filter(|a| a.category == *category) {
            out.push_str(&row(a));
        }
    }
    out
}

fn row(a: &Axiom) -> String {
    let s = &a.scope;
    let mut scope = Vec::new();
    let mut side = |what: &str, names: Vec<String>| {
        if !names.is_empty() {
            scope.push(format!("{what}: {}", names.join(", ")));
        }
    };
    side("mates", s.mates.iter().map(ToString::to_string).collect());
    side("ports", s.ports.iter().map(ToString::to_string).collect());
    side(
        "classes",
        s.classes.iter().map(ToString::to_string).collect(),
    );
    if scope.is_empty() {
        scope.push("everything".to_owned());
    }
    let provenance = match &a.provenance {
        Provenance::Anchored {
            source,
            topic,
            clause,
        } => {
            let clause = clause.as_ref().map(|c| format!(", clause {c}"));
            format!("{source}: {topic}{}", clause.unwrap_or_default())
        }
        Provenance::Synthesized { justification } => format!("synthesized: {justification}"),
    };
    let checked = match &a.check {
        Checking::Checked { id, needs } => {
            let needs: Vec<&str> = needs.iter().map(|n| n.name()).collect();
            let yet = if checks::of(a).is_some() {
                ""
            } else {
                ", not written yet"
            };
            format!("`{id}` ({}){yet}", needs.join(", "))
        }
        Checking::None { why } => format!("no: {why}"),
    };
    format!(
        "| {} | **{}.** {} | {} | {provenance} | {checked} |\n",
        a.id,
        a.title,
        a.statement,
        scope.join("; ")
    )
}
