//! Play in turn: a hub that a key holds stands still, or it rattles before the key stops it.

use std::collections::BTreeSet;

use assemcad_facts::{Held, PairMeetings, guides};
use assemcad_geometry::narrow::meet::Kind;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Finding, Verdict, rounded};
use assemcad_placing::Resolved;
use nalgebra::{DMatrix, Vector3};
use serde_json::{Map, json};

use super::loose::body_of;

/// The most by which a part that is held against turning may turn, in degrees, both ways together. Ours: keys and
/// keyways of DIN 6885 leave a tenth of it.
const MOST_DEG: f64 = 1.0;

/// Islands of more bodies are not looked at: each pair is a programme of its own.
const MOST_BODIES: usize = 60;

/// What turns by a play.
pub(super) struct Rattles {
    hole: usize,
    inner: usize,
    play_deg: f64,
}

/// The pairs of a hole and what is in it that are held against turning, with more play than that.
pub(super) fn rattles(held: &Held, pairs: &[PairMeetings]) -> Vec<Rattles> {
    let mut out = Vec::new();
    if held.approximate {
        return out;
    }
    let bodies = body_of(held);
    for free in &held.free {
        let Some(basis) = free
            .basis
            .as_ref()
            .filter(|_| free.bodies.len() <= MOST_BODIES)
        else {
            continue;
        };
        let index = |part: usize| {
            let body = bodies.get(&part)?;
            free.bodies.iter().position(|b| b == body)
        };
        let mut seen = BTreeSet::new();
        for pair in pairs {
            let (first, second) = (index(pair.a), index(pair.b));
            let (Some(one), Some(two)) = (bodies.get(&pair.a), bodies.get(&pair.b)) else {
                continue;
            };
            if one == two || (first.is_none() && second.is_none()) {
                continue;
            }
            let round = pair
                .meetings
                .iter()
                .find(|m| m.kind == Kind::Cylinder && guides(m));
            let Some(about) = round.and_then(|m| m.about) else {
                continue;
            };
            let axis = Vector3::from(about.direction);
            if !seen.insert((one.min(two), one.max(two))) || turns(basis, first, second, &axis) {
                continue;
            }
            let play = free.turn_play_between(first, second, &axis);
            let Some(play) = play.map(f64::to_degrees).filter(|p| *p > MOST_DEG) else {
                continue;
            };
            let (hole, inner) = match about.first_has_hole {
                true => (pair.a, pair.b),
                false => (pair.b, pair.a),
            };
            out.push(Rattles {
                hole,
                inner,
                play_deg: play,
            });
        }
    }
    out
}

/// Whether two bodies turn against each other about an axis in some motion.
fn turns(
    basis: &DMatrix<f64>,
    first: Option<usize>,
    second: Option<usize>,
    axis: &Vector3<f64>,
) -> bool {
    let of = |body: Option<usize>, column: usize| {
        let speed = |k: usize| body.and_then(|b| basis.get((6 * b + k, column))).copied();
        let turn = Vector3::new(
            speed(0).unwrap_or_default(),
            speed(1).unwrap_or_default(),
            speed(2).unwrap_or_default(),
        );
        turn.dot(axis)
    };
    (0..basis.ncols()).any(|c| (of(second, c) - of(first, c)).abs() > 1e-6)
}

pub(super) fn told(resolved: &Resolved, all: &[Rattles]) -> Vec<Finding> {
    let each = all.iter().map(|r| {
        let (hole, inner) = (resolved.name(r.hole), resolved.name(r.inner));
        let play = rounded(r.play_deg);
        let mut values = Map::new();
        values.insert("play_deg".to_owned(), json!(play));
        let d = Diagnostic::error(
            Code::NotHeld,
            format!("parts '{hole}' and '{inner}'"),
            format!(
                "'{inner}' turns in '{hole}' by {play:.2} degrees before anything stops it: what should hold it against \
                 turning has too much play"
            ),
        )
        .found(play)
        .expected(format!("at most {MOST_DEG} degrees, or a turn that is left free and stated"))
        .hint("make the key or the flat fit its seat, or hold the two by friction: a press fit, a set screw, a bond");
        Finding {
            verdict: Verdict::Fail,
            check: super::CHECK.to_owned(),
            parts: vec![hole, inner],
            mates: Vec::new(),
            values,
            axioms: Vec::new(),
            diagnostic: d,
        }
    });
    each.collect()
}
