//! Plane on plane.

use super::clip::{P, Tri, area};
use super::{Kind, Meeting, REACH_MM, across, spot};
use crate::narrow::patch::{Patch, Surface};
use crate::narrow::region::common;
use crate::narrow::touch::{Axes, flat};

/// Planes whose normals differ by no more than this sine from being opposed face each other.
const OPPOSED: f64 = 1e-4;

/// How far planes that face each other may be within each other, in mm: a key with interference. Deeper is no
/// contact.
const DEEPEST_MM: f64 = 0.2;

/// The smallest area, in mm2: below it is a line.
const LEAST_MM2: f64 = 1e-6;

/// A strip or the rim of a ring that is narrower carries nothing, in mm. Ours.
const LEAST_MM: f64 = 0.3;

/// Directions in which the outermost points are looked for.
const OUTERMOST: u32 = 16;

/// Two planes that face each other.
pub(super) fn meet(a: &Patch<'_>, b: &Patch<'_>, near: &[(u32, u32)]) -> Option<Meeting> {
    let (
        Surface::Plane { origin, normal },
        Surface::Plane {
            origin: other,
            normal: against,
        },
    ) = (a.surface, b.surface)
    else {
        return None;
    };
    if normal.dot(&against) > 0.0 || normal.cross(&against).norm() > OPPOSED {
        return None;
    }
    let axes = across(&normal);
    let gap = (other - origin).dot(&normal);
    if !(-DEEPEST_MM..=REACH_MM).contains(&gap) {
        return None;
    }
    let own = Axes {
        origin,
        x: axes.0,
        y: axes.1,
    };
    // Lines and arcs have closed forms; else the triangles tell.
    let (total, corners) = match (flat(a, &own), flat(b, &own)) {
        (Some(one), Some(two)) => common(&one, &two),
        _ => by_triangles(a, b, &own, near),
    };
    if total < LEAST_MM2 {
        return None;
    }
    let (narrow, wide) = widths(&corners);
    if narrow < LEAST_MM || total < 2.0 * LEAST_MM * wide {
        return None;
    }
    let spots = outermost(&corners);
    let spots = spots.into_iter().map(|p| {
        let at = origin + axes.0 * p.x + axes.1 * p.y;
        spot(at, normal, gap)
    });
    Some(Meeting {
        kind: Kind::Plane,
        gap_mm: gap,
        area_mm2: total,
        about: None,
        spots: spots.collect(),
    })
}

fn by_triangles(a: &Patch<'_>, b: &Patch<'_>, axes: &Axes, near: &[(u32, u32)]) -> (f64, Vec<P>) {
    let flat = |patch: &Patch<'_>, triangle: u32| {
        let corners = patch.triangle(triangle)?;
        Some(Tri::new(corners.map(|p| axes.flat(&p))))
    };
    let (mut total, mut corners) = (0.0, Vec::new());
    for (one, two) in near {
        if let (Some(one), Some(two)) = (flat(a, *one), flat(b, *two)) {
            let common = one.common(&two);
            total += area(&common);
            corners.extend(common);
        }
    }
    (total, corners)
}

/// The least and the largest width over some directions.
fn widths(points: &[P]) -> (f64, f64) {
    let width = |k: u32| {
        let (sin, cos) = libm::sincos(core::f64::consts::PI * f64::from(k) / f64::from(OUTERMOST));
        let along = points.iter().map(|p| p.x * cos + p.y * sin);
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = along.fold(ends, |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let each = (0..OUTERMOST).map(width);
    each.fold(ends, |(l, h), w| (l.min(w), h.max(w)))
}

/// The points that lie outermost in some directions, each once.
fn outermost(points: &[P]) -> Vec<P> {
    let mut out: Vec<P> = Vec::new();
    for k in 0..OUTERMOST {
        let angle = core::f64::consts::TAU * (f64::from(k) + 0.25) / f64::from(OUTERMOST);
        let (sin, cos) = libm::sincos(angle);
        let along = |p: &P| p.x * cos + p.y * sin;
        let best = points.iter().max_by(|p, q| along(p).total_cmp(&along(q)));
        if let Some(p) = best
            && out.iter().all(|q| (p - q).norm() > 1e-6)
        {
            out.push(*p);
        }
    }
    out
}
