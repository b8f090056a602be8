//! The check `freedom`: which motions the mates leave, by name, what they hold twice, and whether that is
//! what the specification intends.
//!
//! Idle spins, the turning of screws and rings about themselves, are no motions of the machine and are told
//! apart. What is compared is the number of motions that go on beyond the first instant, without those.

use std::collections::BTreeSet;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::freedom::{BodyMotion, Freedom, Kind, Lasting, Motion, analyse};
use assemcad_model::name::listed;
use assemcad_model::report::{Finding, Verdict};
use assemcad_model::spec::{Assembly, PartMotion};
use assemcad_placing::linkage::system;
use assemcad_placing::{Placements, Resolved};
use serde_json::{Map, json};

use crate::checks::holding::Moves;
use crate::results::Results;

/// How many motions and mates a sentence names; the report has them all.
const MOST_NAMED: usize = 3;

/// Checks the freedom of an assembly; none where it could not be told.
pub(crate) fn check(
    spec: &Assembly,
    resolved: &Resolved,
    placements: &Placements,
    moves: Option<&Moves>,
    results: &mut Results,
) -> Option<Freedom> {
    let cases = resolved.mates.len();
    let freedom = match system(resolved, placements) {
        Ok(system) => analyse(&system),
        Err((mates, d)) => {
            results.check("freedom", Verdict::Indeterminate, cases, HOW);
            results.findings.push(Finding {
                mates,
                ..finding(Verdict::Indeterminate, d)
            });
            return None;
        }
    };
    let (verdict, said, found) = judge(&freedom, moves, spec);
    results.check("freedom", verdict, cases, &format!("{HOW}: {said}"));
    results.findings.extend(found);
    Some(freedom)
}

const HOW: &str =
    "rank of the mates' constraints at the placed pose, finite steps where some are redundant";

/// The verdict, what was found in a sentence, and the finding if there is one.
fn judge(
    freedom: &Freedom,
    moves: Option<&Moves>,
    spec: &Assembly,
) -> (Verdict, String, Option<Finding>) {
    let open = |message: String| {
        let d = Diagnostic::error(Code::Indeterminate, "freedom", message);
        finding(Verdict::Indeterminate, d)
    };
    let Some(first_order) = freedom.mobility else {
        let said = "the number of free motions cannot be told: the constraints are neither clearly dependent \
                    nor clearly independent at this pose";
        let found = open(format!("{said}; see the ranks in the report"));
        return (Verdict::Indeterminate, said.to_owned(), Some(found));
    };
    let said = summary(freedom, first_order);
    let Some(intended) = spec.motions_meant() else {
        return unstated(freedom, moves, spec, said);
    };
    let wanted = intended as usize;
    let Some(lasting) = freedom.lasting_mobility else {
        let message = format!(
            "{} intended; {first_order} free at this instant, and whether they go on could not be told",
            motions(wanted)
        );
        let found = with_values(open(message), freedom, intended);
        return (Verdict::Indeterminate, said, Some(found));
    };
    let real = real(freedom, lasting, moves, spec);
    if real == wanted {
        return match not_made(freedom, moves, spec) {
            None => (Verdict::Pass, format!("{said}; as intended"), None),
            Some(d) => {
                let named = spec.intended_motions.iter().map(|m| m.part.clone());
                let found = Finding {
                    parts: named.collect(),
                    ..with_values(finding(Verdict::Fail, d), freedom, intended)
                };
                (Verdict::Fail, said, Some(found))
            }
        };
    }
    let names = |idle: bool| -> Vec<String> {
        let chosen = freedom.motions.iter().filter(|m| m.idle == idle);
        chosen.map(|m| m.name.clone()).collect()
    };
    let idle = idle_spins(freedom, spec);
    if real < wanted && idle > 0 && wanted <= real + idle {
        let message = format!(
            "{} intended: {real} free, and {} only if these spins of parts about themselves are meant: {}",
            motions(wanted),
            real + idle,
            brief(&names(true))
        );
        let found = with_values(open(message), freedom, intended);
        return (Verdict::Indeterminate, said, Some(found));
    }
    let held: Vec<String> = freedom
        .redundant
        .iter()
        .flat_map(|r| r.mates.clone())
        .collect();
    let free = if real == 0 {
        "nothing moves".to_owned()
    } else {
        brief(&told(moves, names(false)))
    };
    let d = Diagnostic::error(
        Code::MobilityDiffers,
        "assembly.intended_mobility",
        format!(
            "{} intended and {real} {} free: {free}",
            motions(wanted),
            if real == 1 { "is" } else { "are" }
        ),
    )
    .found(real)
    .expected(wanted);
    let d = if real > wanted {
        d.hint("hold what should not move by a further mate, or state the number that is meant")
    } else if held.is_empty() {
        d.hint("leave out the mate that holds what should move, or choose one that leaves it free")
    } else {
        d.hint(format!(
            "leave out what should not hold; {} say again what others say",
            listed(&held, MOST_NAMED)
        ))
    };
    let named = spec.intended_motions.iter().map(|m| m.part.clone());
    let moving = moves.into_iter().flat_map(|m| m.parts.clone());
    let parts: BTreeSet<String> = named.chain(moving).collect();
    let found = Finding {
        parts: parts.into_iter().collect(),
        mates: if real < wanted { held } else { Vec::new() },
        ..with_values(finding(Verdict::Fail, d), freedom, intended)
    };
    (Verdict::Fail, said, Some(found))
}

/// How many independent motions the machine has; none where it could not be told.
pub(crate) fn independent(
    freedom: &Freedom,
    moves: Option<&Moves>,
    spec: &Assembly,
) -> Option<usize> {
    Some(real(freedom, freedom.lasting_mobility?, moves, spec))
}

/// How many motions the mates leave that no contact stops, without idle spins and what may lie loose.
fn real(freedom: &Freedom, lasting: usize, moves: Option<&Moves>, spec: &Assembly) -> usize {
    let loose = freedom
        .motions
        .iter()
        .filter(|m| !m.idle && may_be_loose(m, spec));
    let loose: usize = loose.map(|m| m.count).sum();
    let left = lasting.saturating_sub(idle_spins(freedom, spec) + loose);
    match moves {
        Some(m) if !m.approximate => left.min(m.real),
        _ => left,
    }
}

/// What moves in words: what was found in the solids, or what the mates leave.
fn told(moves: Option<&Moves>, by_mates: Vec<String>) -> Vec<String> {
    match moves {
        Some(m) if !m.words.is_empty() => m.words.clone(),
        _ => by_mates,
    }
}

/// What nobody states is not meant: a hub without a ring slides off, whatever its mate leaves free.
fn unstated(
    freedom: &Freedom,
    moves: Option<&Moves>,
    spec: &Assembly,
    said: String,
) -> (Verdict, String, Option<Finding>) {
    let free: Vec<&Motion> = freedom
        .motions
        .iter()
        // What floats is joined to nothing, which is told as that.
        .filter(|m| m.count == 1 && !m.idle && !may_be_loose(m, spec))
        .collect();
    let left = free.iter().map(|m| m.count).sum::<usize>() + freedom.idle_spins;
    let real = real(freedom, left, moves, spec);
    if real == 0 {
        return (Verdict::Pass, said, None);
    }
    let names: Vec<String> = free.iter().map(|m| m.name.clone()).collect();
    let d = Diagnostic::error(
        Code::MobilityDiffers,
        "assembly.intended_mobility",
        format!(
            "{} free and nothing states that {} meant: {}",
            motions(real),
            if real == 1 { "it is" } else { "they are" },
            brief(&told(moves, names))
        ),
    )
    .found(real)
    .hint(format!(
        "hold what should not move by a further mate, or state what is meant: intended_mobility: {real}, or free \
         with the part and the motion"
    ));
    let mut parts: Vec<String> = match moves {
        Some(m) if !m.parts.is_empty() => m.parts.clone(),
        _ => free
            .iter()
            .flat_map(|m| m.bodies.iter().map(|b| b.body.clone()))
            .collect(),
    };
    parts.sort();
    parts.dedup();
    let found = Finding {
        parts,
        ..finding(Verdict::Fail, d)
    };
    (
        Verdict::Fail,
        format!("{said}; not stated as intended"),
        Some(found),
    )
}

/// The idle spins that nobody names as a motion: a wheel's turn is one, a screw's is none.
fn idle_spins(freedom: &Freedom, spec: &Assembly) -> usize {
    let named = |m: &&Motion| {
        let mut meant = spec.intended_motions.iter();
        meant.any(|i| m.bodies.iter().any(|b| makes(b, i)))
    };
    let idle = freedom.motions.iter().filter(|m| m.idle);
    let named = idle.filter(named).count();
    freedom.idle_spins.saturating_sub(named)
}

/// Whether what a body does is the motion that is stated.
fn makes(body: &BodyMotion, stated: &PartMotion) -> bool {
    body.body == stated.part
        && match body.kind {
            Kind::Slide => stated.is_slide(body.direction),
            Kind::Turn => stated.is_turn(body.direction),
            Kind::Screw => stated.is_slide(body.direction) || stated.is_turn(body.direction),
        }
}

/// The first intended motion that no free one is: their number alone may be right by the wrong parts.
fn not_made(freedom: &Freedom, moves: Option<&Moves>, spec: &Assembly) -> Option<Diagnostic> {
    let bodies = || freedom.motions.iter().flat_map(|m| &m.bodies);
    let (index, motion) = spec
        .intended_motions
        .iter()
        .enumerate()
        .find(|(i, m)| match moves {
            Some(moves) if !moves.approximate => moves.missing.contains(i),
            _ => !bodies().any(|b| makes(b, m)),
        })?;
    let names: Vec<String> = freedom.motions.iter().map(|m| m.name.clone()).collect();
    let names = told(moves, names);
    Some(
        Diagnostic::error(
            Code::MobilityDiffers,
            format!("assembly.intended_motions[{index}]"),
            format!(
                "'{}' does not move as intended; what moves: {}",
                motion.part,
                brief(&names)
            ),
        )
        .found(motion.part.as_str())
        .hint("name the part that makes the motion, and the world's axis along or about which"),
    )
}

/// Whether all that moves is stated as free to do so.
fn may_be_loose(motion: &Motion, spec: &Assembly) -> bool {
    let stated = |b: &BodyMotion| spec.free.iter().any(|f| makes(b, f));
    !motion.bodies.is_empty() && motion.more_bodies == 0 && motion.bodies.iter().all(stated)
}

fn summary(freedom: &Freedom, first_order: usize) -> String {
    let idle = freedom.idle_spins;
    let mut said = format!("mobility {}", first_order - idle.min(first_order));
    if idle > 0 {
        said.push_str(&format!(
            " and {idle} idle spin{}",
            if idle == 1 { "" } else { "s" }
        ));
    }
    let motions = freedom.motions.iter().filter(|m| !m.idle);
    let names: Vec<String> = motions.map(|m| m.name.clone()).collect();
    if !names.is_empty() {
        said.push_str(&format!(" ({})", brief(&names)));
    }
    let short = |m: &&assemcad_model::freedom::Motion| m.lasting == Lasting::Instantaneous;
    if freedom.motions.iter().any(|m| short(&m)) {
        let lasting = freedom.lasting_mobility;
        let lasting = lasting.map_or("an unknown number".to_owned(), |l| {
            l.saturating_sub(idle).to_string()
        });
        said.push_str(&format!(", of which {lasting} beyond the first instant"));
    }
    let redundant: usize = freedom.redundant.iter().map(|r| r.count).sum();
    if redundant > 0 {
        let mates: Vec<String> = freedom
            .redundant
            .iter()
            .flat_map(|r| r.mates.clone())
            .collect();
        said.push_str(&format!(
            "; {redundant} redundant among the constraints of {}",
            listed(&mates, MOST_NAMED)
        ));
    }
    said
}

fn motions(n: usize) -> String {
    match n {
        1 => "1 motion is".to_owned(),
        n => format!("{n} motions are"),
    }
}

/// The first names, and how many more there are.
fn brief(names: &[String]) -> String {
    let told = names
        .iter()
        .take(MOST_NAMED)
        .cloned()
        .collect::<Vec<_>>()
        .join(" | ");
    match names.len().saturating_sub(MOST_NAMED) {
        0 => told,
        more => format!("{told} | and {more} more"),
    }
}

fn finding(verdict: Verdict, diagnostic: Diagnostic) -> Finding {
    Finding {
        verdict,
        check: "freedom".to_owned(),
        parts: Vec::new(),
        mates: Vec::new(),
        axioms: Vec::new(),
        values: Map::new(),
        diagnostic,
    }
}

fn with_values(mut finding: Finding, freedom: &Freedom, intended: u32) -> Finding {
    let redundant: usize = freedom.redundant.iter().map(|r| r.count).sum();
    for (name, value) in [
        ("intended_mobility", json!(intended)),
        ("mobility_with_idle_spins", json!(freedom.mobility)),
        (
            "lasting_mobility_with_idle_spins",
            json!(freedom.lasting_mobility),
        ),
        ("idle_spins", json!(freedom.idle_spins)),
        ("redundant_constraints", json!(redundant)),
    ] {
        finding.values.insert(name.to_owned(), value);
    }
    finding
}

#[cfg(test)]
mod tests;
