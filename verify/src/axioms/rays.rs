//! Rays through the triangles of solids: where they go in and out.

use std::sync::Arc;

use assemcad_kernel::mesh::Mesh;
use assemcad_model::frame::Placement;
use nalgebra::Vector3;

use super::tree::{Box3, Tree};

/// A crossing of a ray with a solid's surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    /// How far along the ray, in mm.
    pub(super) at: f64,
    /// Whether the ray goes into the material there.
    pub(super) enters: bool,
}

/// The surface of a solid in its own frame, with boxes about its triangles: one for all parts of a recipe.
#[derive(Debug)]
pub(super) struct Facets {
    points: Vec<Vector3<f64>>,
    triangles: Vec<[usize; 3]>,
    tree: Tree,
    /// How far the triangles may be off the surface, in mm.
    deflection_mm: f64,
}

impl Facets {
    pub(super) fn new(mesh: &Mesh, deflection_mm: f64) -> Self {
        let points: Vec<Vector3<f64>> = mesh.positions.iter().map(|p| Vector3::from(*p)).collect();
        let triangles: Vec<[usize; 3]> = mesh
            .triangles
            .iter()
            .map(|t| t.map(|n| n as usize))
            .collect();
        let bounds = |t: &[usize; 3]| {
            let corners = t.iter().filter_map(|n| points.get(*n));
            corners.fold(Box3::NONE, |b, p| b.with([p.x, p.y, p.z]))
        };
        let boxes: Vec<Box3> = triangles.iter().map(bounds).collect();
        Self {
            tree: Tree::new(&boxes),
            points,
            triangles,
            deflection_mm,
        }
    }
}

/// The surface of a placed solid.
#[derive(Debug, Clone)]
pub(super) struct PlacedFacets {
    solid: Arc<Facets>,
    at: Placement,
    /// A ball around the solid: its middle and its radius in mm.
    centre: Vector3<f64>,
    radius: f64,
}

/// How much boxes are widened before a ray is taken to miss them, in mm: far above the rounding of placements.
const WIDER_MM: f64 = 1e-6;

impl PlacedFacets {
    pub(super) fn new(solid: &Arc<Facets>, at: &Placement) -> Self {
        let n = solid.points.len().max(1) as f64;
        let middle = solid.points.iter().sum::<Vector3<f64>>() / n;
        let far = |p: &Vector3<f64>| (p - middle).norm();
        Self {
            centre: Vector3::from(at.point(middle.into())),
            radius: solid.points.iter().map(far).fold(0.0, f64::max),
            solid: Arc::clone(solid),
            at: *at,
        }
    }

    fn world(&self, point: usize) -> Option<Vector3<f64>> {
        let p = self.solid.points.get(point)?;
        Some(Vector3::from(self.at.point((*p).into())))
    }

    /// The ball around the solid as a box.
    pub(super) fn ball(&self) -> Box3 {
        let (c, r) = (self.centre, self.radius + WIDER_MM);
        let corner = |by: f64| [c.x + by, c.y + by, c.z + by];
        Box3::NONE.with(corner(-r)).with(corner(r))
    }

    /// Whether the solid is farther than this from a line, judged by the ball around it.
    pub(super) fn beside(&self, point: &Vector3<f64>, along: &Vector3<f64>, mm: f64) -> bool {
        (self.centre - point).cross(along).norm() > self.radius + mm
    }

    /// How far the solid reaches along a direction, from a point.
    pub(super) fn reach(&self, from: &Vector3<f64>, along: &Vector3<f64>) -> f64 {
        let back = self.at.inverse();
        let local = back.direction((*along).into());
        let start = back.point((*from).into());
        let ahead = |b: &Box3| b.ahead(&start, &local) + WIDER_MM;
        self.solid.tree.greatest(ahead, |triangle| {
            let corners = self.solid.triangles.get(triangle).into_iter().flatten();
            let points = corners.filter_map(|n| self.world(*n));
            points
                .map(|p| (p - from).dot(along))
                .fold(f64::NEG_INFINITY, f64::max)
        })
    }

    /// Where a ray crosses the surface, ahead of its origin, in order. The direction is a unit vector.
    pub(super) fn crossings(&self, origin: &Vector3<f64>, along: &Vector3<f64>) -> Vec<Crossing> {
        // A view with the ray as its axis: it crosses what lies about the origin there.
        let view = View::along(*along);
        let back = self.at.inverse();
        let (from, way) = (
            back.point((*origin).into()),
            back.direction((*along).into()),
        );
        let mut out: Vec<Crossing> = Vec::new();
        let meets = |b: &Box3| b.meets_ray(&from, &way, WIDER_MM);
        self.solid.tree.visit(meets, |triangle| {
            let Some([a, b, c]) = self.solid.triangles.get(triangle) else {
                return;
            };
            let flat = |n: &usize| {
                let arm = self.world(*n)? - origin;
                Some([arm.dot(&view.u), arm.dot(&view.v), arm.dot(&view.d)])
            };
            if let (Some(a), Some(b), Some(c)) = (flat(a), flat(b), flat(c)) {
                out.extend(crossing([a, b, c], [0.0, 0.0]).filter(|c| c.at > 0.0));
            }
        });
        out.sort_by(|x, y| x.at.total_cmp(&y.at));
        out
    }

    pub(super) fn seen(&self, view: &View) -> Seen {
        let world = |p: &Vector3<f64>| Vector3::from(self.at.point((*p).into()));
        let flat = |p: Vector3<f64>| [p.dot(&view.u), p.dot(&view.v), p.dot(&view.d)];
        let points: Vec<[f64; 3]> = self.solid.points.iter().map(|p| flat(world(p))).collect();
        let bounds = points.iter().fold(Box3::NONE, |b, p| b.with(*p));
        // From the solid's own frame to the view: across it only, for boxes.
        let turn = self.at.rotation().transpose();
        let origin = self.at.origin();
        let across = [view.u, view.v].map(|a| ((turn * a).into(), origin.dot(&a)));
        Seen {
            solid: Arc::clone(&self.solid),
            across,
            points,
            low: bounds.low.into(),
            high: bounds.high.into(),
            deflection_mm: self.solid.deflection_mm,
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
    solid: Arc<Facets>,
    /// The two directions across the view in the solid's own frame, and where its origin is along them.
    across: [([f64; 3], f64); 2],
    points: Vec<[f64; 3]>,
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
    /// Calls for each triangle that may be over a rectangle across the view.
    fn over(&self, [low, high]: [[f64; 2]; 2], mut found: impl FnMut([[f64; 3]; 3])) {
        let [(u, x), (v, y)] = &self.across;
        let ([left, bottom], [right, top]) = (low, high);
        let meets = |b: &Box3| {
            let (a, c) = (b.span(u, *x), b.span(v, *y));
            a.0 <= right + WIDER_MM
                && a.1 >= left - WIDER_MM
                && c.0 <= top + WIDER_MM
                && c.1 >= bottom - WIDER_MM
        };
        self.solid.tree.visit(meets, |triangle| {
            let corners = self.solid.triangles.get(triangle);
            if let Some(corners) = corners.and_then(|t| corners_of(&self.points, t)) {
                found(corners);
            }
        });
    }

    /// Calls for each crossing of a ray of a grid with the surface, in no order. Says how much work it was.
    pub(super) fn each_crossing(
        &self,
        grid: &Grid,
        mut found: impl FnMut(usize, Crossing),
    ) -> usize {
        let ([left, bottom], [w, h], [x, y]) = (grid.low, grid.cell, IN_CELL);
        let n = grid.side as f64;
        let mut work = 0;
        let rectangle = [grid.low, [left + n * w, bottom + n * h]];
        self.over(rectangle, |[a, b, c]| {
            let [low_x, low_y, _] = each(each(a, b, f64::min), c, f64::min);
            let [high_x, high_y, _] = each(each(a, b, f64::max), c, f64::max);
            let (i0, i1) = grid.between(low_x, high_x, left, w, x);
            let (j0, j1) = grid.between(low_y, high_y, bottom, h, y);
            work += 1 + i1.saturating_sub(i0) * j1.saturating_sub(j0);
            for j in j0..j1 {
                for i in i0..i1 {
                    let ray = j * grid.side + i;
                    if let Some(crossing) = crossing([a, b, c], grid.point(ray)) {
                        found(ray, crossing);
                    }
                }
            }
        });
        work
    }

    /// The crossings of each ray of a grid with the surface, in no order.
    pub(super) fn crossings(&self, grid: &Grid) -> Vec<Vec<Crossing>> {
        let mut out = vec![Vec::new(); grid.count()];
        self.each_crossing(grid, |ray, crossing| {
            if let Some(ray) = out.get_mut(ray) {
                ray.push(crossing);
            }
        });
        out
    }

    /// Where each ray of a grid first meets the surface and where it leaves it; the other way round where it does
    /// not meet it.
    pub(super) fn depths(&self, grid: &Grid) -> (Vec<Depth>, usize) {
        let mut out = vec![Depth::NONE; grid.count()];
        let work = self.each_crossing(grid, |ray, crossing| {
            if let Some(ray) = out.get_mut(ray) {
                ray.note(crossing.at);
            }
        });
        (out, work)
    }

    /// The same for a single ray.
    pub(super) fn depth(&self, at: [f64; 2]) -> Depth {
        let mut out = Depth::NONE;
        self.over([at, at], |corners| {
            if let Some(crossing) = crossing(corners, at) {
                out.note(crossing.at);
            }
        });
        out
    }
}

/// Where a ray first meets a surface and where it leaves it last.
#[derive(Debug, Clone, Copy)]
pub(super) struct Depth {
    pub(super) first: f64,
    pub(super) last: f64,
}

impl Depth {
    const NONE: Self = Self {
        first: f64::INFINITY,
        last: f64::NEG_INFINITY,
    };

    /// Whether the ray does not meet the surface.
    pub(super) fn is_none(&self) -> bool {
        self.first > self.last
    }

    fn note(&mut self, at: f64) {
        self.first = self.first.min(at);
        self.last = self.last.max(at);
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::{Facets, Grid, PlacedFacets, View};
    use assemcad_kernel::mesh::Mesh;
    use assemcad_model::frame::Placement;
    use nalgebra::Vector3;
    use std::sync::Arc;

    /// The twelve triangles of a box, counter-clockwise from outside.
    pub(crate) fn block(low: [f64; 3], high: [f64; 3]) -> PlacedFacets {
        let solid = Arc::new(Facets::new(&block_mesh(low, high), 0.001));
        PlacedFacets::new(&solid, &Placement::IDENTITY)
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
