//! Rays through the triangles of solids: where they go in and out.

use assemcad_kernel::mesh::Mesh;
use assemcad_model::frame::Placement;
use nalgebra::Vector3;

/// A crossing of a ray with a solid's surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    /// How far along the ray, in mm.
    pub(super) at: f64,
    /// Whether the ray goes into the material there.
    pub(super) enters: bool,
}

/// The surface of a placed solid.
#[derive(Debug, Clone)]
pub(super) struct Facets {
    points: Vec<Vector3<f64>>,
    triangles: Vec<[usize; 3]>,
    /// A ball around the solid: its middle and its radius in mm.
    centre: Vector3<f64>,
    radius: f64,
    /// How far the triangles may be off the surface, in mm.
    pub(super) deflection_mm: f64,
}

impl Facets {
    pub(super) fn new(mesh: &Mesh, at: &Placement, deflection_mm: f64) -> Self {
        let world = |p: &[f64; 3]| Vector3::from(at.point(*p));
        let points: Vec<Vector3<f64>> = mesh.positions.iter().map(world).collect();
        let centre = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
        let far = |p: &Vector3<f64>| (p - centre).norm();
        Self {
            centre,
            radius: points.iter().map(far).fold(0.0, f64::max),
            points,
            triangles: mesh
                .triangles
                .iter()
                .map(|t| t.map(|n| n as usize))
                .collect(),
            deflection_mm,
        }
    }

    /// Whether the solid is farther than this from a line, judged by the ball around it.
    pub(super) fn beside(&self, point: &Vector3<f64>, along: &Vector3<f64>, mm: f64) -> bool {
        (self.centre - point).cross(along).norm() > self.radius + mm
    }

    /// How far the solid reaches along a direction, from a point.
    pub(super) fn reach(&self, from: &Vector3<f64>, along: &Vector3<f64>) -> f64 {
        let reach = |p: &Vector3<f64>| (p - from).dot(along);
        self.points
            .iter()
            .map(reach)
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// Where a ray crosses the surface, ahead of its origin, in order. The direction is a unit vector.
    pub(super) fn crossings(&self, origin: &Vector3<f64>, along: &Vector3<f64>) -> Vec<Crossing> {
        // A view with the ray as its axis: it crosses what lies about the origin there.
        let view = View::along(*along);
        let flat = |p: &Vector3<f64>| {
            let arm = p - origin;
            [arm.dot(&view.u), arm.dot(&view.v), arm.dot(&view.d)]
        };
        let points: Vec<[f64; 3]> = self.points.iter().map(flat).collect();
        let mut out: Vec<Crossing> = Vec::new();
        for corners in &self.triangles {
            let Some([a, b, c]) = corners_of(&points, corners) else {
                continue;
            };
            if let Some(crossing) = crossing([a, b, c], [0.0, 0.0]).filter(|c| c.at > 0.0) {
                out.push(crossing);
            }
        }
        out.sort_by(|x, y| x.at.total_cmp(&y.at));
        out
    }

    pub(super) fn seen(&self, view: &View) -> Seen {
        let flat = |p: &Vector3<f64>| [p.dot(&view.u), p.dot(&view.v), p.dot(&view.d)];
        let points: Vec<[f64; 3]> = self.points.iter().map(flat).collect();
        let start = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        let (low, high) = points.iter().fold(start, |(low, high), p| {
            (each(low, *p, f64::min), each(high, *p, f64::max))
        });
        Seen {
            triangles: self.triangles.clone(),
            points,
            low: low.into(),
            high: high.into(),
            deflection_mm: self.deflection_mm,
        }
    }
}

// Plain numbers from here on: this is where the time goes.

fn each([a, b, c]: [f64; 3], [d, e, f]: [f64; 3], of: fn(f64, f64) -> f64) -> [f64; 3] {
    [of(a, d), of(b, e), of(c, f)]
}

fn corners_of(points: &[[f64; 3]], [a, b, c]: &[usize; 3]) -> Option<[[f64; 3]; 3]> {
    Some([*points.get(*a)?, *points.get(*b)?, *points.get(*c)?])
}

/// Where a ray along the third axis, at a place across it, crosses a triangle.
fn crossing([a, b, c]: [[f64; 3]; 3], [px, py]: [f64; 2]) -> Option<Crossing> {
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a, b, c);
    // Twice the area as it is seen: positive where the surface looks along the ray.
    let area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if area.abs() < f64::EPSILON {
        return None;
    }
    let s = ((bx - px) * (cy - py) - (cx - px) * (by - py)) / area;
    let t = ((cx - px) * (ay - py) - (ax - px) * (cy - py)) / area;
    let r = 1.0 - s - t;
    (s >= 0.0 && t >= 0.0 && r >= 0.0).then_some(Crossing {
        at: s * az + t * bz + r * cz,
        enters: area < 0.0,
    })
}

/// A direction to look along, with two at right angles to it.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    pub(super) u: Vector3<f64>,
    pub(super) v: Vector3<f64>,
    pub(super) d: Vector3<f64>,
}

impl View {
    /// Along a unit vector.
    pub(super) fn along(d: Vector3<f64>) -> Self {
        // The world's axis that is least along it.
        let other = match d.iamin() {
            0 => Vector3::x(),
            1 => Vector3::y(),
            _ => Vector3::z(),
        };
        let u = other.cross(&d).normalize();
        Self {
            u,
            v: d.cross(&u),
            d,
        }
    }
}

/// A body as it is seen along a view: x and y across it, z along it.
#[derive(Debug, Clone)]
pub(super) struct Seen {
    points: Vec<[f64; 3]>,
    triangles: Vec<[usize; 3]>,
    pub(super) low: Vector3<f64>,
    pub(super) high: Vector3<f64>,
    pub(super) deflection_mm: f64,
}

/// Parallel rays along the view: so many a side, in the cells of a rectangle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    low: [f64; 2],
    cell: [f64; 2],
    side: usize,
}

/// Where in its cell a ray is: off the middle, so that it meets no edge of what lies evenly about it.
const IN_CELL: [f64; 2] = [0.487_1, 0.513_7];

impl Grid {
    pub(super) fn over(low: [f64; 2], high: [f64; 2], side: usize) -> Self {
        let [a, b] = low;
        let [c, d] = high;
        let n = side as f64;
        Self {
            low,
            cell: [(c - a) / n, (d - b) / n],
            side,
        }
    }

    /// The same rays, shifted.
    pub(super) fn shifted(&self, by: [f64; 2]) -> Self {
        let ([a, b], [x, y]) = (self.low, by);
        Self {
            low: [a + x, b + y],
            ..*self
        }
    }

    pub(super) fn count(&self) -> usize {
        self.side * self.side
    }

    /// Where a ray is across the view.
    pub(super) fn point(&self, ray: usize) -> [f64; 2] {
        let ([a, b], [w, h], [x, y]) = (self.low, self.cell, IN_CELL);
        let (i, j) = ((ray % self.side) as f64, (ray / self.side) as f64);
        [a + (i + x) * w, b + (j + y) * h]
    }

    /// The cells along one side whose rays lie between two coordinates.
    fn between(&self, low: f64, high: f64, from: f64, cell: f64, within: f64) -> (usize, usize) {
        let index = |x: f64| (x - from) / cell - within;
        let most = self.side as f64;
        // As casts of clamped numbers these neither wrap nor fail.
        let first = index(low).ceil().clamp(0.0, most) as usize;
        let last = (index(high).floor() + 1.0).clamp(0.0, most) as usize;
        (first, last)
    }
}

impl Seen {
    /// The crossings of each ray of a grid with the surface, in no order.
    pub(super) fn crossings(&self, grid: &Grid) -> Vec<Vec<Crossing>> {
        let mut out = vec![Vec::new(); grid.count()];
        let ([left, bottom], [w, h], [x, y]) = (grid.low, grid.cell, IN_CELL);
        for corners in &self.triangles {
            let Some([a, b, c]) = corners_of(&self.points, corners) else {
                continue;
            };
            let [low_x, low_y, _] = each(each(a, b, f64::min), c, f64::min);
            let [high_x, high_y, _] = each(each(a, b, f64::max), c, f64::max);
            let (i0, i1) = grid.between(low_x, high_x, left, w, x);
            let (j0, j1) = grid.between(low_y, high_y, bottom, h, y);
            for j in j0..j1 {
                for i in i0..i1 {
                    let ray = j * grid.side + i;
                    let found = crossing([a, b, c], grid.point(ray));
                    if let (Some(ray), Some(crossing)) = (out.get_mut(ray), found) {
                        ray.push(crossing);
                    }
                }
            }
        }
        out
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::{Facets, Grid, View};
    use assemcad_kernel::mesh::Mesh;
    use assemcad_model::frame::Placement;
    use nalgebra::Vector3;

    /// The twelve triangles of a box, counter-clockwise from outside.
    pub(crate) fn block(low: [f64; 3], high: [f64; 3]) -> Facets {
        Facets::new(&block_mesh(low, high), &Placement::IDENTITY, 0.001)
    }

    pub(crate) fn block_mesh(low: [f64; 3], high: [f64; 3]) -> Mesh {
        let positions = (0..8)
            .map(|n| {
                let pick = |k: usize| if n >> k & 1 == 1 { high[k] } else { low[k] };
                [pick(0), pick(1), pick(2)]
            })
            .collect();
        let quads = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let triangles = quads
            .iter()
            .flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]])
            .collect();
        Mesh {
            positions,
            triangles,
            ..Mesh::default()
        }
    }

    #[test]
    fn a_ray_goes_into_a_block_and_out_of_it() {
        let body = block([1.0, -1.0, -1.0], [3.0, 1.0, 1.0]);
        let along = Vector3::x();
        let found = body.crossings(&Vector3::new(0.0, 0.1, 0.2), &along);
        assert_eq!(found.len(), 2);
        for (crossing, (at, enters)) in found.iter().zip([(1.0, true), (3.0, false)]) {
            assert!((crossing.at - at).abs() < 1e-12);
            assert_eq!(crossing.enters, enters);
        }
        // From within it only goes out; beside it there is nothing.
        let found = body.crossings(&Vector3::new(2.0, 0.1, 0.2), &along);
        assert_eq!((found.len(), found[0].enters), (1, false));
        assert!(
            body.crossings(&Vector3::new(0.0, 1.1, 0.2), &along)
                .is_empty()
        );
        assert_eq!(body.reach(&Vector3::zeros(), &-along), -1.0);
    }

    #[test]
    fn a_grid_of_rays_sees_what_single_rays_see() {
        let body = block([1.0, -1.0, -1.0], [3.0, 1.0, 2.0]);
        for d in [Vector3::x(), Vector3::z(), Vector3::new(0.6, 0.0, 0.8)] {
            let view = View::along(d);
            assert!((view.u.cross(&view.v) - d).norm() < 1e-15);
            let grid = Grid::over([-3.0, -3.0], [3.0, 3.0], 20);
            let rays = body.seen(&view).crossings(&grid);
            let mut hit = 0;
            for (n, mut ray) in rays.into_iter().enumerate() {
                let [x, y] = grid.point(n);
                let origin = view.u * x + view.v * y - d * 10.0;
                let single = body.crossings(&origin, &d);
                ray.sort_by(|a, b| a.at.total_cmp(&b.at));
                assert_eq!(ray.len(), single.len());
                hit += usize::from(!ray.is_empty());
                for (a, b) in ray.iter().zip(&single) {
                    assert!((a.at - (b.at - 10.0)).abs() < 1e-9 && a.enters == b.enters);
                }
            }
            assert!(hit > 10, "{hit}");
        }
    }
}
