//! Finding axioms, and whether one applies to a mate.

use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

use crate::axiom::Axiom;
use crate::class::Class;
use crate::knowledge;

/// What is asked for. What is left empty does not narrow the answer.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Query {
    /// The mate type it must apply to.
    pub mate_type: Option<MateType>,
    /// Port types, of which it must apply to one at least.
    pub port_types: Vec<PortType>,
    /// Component classes, of which it must apply to one at least.
    pub classes: Vec<Class>,
    /// Words in id, title, statement, rationale or decision, of which one at least must occur.
    pub words: String,
    /// The id.
    pub id: Option<String>,
}

/// Whether an axiom applies to a mate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Applicability {
    /// It does.
    Applies,
    /// It does not.
    Not {
        /// Why, in one sentence.
        reason: String,
    },
}

impl Applicability {
    /// Whether it applies.
    #[must_use]
    pub fn holds(&self) -> bool {
        matches!(self, Self::Applies)
    }
}

/// The embedded axioms that a query asks for: those whose scope names what was asked before those that
/// leave it open, then those with more of the words, then by id.
#[must_use]
pub fn find(query: &Query) -> Vec<&'static Axiom> {
    find_in(knowledge::axioms(), query)
}

/// As [`find`], among given axioms.
#[must_use]
pub fn find_in<'a>(axioms: &'a [Axiom], query: &Query) -> Vec<&'a Axiom> {
    let words = words_of(&query.words);
    let mut found: Vec<(usize, usize, &Axiom)> = Vec::new();
    for a in axioms {
        if query
            .id
            .as_ref()
            .is_some_and(|id| !a.id.eq_ignore_ascii_case(id))
        {
            continue;
        }
        let s = &a.scope;
        let mates: Vec<MateType> = query.mate_type.into_iter().collect();
        let Some(exact) = narrowed(&mates, &s.mates)
            .zip(narrowed(&query.port_types, &s.ports))
            .zip(classes_narrowed(&query.classes, &s.classes))
            .map(|((m, p), c)| m + p + c)
        else {
            continue;
        };
        let hits = hits(a, &words);
        if words.is_empty() || hits > 0 {
            found.push((exact, hits, a));
        }
    }
    found.sort_by(|x, y| (y.0, y.1, &x.2.id).cmp(&(x.0, x.1, &y.2.id)));
    found.into_iter().map(|(_, _, a)| a).collect()
}

/// How exactly a list of the scope answers what was asked: none where it excludes it, 1 where it names it,
/// 0 where nothing was asked or the list is open.
fn narrowed<T: PartialEq>(asked: &[T], listed: &[T]) -> Option<usize> {
    if asked.is_empty() || listed.is_empty() {
        return Some(0);
    }
    asked.iter().any(|x| listed.contains(x)).then_some(1)
}

/// A custom part may be of any class: it excludes nothing.
fn classes_narrowed(asked: &[Class], listed: &[Class]) -> Option<usize> {
    match narrowed(asked, listed) {
        None if asked.contains(&Class::Custom) => Some(0),
        other => other,
    }
}

fn words_of(text: &str) -> Vec<String> {
    let mut words: Vec<String> = text
        .split(|c: char| !c.is_alphanumeric() && c != '-')
        .filter(|w| !w.is_empty())
        .map(str::to_lowercase)
        .collect();
    words.sort();
    words.dedup();
    words
}

/// Hits in title and id count three times, those in the statement twice.
fn hits(a: &Axiom, words: &[String]) -> usize {
    let decision = format!("{:?}", a.decision).to_lowercase();
    let fields = [
        (3, a.id.to_lowercase()),
        (3, a.title.to_lowercase()),
        (2, a.statement.to_lowercase()),
        (1, a.rationale.to_lowercase()),
        (1, decision),
    ];
    let weight = |w: &String| -> usize {
        let hit = |(n, text): &(usize, String)| if text.contains(w.as_str()) { *n } else { 0 };
        fields.iter().map(hit).sum()
    };
    words.iter().map(weight).sum()
}

/// Whether an axiom applies to a mate: its scope names the mate's type, one of the two port types and one
/// of the two parts' classes, where it names any. A custom part may be of any class.
#[must_use]
pub fn applies(
    axiom: &Axiom,
    mate_type: MateType,
    base: PortType,
    incoming: PortType,
    classes: &[Class],
) -> Applicability {
    let s = &axiom.scope;
    let reason = if narrowed(&[mate_type], &s.mates).is_none() {
        let listed: Vec<String> = s.mates.iter().map(ToString::to_string).collect();
        format!("is about the mates {}, not {mate_type}", listed.join(", "))
    } else if narrowed(&[base, incoming], &s.ports).is_none() {
        let listed: Vec<String> = s.ports.iter().map(ToString::to_string).collect();
        let listed = listed.join(", ");
        format!("is about ports of the types {listed}, not {base} and {incoming}")
    } else if classes_narrowed(classes, &s.classes).is_none() {
        let listed: Vec<&str> = s.classes.iter().map(|c| c.name()).collect();
        let given: Vec<&str> = classes.iter().map(|c| c.name()).collect();
        let (listed, given) = (listed.join(", "), given.join(" and "));
        format!("is about parts of the classes {listed}, not {given}")
    } else {
        return Applicability::Applies;
    };
    Applicability::Not {
        reason: format!("{} ('{}') {reason}", axiom.id, axiom.title),
    }
}

/// The embedded axioms that apply to a mate: the narrowest scope first, then by id.
#[must_use]
pub fn applicable_to(
    mate_type: MateType,
    base: PortType,
    incoming: PortType,
    classes: &[Class],
) -> Vec<&'static Axiom> {
    let mut all: Vec<&Axiom> = knowledge::axioms()
        .iter()
        .filter(|a| applies(a, mate_type, base, incoming, classes).holds())
        .collect();
    // How many of the three lists are stated, then how much they leave open.
    let width = |a: &Axiom| {
        let s = &a.scope;
        let stated = [s.mates.len(), s.ports.len(), s.classes.len()];
        let open = stated.iter().filter(|n| **n == 0).count();
        (open, stated.iter().sum::<usize>())
    };
    all.sort_by(|a, b| (width(a), &a.id).cmp(&(width(b), &b.id)));
    all
}
