//! What two triangulated sheets in one plane have in common, triangle by triangle.

use nalgebra::Vector2;

pub(super) type P = Vector2<f64>;

/// A triangle of a sheet and its box.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tri {
    corners: [P; 3],
    low: P,
    high: P,
}

impl Tri {
    /// Counter-clockwise, however it is given.
    pub(super) fn new([a, b, c]: [P; 3]) -> Self {
        let corners = if (b - a).perp(&(c - a)) >= 0.0 {
            [a, b, c]
        } else {
            [a, c, b]
        };
        Self {
            corners,
            low: a.inf(&b).inf(&c),
            high: a.sup(&b).sup(&c),
        }
    }

    pub(super) fn moved(&self, by: &P) -> Self {
        Self {
            corners: self.corners.map(|c| c + by),
            low: self.low + by,
            high: self.high + by,
        }
    }

    pub(super) fn middle(&self) -> P {
        let [a, b, c] = self.corners;
        (a + b + c) / 3.0
    }

    fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }

    /// The corners of what two triangles have in common (Sutherland and Hodgman 1974); none where that is less
    /// than a line.
    pub(super) fn common(&self, other: &Self) -> Vec<P> {
        if !self.meets(other) {
            return Vec::new();
        }
        let [a, b, c] = other.corners;
        let mut kept = self.corners.to_vec();
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let side = |p: &P| (to - from).perp(&(p - from));
            let ends = kept.iter().cycle().skip(1);
            let mut next = Vec::with_capacity(kept.len() + 1);
            for (p, q) in kept.iter().zip(ends) {
                let (at_p, at_q) = (side(p), side(q));
                if at_p >= 0.0 {
                    next.push(*p);
                }
                if (at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0) {
                    next.push(p + (q - p) * (at_p / (at_p - at_q)));
                }
            }
            kept = next;
            if kept.len() < 3 {
                return Vec::new();
            }
        }
        kept
    }
}

/// The area of a polygon.
pub(super) fn area(corners: &[P]) -> f64 {
    let Some(first) = corners.first() else {
        return 0.0;
    };
    let ends = corners.iter().skip(1);
    let pairs = corners.iter().zip(ends);
    pairs
        .map(|(p, q)| (p - first).perp(&(q - first)) / 2.0)
        .sum()
}

#[cfg(test)]
mod tests {
    use super::{P, Tri, area};

    fn tri(c: [[f64; 2]; 3]) -> Tri {
        Tri::new(c.map(|[x, y]| P::new(x, y)))
    }

    #[test]
    fn triangles_have_their_closed_forms_in_common() {
        let one = tri([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]);
        // Turned over, and moved by (1, 1): what is left is a triangle with legs of 2.
        let moved = one.moved(&P::new(1.0, 1.0));
        assert!((area(&one.common(&moved)) - 2.0).abs() < 1e-12);
        assert!((area(&moved.common(&one)) - 2.0).abs() < 1e-12);
        assert!((area(&one.common(&one)) - 8.0).abs() < 1e-12);
        // A hexagon of two large equilateral triangles, one turned over: two thirds of either.
        let h = 3.0_f64.sqrt() / 2.0;
        let up = tri([[-1.0, -h / 1.5], [1.0, -h / 1.5], [0.0, h * 4.0 / 3.0]]);
        let down = tri([[-1.0, h / 1.5], [1.0, h / 1.5], [0.0, -h * 4.0 / 3.0]]);
        assert!((area(&up.common(&down)) - 2.0 / 3.0 * 2.0 * h).abs() < 1e-12);
        assert!(one.common(&one.moved(&P::new(9.0, 0.0))).is_empty());
    }
}
