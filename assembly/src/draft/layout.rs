//! What can be wrong with a draft as a whole: where its parts land, and what holds them.

use std::collections::BTreeMap;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::{Placement, Rows};
use assemcad_model::mates::MateType;
use assemcad_model::param::clip;
use assemcad_model::ports::{Port, PortType};
use assemcad_model::spec::{End, Mate};
use assemcad_placing::{Resolved, ResolvedMate, ResolvedPart, place};
use assemcad_store::draft::{Draft, Loose};

/// Parts that no chain of mates joins to the root.
pub(super) fn unreached(draft: &Draft, root: Option<usize>, found: &mut Vec<Diagnostic>) {
    let Some(root) = root else { return };
    let index = by_id(draft);
    let index = |id: &String| index.get(id.as_str()).copied();
    let mut reached = vec![false; draft.parts.len()];
    let mut edges: Vec<Vec<usize>> = vec![Vec::new(); draft.parts.len()];
    let mut reach = vec![root];
    for mate in &draft.mates {
        let ends: Vec<usize> = mate.joins.iter().filter_map(index).collect();
        match ends.as_slice() {
            [a, b] => {
                for (one, other) in [(a, b), (b, a)] {
                    if let Some(list) = edges.get_mut(*one) {
                        list.push(*other);
                    }
                }
            }
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
        reach.extend(edges.get(part).into_iter().flatten());
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
pub(super) fn coincident(
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
    // The first part of each solid in each place, and the first that a face was brought to with each set of options:
    // nothing is compared with all that came before.
    let mut there: BTreeMap<([u64; 12], &str), usize> = BTreeMap::new();
    let mut on_face: BTreeMap<(bool, String, String), usize> = BTreeMap::new();
    for (j, (_, second)) in parts.iter().enumerate() {
        let Some((mate, m)) = by(j) else { continue };
        let same_place = placed.of(j).and_then(|at| {
            let first = there.entry((bits(&at), second.made.solid.hash()));
            Some(*first.or_insert(j)).filter(|i| *i != j)
        });
        let same_face = (m.mate.mate_type == MateType::FaceToFace)
            .then(|| (m.base == j, beyond(m, j).to_string(), m.options.key()))
            .and_then(|face| Some(*on_face.entry(face).or_insert(j)).filter(|i| *i != j));
        let (first, sure) = match (same_place, same_face) {
            (None, None) => continue,
            (Some(i), Some(k)) if k < i => (k, false),
            (Some(i), _) => (i, true),
            (None, Some(k)) => (k, false),
        };
        let Some((_, first)) = parts.get(first) else {
            continue;
        };
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

/// Parts that nothing holds: gears in mesh, and holes in line with holes that nothing goes through.
pub(super) fn unsupported(
    draft: &Draft,
    mates: &[(usize, ResolvedMate)],
    root: Option<usize>,
    found: &mut Vec<Diagnostic>,
) {
    let mut resolved: BTreeMap<usize, &ResolvedMate> = BTreeMap::new();
    for (k, r) in mates {
        resolved.entry(*k).or_insert(r);
    }
    let mut joining: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (n, m) in draft.mates.iter().enumerate() {
        for part in &m.joins {
            let list = joining.entry(part).or_default();
            if list.last() != Some(&n) {
                list.push(n);
            }
        }
    }
    for (i, part) in draft.parts.iter().enumerate() {
        let Some(id) = part.id.as_ref().filter(|_| Some(i) != root) else {
            continue;
        };
        let of = joining.get(id.as_str()).into_iter().flatten();
        let of: Vec<Hold> = of
            .filter_map(|n| Some(hold(draft.mates.get(*n)?, resolved.get(n).copied())))
            .collect();
        if of.is_empty() || of.contains(&Hold::Held) {
            continue;
        }
        let why = if of.contains(&Hold::HoleOnHole) {
            "is in line with a hole, and nothing goes through both that would hold it"
        } else {
            "is held by nothing but its teeth"
        };
        found.push(
            Diagnostic::warning(
                Code::Unsupported,
                draft.place(&format!("parts[{i}]")),
                format!("'{}' {why}", clip(id)),
            )
            .hint("mate its bore with a shaft, and the shaft with bearings"),
        );
    }
}

/// How a mate holds a part.
#[derive(Clone, Copy, PartialEq)]
enum Hold {
    Held,
    Teeth,
    HoleOnHole,
}

fn hold(mate: &Loose<Mate>, resolved: Option<&ResolvedMate>) -> Hold {
    let hole = |p: &Port| {
        matches!(
            p.port_type,
            PortType::Bore | PortType::Hole | PortType::ClearanceHole | PortType::ThreadInternal
        )
    };
    match (mate.whole.as_ref().map(|m| m.mate_type), resolved) {
        (Some(MateType::GearMesh), _) => Hold::Teeth,
        (Some(MateType::Coaxial), Some(r)) if hole(&r.base_port) && hole(&r.incoming_port) => {
            Hold::HoleOnHole
        }
        // One whose form is at fault may yet become one that holds it.
        _ => Hold::Held,
    }
}

/// The end of a mate that is not on a part (by index).
fn beyond(m: &ResolvedMate, part: usize) -> &End {
    if m.base == part {
        &m.mate.incoming
    } else {
        &m.mate.base
    }
}

/// The numbers of a placement: equal ones have equal bits.
fn bits(at: &Placement) -> [u64; 12] {
    let rows = Rows::from(*at).0;
    let mut out = [0; 12];
    // A zero is one, whatever its sign.
    for (slot, x) in out.iter_mut().zip(rows.iter().flatten()) {
        *slot = (x + 0.0).to_bits();
    }
    out
}

/// The places of the draft's parts; of two of one name the first is meant.
fn by_id(draft: &Draft) -> BTreeMap<&str, usize> {
    let mut out = BTreeMap::new();
    for (i, p) in draft.parts.iter().enumerate() {
        if let Some(id) = &p.id {
            out.entry(id.as_str()).or_insert(i);
        }
    }
    out
}
