//! The check `port_use`: no port serves more mates than it can.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::serves_once;
use assemcad_model::ports::Port;
use assemcad_model::report::{Finding, Verdict};
use assemcad_model::spec::{Assembly, End};
use assemcad_placing::{Resolved, ResolvedMate};
use serde_json::{Map, json};

use crate::results::Results;

/// A port's mates of one type that it can serve one of.
type Uses<'a> = BTreeMap<(String, &'static str), (&'a End, &'a Port, Vec<&'a ResolvedMate>)>;

/// Finds ports that are joined more often than they can serve. Mates with a stated gap are left out: what
/// keeps its distance may leave room for another.
pub(crate) fn check(spec: &Assembly, resolved: &Resolved, results: &mut Results) {
    let mut uses: Uses<'_> = BTreeMap::new();
    for m in &resolved.mates {
        let kind = m.mate.mate_type.kind();
        if kind.contact(&m.joint()).is_none() {
            continue;
        }
        for (end, port) in [
            (&m.mate.base, &m.base_port),
            (&m.mate.incoming, &m.incoming_port),
        ] {
            if serves_once(port.port_type, m.mate.mate_type).is_some() {
                let key = (end.to_string(), kind.name);
                uses.entry(key)
                    .or_insert_with(|| (end, port, Vec::new()))
                    .2
                    .push(m);
            }
        }
    }
    let mut verdict = Verdict::Pass;
    let cases = uses.len();
    for (end, port, mates) in uses.into_values() {
        let (Some(first), Some(last)) = (mates.first(), mates.last()) else {
            continue;
        };
        let Some(once) = serves_once(port.port_type, first.mate.mate_type) else {
            continue;
        };
        if mates.len() < 2 {
            continue;
        }
        let message = format!(
            "'{end}' ({}) is joined by {} mates, and serves one: {}",
            port.port_type,
            mates.len(),
            once.why
        );
        let ids: Vec<String> = mates.iter().map(|m| m.mate.id.clone()).collect();
        let place = format!("port '{end}'");
        let (told, d) = if once.never {
            (
                Verdict::Fail,
                Diagnostic::error(Code::PortOverused, place, message),
            )
        } else {
            (
                Verdict::Pass,
                Diagnostic::warning(Code::PortOverused, place, message),
            )
        };
        let d = d
            .found(json!(ids))
            .expected("one mate")
            .hint("join the other part to a port of its own")
            .next(
                "remove",
                json!({"assembly": spec.id, "kind": "mate", "name": last.mate.id}),
            );
        let mut parts: Vec<String> = vec![end.part.clone()];
        let mut seen = BTreeSet::from([&end.part]);
        for m in &mates {
            for p in [&m.mate.base.part, &m.mate.incoming.part] {
                if seen.insert(p) {
                    parts.push(p.clone());
                }
            }
        }
        verdict = verdict.and(told);
        results.findings.push(Finding {
            verdict: told,
            check: "port_use".to_owned(),
            parts,
            mates: ids,
            values: Map::new(),
            axioms: Vec::new(),
            diagnostic: d,
        });
    }
    results.check(
        "port_use",
        verdict,
        cases,
        "ports that can serve one mate of a type serve one",
    );
}
