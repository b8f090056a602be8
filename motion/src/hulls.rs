//! The ring that a part sweeps about an axis at most: from its box.

use assemcad_kernel::protocol::Built;
use assemcad_model::frame::Placement;
use assemcad_model::freedom::Axis;
use assemcad_placing::solids::BOX_MARGIN_MM;
use nalgebra::{Vector2, Vector3};

/// Everything between two radii about an axis and between two heights along it, in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ring {
    radius: (f64, f64),
    height: (f64, f64),
}

impl Ring {
    /// The ring that a placed part's box sweeps in a whole turn.
    pub(crate) fn of(built: &Built, at: &Placement, axis: &Axis) -> Self {
        let (p, z) = (Vector3::from(axis.point), Vector3::from(axis.direction));
        let aside = if z.x.abs() < 0.9 {
            Vector3::x()
        } else {
            Vector3::y()
        };
        let x = (aside - z * z.dot(&aside)).normalize();
        let y = z.cross(&x);
        let mut flat = Vec::new();
        let mut height = (f64::INFINITY, f64::NEG_INFINITY);
        for cx in [built.min[0], built.max[0]] {
            for cy in [built.min[1], built.max[1]] {
                for cz in [built.min[2], built.max[2]] {
                    let corner = Vector3::from(at.point([cx, cy, cz])) - p;
                    let h = corner.dot(&z);
                    height = (height.0.min(h), height.1.max(h));
                    flat.push(Vector2::new(corner.dot(&x), corner.dot(&y)));
                }
            }
        }
        let most = flat.iter().map(|c| c.norm()).fold(0.0, f64::max);
        Self {
            radius: (nearest(&flat), most),
            height,
        }
    }

    /// Whether two rings about one axis are apart.
    pub(crate) fn apart(&self, other: &Self) -> bool {
        let gap =
            |a: (f64, f64), b: (f64, f64)| a.0 > b.1 + BOX_MARGIN_MM || b.0 > a.1 + BOX_MARGIN_MM;
        gap(self.radius, other.radius) || gap(self.height, other.height)
    }
}

/// How near the convex hull of some points comes to the origin: 0 where the origin is in it.
fn nearest(points: &[Vector2<f64>]) -> f64 {
    let mut angles: Vec<f64> = points.iter().map(|p| libm::atan2(p.y, p.x)).collect();
    angles.sort_by(f64::total_cmp);
    let turn = 2.0 * core::f64::consts::PI;
    let round = angles.first().map(|first| first + turn);
    let next = angles.iter().copied().skip(1).chain(round);
    let widest = angles
        .iter()
        .zip(next)
        .map(|(a, b)| b - a)
        .fold(0.0, f64::max);
    // All points on one side of a line through the origin, by more than rounding.
    if widest <= turn / 2.0 + 1e-9 {
        return 0.0;
    }
    let mut near = f64::INFINITY;
    for (i, a) in points.iter().enumerate() {
        for b in points.iter().skip(i) {
            let along = b - a;
            let square = along.norm_squared();
            let t = if square > 0.0 {
                (-a.dot(&along) / square).clamp(0.0, 1.0)
            } else {
                0.0
            };
            near = near.min((a + along * t).norm());
        }
    }
    near
}

#[cfg(test)]
mod tests {
    use super::{Axis, Placement, Ring};
    use assemcad_kernel::protocol::{Built, Source};

    fn cuboid(min: [f64; 3], max: [f64; 3]) -> Built {
        Built {
            recipe: String::new(),
            source: Source::Memory,
            volume: 1.0,
            area: 1.0,
            inertia: [[0.0; 3]; 3],
            centre: [0.0; 3],
            min,
            max,
            brep: String::new(),
            ports: Vec::new(),
        }
    }

    fn ring(min: [f64; 3], max: [f64; 3], at: &Placement) -> Ring {
        let axis = Axis {
            point: [0.0; 3],
            direction: [0.0, 0.0, 1.0],
        };
        Ring::of(&cuboid(min, max), at, &axis)
    }

    #[test]
    fn a_box_sweeps_from_its_nearest_edge_to_its_farthest_corner() {
        let near = |found: (f64, f64), wanted: (f64, f64)| {
            assert!(
                (found.0 - wanted.0).abs() < 1e-12 && (found.1 - wanted.1).abs() < 1e-12,
                "{found:?}"
            );
        };
        // Beside the axis: nearest in the middle of a side; farthest a corner.
        let r = ring([3.0, -4.0, 1.0], [5.0, 4.0, 2.0], &Placement::IDENTITY);
        near(r.radius, (3.0, libm::hypot(5.0, 4.0)));
        near(r.height, (1.0, 2.0));
        // A corner is nearest.
        near(
            ring([3.0, 4.0, 0.0], [6.0, 8.0, 1.0], &Placement::IDENTITY).radius,
            (5.0, 10.0),
        );
        // About the axis, or touching it: from 0.
        assert_eq!(
            ring([-1.0; 3], [1.0; 3], &Placement::IDENTITY).radius.0,
            0.0
        );
        assert_eq!(ring([0.0; 3], [1.0; 3], &Placement::IDENTITY).radius.0, 0.0);
        // Turned onto its side.
        let r = ring(
            [3.0, -4.0, 1.0],
            [5.0, 4.0, 2.0],
            &Placement::rotation_x(90.0),
        );
        near(r.height, (-4.0, 4.0));
    }

    #[test]
    fn rings_are_apart_by_radius_or_by_height() {
        let one = ring([-2.0, -2.0, 0.0], [2.0, 2.0, 5.0], &Placement::IDENTITY);
        let apart = |min, max| one.apart(&ring(min, max, &Placement::IDENTITY));
        assert!(apart([3.0, 0.0, 0.0], [9.0, 9.0, 5.0]));
        // The corners reach to 2.83.
        assert!(!apart([2.5, 0.0, 0.0], [9.0, 9.0, 5.0]));
        assert!(apart([-9.0, -9.0, 5.1], [9.0, 9.0, 6.0]));
        assert!(!apart([-9.0, -9.0, 5.0], [9.0, 9.0, 6.0]));
    }
}
