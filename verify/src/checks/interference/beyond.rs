//! Overlaps beside a meant one: what a thread or a press fit may have in common lies about its axis, and the room
//! that is left there is none for anything else.

use assemcad_geometry::narrow::Sleeve;
use assemcad_geometry::{Asker, Stray};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Finding, Overlapping, Verdict, rounded};
use assemcad_placing::Assembled;
use serde_json::{Map, json};

use super::{Allowed, Judged};

/// How much wider than the thread or the fit the space about the axis is in which nothing is held against the pair,
/// in mm.
const WIDER_MM: f64 = 0.02;

/// Looks for an overlap of a pair outside of where its mates mean one.
pub(super) async fn check(
    door: Asker<'_>,
    assembled: &Assembled<'_>,
    (i, j): (usize, usize),
    allowed: &Allowed,
    found: &mut Judged,
) {
    let (Some(a), Some(b)) = (assembled.solid(i), assembled.solid(j)) else {
        return;
    };
    let sleeves = allowed.meant.iter().filter_map(|m| {
        let frame = assembled.placements.of(m.part)?.frame(&m.frame);
        Some(Sleeve {
            point: frame.origin,
            direction: frame.z,
            radius: m.radius_mm + WIDER_MM,
        })
    });
    let sleeves: Vec<Sleeve> = sleeves.collect();
    // What cannot be shown either way is held against the volume that is meant, as a whole.
    let Ok(Stray::At(point)) = door.beyond(&a, &b, &sleeves).await else {
        return;
    };
    let (one, two) = (assembled.resolved.name(i), assembled.resolved.name(j));
    let point = point.map(rounded);
    let mut values = Map::new();
    values.insert("at_mm".to_owned(), json!(point));
    let d = Diagnostic::error(
        Code::Clash,
        format!("parts '{one}' and '{two}'"),
        format!(
            "they overlap at {} too, beside the overlap that is meant ({})",
            json!(point),
            allowed.why.join(", ")
        ),
    )
    .found(json!(point))
    .hint("change the parameters of one part, or the offsets of the mate that places it");
    found.verdict = Verdict::Fail;
    found.class = Overlapping::Clash;
    found.finding = Some(Finding {
        verdict: Verdict::Fail,
        check: "interference".to_owned(),
        parts: vec![one, two],
        mates: allowed.mates.clone(),
        values,
        axioms: Vec::new(),
        diagnostic: d,
    });
}
