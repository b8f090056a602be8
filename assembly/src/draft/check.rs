//! What can be wrong with a draft beyond its form.

use assemcad_factories::Registry;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::MateType;
use assemcad_model::name::{self, nearest};
use assemcad_model::param::clip;
use assemcad_model::spec::{End, Mate};
use serde_json::{Value, json};

use super::read::{Draft, Loose};
use crate::place;
use crate::resolve::{self, Resolved, ResolvedMate, ResolvedPart};

/// Everything that is wrong with parts and mates. What depends on something that is itself at fault is
/// not guessed at.
pub(super) fn check(registry: &Registry, draft: &Draft) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    if draft.parts.is_empty() && draft.mates.is_empty() && draft.id.is_none() {
        // Nothing of it could be read; the form's faults say all.
        return found;
    }
    if let Some(id) = &draft.id
        && !name::is_valid(id)
    {
        found.push(bad_name(draft.place("id"), id));
    }
    if draft.parts.is_empty() {
        found.push(
            Diagnostic::error(
                Code::AssemblyEmpty,
                draft.place("parts"),
                "the assembly has no parts",
            )
            .next("list_factories", json!({})),
        );
    }
    names(draft, "parts", &draft.parts, &mut found);
    names(draft, "mates", &draft.mates, &mut found);
    let parts = parts(registry, draft, &mut found);
    let mates = mates(draft, &parts, &mut found);
    let root = root(draft, &mut found);
    unreached(draft, root, &mut found);
    coincident(draft, &parts, &mates, root, &mut found);
    unsupported(draft, root, &mut found);
    found
}

fn bad_name(place: String, name: &str) -> Diagnostic {
    Diagnostic::error(Code::NameInvalid, place, "this is not a name")
        .found(name)
        .expected(name::RULE)
}

fn names<T>(draft: &Draft, list: &str, all: &[Loose<T>], found: &mut Vec<Diagnostic>) {
    for (i, item) in all.iter().enumerate() {
        let Some(id) = &item.id else { continue };
        let place = draft.place(&format!("{list}[{i}].id"));
        if !name::is_valid(id) {
            found.push(bad_name(place, id));
        } else if let Some(first) = all.iter().position(|x| x.id.as_ref() == Some(id))
            && first < i
        {
            let at = draft.place(&format!("{list}[{first}].id"));
            found.push(
                Diagnostic::error(
                    Code::NameTaken,
                    place,
                    format!("'{id}' is the name of {at} already"),
                )
                .found(id.as_str()),
            );
        }
    }
}

/// The parts that resolve, each with its index in the draft.
fn parts(
    registry: &Registry,
    draft: &Draft,
    found: &mut Vec<Diagnostic>,
) -> Vec<(usize, ResolvedPart)> {
    let mut resolved = Vec::new();
    for (i, loose) in draft.parts.iter().enumerate() {
        let Some(part) = &loose.whole else { continue };
        let place = format!("parts[{i}]");
        match resolve::part(registry, part, &place) {
            Ok(part) => resolved.push((i, part)),
            Err(faults) => found.extend(faults.into_iter().map(|d| {
                let at = if d.place == "factory" {
                    draft.place(&format!("{place}.factory"))
                } else if d.place.starts_with(&place) {
                    draft.place(&d.place)
                } else {
                    // A place in the factory's own source.
                    format!("{}, {}", draft.place(&place), d.place)
                };
                synthesis(d.at(at))
            })),
        }
    }
    resolved
}

fn synthesis(d: Diagnostic) -> Diagnostic {
    if d.code != Code::FactoryUnknown {
        return d;
    }
    let near = d.hint.clone().map(|h| format!("{h} ")).unwrap_or_default();
    d.hint(format!(
        "{near}If none of the factories makes this part, a synthesized one could serve."
    ))
}

fn mates(
    draft: &Draft,
    parts: &[(usize, ResolvedPart)],
    found: &mut Vec<Diagnostic>,
) -> Vec<(usize, ResolvedMate)> {
    let there: Vec<ResolvedPart> = parts.iter().map(|(_, p)| p.clone()).collect();
    let assembly = draft.id.as_deref().unwrap_or_default();
    let mut resolved = Vec::new();
    for (i, loose) in draft.mates.iter().enumerate() {
        let Some(mate) = &loose.whole else { continue };
        let at = |field: &str| format!("mates[{i}].{field}");
        if ends(draft, &there, mate, &at, found) {
            match resolve::mate(&there, assembly, mate, &at) {
                Ok(mate) => resolved.push((i, mate)),
                Err(faults) => {
                    let place = |d| placed(draft, for_a_draft(d));
                    found.extend(faults.into_iter().map(place));
                }
            }
        } else {
            // One of its parts is at fault itself: what does not depend on that part is still checked.
            let kind = mate.mate_type.kind();
            if let Err(faults) = kind.check_options(&mate.options, &at("options")) {
                found.extend(faults.into_iter().map(|d| placed(draft, d)));
            }
            for (end, field) in [(&mate.base, "base"), (&mate.incoming, "incoming")] {
                if there.iter().any(|p| p.id == end.part)
                    && let Err(d) = resolve::port(&there, end, &at(field))
                {
                    found.push(placed(draft, d));
                }
            }
        }
        if mate.axioms.is_empty() {
            let place = draft.place(&format!("mates[{i}]"));
            found.push(
                Diagnostic::warning(
                    Code::AxiomMissing,
                    place,
                    format!("the mate '{}' cites no axiom", clip(&mate.id)),
                )
                .hint("say why it is there: axioms: [...], or a note while none fits"),
            );
        }
    }
    resolved
}

/// Whether both parts of a mate are there and in order; names that no part has are told.
fn ends(
    draft: &Draft,
    there: &[ResolvedPart],
    mate: &Mate,
    at: &dyn Fn(&str) -> String,
    found: &mut Vec<Diagnostic>,
) -> bool {
    let mut whole = true;
    let mut end = |end: &End, field: &str| {
        whole &= there.iter().any(|p| p.id == end.part);
        let named = |p: &Loose<_>| p.id.as_ref() == Some(&end.part);
        if !draft.parts.iter().any(named) {
            let place = draft.place(&format!("{}.ref", at(field)));
            found.push(part_unknown(draft, &end.part, place));
        }
    };
    end(&mate.base, "base");
    end(&mate.incoming, "incoming");
    whole
}

fn part_unknown(draft: &Draft, id: &str, place: String) -> Diagnostic {
    let names: Vec<&str> = draft.parts.iter().filter_map(|p| p.id.as_deref()).collect();
    let d = Diagnostic::error(
        Code::PartUnknown,
        place,
        format!("there is no part '{}'", clip(id)),
    )
    .found(id)
    .expected(json!(names));
    match nearest(id, names.iter().copied(), 1).first() {
        Some(near) => d.hint(format!("did you mean '{near}'?")),
        None => d,
    }
}

/// A draft is mended in its text, not by a call.
fn for_a_draft(mut d: Diagnostic) -> Diagnostic {
    if let Some(next) = d.next.take() {
        let word = |key: &str| {
            let value = next.arguments.get(key).and_then(Value::as_str);
            value.unwrap_or_default().to_owned()
        };
        d.hint = Some(format!(
            "this would fit: mate_type {}, base {}, incoming {}",
            word("mate_type"),
            word("base"),
            word("incoming")
        ));
    }
    d
}

fn placed(draft: &Draft, d: Diagnostic) -> Diagnostic {
    let field = match d.code {
        Code::PortUnknown => ".port",
        Code::PartUnknown => ".ref",
        _ => "",
    };
    let place = draft.place(&format!("{}{field}", d.place));
    d.at(place)
}

/// The index of the root in the draft.
fn root(draft: &Draft, found: &mut Vec<Diagnostic>) -> Option<usize> {
    let Some(id) = &draft.root else {
        return (!draft.parts.is_empty()).then_some(0);
    };
    let index = draft.parts.iter().position(|p| p.id.as_ref() == Some(id));
    if index.is_none() {
        found.push(part_unknown(draft, id, draft.place("root")));
    }
    index
}

/// Parts that no chain of mates joins to the root.
fn unreached(draft: &Draft, root: Option<usize>, found: &mut Vec<Diagnostic>) {
    let Some(root) = root else { return };
    let index = |id: &String| draft.parts.iter().position(|p| p.id.as_ref() == Some(id));
    let mut reached = vec![false; draft.parts.len()];
    let mut edges = Vec::new();
    let mut reach = vec![root];
    for mate in &draft.mates {
        let ends: Vec<usize> = mate.joins.iter().filter_map(index).collect();
        match ends.as_slice() {
            [a, b] => edges.push((*a, *b)),
            // Its other end is told as a fault; mended, it may well lead to the root.
            [one] => reach.push(*one),
            _ => {}
        }
    }
    while let Some(part) = reach.pop() {
        match reached.get_mut(part) {
            Some(seen) if !*seen => *seen = true,
            _ => continue,
        }
        for (a, b) in &edges {
            if *a == part {
                reach.push(*b);
            } else if *b == part {
                reach.push(*a);
            }
        }
    }
    let name = |i: usize| draft.parts.get(i).and_then(|p| p.id.as_deref());
    for (i, _) in reached.iter().enumerate().filter(|(_, seen)| !**seen) {
        let Some(id) = name(i) else { continue };
        // Of two parts with one name only the first can be meant; that is told already.
        if index(&id.to_owned()) != Some(i) {
            continue;
        }
        let root = name(root).unwrap_or_default();
        let message = format!("no mate joins '{}' to the root '{}'", clip(id), clip(root));
        let place = draft.place(&format!("parts[{i}]"));
        found.push(
            Diagnostic::error(Code::Unconnected, place, message)
                .hint("add a mate that joins it to a part that has a place, or leave it out"),
        );
    }
}

/// Parts that land in the same place.
fn coincident(
    draft: &Draft,
    parts: &[(usize, ResolvedPart)],
    mates: &[(usize, ResolvedMate)],
    root: Option<usize>,
    found: &mut Vec<Diagnostic>,
) {
    let resolved = Resolved {
        parts: parts.iter().map(|(_, p)| p.clone()).collect(),
        mates: mates.iter().map(|(_, m)| m.clone()).collect(),
        root: parts.iter().position(|(i, _)| Some(*i) == root),
    };
    let Ok(placed) = place::assembly(&resolved) else {
        return;
    };
    let by = |part: usize| {
        let mate = placed.placed_by.get(part).copied().flatten()?;
        resolved.mates.get(mate).map(|m| (mate, m))
    };
    for (j, (_, second)) in parts.iter().enumerate() {
        let Some((mate, m)) = by(j) else { continue };
        let twin = parts
            .iter()
            .enumerate()
            .take(j)
            .find_map(|(i, (_, first))| {
                let (_, n) = by(i)?;
                let same = first.made.recipe == second.made.recipe;
                match (placed.of(i), placed.of(j)) {
                    (Some(a), Some(b)) if same && a == b => Some((first, true)),
                    _ => (faces_meet(n, m) && shared(n, i, m, j)).then_some((first, false)),
                }
            });
        let Some((first, sure)) = twin else { continue };
        let index = mates.get(mate).map(|(i, _)| *i).unwrap_or_default();
        let place = draft.place(&format!("mates[{index}]"));
        let d = if sure {
            Diagnostic::error(
                Code::Coincident,
                place,
                format!("'{}' lands in the very place of '{}'", second.id, first.id),
            )
        } else {
            Diagnostic::warning(
                Code::Coincident,
                place,
                format!(
                    "'{}' lands on the same point of the same face as '{}'",
                    second.id, first.id
                ),
            )
        };
        found.push(d.hint("give one of the two mates an offset, or use another port"));
    }
}

/// Gears that nothing holds but the teeth of another: no bearing, no shaft, no bore.
fn unsupported(draft: &Draft, root: Option<usize>, found: &mut Vec<Diagnostic>) {
    for (i, part) in draft.parts.iter().enumerate() {
        let Some(id) = part.id.as_ref().filter(|_| Some(i) != root) else {
            continue;
        };
        let mut of = draft
            .mates
            .iter()
            .filter(|m| m.joins.contains(id))
            .peekable();
        // A mate whose form is at fault may yet become one that holds it.
        let teeth = |m: &Loose<Mate>| {
            let whole = m.whole.as_ref();
            whole.is_some_and(|m| m.mate_type == MateType::GearMesh)
        };
        if of.peek().is_some() && of.all(teeth) {
            let place = draft.place(&format!("parts[{i}]"));
            let message = format!("'{}' is held by nothing but its teeth", clip(id));
            found.push(
                Diagnostic::warning(Code::Unsupported, place, message)
                    .hint("mate its bore with a shaft, and the shaft with bearings"),
            );
        }
    }
}

/// Whether two mates put faces on faces with equal options.
fn faces_meet(n: &ResolvedMate, m: &ResolvedMate) -> bool {
    n.mate.mate_type == m.mate.mate_type
        && n.options == m.options
        && n.mate.mate_type == MateType::FaceToFace
}

/// Whether two mates bring their parts (by index) to the same port of the same part.
fn shared(n: &ResolvedMate, i: usize, m: &ResolvedMate, j: usize) -> bool {
    let other = |m: &ResolvedMate, part: usize| {
        if m.base == part {
            m.mate.incoming.clone()
        } else {
            m.mate.base.clone()
        }
    };
    let side = (n.base == i) == (m.base == j);
    side && other(n, i) == other(m, j)
}
