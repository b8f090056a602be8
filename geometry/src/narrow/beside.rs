//! Faces that look the same way and lie beside each other: what they have in common lies on the borders of both.
//!
//! Two faces of one surface that look the same way would not be seen to cross where one enters the other. Where
//! a curve parts them, each lies on its own side of it, and no point within one of them is a point of the other.

use super::patch::{Edge, PARALLEL, Patch, Surface, V, across};
use super::side::TOUCH_MM;

/// So many edges of a border are tried.
const MOST_EDGES: usize = 64;

/// Whether no point within one of two faces is for sure a point of the other.
pub(super) fn beside(a: &Patch<'_>, b: &Patch<'_>) -> bool {
    match (a.surface, b.surface) {
        (
            Surface::Plane { origin, normal },
            Surface::Plane {
                origin: other,
                normal: own,
            },
        ) => {
            if normal.cross(&own).norm() > PARALLEL {
                return false;
            }
            (other - origin).dot(&normal).abs() > TOUCH_MM || parted(a, b, &normal)
        }
        (
            Surface::Round {
                origin,
                axis,
                radius,
                slope,
                range,
            },
            Surface::Round {
                origin: other,
                axis: own,
                radius: r,
                slope: s,
                range: reach,
            },
        ) if slope == 0.0 && s == 0.0 => {
            let coaxial = own.cross(&axis).norm() <= PARALLEL
                && across(&(other - origin), &axis).norm() <= TOUCH_MM;
            if !coaxial {
                return false;
            }
            let [from, to] = reach.map(|z| (other + own * z - origin).dot(&axis));
            let (low, high) = (from.min(to), from.max(to));
            let [first, last] = range;
            let (first, last) = (first.min(last), first.max(last));
            (radius - r).abs() > 2.0 * TOUCH_MM
                || low >= last - TOUCH_MM
                || high <= first + TOUCH_MM
        }
        _ => false,
    }
}

/// Whether an edge of one of two faces in a plane parts them.
fn parted(a: &Patch<'_>, b: &Patch<'_>, normal: &V) -> bool {
    let (few, many) = match a.face.edges.len() <= b.face.edges.len() {
        true => (a, b),
        false => (b, a),
    };
    let edges = few.borders().chain(many.borders()).take(MOST_EDGES);
    edges.into_iter().any(|edge| match edge {
        Edge::Line(start, end) => {
            let Some(side) = normal.cross(&(end - start)).try_normalize(1e-12) else {
                return false;
            };
            let at = start.dot(&side);
            let above = |p: &Patch<'_>| p.lowest(&side).is_some_and(|l| l >= at - TOUCH_MM);
            let below = |p: &Patch<'_>| p.lowest(&-side).is_some_and(|l| l >= -at - TOUCH_MM);
            (above(few) && below(many)) || (below(few) && above(many))
        }
        Edge::Circle {
            center,
            axis,
            radius,
            ..
        } => {
            let out = |p: &Patch<'_>| {
                p.nearest_to_line(&center, &axis)
                    .is_some_and(|l| l >= radius - TOUCH_MM)
            };
            let within = |p: &Patch<'_>| {
                p.farthest_from_line(&center, &axis)
                    .is_some_and(|l| l <= radius + TOUCH_MM)
            };
            (within(few) && out(many)) || (out(few) && within(many))
        }
        Edge::Unknown => false,
    })
}
