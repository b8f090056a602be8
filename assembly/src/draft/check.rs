//! What can be wrong with a draft beyond its form.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::name::{self, instead};
use assemcad_model::param::clip;
use assemcad_model::spec::Part;
use assemcad_model::told::Capped;
use assemcad_placing::resolved::port_among;
use assemcad_placing::{ResolvedMate, ResolvedPart};
use assemcad_store::draft::{Draft, Loose};
use assemcad_verify::axioms::cite::Cited;
use serde_json::{Value, json};

use super::layout::{coincident, unreached, unsupported};
use crate::Workshop;
use crate::resolve;

/// Everything that is wrong with parts and mates. What depends on something that is itself at fault is
/// not guessed at.
pub(super) async fn check(workshop: &Workshop, draft: &Draft) -> Vec<Diagnostic> {
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
    let parts = parts(workshop, draft, &mut found).await;
    let mates = mates(draft, &parts, &mut found);
    let root = root(draft, &mut found);
    if let Some(assembly) = &draft.assembly {
        let stated = assembly.stated_faults().into_iter();
        let faults = stated.chain(assemcad_verify::axioms::accept::faults(assembly));
        found.extend(faults.map(|d| {
            let place = draft.place(&d.place);
            d.at(place)
        }));
    }
    unreached(draft, root, &mut found);
    coincident(draft, &parts, &mates, root, &mut found);
    unsupported(draft, &mates, root, &mut found);
    found
}

fn bad_name(place: String, name: &str) -> Diagnostic {
    Diagnostic::error(Code::NameInvalid, place, "this is not a name")
        .found(name)
        .expected(name::RULE)
}

fn names<T>(draft: &Draft, list: &str, all: &[Loose<T>], found: &mut Vec<Diagnostic>) {
    let mut first: BTreeMap<&str, usize> = BTreeMap::new();
    let mut wrong = Capped::new();
    for (i, item) in all.iter().enumerate() {
        let Some(id) = &item.id else { continue };
        let place = || draft.place(&format!("{list}[{i}].id"));
        let first = *first.entry(id).or_insert(i);
        if !name::is_valid(id) {
            wrong.push(|| bad_name(place(), id));
        } else if first < i {
            wrong.push(|| {
                let at = draft.place(&format!("{list}[{first}].id"));
                let message = format!("'{id}' is the name of {at} already");
                Diagnostic::error(Code::NameTaken, place(), message).found(id.as_str())
            });
        }
    }
    found.extend(wrong.told());
}

/// The parts that resolve, each with its index in the draft.
async fn parts(
    workshop: &Workshop,
    draft: &Draft,
    found: &mut Vec<Diagnostic>,
) -> Vec<(usize, ResolvedPart)> {
    let mut resolved = Vec::new();
    let whole: Vec<(usize, &Part)> = draft
        .parts
        .iter()
        .enumerate()
        .filter_map(|(i, loose)| Some((i, loose.whole.as_ref()?)))
        .collect();
    let made = resolve::parts(workshop, &whole).await;
    for ((i, _), result) in whole.iter().zip(made) {
        let (i, place) = (*i, &format!("parts[{i}]"));
        match result {
            Ok(part) => resolved.push((i, part)),
            Err(faults) => found.extend(faults.into_iter().map(|d| {
                let at = if d.place == "factory" {
                    draft.place(&format!("{place}.factory"))
                } else if d.place.starts_with(place) {
                    draft.place(&d.place)
                } else {
                    // A place in the factory's own source.
                    format!("{}, {}", draft.place(place), d.place)
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
    let by_name = resolve::by_name(&there);
    let named = |id: &str| by_name.get(id).copied();
    let written: BTreeSet<&str> = draft.parts.iter().filter_map(|p| p.id.as_deref()).collect();
    let mut unknown = Capped::new();
    let mut resolved = Vec::new();
    for (i, loose) in draft.mates.iter().enumerate() {
        let Some(mate) = &loose.whole else { continue };
        let at = |field: &str| format!("mates[{i}].{field}");
        let mut cited = Cited::of_type(mate.mate_type);
        for (end, field) in [(&mate.base, "base"), (&mate.incoming, "incoming")] {
            if !written.contains(end.part.as_str()) {
                unknown.push(|| {
                    let place = draft.place(&format!("{}.ref", at(field)));
                    part_unknown(draft, &end.part, place)
                });
            }
        }
        if named(&mate.base.part).is_some() && named(&mate.incoming.part).is_some() {
            match resolve::mate_among(&there, &named, assembly, mate, &at) {
                Ok(mate) => {
                    cited = Cited::resolved(&mate, &there);
                    resolved.push((i, mate));
                }
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
                if named(&end.part).is_some()
                    && let Err(d) = port_among(&there, &named, end, &at(field))
                {
                    found.push(placed(draft, d));
                }
            }
        }
        found.extend(cited.check(mate, Severity::Error, &|index| match index {
            None => draft.place(&format!("mates[{i}]")),
            Some(j) => draft.place(&format!("mates[{i}].axioms[{j}]")),
        }));
    }
    found.extend(unknown.told());
    resolved
}

fn part_unknown(draft: &Draft, id: &str, place: String) -> Diagnostic {
    let names: Vec<&str> = draft.parts.iter().filter_map(|p| p.id.as_deref()).collect();
    let d = Diagnostic::error(
        Code::PartUnknown,
        place,
        format!("there is no part '{}'", clip(id)),
    )
    .found(id);
    let (offered, near) = instead(id, &names);
    let d = d.expected(offered);
    match near {
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
