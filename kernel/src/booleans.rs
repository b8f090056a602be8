//! Union, difference and intersection, each judged by what it must do to the volume.

use assemcad_model::frame::Placement;
use cxx::UniquePtr;

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge;
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

    fn code(self) -> u8 {
        match self {
            Self::Fuse => 0,
            Self::Cut => 1,
            Self::Common => 2,
        }
    }
}

impl Shape {
    /// The union of two solids that overlap or share a face.
    ///
    /// # Errors
    /// When not exactly one valid solid comes out, or its volume is less than the larger one's or
    /// more than the sum.
    pub fn fuse(&self, other: &Self) -> Result<Self> {
        self.combine(other, Kind::Fuse)
    }

    /// This solid without `tool`.
    ///
    /// # Errors
    /// When not exactly one valid solid is left, or nothing was removed.
    pub fn cut(&self, tool: &Self) -> Result<Self> {
        self.combine(tool, Kind::Cut)
    }

    /// What two solids have in common.
    ///
    /// # Errors
    /// When not exactly one valid solid comes out, or it is larger than one of the two.
    pub fn common(&self, other: &Self) -> Result<Self> {
        self.combine(other, Kind::Common)
    }

    fn combine(&self, other: &Self, kind: Kind) -> Result<Self> {
        let name = kind.name();
        let bridge::BooleanRaw { solid, warnings } =
            bridge::boolean(self.solid()?, other.solid()?, kind.code())
                .context(|| format!("the {name} of the two solids could not be computed"))?;
        let raw = Self::wrap(solid)?;
        let parts =
            bridge::parts(raw.solid()?).context(|| format!("the {name} could not be looked at"))?;
        if parts.solids != 1 {
            return Err(self.not_one(other, kind, parts.solids)?);
        }
        if parts.loose != 0 {
            return Err(KernelError::invalid(format!(
                "the {name} leaves faces without a body"
            )));
        }
        let plain = Self::wrap(
            bridge::only_solid(raw.solid()?)
                .context(|| format!("the {name} could not be looked at"))?,
        )?
        .checked(&format!("the result of the {name}"))?;
        self.plausible(other, kind, plain.mass()?.volume)?;
        self.vouched(other, kind, &plain, &warnings)?;
        plain.unified()
    }

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

    /// The solid with faces of one surface joined, where that changes nothing else.
    fn unified(self) -> Result<Self> {
        let unified = bridge::unify(self.solid()?)
            .map(|solid| Self::from_unified(&solid))
            // Joining faces is a nicety: a failure leaves the solid as it was.
            .unwrap_or(None);
        let Some(unified) = unified else {
            return Ok(self);
        };
        let (before, after) = (self.mass()?.volume, unified.mass()?.volume);
        Ok(if (before - after).abs() <= EQUAL * before {
            unified
        } else {
            self
        })
    }

    fn from_unified(solid: &UniquePtr<bridge::Solid>) -> Option<Self> {
        let single = bridge::only_solid(solid.as_ref()?).ok()?;
        Self::wrap(single)
            .and_then(|shape| shape.checked("the joined solid"))
            .ok()
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

    fn not_one(&self, other: &Self, kind: Kind, solids: u32) -> Result<KernelError> {
        match (kind, solids) {
            (Kind::Fuse, n) => self.apart(
                other,
                &format!("the solids do not join: the fuse leaves {n} separate solids"),
                true,
            ),
            (Kind::Cut, 0) => self.apart(other, "the cut leaves nothing of the solid", false),
            (Kind::Common, 0) => self.apart(other, "the solids have no volume in common", true),
            (_, n) => Ok(KernelError::refused(format!(
                "the {} leaves {n} separate solids instead of one",
                kind.name()
            ))),
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
