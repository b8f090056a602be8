//! Triangles: whether two are farther apart than a given distance, and which rays pass through one.

use super::patch::V;

/// Whether two triangles are for sure farther from each other than `gap` mm: a plane parts them by more.
pub(super) fn apart(a: &[V; 3], b: &[V; 3], gap: f64) -> bool {
    let parts = |axis: &V| -> bool {
        let length = axis.norm();
        if length <= 1e-12 {
            return false;
        }
        let over = |t: &[V; 3]| {
            let [p, q, r] = t.map(|v| v.dot(axis) / length);
            (p.min(q).min(r), p.max(q).max(r))
        };
        let ((a_low, a_high), (b_low, b_high)) = (over(a), over(b));
        b_low - a_high > gap || a_low - b_high > gap
    };
    let normal = |[p, q, r]: &[V; 3]| (q - p).cross(&(r - p));
    // The plane of one of them parts most; else the plane across the shortest way between the two.
    parts(&normal(a)) || parts(&normal(b)) || parts(&shortest(a, b))
}

/// The shortest way from one triangle to the other, where they do not cross.
fn shortest(a: &[V; 3], b: &[V; 3]) -> V {
    let mut best = (f64::INFINITY, V::zeros());
    let mut take = |way: V| {
        let length = way.norm_squared();
        if length < best.0 {
            best = (length, way);
        }
    };
    for (a0, a1) in sides(a) {
        for (b0, b1) in sides(b) {
            take(between_segments(&a0, &a1, &b0, &b1));
        }
    }
    for corner in b {
        take(corner - on_triangle(corner, a));
    }
    for corner in a {
        take(on_triangle(corner, b) - corner);
    }
    best.1
}

fn sides([p, q, r]: &[V; 3]) -> [(V, V); 3] {
    [(*p, *q), (*q, *r), (*r, *p)]
}

/// The shortest way from one segment to another (Ericson, *Real-Time Collision Detection*, 2005, 5.1.9).
pub(super) fn between_segments(a0: &V, a1: &V, b0: &V, b1: &V) -> V {
    let (d1, d2, r) = (a1 - a0, b1 - b0, a0 - b0);
    let (a, e, f) = (d1.norm_squared(), d2.norm_squared(), d2.dot(&r));
    let (s, t) = if a <= 1e-24 && e <= 1e-24 {
        (0.0, 0.0)
    } else if a <= 1e-24 {
        (0.0, (f / e).clamp(0.0, 1.0))
    } else {
        let c = d1.dot(&r);
        if e <= 1e-24 {
            ((-c / a).clamp(0.0, 1.0), 0.0)
        } else {
            let b = d1.dot(&d2);
            let denominator = a * e - b * b;
            let s = if denominator > 1e-12 * a * e {
                ((b * f - c * e) / denominator).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let t = (b * s + f) / e;
            if t < 0.0 {
                ((-c / a).clamp(0.0, 1.0), 0.0)
            } else if t > 1.0 {
                (((b - c) / a).clamp(0.0, 1.0), 1.0)
            } else {
                (s, t)
            }
        }
    };
    (b0 + d2 * t) - (a0 + d1 * s)
}

/// The point of a triangle that is nearest to a point (Ericson, 5.1.5).
pub(super) fn on_triangle(p: &V, [a, b, c]: &[V; 3]) -> V {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return *a;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return *b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return *c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && (d4 - d3) >= 0.0 && (d5 - d6) >= 0.0 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let scale = 1.0 / (va + vb + vc);
    a + ab * (vb * scale) + ac * (vc * scale)
}

/// How a ray meets a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Met {
    /// It passes by.
    Not,
    /// It passes through.
    Through,
    /// It comes so near to a side or runs so flat that it cannot be told.
    Unclear,
}

/// How a ray from a point meets a triangle (Moeller and Trumbore, 1997).
pub(super) fn met(from: &V, along: &V, [a, b, c]: &[V; 3]) -> Met {
    let (ab, ac) = (b - a, c - a);
    let p = along.cross(&ac);
    let det = ab.dot(&p);
    let arm = from - a;
    let size = ab.norm() * ac.norm();
    if det.abs() <= 1e-9 * size {
        // It runs along the plane: through it only where the plane is near.
        let normal = ab.cross(&ac);
        let near =
            normal.norm() <= 1e-12 * size || arm.dot(&normal).abs() <= 1e-9 * size * arm.norm();
        return if near { Met::Unclear } else { Met::Not };
    }
    let u = arm.dot(&p) / det;
    let q = arm.cross(&ab);
    let v = along.dot(&q) / det;
    let t = ac.dot(&q) / det;
    const EDGE: f64 = 1e-9;
    if u < -EDGE || v < -EDGE || u + v > 1.0 + EDGE || t < -EDGE {
        return Met::Not;
    }
    if u > EDGE && v > EDGE && u + v < 1.0 - EDGE && t > EDGE {
        return Met::Through;
    }
    Met::Unclear
}

#[cfg(test)]
mod tests {
    use super::{Met, V, apart, between_segments, met, on_triangle};
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = V> {
        (-5.0..5.0, -5.0..5.0, -5.0..5.0).prop_map(|(x, y, z)| V::new(x, y, z))
    }

    fn triangle() -> impl Strategy<Value = [V; 3]> {
        (point(), point(), point()).prop_map(|(a, b, c)| [a, b, c])
    }

    /// Distance by brute force: the nearest of many points of both.
    fn sampled(a: &[V; 3], b: &[V; 3]) -> f64 {
        let points = |[p, q, r]: &[V; 3]| -> Vec<V> {
            let mut all = Vec::new();
            for i in 0..=12 {
                for j in 0..=12 - i {
                    let (u, v) = (f64::from(i) / 12.0, f64::from(j) / 12.0);
                    all.push(p + (q - p) * u + (r - p) * v);
                }
            }
            all
        };
        let (one, two) = (points(a), points(b));
        let pairs = one
            .iter()
            .flat_map(|p| two.iter().map(move |q| (p - q).norm()));
        pairs.fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #[test]
        fn triangles_said_to_be_apart_have_no_points_that_near(a in triangle(), b in triangle(), gap in 0.0..6.0) {
            let least = sampled(&a, &b);
            if apart(&a, &b, gap) {
                prop_assert!(least > gap);
            } else {
                // The samples are at most one sixth of a side from the nearest points.
                prop_assert!(least <= gap + 5.0);
            }
        }

        #[test]
        fn the_nearest_point_of_a_triangle_is_no_farther_than_any_other(p in point(), t in triangle(), u in 0.0..1.0, v in 0.0..1.0) {
            let v = v * (1.0 - u);
            let other: V = t[0] + (t[1] - t[0]) * u + (t[2] - t[0]) * v;
            prop_assert!((p - on_triangle(&p, &t)).norm() <= (p - other).norm() + 1e-9);
        }

        #[test]
        fn the_shortest_way_between_segments_is_no_longer_than_any_other(a in point(), b in point(), c in point(), d in point(), s in 0.0..1.0, t in 0.0..1.0) {
            let other: V = (c + (d - c) * t) - (a + (b - a) * s);
            prop_assert!(between_segments(&a, &b, &c, &d).norm() <= other.norm() + 1e-9);
        }
    }

    #[test]
    fn parallel_triangles_one_above_the_other_are_apart_by_their_height() {
        let flat = |z: f64| {
            [
                V::new(0.0, 0.0, z),
                V::new(4.0, 0.0, z),
                V::new(0.0, 4.0, z),
            ]
        };
        assert!(apart(&flat(0.0), &flat(0.01), 0.0099));
        assert!(!apart(&flat(0.0), &flat(0.01), 0.0101));
    }

    #[test]
    fn rays_through_beside_and_at_the_side() {
        let t = [V::zeros(), V::new(4.0, 0.0, 0.0), V::new(0.0, 4.0, 0.0)];
        let down = V::new(0.0, 0.0, -1.0);
        assert_eq!(met(&V::new(1.0, 1.0, 3.0), &down, &t), Met::Through);
        assert_eq!(met(&V::new(3.0, 3.0, 3.0), &down, &t), Met::Not);
        assert_eq!(met(&V::new(1.0, 1.0, -3.0), &down, &t), Met::Not);
        assert_eq!(met(&V::new(1.0, 0.0, 3.0), &down, &t), Met::Unclear);
        assert_eq!(met(&V::new(-1.0, 1.0, 0.0), &V::x(), &t), Met::Unclear);
    }
}
