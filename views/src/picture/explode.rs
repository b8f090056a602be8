//! Parts drawn apart: each along the axis of the mate that placed it, away from what it is mated to.

use assemcad_model::mates::MateType;
use assemcad_placing::{Box3, Partial};
use nalgebra::Vector3;

/// The gap between parts that are drawn apart, as a share of the assembly's diagonal.
const GAP: f64 = 0.06;

/// How far each part is moved in the world, in mm, parts without a place not at all. `boxes` are those of
/// the placed parts.
///
/// A part is moved by what its neighbour is moved, and then out of the neighbour's box along the axis of
/// their mate, and by a gap more.
pub(super) fn offsets(part: &Partial, boxes: &[Option<Box3>], factor: f64) -> Vec<[f64; 3]> {
    let mut moved: Vec<Option<Vector3<f64>>> = vec![None; boxes.len()];
    if let Some(slot) = part.resolved.root.and_then(|root| moved.get_mut(root)) {
        *slot = Some(Vector3::zeros());
    }
    let gap = GAP * diagonal(boxes);
    // Each round moves the parts whose neighbours are known: as many rounds as parts are enough.
    for _ in 0..boxes.len() {
        for i in 0..boxes.len() {
            if moved.get(i).copied().flatten().is_some() {
                continue;
            }
            if let Some(by) = one(part, boxes, &moved, i, gap, factor)
                && let Some(slot) = moved.get_mut(i)
            {
                *slot = Some(by);
            }
        }
    }
    moved
        .into_iter()
        .map(|m| m.unwrap_or_default().into())
        .collect()
}

fn one(
    part: &Partial,
    boxes: &[Option<Box3>],
    moved: &[Option<Vector3<f64>>],
    i: usize,
    gap: f64,
    factor: f64,
) -> Option<Vector3<f64>> {
    let mate = (*part.placements.placed_by.get(i)?)?;
    let mate = part.resolved.mates.get(mate)?;
    let (neighbour, port) = if mate.incoming == i {
        (mate.base, &mate.base_port)
    } else {
        (mate.incoming, &mate.incoming_port)
    };
    let before = moved.get(neighbour).copied().flatten()?;
    let at = part.placements.of(neighbour)?;
    let mut along = Vector3::from(at.direction(port.frame.z));
    // An axis has two ways: out by the one on which its neighbour went. A face has one.
    let face = matches!(
        mate.mate.mate_type,
        MateType::FaceToFace | MateType::SnapToFace | MateType::CoaxialFace
    );
    if !face && along.dot(&before) < 0.0 {
        along = -along;
    }
    let (own, other) = (boxes.get(i)?.as_ref()?, boxes.get(neighbour)?.as_ref()?);
    let inside = (reach(other, &along) + reach(own, &-along)).max(0.0);
    Some(before + along * ((inside + gap) * factor))
}

/// How far a box reaches along a direction, from the origin.
fn reach((min, max): &Box3, along: &Vector3<f64>) -> f64 {
    min.iter()
        .zip(max)
        .zip(along.iter())
        .map(|((low, high), d)| (low * d).max(high * d))
        .sum()
}

/// The diagonal of the box of all boxes, in mm.
pub(super) fn diagonal(boxes: &[Option<Box3>]) -> f64 {
    let (mut low, mut high) = (
        Vector3::repeat(f64::INFINITY),
        Vector3::repeat(f64::NEG_INFINITY),
    );
    for (min, max) in boxes.iter().flatten() {
        low = low.inf(&Vector3::from(*min));
        high = high.sup(&Vector3::from(*max));
    }
    let diagonal = (high - low).norm();
    if diagonal.is_finite() { diagonal } else { 0.0 }
}
