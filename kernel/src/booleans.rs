//! Union, difference and intersection, each judged by what it must do to the volume.

use assemcad_model::frame::Placement;

use crate::error::{KernelError, Result};
use crate::pair;
use crate::query::Side;
use crate::shape::Shape;

/// How far, relatively, volumes may differ that must be equal.
const EQUAL: f64 = 1e-9;

/// The same for the sum of two volumes: two bodies that touch along a curved, approximated edge add
/// up only as well as that edge is known.
const SUM: f64 = 1e-6;

/// How many points vouch for a result, and for one that came with a warning.
const POINTS: u32 = 64;
const POINTS_AFTER_WARNING: u32 = 1000;

/// Points nearer to a surface than this, in mm, vouch for nothing.
const NEAR: f64 = 1e-4;

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

/// Holds a result against its operands: by volume, and at points that know nothing of the boolean.
///
/// # Errors
/// When the result cannot be right, or a cut removes nothing.
pub(crate) fn judge(kind: Kind, a: &Shape, b: &Shape, result: &Shape) -> Result<()> {
    a.plausible(b, kind, result.mass()?.volume)?;
    a.vouched(b, kind, result, &[])
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Fuse => "fuse",
            Self::Cut => "cut",
            Self::Common => "common part",
        }
    }
}

impl Shape {
    /// That points are in the result exactly when they should be: the one check that does not rest
    /// on the boolean itself, which may be wrong without a word, and right in spite of its warnings.
    fn vouched(&self, other: &Self, kind: Kind, result: &Self, warnings: &[String]) -> Result<()> {
        let (a, b) = (self.bounds()?, other.bounds()?);
        // Only where the boxes overlap has anything been computed; after a warning, look everywhere.
        let (region, count) = if warnings.is_empty() {
            let Some(region) = a.common(&b) else {
                return Ok(());
            };
            (region, POINTS)
        } else {
            (a.union(&b), POINTS_AFTER_WARNING)
        };
        let points = pair::samples(&region, count);
        let in_a = self.classify(&points, NEAR)?;
        let in_b = other.classify(&points, NEAR)?;
        let found = result.classify(&points, NEAR)?;
        for (((point, a), b), found) in points.iter().zip(in_a).zip(in_b).zip(found) {
            if [a, b, found].contains(&Side::Boundary) {
                continue;
            }
            let (a, b) = (a == Side::Inside, b == Side::Inside);
            let expected = match kind {
                Kind::Fuse => a || b,
                Kind::Cut => a && !b,
                Kind::Common => a && b,
            };
            if expected != (found == Side::Inside) {
                let [x, y, z] = point;
                let (is, should) = if expected {
                    ("out of", "in")
                } else {
                    ("in", "out of")
                };
                let mut text = format!(
                    "the {} of the two solids came out wrong: the point ({x:.3}, {y:.3}, {z:.3}) is \
                     {is} the result and should be {should} it",
                    kind.name()
                );
                if !warnings.is_empty() {
                    text.push_str(&format!(" (the kernel warned: {})", warnings.join("; ")));
                }
                return Err(KernelError::invalid(text));
            }
        }
        Ok(())
    }

    fn plausible(&self, other: &Self, kind: Kind, volume: f64) -> Result<()> {
        let (a, b) = (self.mass()?.volume, other.mass()?.volume);
        let wrong = |rule: &str| {
            KernelError::invalid(format!(
                "the {} of solids of {a:.6} and {b:.6} mm3 came out with {volume:.6} mm3, {rule}",
                kind.name()
            ))
        };
        match kind {
            Kind::Fuse if volume < a.max(b) * (1.0 - EQUAL) => {
                Err(wrong("which is less than the larger one"))
            }
            Kind::Fuse if volume > (a + b) * (1.0 + SUM) => {
                Err(wrong("which is more than their sum"))
            }
            Kind::Cut if volume > a * (1.0 + EQUAL) => Err(wrong("which is more than before")),
            Kind::Cut if volume >= a * (1.0 - EQUAL) => Err(self.apart(
                other,
                "the tool does not touch the solid: the cut removes nothing",
                false,
            )?),
            Kind::Cut if volume < (a - b) - SUM * a.max(b) => {
                Err(wrong("which is less than the tool can leave"))
            }
            Kind::Common if volume > a.min(b) * (1.0 + EQUAL) => {
                Err(wrong("which is more than the smaller one"))
            }
            _ => Ok(()),
        }
    }

    /// A sentence with both boxes and, where asked for, the gap between the solids.
    fn apart(&self, other: &Self, what: &str, gap: bool) -> Result<KernelError> {
        let mut text = format!(
            "{what}; the first solid spans {} mm, the second {} mm",
            self.bounds()?,
            other.bounds()?
        );
        if gap {
            let here = Placement::IDENTITY;
            let found = pair::distance(self, &here, other, &here)?;
            text.push_str(&format!(
                "; the gap between them is {:.6} mm",
                found.distance
            ));
        }
        Ok(KernelError::refused(text))
    }
}
