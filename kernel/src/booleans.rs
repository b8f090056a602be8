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
    vouched(kind, &a, &b, &result)
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
    match kind {
        Kind::Fuse if volume < a.largest.max(b.largest) * (1.0 - EQUAL) => {
            wrong("which is less than the larger one")
        }
        Kind::Fuse if volume > (a.volume + b.volume) * (1.0 + SUM) => {
            wrong("which is more than their sum")
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
        Kind::Cut if volume < (a.volume - b.volume) - SUM * a.volume.max(b.volume) => {
            wrong("which is less than the tool can leave")
        }
        Kind::Common if volume > a.volume.min(b.volume) * (1.0 + EQUAL) => {
            wrong("which is more than the smaller one")
        }
        _ => Ok(()),
    }
}

/// That points are in the result exactly when they should be.
fn vouched(kind: Kind, a: &Pile, b: &Pile, result: &Pile) -> Result<()> {
    // Only where the boxes overlap has anything been computed.
    let Some(region) = a.bounds.common(&b.bounds) else {
        return Ok(());
    };
    let agree = |points: &[[f64; 3]]| -> Result<Vec<Option<bool>>> {
        let told = a.holds(points)?.into_iter().zip(b.holds(points)?);
        let each = told.zip(result.holds(points)?).map(|told| match told {
            ((Some(a), Some(b)), Some(found)) => Some(kind.holds(a, b) == found),
            _ => None,
        });
        Ok(each.collect())
    };
    let points = pair::samples(&region, POINTS);
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
