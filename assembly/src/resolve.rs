//! From the names in a specification to recipes and ports.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::{Joint, MateType};
use assemcad_model::ports::Port;
use assemcad_model::spec::{Assembly, End, Mate, Part};
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
    let mut parts = Vec::new();
    let mut faults = Vec::new();
    let places: Vec<String> = (0..spec.parts.len())
        .map(|i| format!("parts[{i}]"))
        .collect();
    // What is made alike is made once.
    let mut first: BTreeMap<(&str, String), usize> = BTreeMap::new();
    let of: Vec<usize> = (spec.parts.iter().enumerate())
        .map(|(i, p)| {
            let params = serde_json::to_string(&p.params).unwrap_or_else(|_| p.id.clone());
            *first.entry((&p.factory, params)).or_insert(i)
        })
        .collect();
    let each = || spec.parts.iter().zip(&places).zip(&of).enumerate();
    let one = each().filter(|(i, (_, first))| i == *first);
    let one = one.map(|(_, ((p, place), _))| part(workshop, p, place));
    let made: Vec<_> = first
        .into_values()
        .collect::<BTreeSet<_>>()
        .into_iter()
        .collect();
    let made: BTreeMap<usize, _> = made.into_iter().zip(join_all(one).await).collect();
    let all = each().map(|(i, ((p, place), first))| {
        let known = made.get(first);
        async move {
            match known {
                Some(Ok(made)) => Ok(ResolvedPart {
                    id: p.id.clone(),
                    ..made.clone()
                }),
                Some(Err(faults)) if *first == i => Err(faults.clone()),
                // What is wrong is told of each part in its own words.
                _ => part(workshop, p, place).await,
            }
        }
    });
    for result in join_all(all).await {
        match result {
            Ok(p) => parts.push(p),
            Err(more) => faults.extend(more),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut mates = Vec::new();
    let mut by_name: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, p) in parts.iter().enumerate() {
        by_name.entry(&p.id).or_insert(i);
    }
    let named = |id: &str| by_name.get(id).copied();
    for (i, m) in spec.mates.iter().enumerate() {
        let place = format!("mates[{i}]");
        let at = |field: &str| format!("{place}.{field}");
        match mate_among(&parts, &named, &spec.id, m, &at) {
            Ok(m) => mates.push(m),
            Err(more) => faults.extend(more),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let root = match spec.root() {
        None => None,
        Some(id) => Some(index(&parts, id).ok_or_else(|| vec![part_unknown(&parts, id, "root")])?),
    };
    Ok(Resolved { parts, mates, root })
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
fn mate_among(
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
