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
pub(super) struct Body {
    points: Vec<Vector3<f64>>,
    triangles: Vec<[usize; 3]>,
    /// How far the triangles may be off the surface, in mm.
    pub(super) deflection_mm: f64,
}

impl Body {
    pub(super) fn new(mesh: &Mesh, at: &Placement, deflection_mm: f64) -> Self {
        let world = |p: &[f64; 3]| Vector3::from(at.point(*p));
        Self {
            points: mesh.positions.iter().map(world).collect(),
            triangles: mesh
                .triangles
                .iter()
                .map(|t| t.map(|n| n as usize))
                .collect(),
            deflection_mm,
        }
    }

    /// The corners of the triangles.
    fn corners(&self) -> impl Iterator<Item = [Vector3<f64>; 3]> {
        self.triangles.iter().filter_map(|[a, b, c]| {
            let at = |n: &usize| self.points.get(*n).copied();
            Some([at(a)?, at(b)?, at(c)?])
        })
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
        let mut out: Vec<Crossing> = Vec::new();
        for [a, b, c] in self.corners() {
            // Moeller and Trumbore: the ray in the triangle's own coordinates.
            let (ab, ac) = (b - a, c - a);
            let p = along.cross(&ac);
            let det = ab.dot(&p);
            if det.abs() < f64::EPSILON {
                continue;
            }
            let t = origin - a;
            let u = t.dot(&p) / det;
            let q = t.cross(&ab);
            let v = along.dot(&q) / det;
            let at = ac.dot(&q) / det;
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && at > 0.0 {
                out.push(Crossing {
                    at,
                    enters: det > 0.0,
                });
            }
        }
        out.sort_by(|x, y| x.at.total_cmp(&y.at));
        out
    }

    pub(super) fn seen(&self, view: &View) -> Seen {
        let flat = |p: &Vector3<f64>| Vector3::new(p.dot(&view.u), p.dot(&view.v), p.dot(&view.d));
        let points: Vec<Vector3<f64>> = self.points.iter().map(flat).collect();
        let start = (
            Vector3::repeat(f64::INFINITY),
            Vector3::repeat(f64::NEG_INFINITY),
        );
        let (low, high) = points
            .iter()
            .fold(start, |(low, high), p| (low.inf(p), high.sup(p)));
        Seen {
            triangles: self.triangles.clone(),
            points,
            low,
            high,
            deflection_mm: self.deflection_mm,
        }
    }
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
    points: Vec<Vector3<f64>>,
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
        for [a, b, c] in &self.triangles {
            let at = |n: &usize| self.points.get(*n);
            let (Some(a), Some(b), Some(c)) = (at(a), at(b), at(c)) else {
                continue;
            };
            let (low, high) = (a.inf(b).inf(c), a.sup(b).sup(c));
            let (i0, i1) = grid.between(low.x, high.x, left, w, x);
            let (j0, j1) = grid.between(low.y, high.y, bottom, h, y);
            if i0 >= i1 || j0 >= j1 {
                continue;
            }
            // Twice the area as it is seen: positive where the surface looks along the view.
            let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
            if area.abs() < f64::EPSILON {
                continue;
            }
            for j in j0..j1 {
                for i in i0..i1 {
                    let ray = j * grid.side + i;
                    let [px, py] = grid.point(ray);
                    let s = ((b.x - px) * (c.y - py) - (c.x - px) * (b.y - py)) / area;
                    let t = ((c.x - px) * (a.y - py) - (a.x - px) * (c.y - py)) / area;
                    let r = 1.0 - s - t;
                    if s < 0.0 || t < 0.0 || r < 0.0 {
                        continue;
                    }
                    if let Some(ray) = out.get_mut(ray) {
                        ray.push(Crossing {
                            at: s * a.z + t * b.z + r * c.z,
                            enters: area < 0.0,
                        });
                    }
                }
            }
        }
        out
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::{Body, Grid, View};
    use assemcad_kernel::mesh::Mesh;
    use assemcad_model::frame::Placement;
    use nalgebra::Vector3;

    /// The twelve triangles of a box, counter-clockwise from outside.
    pub(crate) fn block(low: [f64; 3], high: [f64; 3]) -> Body {
        Body::new(&block_mesh(low, high), &Placement::IDENTITY, 0.001)
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
            normals: Vec::new(),
            triangles,
        }
    }

    #[test]
    fn a_ray_goes_into_a_block_and_out_of_it() {
        let body = block([1.0, -1.0, -1.0], [3.0, 1.0, 1.0]);
        let along = Vector3::x();
        let found = body.crossings(&Vector3::new(0.0, 0.1, 0.2), &along);
        let told: Vec<(f64, bool)> = found.iter().map(|c| (c.at, c.enters)).collect();
        assert_eq!(told, [(1.0, true), (3.0, false)]);
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
