//! What there is to say of a clash beside its volume: duplicates, threads that nobody engages, and how the
//! parts come free of each other.

use assemcad_geometry::{Asker, PlacedSolid};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::{Frame, Placement};
use assemcad_model::report::{Finding, rounded};
use assemcad_model::spec::Assembly;
use assemcad_placing::solids::moved;
use assemcad_placing::{Assembled, Box3};
use serde_json::json;

use super::thread;

/// Of so many clashes the way out is looked for by moving a part; of the others it is taken from the boxes.
pub(super) const MOST_MOVED: usize = 16;

/// So many directions are tried for one clash.
const MOST_TRIED: usize = 8;

/// Equal parts whose common volume differs less from their own are one body, relative.
const SAME_BODY: f64 = 1e-6;

/// A pair of parts that clash.
pub(super) struct Clash<'a> {
    pub(super) spec: &'a Assembly,
    pub(super) assembled: &'a Assembled<'a>,
    pub(super) pair: (usize, usize),
    /// The box of what they have in common.
    pub(super) common: Option<Box3>,
    pub(super) volume: f64,
    pub(super) tau: f64,
}

/// A move of the second part that takes the two apart.
#[derive(Debug, Clone, Copy)]
struct Way {
    along: [f64; 3],
    mm: f64,
}

/// Completes the finding of a clash.
pub(super) async fn tell(door: Asker<'_>, c: &Clash<'_>, moving: bool, finding: &mut Finding) {
    if let Some(d) = duplicate(c) {
        finding.diagnostic = d;
        return;
    }
    if let Some(way) = way_out(door, c, moving).await {
        // Moved that far, the two are free of each other. A shorter way may be there: the depth of
        // penetration is at most this.
        let values = &mut finding.values;
        values.insert("penetration_at_most_mm".to_owned(), json!(rounded(way.mm)));
        values.insert(
            "second_part_comes_free_along".to_owned(),
            json!(way.along.map(rounded)),
        );
    }
    if let Some(call) = thread::engage(c.spec, c.assembled, c.pair) {
        let d = &mut finding.diagnostic;
        d.message = format!(
            "{}: a screw in a threaded hole that no mate engages",
            d.message
        );
        d.hint = Some(
            "join the two threads with thread_engage, which allows for the overlap".to_owned(),
        );
        *d = d.clone().next("mate", call);
    }
}

/// The shortest way out that was found, of those along the world's axes and the mates' axes: as far as
/// what they have in common reaches, where the kernel finds nothing in common after that move (around
/// a corner it may), or else as far as the parts' boxes overlap.
async fn way_out(door: Asker<'_>, c: &Clash<'_>, moving: bool) -> Option<Way> {
    let (i, j) = c.pair;
    let boxes = (c.assembled.world_box(i)?, c.assembled.world_box(j)?);
    let by_boxes = out_of_box(&boxes.0, &boxes.1)?;
    let (a, b) = (c.assembled.solid(i)?, c.assembled.solid(j)?);
    let Some(common) = c.common.filter(|_| moving) else {
        return Some(by_boxes);
    };
    let mut ways = Vec::new();
    for (k, (lo, hi)) in common.0.into_iter().zip(common.1).enumerate() {
        let mut along = [0.0; 3];
        along.get_mut(k).map(|x| *x = 1.0)?;
        ways.extend(both(along, hi - lo));
    }
    for axis in slanted_axes(c) {
        if let Some(extent) = extent_along(door, &a, &b, &axis).await {
            ways.extend(both(axis.z, extent));
        }
    }
    ways.sort_by(|x, y| x.mm.total_cmp(&y.mm));
    ways.retain(|w| w.mm < by_boxes.mm);
    for way in ways.into_iter().take(MOST_TRIED) {
        let [x, y, z] = way.along.map(|d| d * way.mm);
        let to = Placement::translation(x, y, z) * b.at;
        let left = overlap(door, &a, &moved(&b, &to)).await;
        if left.is_some_and(|(volume, _)| volume <= c.tau) {
            return Some(way);
        }
    }
    Some(by_boxes)
}

/// How far what two solids have in common reaches along the z of a frame.
async fn extent_along(
    door: Asker<'_>,
    a: &PlacedSolid,
    b: &PlacedSolid,
    axis: &Frame,
) -> Option<f64> {
    let turn = axis.placement().ok()?.inverse();
    let turned = |s: &PlacedSolid| moved(s, &(turn * s.at));
    let (_, place) = overlap(door, &turned(a), &turned(b)).await?;
    place.map(|([.., lo], [.., hi])| hi - lo)
}

/// Volume and box of what two solids have in common; none where the kernel does not tell for sure.
async fn overlap(door: Asker<'_>, a: &PlacedSolid, b: &PlacedSolid) -> Option<(f64, Option<Box3>)> {
    let v = door.common_volume(a, b, 0).await.ok()?;
    let place = v.place.map(|(min, max, _)| (min, max));
    v.warnings.is_empty().then_some((v.volume, place))
}

fn both(along: [f64; 3], mm: f64) -> [Way; 2] {
    let back = along.map(|x| 0.0 - x);
    [Way { along, mm }, Way { along: back, mm }]
}

/// The axes of the mates between the two parts that are none of the world's.
fn slanted_axes(c: &Clash<'_>) -> Vec<Frame> {
    let (i, j) = c.pair;
    let between = c.assembled.resolved.between(i, j);
    let axes =
        between.filter_map(|m| Some(c.assembled.placements.of(m.base)?.frame(&m.base_port.frame)));
    axes.filter(|f| f.z.iter().all(|x| x.abs() < 1.0 - 1e-9))
        .collect()
}

/// The shortest move of the second box out of the first along the world's axes.
fn out_of_box(a: &Box3, b: &Box3) -> Option<Way> {
    let mut ways = Vec::new();
    for k in 0..3 {
        let of = |p: &[f64; 3]| p.get(k).copied();
        let mut along = [0.0; 3];
        along.get_mut(k).map(|x| *x = 1.0)?;
        let [up, down] = both(along, 0.0);
        ways.push(Way {
            mm: of(&a.1)? - of(&b.0)?,
            ..up
        });
        ways.push(Way {
            mm: of(&b.1)? - of(&a.0)?,
            ..down
        });
    }
    ways.into_iter().min_by(|x, y| x.mm.total_cmp(&y.mm))
}

/// Two parts of one recipe that are one body: the same part twice in one place.
fn duplicate(c: &Clash<'_>) -> Option<Diagnostic> {
    let of = |i: usize| Some((c.assembled.resolved.parts.get(i)?, c.assembled.built(i)?));
    let ((a, built_a), (b, built_b)) = (of(c.pair.0)?, of(c.pair.1)?);
    let whole = c.volume >= built_a.volume * (1.0 - SAME_BODY);
    if built_a.recipe != built_b.recipe || !whole {
        return None;
    }
    // Of the two the one is taken out that fewer mates hold; the later where that is equal.
    let count = |id: &str| c.spec.mates_of(id).count();
    let second = if count(&a.id) < count(&b.id) { a } else { b };
    let d = Diagnostic::error(
        Code::Duplicate,
        format!("parts '{}' and '{}'", a.id, b.id),
        format!(
            "'{}' and '{}' are the same part ({}) twice in one place",
            a.id, b.id, a.factory
        ),
    );
    let remove =
        |kind: &str, name: &str| json!({"assembly": c.spec.id, "kind": kind, "name": name});
    Some(match c.spec.mates_of(&second.id).next() {
        None => d
            .hint("take one of them out, or give it another place")
            .next("remove", remove("part", &second.id)),
        Some(mate) => d
            .hint(format!(
                "give one of them another place, or take it out: first the mates of '{}', then the part",
                second.id
            ))
            .next("remove", remove("mate", &mate.id)),
    })
}
