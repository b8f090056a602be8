//! What is in whose way: pairs of placed solids, looked at along an axis.
//!
//! A solid that moves straight along a direction, all the way, meets another one if and only if some ray along
//! the direction leaves the other's material beyond where it first meets this one's. So the two outermost
//! crossings of each ray with either solid tell both ways of both solids. The rays are samples: what is
//! narrower than their distance may be missed.

use nalgebra::Vector3;

use super::rays::{Crossing, Facets, Grid, Seen, View};

/// Rays along either side of the rectangle in which both solids are seen.
pub(super) const SIDE: usize = 40;

/// How thick an overlap must be before it counts, in deflections of the triangles: chords of two circles of
/// one radius cut into each other by up to one each.
const THICK: f64 = 2.5;

/// Where two solids may pass through each other along an axis: threads, press fits and the teeth of helical
/// gears. About one axis a ring, about two the places that lie in both rings.
#[derive(Debug, Clone)]
pub(super) struct Passage {
    pub(super) rings: Vec<Ring>,
}

/// A ring about an axis.
#[derive(Debug, Clone)]
pub(super) struct Ring {
    pub(super) point: Vector3<f64>,
    pub(super) axis: Vector3<f64>,
    pub(super) inner_mm: f64,
    pub(super) outer_mm: f64,
}

/// How far two solids can go along the axis, in mm: none where they can go all the way.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Stopped {
    /// The first by the second.
    pub(super) first: Option<f64>,
    /// The second by the first.
    pub(super) second: Option<f64>,
}

impl Stopped {
    /// The same, seen the other way along the axis: who stops whom turns round.
    pub(super) fn turned(self) -> Self {
        Self {
            first: self.second,
            second: self.first,
        }
    }
}

/// Looks at two solids along a view.
pub(super) fn look(view: &View, a: &Seen, b: &Seen, passages: &[Passage]) -> Stopped {
    let thick = THICK * a.deflection_mm.max(b.deflection_mm);
    let (low, high) = (a.low.sup(&b.low), a.high.inf(&b.high));
    // Side by side, or touching along a line.
    if high.x - low.x <= 2.0 * thick || high.y - low.y <= 2.0 * thick {
        return Stopped::default();
    }
    let grid = Grid::over([low.x, low.y], [high.x, high.y], SIDE);
    // What is wholly behind stops nobody.
    let (ahead, behind) = (b.high.z > a.low.z + thick, a.high.z > b.low.z + thick);
    let mut cells = open_cells(view, &grid, passages, thick);
    let mut out: Vec<(usize, Stopped)> = Vec::new();
    let shifts = [
        [0.0, 0.0],
        [thick, 0.0],
        [-thick, 0.0],
        [0.0, thick],
        [0.0, -thick],
    ];
    for (n, shift) in shifts.into_iter().enumerate() {
        if cells.is_empty() {
            return Stopped::default();
        }
        let grid = grid.shifted(shift);
        let (in_a, in_b) = (a.crossings(&grid), b.crossings(&grid));
        let at = |cell: usize| {
            let (a, b) = (in_a.get(cell)?, in_b.get(cell)?);
            let found = Stopped {
                first: play(a, b, thick).filter(|_| ahead),
                second: play(b, a, thick).filter(|_| behind),
            };
            (found != Stopped::default()).then_some((cell, found))
        };
        if n == 0 {
            out = cells.iter().filter_map(|c| at(*c)).collect();
        } else {
            // A stop has to be there at every one of the shifted rays: thinner ones are the triangles' own.
            out = out
                .into_iter()
                .filter_map(|(cell, known)| {
                    let (_, here) = at(cell)?;
                    let both = Stopped {
                        first: longer(known.first, here.first),
                        second: longer(known.second, here.second),
                    };
                    (both != Stopped::default()).then_some((cell, both))
                })
                .collect();
        }
        cells = out.iter().map(|(cell, _)| *cell).collect();
    }
    let least = |of: fn(&Stopped) -> Option<f64>| {
        let all = out.iter().filter_map(|(_, s)| of(s));
        all.fold(None, |least: Option<f64>, p| {
            Some(least.map_or(p, |l| l.min(p)))
        })
    };
    Stopped {
        first: least(|s| s.first),
        second: least(|s| s.second),
    }
}

fn longer(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    Some(a?.max(b?))
}

/// The cells in which the two solids may not pass through each other.
fn open_cells(view: &View, grid: &Grid, passages: &[Passage], thick: f64) -> Vec<usize> {
    let along = |r: &Ring| r.axis.cross(&view.d).norm() <= 1e-6;
    let flat: Vec<Vec<(f64, f64, f64, f64)>> = passages
        .iter()
        .filter(|p| p.rings.iter().all(along))
        .map(|p| {
            let ring = |r: &Ring| {
                let (inner, outer) = (r.inner_mm - 2.0 * thick, r.outer_mm + 2.0 * thick);
                (r.point.dot(&view.u), r.point.dot(&view.v), inner, outer)
            };
            p.rings.iter().map(ring).collect()
        })
        .collect();
    let passes = |cell: &usize| {
        let [x, y] = grid.point(*cell);
        let within = |(u, v, inner, outer): &(f64, f64, f64, f64)| {
            let r = libm::hypot(x - u, y - v);
            r >= *inner && r <= *outer
        };
        flat.iter().any(|rings| rings.iter().all(within))
    };
    (0..grid.count()).filter(|c| !passes(c)).collect()
}

/// How far the solid of the first crossings can go along a ray before it meets the other one; none where it
/// can go all the way.
fn play(own: &[Crossing], other: &[Crossing], thick: f64) -> Option<f64> {
    let first = own.iter().map(|c| c.at).fold(f64::INFINITY, f64::min);
    let last = other.iter().map(|c| c.at).fold(f64::NEG_INFINITY, f64::max);
    // Written so that a ray that meets only one of them is free.
    if own.is_empty() || other.is_empty() || last <= first + thick {
        return None;
    }
    let mut least = f64::INFINITY;
    for out in own.iter().filter(|c| !c.enters) {
        for into in other.iter().filter(|c| c.enters && c.at >= out.at - thick) {
            least = least.min((into.at - out.at).max(0.0));
        }
    }
    // One that is within the other has no play.
    Some(if least.is_finite() { least } else { 0.0 })
}

/// The bodies of an assembly, looked at along axes; what was seen once is kept.
pub(super) struct Looker<'a> {
    bodies: &'a [Option<Facets>],
    passages: &'a dyn Fn(usize, usize) -> Vec<Passage>,
    /// The views so far: axis, what the bodies look like, what was found for pairs.
    views: Vec<Sighting>,
    /// How many pairs may be looked at yet.
    left: usize,
}

struct Sighting {
    view: View,
    seen: Vec<Option<Seen>>,
    known: std::collections::BTreeMap<(usize, usize), Stopped>,
}

impl<'a> Looker<'a> {
    pub(super) fn new(
        bodies: &'a [Option<Facets>],
        passages: &'a dyn Fn(usize, usize) -> Vec<Passage>,
        most: usize,
    ) -> Self {
        Self {
            bodies,
            passages,
            views: Vec::new(),
            left: most,
        }
    }

    /// What stops two bodies along an axis, a unit vector; none where one of them is not known, or too many
    /// pairs were looked at.
    pub(super) fn pair(&mut self, axis: &Vector3<f64>, i: usize, j: usize) -> Option<Stopped> {
        let parallel = |s: &Sighting| s.view.d.cross(axis).norm() <= 1e-9;
        let at = match self.views.iter().position(parallel) {
            Some(at) => at,
            None => {
                let view = View::along(*axis);
                let seen = |b: &Option<Facets>| b.as_ref().map(|b| b.seen(&view));
                self.views.push(Sighting {
                    view,
                    seen: self.bodies.iter().map(seen).collect(),
                    known: std::collections::BTreeMap::new(),
                });
                self.views.len() - 1
            }
        };
        let sighting = self.views.get_mut(at)?;
        let same = sighting.view.d.dot(axis) > 0.0;
        let found = match sighting.known.get(&(i, j)) {
            Some(known) => *known,
            None => {
                let (a, b) = (
                    sighting.seen.get(i)?.as_ref()?,
                    sighting.seen.get(j)?.as_ref()?,
                );
                self.left = self.left.checked_sub(1)?;
                let found = look(&sighting.view, a, b, &(self.passages)(i, j));
                sighting.known.insert((i, j), found);
                found
            }
        };
        Some(if same { found } else { found.turned() })
    }
}

#[cfg(test)]
mod tests {
    use super::super::rays::View;
    use super::super::rays::tests::block;
    use super::{Passage, Ring, Stopped, look};
    use nalgebra::Vector3;

    fn along(
        d: Vector3<f64>,
        a: ([f64; 3], [f64; 3]),
        b: ([f64; 3], [f64; 3]),
        passages: &[Passage],
    ) -> Stopped {
        let view = View::along(d);
        let (a, b) = (block(a.0, a.1), block(b.0, b.1));
        look(&view, &a.seen(&view), &b.seen(&view), passages)
    }

    #[test]
    fn a_block_is_stopped_by_what_is_ahead_of_it() {
        let low = ([0.0; 3], [10.0; 3]);
        let high = ([4.0, 4.0, 13.0], [6.0, 6.0, 20.0]);
        let up = along(Vector3::z(), low, high, &[]);
        assert!((up.first.unwrap() - 3.0).abs() < 1e-9);
        assert_eq!(up.second, None);
        assert_eq!(along(-Vector3::z(), low, high, &[]), up.turned());
        // Across they are free of each other.
        assert_eq!(along(Vector3::x(), low, high, &[]), Stopped::default());
        // So they are where one stands beside the other, touching it.
        let beside = ([10.0, 0.0, 0.0], [20.0, 10.0, 10.0]);
        assert_eq!(along(Vector3::z(), low, beside, &[]), Stopped::default());
        let touching = along(Vector3::x(), low, beside, &[]);
        assert_eq!((touching.first, touching.second), (Some(0.0), None));
    }

    #[test]
    fn a_ring_lets_a_thread_pass_and_its_middle_does_not() {
        let low = ([0.0; 3], [10.0; 3]);
        let post = ([4.0, 4.0, 10.0], [6.0, 6.0, 20.0]);
        let ring = |inner_mm, outer_mm| Passage {
            rings: vec![Ring {
                point: Vector3::new(5.0, 5.0, 0.0),
                axis: -Vector3::z(),
                inner_mm,
                outer_mm,
            }],
        };
        assert_eq!(
            along(Vector3::z(), low, post, &[ring(0.0, 2.0)]),
            Stopped::default()
        );
        let found = along(Vector3::z(), low, post, &[ring(0.9, 2.0)]);
        assert_eq!(found.first, Some(0.0));
        // Across the axis a thread lets nothing pass.
        let found = along(Vector3::x(), low, ([4.0; 3], [16.0; 3]), &[ring(0.0, 99.0)]);
        assert!(found.first.is_some() && found.second.is_some());
    }
}
