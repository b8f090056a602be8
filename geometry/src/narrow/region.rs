//! Regions of a plane that lines and arcs bound, and the area that two of them have in common.
//!
//! The border of what two regions have in common is made of pieces of their borders, cut where these meet. A
//! piece belongs to it where the common part lies on one of its sides only; which one is found by looking a little
//! to its left and right. Green's formula sums the area, exact for lines and arcs.

use core::f64::consts::TAU;

use nalgebra::Vector2;

pub(super) type P = Vector2<f64>;

/// How far beside a piece it is looked, in mm.
const BESIDE_MM: f64 = 1e-6;

/// How many steps along an arc are taken for its points.
const ALONG_ARC: u32 = 16;

/// Points nearer to each other than this are one, in mm.
const SAME_MM: f64 = 1e-7;

/// A piece of a border.
#[derive(Debug, Clone, Copy)]
pub(super) enum Curve {
    Line {
        from: P,
        to: P,
    },
    /// Counter-clockwise from an angle, by a sweep of at most one turn, in radians.
    Arc {
        center: P,
        radius: f64,
        from: f64,
        sweep: f64,
    },
}

/// A region by its border; in which order and direction does not matter.
pub(super) type Region = Vec<Curve>;

/// The common area of two regions in mm2.
pub(super) fn common_area(a: &Region, b: &Region) -> f64 {
    common(a, b).0
}

/// The common area of two regions in mm2, and points of the border of what they have in common: the ends of its pieces
/// and points along those that are round.
pub(super) fn common(a: &Region, b: &Region) -> (f64, Vec<P>) {
    let (box_a, box_b) = (bounds(a), bounds(b));
    let window = (box_a.0.sup(&box_b.0), box_a.1.inf(&box_b.1));
    if window.0.x >= window.1.x || window.0.y >= window.1.y {
        return (0.0, Vec::new());
    }
    let seen = |c: &&Curve| {
        let (low, high) = bounds(core::slice::from_ref(*c));
        low.x <= window.1.x + SAME_MM
            && high.x >= window.0.x - SAME_MM
            && low.y <= window.1.y + SAME_MM
            && high.y >= window.0.y - SAME_MM
    };
    let near: Vec<&Curve> = a.iter().chain(b).filter(seen).collect();
    // A ray along x from a point of the window passes only what reaches the window's heights.
    let beside = |region: &Region| -> Region {
        let heights = |c: &&Curve| {
            let (low, high) = bounds(core::slice::from_ref(*c));
            // Points are looked at a little beside the window's border.
            let slack = 2.0 * BESIDE_MM;
            low.y <= window.1.y + slack
                && high.y >= window.0.y - slack
                && high.x >= window.0.x - slack
        };
        region.iter().filter(heights).copied().collect()
    };
    let (rows_a, rows_b) = (beside(a), beside(b));
    let origin = (window.0 + window.1) / 2.0;
    let mut kept: Vec<(P, f64)> = Vec::new();
    let mut area = 0.0;
    let mut points = Vec::new();
    for curve in &near {
        for piece in pieces(curve, &near) {
            let (middle, left) = piece.middle();
            let both = |p: P| inside(&rows_a, &p) && inside(&rows_b, &p);
            let (on_left, on_right) = (
                both(middle + left * BESIDE_MM),
                both(middle - left * BESIDE_MM),
            );
            if on_left == on_right {
                continue;
            }
            // The same piece of both borders counts once.
            let length = piece.length();
            let again = |(m, l): &(P, f64)| {
                (m - middle).norm() <= SAME_MM && (l - length).abs() <= 4.0 * SAME_MM
            };
            if kept.iter().any(again) {
                continue;
            }
            kept.push((middle, length));
            let steps = match piece {
                Curve::Line { .. } => 1,
                Curve::Arc { .. } => ALONG_ARC,
            };
            points.extend((0..=steps).map(|k| piece.at(f64::from(k) / f64::from(steps))));
            area += if on_left {
                piece.swept(&origin)
            } else {
                -piece.swept(&origin)
            };
        }
    }
    (area.max(0.0), points)
}

fn bounds(curves: &[Curve]) -> (P, P) {
    let mut out = (P::repeat(f64::INFINITY), P::repeat(f64::NEG_INFINITY));
    let mut take = |p: P| out = (out.0.inf(&p), out.1.sup(&p));
    for curve in curves {
        match curve {
            Curve::Line { from, to } => {
                take(*from);
                take(*to);
            }
            // The whole circle: enough to see what is near.
            Curve::Arc { center, radius, .. } => {
                take(center.add_scalar(-radius));
                take(center.add_scalar(*radius));
            }
        }
    }
    out
}

/// Whether a point off the border is in a region: a ray along x passes its border an odd number of times.
fn inside(region: &[Curve], p: &P) -> bool {
    let passes = |curve: &Curve| -> usize {
        match *curve {
            Curve::Line { from, to } => {
                if (from.y > p.y) == (to.y > p.y) {
                    return 0;
                }
                let x = from.x + (to.x - from.x) * ((p.y - from.y) / (to.y - from.y));
                usize::from(x > p.x)
            }
            Curve::Arc {
                center,
                radius,
                from,
                sweep,
            } => {
                let h = p.y - center.y;
                if h.abs() >= radius || center.x + radius <= p.x {
                    return 0;
                }
                let half = libm::sqrt((radius - h) * (radius + h));
                let met =
                    |x: f64| center.x + x > p.x && on_arc(libm::atan2(h, x), from, sweep, 0.0);
                usize::from(met(half)) + usize::from(met(-half))
            }
        }
    };
    region.iter().map(passes).sum::<usize>() % 2 == 1
}

/// Whether an angle lies on an arc; `slack` radians beyond its ends count too.
fn on_arc(angle: f64, from: f64, sweep: f64, slack: f64) -> bool {
    sweep >= TAU - 1e-9 || turned(angle - from, -slack) <= sweep + slack
}

/// An angle moved by whole turns to where it is at least `least`.
fn turned(angle: f64, least: f64) -> f64 {
    angle - TAU * libm::floor((angle - least) / TAU)
}

/// A curve cut where others meet it.
fn pieces(curve: &Curve, others: &[&Curve]) -> Vec<Curve> {
    // By the share of the way along the curve.
    let mut cuts = vec![0.0, 1.0];
    for other in others {
        if !core::ptr::eq(*other, curve) {
            for point in meetings(curve, other) {
                cuts.extend(curve.share(&point));
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    let shortest = SAME_MM / curve.length().max(SAME_MM);
    cuts.dedup_by(|b, a| *b - *a <= shortest);
    let ends = cuts.iter().skip(1);
    let spans = cuts.iter().zip(ends);
    spans.map(|(from, to)| curve.part(*from, *to)).collect()
}

/// Where two curves meet, and the ends of the other one, which may lie on the first.
fn meetings(a: &Curve, b: &Curve) -> Vec<P> {
    let mut found = b.ends().to_vec();
    match (*a, *b) {
        (Curve::Line { from, to }, Curve::Line { from: p, to: q }) => {
            let (d, e) = (to - from, q - p);
            let cross = d.perp(&e);
            if cross.abs() > 1e-12 * d.norm() * e.norm() {
                found.push(from + d * ((p - from).perp(&e) / cross));
            }
        }
        (Curve::Line { from, to }, Curve::Arc { center, radius, .. })
        | (Curve::Arc { center, radius, .. }, Curve::Line { from, to }) => {
            let Some(d) = (to - from).try_normalize(1e-12) else {
                return found;
            };
            let foot = from + d * (center - from).dot(&d);
            let off = (foot - center).norm();
            let half = libm::sqrt(((radius - off) * (radius + off)).max(0.0));
            if off <= radius + SAME_MM {
                found.extend([foot + d * half, foot - d * half]);
            }
        }
        (
            Curve::Arc { center, radius, .. },
            Curve::Arc {
                center: other,
                radius: r,
                ..
            },
        ) => {
            let arm = other - center;
            let d = arm.norm();
            if d > SAME_MM && d <= radius + r + SAME_MM && d >= (radius - r).abs() - SAME_MM {
                let along = (d * d + (radius - r) * (radius + r)) / (2.0 * d);
                let half = libm::sqrt(((radius - along) * (radius + along)).max(0.0));
                let u = arm / d;
                let across = P::new(-u.y, u.x);
                let foot = center + u * along;
                found.extend([foot + across * half, foot - across * half]);
            }
        }
    }
    found
}

impl Curve {
    fn at(&self, share: f64) -> P {
        match *self {
            Self::Line { from, to } => from + (to - from) * share,
            Self::Arc {
                center,
                radius,
                from,
                sweep,
            } => {
                let (sin, cos) = libm::sincos(from + sweep * share);
                center + P::new(cos, sin) * radius
            }
        }
    }

    fn ends(&self) -> [P; 2] {
        [self.at(0.0), self.at(1.0)]
    }

    fn length(&self) -> f64 {
        match self {
            Self::Line { from, to } => (to - from).norm(),
            Self::Arc { radius, sweep, .. } => radius * sweep,
        }
    }

    /// Its middle, and the direction to the left of it.
    fn middle(&self) -> (P, P) {
        let middle = self.at(0.5);
        let left = match self {
            Self::Line { from, to } => {
                let d = (to - from).normalize();
                P::new(-d.y, d.x)
            }
            Self::Arc { center, .. } => (center - middle).normalize(),
        };
        (middle, left)
    }

    /// How far along the curve a point lies that is on it; none of one that is not.
    fn share(&self, p: &P) -> Option<f64> {
        match *self {
            Self::Line { from, to } => {
                let d = to - from;
                let share = (p - from).dot(&d) / d.norm_squared();
                let on = (from + d * share - p).norm() <= SAME_MM && (0.0..=1.0).contains(&share);
                on.then_some(share)
            }
            Self::Arc {
                center,
                radius,
                from,
                sweep,
            } => {
                let arm = p - center;
                if (arm.norm() - radius).abs() > SAME_MM {
                    return None;
                }
                let share = turned(libm::atan2(arm.y, arm.x) - from, 0.0) / sweep;
                (share <= 1.0).then_some(share)
            }
        }
    }

    fn part(&self, a: f64, b: f64) -> Self {
        match *self {
            Self::Line { from, to } => Self::Line {
                from: from + (to - from) * a,
                to: from + (to - from) * b,
            },
            Self::Arc {
                center,
                radius,
                from,
                sweep,
            } => Self::Arc {
                center,
                radius,
                from: from + sweep * a,
                sweep: sweep * (b - a),
            },
        }
    }

    /// Half of the integral of x dy - y dx along it, about an origin.
    fn swept(&self, origin: &P) -> f64 {
        match *self {
            Self::Line { from, to } => (from - origin).perp(&(to - origin)) / 2.0,
            Self::Arc {
                center,
                radius,
                from,
                sweep,
            } => {
                let c = center - origin;
                let (s0, c0) = libm::sincos(from);
                let (s1, c1) = libm::sincos(from + sweep);
                (radius * radius * sweep + radius * (c.x * (s1 - s0) - c.y * (c1 - c0))) / 2.0
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Curve, P, Region, common_area};
    use core::f64::consts::{PI, TAU};
    use proptest::prelude::*;

    fn rectangle(x: f64, y: f64, w: f64, h: f64) -> Region {
        let p = [
            P::new(x, y),
            P::new(x + w, y),
            P::new(x + w, y + h),
            P::new(x, y + h),
        ];
        let sides = (0..4).map(|i| Curve::Line {
            from: p[i],
            to: p[(i + 1) % 4],
        });
        sides.collect()
    }

    fn circle(x: f64, y: f64, radius: f64) -> Curve {
        Curve::Arc {
            center: P::new(x, y),
            radius,
            from: 0.3,
            sweep: TAU,
        }
    }

    fn near(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-9 * b.abs().max(1.0), "{a} {b}");
    }

    #[test]
    fn rectangles_circles_and_rings() {
        let plate = rectangle(-20.0, -10.0, 40.0, 20.0);
        near(common_area(&plate, &rectangle(15.0, 5.0, 40.0, 20.0)), 25.0);
        near(common_area(&plate, &rectangle(20.0, 5.0, 40.0, 20.0)), 0.0);
        near(common_area(&plate, &plate), 800.0);
        let ring = vec![circle(1.0, 2.0, 7.0), circle(1.0, 2.0, 4.0)];
        near(common_area(&plate, &ring), PI * 33.0);
        // The plate drilled as wide as the ring's hole, and wider.
        for hole in [4.0, 5.0] {
            let drilled: Region = plate
                .iter()
                .copied()
                .chain([circle(1.0, 2.0, hole)])
                .collect();
            near(common_area(&drilled, &ring), PI * (49.0 - hole * hole));
            near(common_area(&ring, &drilled), PI * (49.0 - hole * hole));
        }
        // Two equal rings; a ring in the hole of another.
        near(common_area(&ring, &ring), PI * 33.0);
        near(common_area(&ring, &vec![circle(1.0, 2.0, 4.0)]), 0.0);
    }

    #[test]
    fn a_lens_and_a_half_circle_have_their_closed_forms() {
        // Two circles of radius 5, 6 apart: 2 r^2 acos(d / 2r) - d/2 sqrt(4 r^2 - d^2).
        let lens = 50.0 * libm::acos(0.6) - 3.0 * 8.0;
        near(
            common_area(&vec![circle(0.0, 0.0, 5.0)], &vec![circle(6.0, 0.0, 5.0)]),
            lens,
        );
        let half = common_area(
            &rectangle(-9.0, 0.0, 18.0, 9.0),
            &vec![circle(0.0, 0.0, 5.0)],
        );
        near(half, 12.5 * PI);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn a_rectangle_and_a_circle_agree_with_counted_points(x in -6.0..6.0, y in -6.0..6.0, w in 1.0..9.0, h in 1.0..9.0, r in 1.0..5.0) {
            let found = common_area(&rectangle(x, y, w, h), &vec![circle(0.5, -0.25, r)]);
            let n = 150;
            let cell = w * h / f64::from(n * n);
            let mut counted = 0.0;
            for i in 0..n {
                for j in 0..n {
                    let p = P::new(x + w * (f64::from(i) + 0.5) / f64::from(n), y + h * (f64::from(j) + 0.5) / f64::from(n));
                    if (p - P::new(0.5, -0.25)).norm() < r {
                        counted += cell;
                    }
                }
            }
            // A border crosses at most some thousand cells, half of each in doubt.
            prop_assert!((found - counted).abs() <= 0.5 * 4.0 * f64::from(n) * cell);
        }
    }
}
