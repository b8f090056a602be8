//! Union, difference and intersection, judged by what they must do to volume and points.
//!
//! The kernel's booleans fail in silence: a union that forgets one operand, a cut that cuts nothing.
//! Two things know nothing of them: the volumes of the operands, and points that are in the material
//! or out of it.

use crate::brep::Topology;
use crate::error::{KernelError, Result};
use crate::pair;
use crate::query::{Bounds, Side};
use crate::shape::Shape;

/// How far, relatively, volumes may differ that must be equal.
const EQUAL: f64 = 1e-9;

/// The same for the sum of two volumes: two bodies that touch along a curved, approximated edge add
/// up only as well as that edge is known.
const SUM: f64 = 1e-6;

/// How many points vouch for a result.
const POINTS: u32 = 64;

/// Points nearer to a surface than this, in mm, vouch for nothing.
const NEAR: f64 = 1e-4;

/// Shares of the region's size by which a point is moved when it is in doubt.
const NUDGES: [[f64; 3]; 4] = [
    [1.3e-3, 2.1e-3, 3.4e-3],
    [-2.3e-3, 1.7e-3, -1.1e-3],
    [3.1e-3, -1.9e-3, -2.7e-3],
    [-1.7e-3, -2.9e-3, 2.2e-3],
];

/// The three booleans.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Union.
    Fuse,
    /// Difference.
    Cut,
    /// Intersection.
    Common,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Fuse => "union",
            Self::Cut => "cut",
            Self::Common => "common part",
        }
    }

    fn holds(self, in_a: bool, in_b: bool) -> bool {
        match self {
            Self::Fuse => in_a || in_b,
            Self::Cut => in_a && !in_b,
            Self::Common => in_a && in_b,
        }
    }
}

/// Holds a result against its operands.
///
/// # Errors
/// When the result cannot be right, or a cut removes nothing.
pub(crate) fn judge(kind: Kind, a: &Shape, b: &Shape, result: &Shape) -> Result<()> {
    let (a, b, result) = (Pile::of(a)?, Pile::of(b)?, Pile::of(result)?);
    plausible(kind, &a, &b, &result)?;
    match a.bounds.common(&b.bounds) {
        // Where the boxes share something thinner, every point is too near to a surface.
        Some(region) if region.size().iter().all(|s| *s > 2.0 * NEAR) => {
            vouched(kind, &region, &a, &b, &result)
        }
        _ => Ok(()),
    }
}

/// Solids that may overlap.
struct Pile {
    solids: Vec<(Shape, Bounds)>,
    /// Of them all, overlaps counted more than once.
    volume: f64,
    /// Of the largest one.
    largest: f64,
    bounds: Bounds,
}

impl Pile {
    fn of(shape: &Shape) -> Result<Self> {
        let mut pile = Self {
            solids: Vec::new(),
            volume: 0.0,
            largest: 0.0,
            bounds: Bounds::default(),
        };
        for solid in shape.parts(Topology::Solid)? {
            let (volume, bounds) = (solid.mass()?.volume, solid.bounds()?);
            pile.volume += volume;
            pile.largest = pile.largest.max(volume);
            pile.bounds = if pile.solids.is_empty() {
                bounds
            } else {
                pile.bounds.union(&bounds)
            };
            pile.solids.push((solid, bounds));
        }
        Ok(pile)
    }

    /// Whether points are in the material; none where one is too near to a surface.
    ///
    /// All points of a solid are asked for at once: readying the solid costs more than most answers.
    fn holds(&self, points: &[[f64; 3]]) -> Result<Vec<Option<bool>>> {
        let mut found = vec![Some(false); points.len()];
        for (solid, bounds) in &self.solids {
            let beyond =
                |(p, (low, high)): (&f64, (&f64, &f64))| *p < low - NEAR || *p > high + NEAR;
            let near = |point: &[f64; 3]| {
                !point
                    .iter()
                    .zip(bounds.min.iter().zip(&bounds.max))
                    .any(beyond)
            };
            // A point in one of the solids is in the material, whatever the others are.
            let mut open: Vec<(&[f64; 3], &mut Option<bool>)> = points
                .iter()
                .zip(&mut found)
                .filter(|(point, held)| **held != Some(true) && near(point))
                .collect();
            let asked: Vec<[f64; 3]> = open.iter().map(|(point, _)| **point).collect();
            if asked.is_empty() {
                continue;
            }
            for ((_, held), side) in open.iter_mut().zip(solid.classify(&asked, NEAR)?) {
                match side {
                    Side::Inside => **held = Some(true),
                    Side::Boundary => **held = None,
                    Side::Outside => {}
                }
            }
        }
        Ok(found)
    }
}

fn plausible(kind: Kind, a: &Pile, b: &Pile, result: &Pile) -> Result<()> {
    let volume = result.volume;
    let wrong = |rule: &str| {
        Err(KernelError::invalid(format!(
            "the {} of solids of {:.6} and {:.6} mm3 came out with {volume:.6} mm3, {rule}",
            kind.name(),
            a.volume,
            b.volume
        )))
    };
    // What the operands share lies in what their boxes share. Of solids that may overlap each other the sum
    // of volumes is no more than a bound.
    let shared = a.bounds.common(&b.bounds).map_or(0.0, |r| r.volume());
    let single = a.solids.len() == 1;
    let most = if single {
        b.volume.min(shared)
    } else {
        b.volume
    };
    let sum = a.volume + b.volume;
    match kind {
        Kind::Fuse if volume < a.largest.max(b.largest) * (1.0 - EQUAL) => {
            wrong("which is less than the larger one")
        }
        Kind::Fuse if volume > sum * (1.0 + SUM) => wrong("which is more than their sum"),
        Kind::Fuse if single && b.solids.len() == 1 && volume < sum * (1.0 - SUM) - shared => {
            wrong("which is less than their sum without all that they may share")
        }
        Kind::Cut if volume > a.volume * (1.0 + EQUAL) => wrong("which is more than before"),
        Kind::Cut if volume >= a.volume * (1.0 - EQUAL) && a.solids.len() == 1 => {
            // Boxes that meet say nothing of a tool that lies in a hole, or where another cut was.
            let why = match a.bounds.common(&b.bounds) {
                Some(_) => "there is no material where the tool is",
                None => "the tool does not reach into the solid",
            };
            Err(KernelError::refused(format!(
                "the cut removes nothing: {why}; the solid spans {} mm, the tool {} mm",
                a.bounds, b.bounds
            )))
        }
        Kind::Cut if volume < a.volume - most - SUM * a.volume.max(b.volume) => {
            wrong("which is less than the tool can leave")
        }
        Kind::Common if volume > a.volume.min(b.volume) * (1.0 + EQUAL) => {
            wrong("which is more than the smaller one")
        }
        _ => Ok(()),
    }
}

/// Whether points should be in the result; none where one is too near to a surface. The second operand is
/// asked only where the first leaves it open.
fn expected(kind: Kind, a: &Pile, b: &Pile, points: &[[f64; 3]]) -> Result<Vec<Option<bool>>> {
    let settles = kind == Kind::Fuse;
    let mut told = a.holds(points)?;
    let open: Vec<[f64; 3]> = points
        .iter()
        .zip(&told)
        .filter(|(_, held)| **held == Some(!settles))
        .map(|(point, _)| *point)
        .collect();
    let mut others = b.holds(&open)?.into_iter();
    for held in &mut told {
        *held = match *held {
            Some(known) if known == settles => Some(kind.holds(known, false)),
            Some(known) => others
                .next()
                .flatten()
                .map(|other| kind.holds(known, other)),
            None => None,
        };
    }
    Ok(told)
}

/// That points are in the result exactly when they should be.
fn vouched(kind: Kind, region: &Bounds, a: &Pile, b: &Pile, result: &Pile) -> Result<()> {
    let agree = |points: &[[f64; 3]]| -> Result<Vec<Option<bool>>> {
        let told = expected(kind, a, b, points)?;
        let each = told.into_iter().zip(result.holds(points)?);
        Ok(each.map(|(told, found)| Some(told? == found?)).collect())
    };
    let points = pair::samples(region, POINTS);
    for (point, agrees) in points.iter().zip(agree(&points)?) {
        if agrees != Some(false) {
            continue;
        }
        // The classifier sends a ray, which an edge on its way may mislead: only where the
        // neighbours disagree too is it the boolean that is wrong.
        let near = NUDGES.map(|nudge| {
            let mut near = *point;
            for ((x, share), size) in near.iter_mut().zip(nudge).zip(region.size()) {
                *x += share * size;
            }
            near
        });
        let against = agree(&near)?.iter().filter(|a| **a == Some(false)).count();
        if against >= 3 {
            let [x, y, z] = point;
            return Err(KernelError::invalid(format!(
                "the {} of the two solids came out wrong about ({x:.3}, {y:.3}, {z:.3}): there is \
                 material where there should be none, or none where there should be some; let the \
                 solids overlap by more, or move their faces out of one plane",
                kind.name()
            )));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Kind, judge};
    use crate::error;
    use crate::shape::Shape;
    use assemcad_model::frame::Frame;

    fn cuboid(corner: [f64; 3], size: [f64; 3]) -> Shape {
        let frame = Frame {
            origin: corner,
            ..Frame::WORLD
        };
        Shape::cuboid(&frame, size).unwrap()
    }

    fn says(outcome: error::Result<()>, words: &str) {
        let told = outcome.unwrap_err().message;
        assert!(told.contains(words), "{told}");
    }

    #[test]
    fn right_results_pass() {
        let a = cuboid([0.0; 3], [10.0; 3]);
        let b = cuboid([5.0, 5.0, 5.0], [10.0; 3]);
        judge(Kind::Fuse, &a, &b, &a.fused(&[&b], false, None).unwrap()).unwrap();
        judge(Kind::Cut, &a, &b, &a.without(&[&b], None).unwrap()).unwrap();
        judge(Kind::Common, &a, &b, &a.shared(&[&b], None).unwrap()).unwrap();
        // Beside each other, with a face in common.
        let c = cuboid([10.0, 0.0, 0.0], [3.0, 10.0, 10.0]);
        judge(Kind::Fuse, &a, &c, &a.fused(&[&c], false, None).unwrap()).unwrap();
        // A thin overlap, of more than a part in a million.
        let d = cuboid([10.0 - 1e-4, 0.0, 0.0], [3.0, 10.0, 10.0]);
        judge(Kind::Fuse, &a, &d, &a.fused(&[&d], false, None).unwrap()).unwrap();
    }

    #[test]
    fn a_union_that_forgets_an_operand_is_found() {
        let a = cuboid([0.0; 3], [10.0; 3]);
        // Where the boxes overlap, points see nothing of it: there the first operand is whole.
        let over = cuboid([5.0, 5.0, 5.0], [8.0; 3]);
        says(judge(Kind::Fuse, &a, &over, &a), "all that they may share");
        let inside = cuboid([1.0; 3], [8.0; 3]);
        let cut = a.without(&[&inside], None).unwrap();
        says(
            judge(
                Kind::Fuse,
                &cut,
                &inside,
                &a.without(&[&cuboid([1.0; 3], [1.0, 8.0, 8.0])], None)
                    .unwrap(),
            ),
            "came out wrong about",
        );
        let beside = cuboid([10.0, 0.0, 0.0], [3.0, 10.0, 10.0]);
        says(
            judge(Kind::Fuse, &a, &beside, &a),
            "all that they may share",
        );
        let thin = cuboid([10.0 - 1e-4, 0.0, 0.0], [3.0, 10.0, 10.0]);
        says(judge(Kind::Fuse, &a, &thin, &a), "all that they may share");
    }

    #[test]
    fn results_in_the_wrong_place_are_found_where_volumes_are_right() {
        let a = cuboid([0.0; 3], [10.0; 3]);
        let b = cuboid([5.0, 5.0, 5.0], [10.0; 3]);
        // 125 mm3 taken away at the other corner, or kept there.
        let other = cuboid([0.0; 3], [5.0; 3]);
        let cut = a.without(&[&other], None).unwrap();
        says(judge(Kind::Cut, &a, &b, &cut), "came out wrong about");
        says(judge(Kind::Common, &a, &b, &other), "came out wrong about");
    }

    #[test]
    fn volumes_that_cannot_be_are_found() {
        let a = cuboid([0.0; 3], [10.0; 3]);
        let b = cuboid([5.0, 5.0, 5.0], [10.0; 3]);
        says(judge(Kind::Cut, &a, &b, &a), "removes nothing");
        let both = cuboid([0.0; 3], [20.0, 10.0, 11.0]);
        says(judge(Kind::Fuse, &a, &b, &both), "more than their sum");
        says(judge(Kind::Common, &a, &b, &both), "more than the smaller");
        // All gone, and the tool's box reaches only an eighth of it.
        let corner = cuboid([9.0; 3], [20.0; 3]);
        let left = cuboid([0.0; 3], [9.0, 9.0, 9.0]);
        says(judge(Kind::Cut, &a, &corner, &left), "the tool can leave");
    }
}
