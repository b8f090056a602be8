//! Lines and points of contact, and balls in sockets.

use super::{Kind, Meeting, Spot, covers, spot};
use crate::narrow::patch::{Patch, Surface, V, across as perpendicular};

/// How far a line or a point may be off and still stop something soon, in mm. Ours.
const REACH_MM: f64 = 0.3;

/// How deep it may be within the other, in mm.
const DEEPEST_MM: f64 = 0.05;

/// Directions at right angles or parallel up to this sine.
const STRAIGHT: f64 = 1e-4;

/// Points along a line at which both are looked for.
const ALONG: u32 = 16;

/// A cylinder along a plane, seen from the cylinder.
pub(super) fn on_plane(round: &Patch<'_>, plane: &Patch<'_>) -> Option<Meeting> {
    let (
        Surface::Round {
            origin,
            axis,
            radius,
            slope: 0.0,
            range,
        },
        Surface::Plane {
            origin: point,
            normal,
        },
    ) = (round.surface, plane.surface)
    else {
        return None;
    };
    if round.hollow() || axis.dot(&normal).abs() > STRAIGHT {
        return None;
    }
    let gap = (origin - point).dot(&normal) - radius;
    let at = |z: f64| origin + axis * z - normal * radius;
    line(round, plane, range, at, -normal, gap)
}

/// Two cylinders along each other from outside.
pub(super) fn beside(a: &Patch<'_>, b: &Patch<'_>) -> Option<Meeting> {
    let (
        Surface::Round {
            origin,
            axis,
            radius,
            slope: 0.0,
            range,
        },
        Surface::Round {
            origin: other,
            axis: own,
            radius: r,
            slope: 0.0,
            ..
        },
    ) = (a.surface, b.surface)
    else {
        return None;
    };
    if a.hollow() || b.hollow() || axis.cross(&own).norm() > STRAIGHT {
        return None;
    }
    let way = perpendicular(&(other - origin), &axis);
    let distance = way.norm();
    let towards = way.try_normalize(1e-9)?;
    let at = |z: f64| origin + axis * z + towards * radius;
    line(a, b, range, at, towards, distance - radius - r)
}

/// The ends of the line over which both are there.
fn line(
    a: &Patch<'_>,
    b: &Patch<'_>,
    [from, to]: [f64; 2],
    at: impl Fn(f64) -> V,
    normal: V,
    gap: f64,
) -> Option<Meeting> {
    if !(-DEEPEST_MM..=REACH_MM).contains(&gap) {
        return None;
    }
    let places = (0..=ALONG).map(|k| {
        // A little within the ends, where the faces' own borders are.
        let share = f64::from(k) / f64::from(ALONG);
        at(from + (to - from) * (1e-3 + share * 0.998))
    });
    let there: Vec<V> = places
        .filter(|p| covers(a, p) && covers(b, &(p + normal * gap)))
        .collect();
    let ends = [*there.first()?, *there.last()?];
    Some(Meeting {
        kind: Kind::Line,
        gap_mm: gap,
        area_mm2: 0.0,
        about: None,
        spots: ends.into_iter().map(|p| spot(p, normal, gap)).collect(),
    })
}

/// A ball on a plane, seen from the ball.
pub(super) fn ball_on_plane(ball: &Patch<'_>, plane: &Patch<'_>) -> Option<Meeting> {
    let (
        Surface::Sphere { center, radius },
        Surface::Plane {
            origin: point,
            normal,
        },
    ) = (ball.surface, plane.surface)
    else {
        return None;
    };
    let gap = (center - point).dot(&normal) - radius;
    let at = center - normal * radius;
    let near = (-DEEPEST_MM..=REACH_MM).contains(&gap) && !ball.hollow();
    (near && covers(ball, &at) && covers(plane, &(at - normal * gap))).then(|| Meeting {
        kind: Kind::Point,
        gap_mm: gap,
        area_mm2: 0.0,
        about: None,
        spots: vec![spot(at, -normal, gap)],
    })
}

/// A ball in a socket.
pub(super) fn socket(a: &Patch<'_>, b: &Patch<'_>) -> Option<Meeting> {
    let first_has_hole = match (a.hollow(), b.hollow()) {
        (true, false) => true,
        (false, true) => false,
        _ => return None,
    };
    let (outer, inner) = if first_has_hole { (a, b) } else { (b, a) };
    let (
        Surface::Sphere {
            center: hole,
            radius: wide,
        },
        Surface::Sphere { center, radius },
    ) = (outer.surface, inner.surface)
    else {
        return None;
    };
    let (gap, off) = (wide - radius, center - hole);
    if !(-DEEPEST_MM..=REACH_MM).contains(&gap) || off.norm() > gap.max(0.0) + DEEPEST_MM {
        return None;
    }
    let out_of_first = if first_has_hole { -1.0 } else { 1.0 };
    let mut spots: Vec<Spot> = Vec::new();
    for x in [-1.0, 0.0, 1.0] {
        for y in [-1.0, 0.0, 1.0] {
            for z in [-1.0, 0.0, 1.0] {
                let Some(way) = V::new(x, y, z).try_normalize(0.5) else {
                    continue;
                };
                let at = center + way * radius;
                let room = wide - (at - hole).norm();
                if covers(inner, &at) && covers(outer, &(hole + way * wide)) {
                    spots.push(spot(at, way * out_of_first, room));
                }
            }
        }
    }
    (!spots.is_empty()).then_some(Meeting {
        kind: Kind::Ball,
        gap_mm: gap,
        area_mm2: 0.0,
        about: None,
        spots,
    })
}
