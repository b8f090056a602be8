//! Outlines against the exact involute.

use core::f64::consts::{PI, TAU};

use assemcad_model::language::{Outline, Segment};

use super::{FLANK_TOLERANCE_MM, Toothing};

type Point = [f64; 2];

const PLAIN: Toothing = Toothing {
    module: 2.0,
    teeth: 20,
    pressure_angle_deg: 20.0,
    profile_shift: 0.0,
    thinning: 0.0,
    internal: false,
};

fn pieces(toothing: &Toothing) -> Vec<(Point, Option<Point>, Point)> {
    let Outline { start, segments } = toothing.outline().unwrap();
    let mut at = start;
    let mut all = Vec::new();
    for segment in segments {
        let (via, to) = match segment {
            Segment::Line { to } => (None, to),
            Segment::Arc { via, to } => (Some(via), to),
        };
        all.push((at, via, to));
        at = to;
    }
    assert_eq!(at, start, "closed to the last digit");
    all
}

/// Centre and radius of the circle through three points.
fn circle(a: Point, b: Point, c: Point) -> (Point, f64) {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let d = 2.0 * (u[0] * v[1] - u[1] * v[0]);
    let (uu, vv) = (u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]);
    let o = [(v[1] * uu - u[1] * vv) / d, (u[0] * vv - v[0] * uu) / d];
    ([a[0] + o[0], a[1] + o[1]], libm::hypot(o[0], o[1]))
}

fn radius([x, y]: Point) -> f64 {
    libm::hypot(x, y)
}

/// The deviations of 1000 points of one exact flank of each side from the outline's arcs, measured
/// from the arcs towards the outside of the material.
fn deviations(toothing: &Toothing) -> Vec<f64> {
    let m = toothing.module;
    let z = f64::from(toothing.teeth);
    let alpha = toothing.pressure_angle_deg.to_radians();
    let r = m * z / 2.0;
    let rb = r * libm::cos(alpha);
    // The tooth about +x: half its angle at the radius r_y is s / 2r + inv alpha - inv alpha_y, of an
    // internal tooth with the sign of the involute functions turned round.
    let s = m
        * (PI / 2.0
            + if toothing.internal { -2.0 } else { 2.0 }
                * toothing.profile_shift
                * libm::tan(alpha))
        - toothing.thinning;
    let inv = |a: f64| libm::tan(a) - a;
    let sense = if toothing.internal { -1.0 } else { 1.0 };
    let half = |t: f64| s / (2.0 * r) + sense * (inv(alpha) - (t - libm::atan(t)));
    let all = pieces(toothing);
    // The arcs of the two flanks of the tooth about +x are those that are no circle about the axis.
    let near: Vec<_> = all
        .iter()
        .filter_map(|(a, via, b)| Some((*a, (*via)?, *b)))
        .filter(|(a, via, b)| radius(circle(*a, *via, *b).0) > 1e-6)
        .filter(|(_, via, _)| libm::atan2(via[1], via[0]).abs() < PI / z)
        .collect();
    let ends = near.iter().flat_map(|(a, _, b)| [radius(*a), radius(*b)]);
    let (low, high) = ends.fold((f64::MAX, 0.0_f64), |(l, h), r| (l.min(r), h.max(r)));
    let unrolled = |radius: f64| libm::sqrt((radius * radius / (rb * rb) - 1.0).max(0.0));
    let (from, to) = (unrolled(low), unrolled(high));
    let mut found = Vec::new();
    for side in [1.0, -1.0] {
        for i in 0..1000 {
            let t = from + (to - from) * f64::from(i) / 999.0;
            let ry = rb * libm::sqrt(1.0 + t * t);
            let angle = side * half(t);
            let p = [ry * libm::cos(angle), ry * libm::sin(angle)];
            // The arc of that side whose radii hold the point.
            let (a, via, b) = near
                .iter()
                .filter(|(_, via, _)| via[1] * side > 0.0)
                .min_by(|l, r| {
                    let outside = |(a, _, b): &(Point, Point, Point)| {
                        let (lo, hi) = (radius(*a).min(radius(*b)), radius(*a).max(radius(*b)));
                        (lo - ry).max(ry - hi)
                    };
                    outside(l).total_cmp(&outside(r))
                })
                .unwrap();
            let (c, rho) = circle(*a, *via, *b);
            let d = libm::hypot(p[0] - c[0], p[1] - c[1]) - rho;
            // An external flank bulges out of the material, an internal one into it.
            found.push(if toothing.internal { -d } else { d });
        }
    }
    found
}

fn cases() -> Vec<Toothing> {
    let mut all = Vec::new();
    for (module, teeth) in [
        (0.2, 18),
        (2.0, 17),
        (2.0, 20),
        (2.0, 41),
        (2.0, 42),
        (2.0, 43),
        (3.0, 100),
        (10.0, 60),
        (50.0, 20),
        (1.0, 400),
    ] {
        for profile_shift in [0.0, 0.3] {
            for thinning in [0.0, 0.05 * module] {
                for internal in [false, true] {
                    if internal && teeth < 40 {
                        continue;
                    }
                    all.push(Toothing {
                        module,
                        teeth,
                        profile_shift,
                        thinning,
                        internal,
                        ..PLAIN
                    });
                }
            }
        }
    }
    all.push(Toothing {
        pressure_angle_deg: 14.5,
        teeth: 32,
        ..PLAIN
    });
    all.push(Toothing {
        pressure_angle_deg: 30.0,
        teeth: 9,
        ..PLAIN
    });
    all
}

#[test]
fn flanks_lie_inside_the_involute_and_within_half_a_micrometre() {
    for toothing in cases() {
        let all = deviations(&toothing);
        assert_eq!(all.len(), 2000);
        let low = all.iter().copied().fold(f64::MAX, f64::min);
        let high = all.iter().copied().fold(f64::MIN, f64::max);
        assert!(
            low >= 0.0 && high <= FLANK_TOLERANCE_MM,
            "{toothing:?}: {low:e} to {high:e} mm"
        );
        // Closer than needed would be arcs for nothing.
        assert!(high > FLANK_TOLERANCE_MM / 30.0, "{toothing:?}");
    }
}

#[test]
fn one_tooth_is_like_the_next_and_like_its_mirror_image() {
    for toothing in cases() {
        let all = pieces(&toothing);
        let each = all.len() / toothing.teeth as usize;
        assert_eq!(each * toothing.teeth as usize, all.len());
        assert!(each <= 2 * 20 + 4, "{toothing:?}: {each} pieces to a tooth");
        // Turned by one pitch.
        let pitch = TAU / f64::from(toothing.teeth);
        let (s, c) = libm::sincos(pitch);
        let size = toothing.module * f64::from(toothing.teeth);
        for (one, next) in all.iter().zip(all.iter().skip(each)) {
            let [x, y] = one.0;
            let turned = [x * c - y * s, x * s + y * c];
            assert!(radius([turned[0] - next.0[0], turned[1] - next.0[1]]) < 1e-13 * size);
        }
        // Mirrored about x: every corner has its image among the corners.
        for (p, ..) in &all {
            let best = all
                .iter()
                .map(|(q, ..)| radius([p[0] - q[0], p[1] + q[1]]))
                .fold(f64::MAX, f64::min);
            assert!(best < 1e-13 * size, "{toothing:?} {p:?}");
        }
    }
}

#[test]
fn tip_root_and_thickness() {
    // Module 2, 20 teeth: r = 20, tip 22, root 17.5; half the pitch angle at the pitch circle.
    let all = pieces(&PLAIN);
    let radii =
        |f: fn(f64, f64) -> f64, start: f64| all.iter().map(|(p, ..)| radius(*p)).fold(start, f);
    assert!((radii(f64::max, 0.0) - 22.0).abs() < 1e-12);
    assert!((radii(f64::min, 99.0) - 17.5).abs() < 1e-12);
    // A tooth on +x.
    assert!(all.iter().any(|(_, via, _)| *via == Some([22.0, 0.0])));
    // A gap on +x of the hole in a ring.
    let ring = Toothing {
        internal: true,
        teeth: 60,
        ..PLAIN
    };
    let inner = pieces(&ring)
        .iter()
        .filter_map(|(_, via, _)| *via)
        .find(|via| via[1].abs() < 1e-12 && via[0] > 0.0)
        .unwrap();
    assert!((inner[0] - 58.0).abs() < 1e-12, "{inner:?}");
}

#[test]
fn what_cannot_be_is_refused() {
    for toothing in [
        Toothing {
            profile_shift: 2.0,
            ..PLAIN
        },
        Toothing {
            pressure_angle_deg: 45.0,
            ..PLAIN
        },
        Toothing {
            thinning: 3.0,
            ..PLAIN
        },
        Toothing { teeth: 2, ..PLAIN },
        Toothing {
            internal: true,
            ..PLAIN
        },
        Toothing {
            internal: true,
            teeth: 60,
            thinning: 10.0,
            ..PLAIN
        },
    ] {
        assert!(toothing.outline().is_err(), "{toothing:?}");
    }
}
