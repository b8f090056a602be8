//! What is in whose way: pairs of placed solids, looked at along an axis.
//!
//! A solid that moves straight along a direction, all the way, meets another one if and only if some ray along
//! the direction leaves the other's material beyond where it first meets this one's. So the two outermost
//! crossings of each ray with either solid tell both ways of both solids. The rays are samples: what is
//! narrower than their distance may be missed.

use nalgebra::Vector3;

use super::rays::{Crossing, Depth, Grid, Seen, View};

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

/// What two solids have in common across a view, where they may stop each other.
struct Common {
    grid: Grid,
    thick: f64,
    /// Whether the second one is ahead of the first in part, and the first of the second.
    ahead: bool,
    behind: bool,
}

impl Common {
    /// None where they are side by side, or touch along a line.
    fn new(a: &Seen, b: &Seen) -> Option<Self> {
        let thick = THICK * a.deflection_mm.max(b.deflection_mm);
        let (low, high) = (a.low.sup(&b.low), a.high.inf(&b.high));
        if high.x - low.x <= 2.0 * thick || high.y - low.y <= 2.0 * thick {
            return None;
        }
        Some(Self {
            grid: Grid::over([low.x, low.y], [high.x, high.y], SIDE),
            thick,
            // What is wholly behind stops nobody.
            ahead: b.high.z > a.low.z + thick,
            behind: a.high.z > b.low.z + thick,
        })
    }

    /// Where rays are shifted to: a stop has to be there at every one of them, since thinner ones are the
    /// triangles' own.
    fn shifts(&self) -> [[f64; 2]; 5] {
        let thick = self.thick;
        [
            [0.0, 0.0],
            [thick, 0.0],
            [-thick, 0.0],
            [0.0, thick],
            [0.0, -thick],
        ]
    }

    /// Who stops whom on a ray.
    fn stops(&self, a: &Depth, b: &Depth) -> Stops {
        Stops {
            first: self.ahead && b.last > a.first + self.thick,
            second: self.behind && a.last > b.first + self.thick,
        }
    }

    /// The same on a ray and on all that are beside it.
    fn stops_at(&self, a: &Seen, b: &Seen, cell: usize, wanted: Stops) -> Stops {
        let mut out = wanted;
        for shift in self.shifts() {
            if out == Stops::default() {
                break;
            }
            let at = self.grid.shifted(shift).point(cell);
            let one = a.depth(at);
            // A ray that meets only one of them is free.
            out = if one.is_none() {
                Stops::default()
            } else {
                out.and(self.stops(&one, &b.depth(at)))
            };
        }
        out
    }
}

/// Who of two solids stops whom along the axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Stops {
    /// The first cannot go all the way, because of the second.
    pub(super) first: bool,
    /// The second cannot.
    pub(super) second: bool,
}

impl Stops {
    fn and(self, other: Self) -> Self {
        Self {
            first: self.first && other.first,
            second: self.second && other.second,
        }
    }

    fn without(self, other: Self) -> Self {
        Self {
            first: self.first && !other.first,
            second: self.second && !other.second,
        }
    }

    fn or(self, other: Self) -> Self {
        Self {
            first: self.first || other.first,
            second: self.second || other.second,
        }
    }

    /// The same, seen the other way along the axis.
    pub(super) fn turned(self) -> Self {
        Self {
            first: self.second,
            second: self.first,
        }
    }
}

/// Every so many rays along either side are tried alone before all of them are: what stands on something is mostly
/// stopped there.
const APART: usize = 10;

/// Who of two solids stops whom along a view: as [`look`] finds it, without how far they can go. And how much
/// work it was.
pub(super) fn whether(view: &View, a: &Seen, b: &Seen, passages: &[Passage]) -> (Stops, usize) {
    let Some(common) = Common::new(a, b) else {
        return (Stops::default(), 1);
    };
    let wanted = Stops {
        first: common.ahead,
        second: common.behind,
    };
    let cells = open_cells(view, &common.grid, passages, common.thick);
    let mut found = Stops::default();
    let mut work = 1;
    let half = APART / 2;
    let few = |c: &&usize| *c % SIDE % APART == half && *c / SIDE % APART == half;
    for cell in cells.iter().filter(few) {
        let left = wanted.without(found);
        if left == Stops::default() {
            return (found, work);
        }
        found = found.or(common.stops_at(a, b, *cell, left));
        work += 20;
    }
    if wanted.without(found) == Stops::default() || cells.is_empty() {
        return (found, work);
    }
    let ((in_a, one), (in_b, other)) = (a.depths(&common.grid), b.depths(&common.grid));
    work += one + other + common.grid.count();
    for cell in cells {
        let left = wanted.without(found);
        if left == Stops::default() {
            break;
        }
        if let (Some(one), Some(other)) = (in_a.get(cell), in_b.get(cell)) {
            let here = left.and(common.stops(one, other));
            if here != Stops::default() {
                found = found.or(common.stops_at(a, b, cell, here));
                work += 20;
            }
        }
    }
    (found, work)
}

/// Looks at two solids along a view.
pub(super) fn look(view: &View, a: &Seen, b: &Seen, passages: &[Passage]) -> Stopped {
    let Some(common) = Common::new(a, b) else {
        return Stopped::default();
    };
    let (thick, ahead, behind) = (common.thick, common.ahead, common.behind);
    let mut cells = open_cells(view, &common.grid, passages, thick);
    let mut out: Vec<(usize, Stopped)> = Vec::new();
    for (n, shift) in common.shifts().into_iter().enumerate() {
        if cells.is_empty() {
            return Stopped::default();
        }
        let grid = common.grid.shifted(shift);
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

#[cfg(test)]
mod tests {
    use super::super::rays::View;
    use super::super::rays::tests::block;
    use super::{Passage, Ring, Stopped, Stops, look, whether};
    use nalgebra::Vector3;
    use proptest::prelude::*;

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

    fn some_block() -> impl Strategy<Value = ([f64; 3], [f64; 3])> {
        let low = prop::array::uniform3(-5.0..5.0f64);
        let size = prop::array::uniform3(0.1..8.0f64);
        (low, size).prop_map(|(l, s)| (l, core::array::from_fn(|k| l[k] + s[k])))
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// Whether one stops the other is what measuring it finds, in rings that let pass too.
        #[test]
        fn to_ask_whether_is_to_ask_how_far(
            a in some_block(),
            b in some_block(),
            d in prop::array::uniform3(-1.0..1.0f64),
            outer_mm in 0.0..6.0f64,
        ) {
            let d = Vector3::from(d);
            prop_assume!(d.norm() > 0.1);
            let view = View::along(d.normalize());
            let (a, b) = (block(a.0, a.1).seen(&view), block(b.0, b.1).seen(&view));
            let ring = Ring { point: Vector3::zeros(), axis: view.d, inner_mm: 1.0, outer_mm };
            for passages in [Vec::new(), vec![Passage { rings: vec![ring] }]] {
                let far = look(&view, &a, &b, &passages);
                let wanted = Stops { first: far.first.is_some(), second: far.second.is_some() };
                prop_assert_eq!(whether(&view, &a, &b, &passages).0, wanted);
            }
        }
    }
}
