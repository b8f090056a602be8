//! From the names in a specification to recipes and ports.

use std::collections::BTreeMap;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::{Joint, MateType};
use assemcad_model::ports::Port;
use assemcad_model::spec::{Assembly, End, Mate, Part};
use assemcad_model::told::MOST_FOUND;
use assemcad_placing::resolved::{part_unknown, port_among};
use assemcad_placing::{Resolved, ResolvedMate, ResolvedPart};
use futures::future::join_all;
use serde_json::json;

use crate::{Faults, Workshop};

/// Resolves a whole specification.
///
/// # Errors
/// Everything that is wrong with its parts, or, where they are in order, with its mates.
pub async fn assembly(workshop: &Workshop, spec: &Assembly) -> Result<Resolved, Faults> {
    let mut faults = Vec::new();
    let mut there = Vec::new();
    let wanted: Vec<(usize, &Part)> = spec.parts.iter().enumerate().collect();
    for result in parts(workshop, &wanted).await {
        match result {
            Ok(p) => there.push(p),
            Err(more) => faults.extend(more),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let parts = there;
    let mut mates = Vec::new();
    let by_name = by_name(&parts);
    let named = |id: &str| by_name.get(id).copied();
    for (i, m) in spec.mates.iter().enumerate() {
        let place = format!("mates[{i}]");
        let at = |field: &str| format!("{place}.{field}");
        match mate_among(&parts, &named, &spec.id, m, &at) {
            Ok(m) => mates.push(m),
            Err(more) => faults.extend(more),
        }
        // Each comes with what would fit instead: a few hundred say enough.
        if faults.len() > MOST_FOUND {
            break;
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let root = match spec.root() {
        None => None,
        Some(id) => Some(named(id).ok_or_else(|| vec![part_unknown(&parts, id, "root")])?),
    };
    Ok(Resolved { parts, mates, root })
}

/// The indices of parts by their names; of two of one name the first is meant.
pub(crate) fn by_name(parts: &[ResolvedPart]) -> BTreeMap<String, usize> {
    let mut out = BTreeMap::new();
    for (i, p) in parts.iter().enumerate() {
        out.entry(p.id.clone()).or_insert(i);
    }
    out
}

/// Resolves parts, each with its index in the specification; an answer for each, in their order. What is made
/// alike is made once.
pub(crate) async fn parts(
    workshop: &Workshop,
    wanted: &[(usize, &Part)],
) -> Vec<Result<ResolvedPart, Faults>> {
    let mut first: BTreeMap<(&str, String), usize> = BTreeMap::new();
    let of: Vec<usize> = (wanted.iter().enumerate())
        .map(|(k, (_, p))| {
            let params = serde_json::to_string(&p.params).unwrap_or_else(|_| p.id.clone());
            *first.entry((&p.factory, params)).or_insert(k)
        })
        .collect();
    let places: Vec<String> = wanted.iter().map(|(i, _)| format!("parts[{i}]")).collect();
    let each = || wanted.iter().zip(&places).zip(&of).enumerate();
    let one = each().filter(|(k, (_, first))| k == *first);
    let one =
        one.map(|(k, (((_, p), place), _))| async move { (k, part(workshop, p, place).await) });
    let made: BTreeMap<usize, _> = join_all(one).await.into_iter().collect();
    each()
        .map(|(_, (((_, p), place), first))| match made.get(first) {
            Some(Ok(made)) => Ok(ResolvedPart {
                id: p.id.clone(),
                ..made.clone()
            }),
            Some(Err(faults)) => {
                let (there, at) = (wanted.get(*first), places.get(*first));
                let other = there.map_or("", |(_, p)| &p.id);
                let retold = faults.iter().cloned();
                let retold = retold.map(|d| of_another(d, (other, at), (&p.id, place)));
                Err(retold.collect())
            }
            None => Err(Faults::new()),
        })
        .collect()
}

/// What is wrong with one part, told of another that is made alike.
fn of_another(
    d: Diagnostic,
    (id, place): (&str, Option<&String>),
    (other, there): (&str, &str),
) -> Diagnostic {
    let of_part = |id: &str| format!("part '{id}', ");
    let behind = |head: &str| d.place.strip_prefix(head).map(str::to_owned);
    let moved = behind(&of_part(id)).map(|rest| format!("{}{rest}", of_part(other)));
    let in_text = |p: &String| behind(p).map(|rest| format!("{there}{rest}"));
    match moved.or_else(|| place.and_then(in_text)) {
        Some(moved) => d.at(moved),
        None => d,
    }
}

/// Resolves one part: its factory found, its parameters checked, recipe and ports made.
///
/// # Errors
/// Everything that is wrong with factory and parameters, `place` leading the paths; why the kernel makes
/// no solid of them.
pub async fn part(workshop: &Workshop, part: &Part, place: &str) -> Result<ResolvedPart, Faults> {
    let at = |field: &str| {
        if place.is_empty() {
            field.to_owned()
        } else {
            format!("{place}.{field}")
        }
    };
    let made = workshop
        .make(&part.factory, &part.params, Some(&part.id))
        .await
        .map_err(|faults| {
            let under = |d: Diagnostic| {
                let inner = d.place.clone();
                let ours = inner == "factory" || inner.starts_with("params");
                if ours { d.at(at(&inner)) } else { d }
            };
            faults.into_iter().map(under).collect::<Faults>()
        })?;
    // A short name is written out, so that a factory added later does not make it mean another.
    let factory = workshop.registry.get(&part.factory).map_err(|d| vec![*d])?;
    Ok(ResolvedPart {
        id: part.id.clone(),
        factory: factory.name().to_owned(),
        made,
    })
}

/// Resolves one mate: parts and ports found, types compatible, options complete, conditions met.
///
/// `at` gives the place of a field in what the reader wrote.
///
/// # Errors
/// Everything that is wrong with it.
pub fn mate(
    parts: &[ResolvedPart],
    assembly: &str,
    mate: &Mate,
    at: &dyn Fn(&str) -> String,
) -> Result<ResolvedMate, Faults> {
    mate_among(parts, &|id| index(parts, id), assembly, mate, at)
}

/// The same, where the index of a part's name is known.
///
/// # Errors
/// As [`mate`].
pub(crate) fn mate_among(
    parts: &[ResolvedPart],
    named: &dyn Fn(&str) -> Option<usize>,
    assembly: &str,
    mate: &Mate,
    at: &dyn Fn(&str) -> String,
) -> Result<ResolvedMate, Faults> {
    let mut faults = Vec::new();
    let mut find = |end: &End, field: &str| match port_among(parts, named, end, &at(field)) {
        Ok(found) => Some(found),
        Err(d) => {
            faults.push(d);
            None
        }
    };
    let base = find(&mate.base, "base");
    let incoming = find(&mate.incoming, "incoming");
    let kind = mate.mate_type.kind();
    let options = match kind.check_options(&mate.options, &at("options")) {
        Ok(options) => Some(options),
        Err(more) => {
            faults.extend(more);
            None
        }
    };
    if let (Some((base, base_port)), Some((incoming, incoming_port))) = (base, incoming) {
        if base == incoming {
            faults.push(
                Diagnostic::error(
                    Code::MateSelf,
                    at("incoming"),
                    format!(
                        "a mate joins two parts, and this one joins '{}' to itself",
                        mate.base.part
                    ),
                )
                .found(mate.incoming.to_string()),
            );
        } else if !kind.joins(base_port.port_type, incoming_port.port_type) {
            faults.push(incompatible(
                parts,
                assembly,
                mate,
                (base, base_port),
                (incoming, incoming_port),
                at,
            ));
        } else if let Some(options) = options {
            let joint = Joint {
                base: base_port,
                incoming: incoming_port,
                options: &options,
            };
            faults.extend(kind.conditions(&joint).into_iter().map(|c| {
                Diagnostic::error(Code::MateIncompatible, at("incoming"), c.message)
                    .found(c.found)
                    .expected(c.expected)
            }));
            if faults.is_empty() {
                return Ok(ResolvedMate {
                    mate: mate.clone(),
                    base,
                    incoming,
                    base_port: base_port.clone(),
                    incoming_port: incoming_port.clone(),
                    options,
                });
            }
        }
    }
    Err(faults)
}

fn index(parts: &[ResolvedPart], id: &str) -> Option<usize> {
    parts.iter().position(|p| p.id == id)
}

/// The diagnostic for ports that this mate type does not join: says what would.
fn incompatible(
    parts: &[ResolvedPart],
    assembly: &str,
    mate: &Mate,
    (base, base_port): (usize, &Port),
    (incoming, incoming_port): (usize, &Port),
    at: &dyn Fn(&str) -> String,
) -> Diagnostic {
    let kind = mate.mate_type.kind();
    let fitting = |i: usize, fits: &dyn Fn(&Port) -> bool| -> Vec<String> {
        let ports = parts.get(i).map(ResolvedPart::ports).unwrap_or_default();
        let named = |p: &Port| format!("{}:{}", parts.get(i).map_or("", |p| &p.id), p.name);
        ports.iter().filter(|p| fits(p)).map(named).collect()
    };
    let types = assemcad_model::mates::joining(base_port.port_type, incoming_port.port_type);
    let for_incoming = fitting(incoming, &|p| kind.joins(base_port.port_type, p.port_type));
    let for_base = fitting(base, &|p| kind.joins(p.port_type, incoming_port.port_type));
    let mut next = json!({
        "assembly": assembly, "id": mate.id, "mate_type": mate.mate_type,
        "base": mate.base.to_string(), "incoming": mate.incoming.to_string(),
    });
    // Faces may be joined in several ways; the plain one is what is mostly meant.
    let plain = types.iter().find(|t| **t == MateType::FaceToFace);
    let mended = if let Some(t) = plain.or(types.first()) {
        Some(("mate_type", json!(t)))
    } else if let Some(p) = for_incoming.first() {
        Some(("incoming", json!(p)))
    } else {
        for_base.first().map(|p| ("base", json!(p)))
    };
    let d = Diagnostic::error(
        Code::MateIncompatible,
        at("mate_type"),
        format!(
            "{} does not join '{}' ({}) with '{}' ({})",
            kind.name, mate.base, base_port.port_type, mate.incoming, incoming_port.port_type
        ),
    )
    .found(json!([
        kind.name,
        base_port.port_type,
        incoming_port.port_type
    ]))
    .expected(json!({
        "mate_types_for_these_ports": types,
        "incoming_ports_for_this_mate_and_base": for_incoming,
        "base_ports_for_this_mate_and_incoming": for_base,
        "port_pairs_of_this_mate": kind.pairs,
    }));
    match (mended, next.as_object_mut()) {
        (Some((field, value)), Some(call)) => {
            call.insert(field.to_owned(), value);
            d.next("mate", next)
        }
        _ => {
            d.hint("no port of one of these parts fits any port of the other under this mate type")
        }
    }
}
