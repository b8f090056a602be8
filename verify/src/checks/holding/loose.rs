//! Motions that mates say they hold and nothing stops.

use std::collections::{BTreeMap, BTreeSet};

use assemcad_facts::{Free, Held, Way};
use assemcad_model::diagnostic::{Code, Diagnostic, Severity};
use assemcad_model::freedom::Link;
use assemcad_model::name::listed;
use assemcad_model::report::{Finding, Verdict, rounded};
use assemcad_model::spec::Assembly;
use assemcad_placing::Resolved;
use nalgebra::{DMatrix, DVector, Vector6};
use serde_json::{Map, json};

/// Speeds below this share of the motion's own are none.
const STILL: f64 = 1e-4;

/// How many parts and mates a sentence names.
const MOST_NAMED: usize = 4;

/// A motion that should not be.
#[derive(Debug, Clone)]
pub(super) struct Loose {
    /// The bodies that go.
    pub(super) bodies: Vec<usize>,
    /// The motion, where it is one body's and simple.
    pub(super) way: Option<Way>,
    /// Indices of the links that say they hold it.
    pub(super) links: Vec<usize>,
    /// Whether what goes meets anything at all: what hangs in the air does not lie loose.
    pub(super) lies: bool,
}

/// Every loose body once, by its simplest motion, with what it pushes along; of what is loose in no simple way, one
/// motion.
pub(super) fn loose(held: &Held, links: &[Link]) -> Vec<Loose> {
    let body_of = body_of(held);
    let mut out = Vec::new();
    for free in &held.free {
        let Some(basis) = free.basis.as_ref().filter(|b| b.ncols() > 0) else {
            continue;
        };
        let claims = claims(free, links, &body_of);
        let before = out.len();
        let mut seen: Vec<Vec<usize>> = Vec::new();
        for alone in [true, false] {
            for index in 0..free.bodies.len() {
                if seen.iter().any(|set| set.contains(&index)) {
                    continue;
                }
                let found = free.ways(index).find_map(|(way, twist)| {
                    let set = free.pushed(index, &twist)?;
                    let goes = |b: usize| set.contains(&b).then_some(twist);
                    let broken = broken(&claims, &goes);
                    (!broken.is_empty() && alone == (set.len() == 1)).then_some((set, way, broken))
                });
                if let Some((set, way, links)) = found {
                    out.push(Loose {
                        bodies: set
                            .iter()
                            .filter_map(|b| free.bodies.get(*b).copied())
                            .collect(),
                        way: Some(way),
                        links,
                        lies: set.iter().all(|b| free.meets(*b)),
                    });
                    seen.push(set);
                }
            }
            // Where single parts are loose, what they could take along is the same cause.
            if !seen.is_empty() {
                break;
            }
        }
        if out.len() == before {
            out.extend(together(free, &claims, basis));
        }
    }
    out
}

/// The body of each part.
pub(super) fn body_of(held: &Held) -> BTreeMap<usize, usize> {
    let each = held.bodies.iter().enumerate();
    each.flat_map(|(body, parts)| parts.iter().map(move |p| (*p, body)))
        .collect()
}

/// A link's rows, between two bodies of an island; none for what stands still.
pub(super) struct Claim {
    link: usize,
    pub(super) first: Option<usize>,
    pub(super) second: Option<usize>,
    pub(super) rows: Vec<Vector6<f64>>,
}

pub(super) fn claims(free: &Free, links: &[Link], body_of: &BTreeMap<usize, usize>) -> Vec<Claim> {
    let index = |part: usize| {
        let body = body_of.get(&part)?;
        free.bodies.iter().position(|b| b == body)
    };
    let point = free.scale.middle.into();
    let of = |(n, link): (usize, &Link)| {
        let (first, second) = (index(link.base), index(link.incoming));
        (first != second).then(|| Claim {
            link: n,
            first,
            second,
            rows: link
                .rows(point, free.scale.length)
                .into_iter()
                .map(Vector6::from)
                .collect(),
        })
    };
    links.iter().enumerate().filter_map(of).collect()
}

/// The links that a motion breaks, given each body's twist.
fn broken(claims: &[Claim], twist: &dyn Fn(usize) -> Option<Vector6<f64>>) -> Vec<usize> {
    let of = |body: Option<usize>| body.and_then(twist).unwrap_or_default();
    let breaks = |c: &&Claim| {
        let relative = of(c.second) - of(c.first);
        let mut rows = c.rows.iter();
        rows.any(|r| r.dot(&relative).abs() > STILL * r.norm())
    };
    claims.iter().filter(breaks).map(|c| c.link).collect()
}

/// What moves only together: the motion that breaks the most.
fn together(free: &Free, claims: &[Claim], basis: &DMatrix<f64>) -> Option<Loose> {
    let rows: Vec<DVector<f64>> = claims
        .iter()
        .flat_map(|c| c.rows.iter().map(move |r| (c, r)))
        .map(|(c, row)| {
            let mut out = DVector::zeros(basis.nrows());
            for (body, sign) in [(c.first, -1.0), (c.second, 1.0)] {
                if let Some(b) = body {
                    for (k, x) in row.iter().enumerate() {
                        if let Some(slot) = out.get_mut(6 * b + k) {
                            *slot += sign * x / row.norm();
                        }
                    }
                }
            }
            basis.tr_mul(&out)
        })
        .collect();
    if rows.is_empty() {
        return None;
    }
    let speeds = DMatrix::from_columns(&rows).transpose();
    let svd = speeds.svd(false, true);
    let (most, largest) = svd.singular_values.argmax();
    if largest <= STILL {
        return None;
    }
    let motion = basis * svd.v_t?.row(most).transpose();
    let twist = |b: usize| {
        let own = motion.as_slice().get(6 * b..6 * b + 6)?;
        Some(Vector6::from_column_slice(own))
    };
    let sizes: Vec<f64> = (0..free.bodies.len())
        .map(|b| twist(b).map_or(0.0, |t| t.norm()))
        .collect();
    let fastest = sizes.iter().copied().fold(0.0, f64::max);
    let moving = free.bodies.iter().zip(&sizes);
    let moving = moving.filter(|(_, s)| **s > 0.05 * fastest);
    Some(Loose {
        bodies: moving.map(|(b, _)| *b).collect(),
        way: None,
        links: broken(claims, &twist),
        lies: (0..free.bodies.len()).all(|b| free.meets(b)),
    })
}

/// The findings: equal ones of equal parts together.
pub(super) fn told(
    spec: &Assembly,
    resolved: &Resolved,
    held: &Held,
    loose: &[Loose],
) -> Vec<Finding> {
    let mut grouped: BTreeMap<(bool, Vec<&str>, u8), Vec<&Loose>> = BTreeMap::new();
    let mut order: Vec<(bool, Vec<&str>, u8)> = Vec::new();
    for one in loose {
        let parts = one
            .bodies
            .iter()
            .filter_map(|b| held.bodies.get(*b))
            .flatten();
        let mut kinds: Vec<&str> = parts
            .filter_map(|p| resolved.parts.get(*p))
            .map(|p| p.made.solid.hash())
            .collect();
        kinds.sort_unstable();
        let key = (
            may_be(spec, resolved, held, one),
            kinds,
            match one.way {
                Some(Way::Slide(_)) => 0,
                Some(Way::Turn(..)) => 1,
                None => 2,
            },
        );
        if !grouped.contains_key(&key) {
            order.push(key.clone());
        }
        grouped.entry(key).or_default().push(one);
    }
    order
        .iter()
        .filter_map(|key| Some((key.0, grouped.get(key)?)))
        .filter_map(|(stated, all)| {
            let found = finding(resolved, held, all)?;
            Some(if stated { as_stated(found) } else { found })
        })
        .collect()
}

/// What is stated as free is shown, and is no fault.
fn as_stated(mut found: Finding) -> Finding {
    found.verdict = Verdict::Pass;
    found.diagnostic.severity = Severity::Note;
    found.diagnostic.message = format!("stated as free: {}", found.diagnostic.message);
    found.diagnostic.hint = None;
    found
}

/// Whether it is stated that some of what goes may go so.
fn may_be(spec: &Assembly, resolved: &Resolved, held: &Held, loose: &Loose) -> bool {
    let bodies = loose.bodies.iter().filter_map(|b| held.bodies.get(*b));
    let names: Vec<String> = bodies.flatten().map(|p| resolved.name(*p)).collect();
    // Every part that goes is stated: what is glued on a lid says nothing of the lid.
    let stated = |name: &String| {
        spec.free.iter().any(|f| {
            f.part == *name
                && match &loose.way {
                    Some(Way::Slide(along)) => f.is_slide((*along).into()),
                    Some(Way::Turn(_, along)) => f.is_turn((*along).into()),
                    None => f.slides_along.is_none() && f.turns_about.is_none(),
                }
        })
    };
    loose.lies && names.iter().all(stated)
}

fn finding(resolved: &Resolved, held: &Held, all: &[&Loose]) -> Option<Finding> {
    let first = all.first()?;
    let parts: Vec<String> = all
        .iter()
        .flat_map(|l| l.bodies.iter())
        .filter_map(|b| held.bodies.get(*b))
        .flatten()
        .map(|p| resolved.name(*p))
        .collect();
    let mates: BTreeSet<usize> = all.iter().flat_map(|l| l.links.iter().copied()).collect();
    let mates: Vec<String> = mates
        .iter()
        .filter_map(|m| resolved.mates.get(*m))
        .map(|m| m.mate.id.clone())
        .collect();
    let mut values = Map::new();
    let what = match &first.way {
        Some(Way::Slide(along)) => {
            let along = [along.x, along.y, along.z].map(rounded);
            values.insert("slides_along".to_owned(), json!(along));
            format!("from sliding along {}", direction(along))
        }
        Some(Way::Turn(point, along)) => {
            let along = [along.x, along.y, along.z].map(rounded);
            let point = [point.x, point.y, point.z].map(rounded);
            values.insert("turns_about".to_owned(), json!(along));
            values.insert("through_mm".to_owned(), json!(point));
            format!(
                "from turning about {} through {}",
                direction(along),
                json!(point)
            )
        }
        None => "against each other".to_owned(),
    };
    let subject = listed(&parts, MOST_NAMED);
    let message = format!(
        "nothing keeps {subject} {what}: {} {} it, and no contact, thread, press fit or clamped stack in the solids does",
        listed(&mates, MOST_NAMED),
        if mates.len() == 1 { "claims" } else { "claim" }
    );
    let d = Diagnostic::error(Code::NotHeld, format!("part {subject}"), message)
        .hint(
            "let faces touch where the mates say so, add what holds the part (a screw through the whole stack, a \
             shoulder or ring on the other side, a key, a press fit), or state what is meant: a bond (bond: welded), or that the part may lie loose (free)",
        );
    Some(Finding {
        verdict: Verdict::Fail,
        check: super::CHECK.to_owned(),
        parts,
        mates,
        values,
        axioms: Vec::new(),
        diagnostic: d,
    })
}

/// A direction in words where it is one of the world's.
pub(super) fn direction(along: [f64; 3]) -> String {
    for (k, axis) in ["x", "y", "z"].iter().enumerate() {
        for (sign, word) in [(1.0, "+"), (-1.0, "-")] {
            let other = along.iter().enumerate().all(|(i, v)| {
                let wanted = if i == k { sign } else { 0.0 };
                (v - wanted).abs() <= 1e-6
            });
            if other {
                return format!("{word}{axis}");
            }
        }
    }
    json!(along).to_string()
}
