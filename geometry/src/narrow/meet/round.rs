//! Cylinders and cones in holes about one axis.

use core::f64::consts::{PI, TAU};

use super::clip::{P, Tri, area};
use super::{About, Kind, Meeting, REACH_MM, across, spot};
use crate::narrow::patch::{Patch, Surface, V, across as perpendicular};

/// Axes that differ by no more than this sine are parallel.
const PARALLEL: f64 = 1e-4;

/// Slopes of cones that differ by no more than this are one.
const SAME_SLOPE: f64 = 1e-4;

/// How much wider a cylinder may be than the hole that it is in, as a share of the hole: threads are modelled as
/// plain cylinders, and that of M1.6 is 28 percent wider than its core.
const TIGHTEST: f64 = 0.35;

/// How far an axis may be beyond where the hole's wall lets it be, in mm.
const BEYOND_MM: f64 = 0.05;

/// Sectors of the circle in which the points that hold are looked for.
const SECTORS: u32 = 16;

/// The smallest area, in mm2.
const LEAST_MM2: f64 = 1e-6;

#[derive(Debug, Clone, Copy)]
struct Cone {
    origin: V,
    axis: V,
    radius: f64,
    slope: f64,
}

fn cone(patch: &Patch<'_>) -> Option<Cone> {
    match patch.surface {
        Surface::Round {
            origin,
            axis,
            radius,
            slope,
            ..
        } => Some(Cone {
            origin,
            axis,
            radius,
            slope,
        }),
        _ => None,
    }
}

/// One of the two in the other.
pub(super) fn meet(a: &Patch<'_>, b: &Patch<'_>, near: &[(u32, u32)]) -> Option<Meeting> {
    let first_has_hole = match (a.hollow(), b.hollow()) {
        (true, false) => true,
        (false, true) => false,
        _ => return None,
    };
    let (outer, inner) = if first_has_hole { (a, b) } else { (b, a) };
    let (hole, pin) = (cone(outer)?, cone(inner)?);
    let way = hole.axis.dot(&pin.axis);
    if hole.axis.cross(&pin.axis).norm() > PARALLEL {
        return None;
    }
    let slope = pin.slope * way;
    if (hole.slope - slope).abs() > SAME_SLOPE {
        return None;
    }
    let arm = pin.origin - hole.origin;
    // The pin's radius where the hole's is stated.
    let radius = pin.radius - slope * arm.dot(&hole.axis);
    let off = perpendicular(&arm, &hole.axis);
    let play = hole.radius - radius;
    let flank = libm::sqrt(1.0 + slope * slope);
    let gap = play / flank;
    let tightest = -TIGHTEST * hole.radius.abs();
    if !(tightest..=REACH_MM).contains(&gap) || off.norm() > play.max(0.0) + BEYOND_MM {
        return None;
    }
    let (x, y) = across(&hole.axis);
    let unrolled = |patch: &Patch<'_>, triangle: u32, about: &V| {
        let polar = |p: &V| {
            let arm = p - about;
            let angle = libm::atan2(arm.dot(&y), arm.dot(&x));
            (angle, (p - hole.origin).dot(&hole.axis))
        };
        let corners = patch.triangle(triangle)?;
        let [(first, _), ..] = corners.map(|p| polar(&p));
        Some(Tri::new(corners.map(|p| {
            let (angle, z) = polar(&p);
            P::new(first + turn(angle - first), z)
        })))
    };
    let about_pin = hole.origin + off;
    let mut found = Found::default();
    for (one, two) in near {
        let (of_hole, of_pin) = if first_has_hole {
            (one, two)
        } else {
            (two, one)
        };
        let (Some(one), Some(two)) = (
            unrolled(outer, *of_hole, &hole.origin),
            unrolled(inner, *of_pin, &about_pin),
        ) else {
            continue;
        };
        let whole = TAU * libm::round((one.middle().x - two.middle().x) / TAU);
        // A triangle may come round on either side.
        for turns in [whole, whole + TAU, whole - TAU] {
            found.take(&one.common(&two.moved(&P::new(turns, 0.0))));
        }
    }
    let middle = (found.range[0] + found.range[1]) / 2.0;
    let area = found.area * (radius + slope * middle).abs() * flank;
    if area < LEAST_MM2 || !area.is_finite() {
        return None;
    }
    let out_of_first = if first_has_hole { -1.0 } else { 1.0 };
    let spots = found.spots.iter().flatten().flatten().map(|(angle, z)| {
        let (sin, cos) = libm::sincos(*angle);
        let radial = x * cos + y * sin;
        let r = radius + slope * z;
        let at = hole.origin + off + hole.axis * *z + radial * r;
        let normal = (radial - hole.axis * slope) / flank;
        let room = (hole.radius + slope * z - (off + radial * r).norm()) / flank;
        spot(at, normal * out_of_first, room)
    });
    Some(Meeting {
        kind: if hole.slope == 0.0 {
            Kind::Cylinder
        } else {
            Kind::Cone
        },
        gap_mm: gap,
        area_mm2: area,
        about: Some(About {
            point: hole.origin.into(),
            direction: hole.axis.into(),
            hole_mm: hole.radius,
            inner_mm: radius,
            range: found.range,
            share: found.share(),
            first_has_hole,
        }),
        spots: spots.collect(),
    })
}

/// An angle within half a turn of 0.
fn turn(angle: f64) -> f64 {
    angle - TAU * libm::floor((angle + PI) / TAU)
}

/// What two sheets have in common, as angles and heights.
struct Found {
    area: f64,
    range: [f64; 2],
    /// The lowest and the highest point of each sector.
    spots: Vec<[Option<(f64, f64)>; 2]>,
    /// From which angle to which: pieces.
    spans: Vec<(f64, f64)>,
}

impl Default for Found {
    fn default() -> Self {
        Self {
            area: 0.0,
            range: [f64::INFINITY, f64::NEG_INFINITY],
            spots: vec![[None; 2]; SECTORS as usize],
            spans: Vec::new(),
        }
    }
}

impl Found {
    fn take(&mut self, common: &[P]) {
        if common.is_empty() {
            return;
        }
        self.area += area(common);
        let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
        for p in common {
            let [low, high] = self.range;
            self.range = [low.min(p.y), high.max(p.y)];
            (from, to) = (from.min(p.x), to.max(p.x));
            let share = (turn(p.x) + PI) / TAU * f64::from(SECTORS);
            // Rounded, so that the two ends of one line of triangles fall into one sector.
            let sector = libm::floor(share + 1e-6) as usize % SECTORS as usize;
            if let Some([lowest, highest]) = self.spots.get_mut(sector) {
                let here = (p.x, p.y);
                if lowest.is_none_or(|(_, z)| p.y < z) {
                    *lowest = Some(here);
                }
                if highest.is_none_or(|(_, z)| p.y > z) {
                    *highest = Some(here);
                }
            }
        }
        let start = turn(from);
        self.spans.push((start, start + (to - from)));
    }

    /// The share of the circle that the pieces cover.
    fn share(&self) -> f64 {
        let split = self
            .spans
            .iter()
            .flat_map(|(from, to)| [(*from, to.min(PI)), (-PI, to - TAU)]);
        let mut spans: Vec<(f64, f64)> = split.filter(|(from, to)| to > from).collect();
        spans.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut covered, mut end) = (0.0, -PI);
        for (from, to) in spans {
            covered += (to - from.max(end)).max(0.0);
            end = end.max(to);
        }
        (covered / TAU).min(1.0)
    }
}
