//! What can be wrong with a draft beyond its form.

use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::name::{self, nearest};
use assemcad_model::param::clip;
use assemcad_model::spec::{End, Mate, Part};
use assemcad_placing::resolved::port;
use assemcad_placing::{ResolvedMate, ResolvedPart};
use assemcad_store::draft::{Draft, Loose};
use assemcad_verify::axioms::cite::Cited;
use futures::future::join_all;
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
        let faults = assembly.stated_faults().into_iter();
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
async fn parts(
    workshop: &Workshop,
    draft: &Draft,
    found: &mut Vec<Diagnostic>,
) -> Vec<(usize, ResolvedPart)> {
    let mut resolved = Vec::new();
    let whole: Vec<(usize, &Part, String)> = draft
        .parts
        .iter()
        .enumerate()
        .filter_map(|(i, loose)| Some((i, loose.whole.as_ref()?, format!("parts[{i}]"))))
        .collect();
    let each = whole
        .iter()
        .map(|(_, part, place)| resolve::part(workshop, part, place));
    for ((i, _, place), result) in whole.iter().zip(join_all(each).await) {
        let i = *i;
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
    let mut resolved = Vec::new();
    for (i, loose) in draft.mates.iter().enumerate() {
        let Some(mate) = &loose.whole else { continue };
        let at = |field: &str| format!("mates[{i}].{field}");
        let mut cited = Cited::of_type(mate.mate_type);
        if ends(draft, &there, mate, &at, found) {
            match resolve::mate(&there, assembly, mate, &at) {
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
                if there.iter().any(|p| p.id == end.part)
                    && let Err(d) = port(&there, end, &at(field))
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
