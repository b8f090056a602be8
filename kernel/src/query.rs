//! What can be asked of one solid: extent, mass, validity, which side a point is on.

use assemcad_model::frame::{Frame, Placement};
use serde::{Deserialize, Serialize};

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge;
use crate::limits::{SMALLEST, coordinates, length};
use crate::shape::{Shape, frame, pose};

/// A box along the world's axes, in mm.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Bounds {
    /// The lowest corner.
    pub min: [f64; 3],
    /// The highest corner.
    pub max: [f64; 3],
}

impl Bounds {
    /// The extents along x, y, z in mm.
    #[must_use]
    pub fn size(&self) -> [f64; 3] {
        [0, 1, 2].map(|i: usize| self.at(i).1 - self.at(i).0)
    }

    /// The volume in mm3.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.size().iter().product()
    }

    /// What two boxes have in common; `None` when nothing of positive volume.
    #[must_use]
    pub fn common(&self, other: &Self) -> Option<Self> {
        let low = |i| self.at(i).0.max(other.at(i).0);
        let high = |i| self.at(i).1.min(other.at(i).1);
        let out = Self {
            min: [low(0), low(1), low(2)],
            max: [high(0), high(1), high(2)],
        };
        out.size().iter().all(|s| *s > 0.0).then_some(out)
    }

    /// The box of two boxes.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let low = |i| self.at(i).0.min(other.at(i).0);
        let high = |i| self.at(i).1.max(other.at(i).1);
        Self {
            min: [low(0), low(1), low(2)],
            max: [high(0), high(1), high(2)],
        }
    }

    /// The middle.
    #[must_use]
    pub fn middle(&self) -> [f64; 3] {
        [0, 1, 2].map(|i: usize| 0.5 * (self.at(i).0 + self.at(i).1))
    }

    /// Whether a point lies in it.
    #[must_use]
    pub fn holds(&self, point: &[f64; 3]) -> bool {
        let mut each = point.iter().zip(self.min.iter().zip(&self.max));
        each.all(|(p, (low, high))| p >= low && p <= high)
    }

    fn at(&self, axis: usize) -> (f64, f64) {
        (
            self.min.get(axis).copied().unwrap_or_default(),
            self.max.get(axis).copied().unwrap_or_default(),
        )
    }
}

impl core::fmt::Display for Bounds {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let ([a, b, c], [d, e, g]) = (self.min, self.max);
        write!(f, "({a:.3}, {b:.3}, {c:.3}) to ({d:.3}, {e:.3}, {g:.3})")
    }
}

impl From<bridge::BoundsRaw> for Bounds {
    fn from(raw: bridge::BoundsRaw) -> Self {
        Self {
            min: raw.min,
            max: raw.max,
        }
    }
}

/// The mass properties of a solid of density 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Mass {
    /// Volume in mm3.
    pub volume: f64,
    /// Area of the surface in mm2.
    pub area: f64,
    /// Centre of volume in mm.
    pub center: [f64; 3],
    /// Matrix of inertia about the centre, along the world's axes, in mm5.
    pub inertia: [[f64; 3]; 3],
}

/// Whether a solid is one, and what speaks against it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Validity {
    /// How many solids the shape is made of.
    pub solids: u32,
    /// Whether every shell is closed.
    pub closed: bool,
    /// What the kernel's own check found, in plain words; empty when nothing.
    pub reasons: Vec<String>,
}

impl Validity {
    /// One closed solid and nothing against it.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.solids == 1 && self.closed && self.reasons.is_empty()
    }
}

/// Where a point is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// Outside of the material.
    Outside,
    /// In the material.
    Inside,
    /// On the surface, within the tolerance.
    Boundary,
}

impl Shape {
    /// The tight box of the solid: of its exact geometry, without tolerances.
    ///
    /// Exact to about 1e-7 mm for planes, cylinders, cones, spheres and tori; for free-form faces the
    /// extremes are searched for numerically.
    ///
    /// # Errors
    /// When the kernel fails.
    pub fn bounds(&self) -> Result<Bounds> {
        self.bounds_at(&Placement::IDENTITY)
    }

    /// The tight box of the solid at a place.
    ///
    /// # Errors
    /// When the placement is not rigid or the kernel fails.
    pub fn bounds_at(&self, at: &Placement) -> Result<Bounds> {
        bridge::bounds(self.solid()?, &pose(at)?)
            .map(Bounds::from)
            .context(|| "the bounding box could not be found".to_owned())
    }

    /// Volume, area, centre and inertia.
    ///
    /// Integrated to about 1e-12 over the faces as they are. Where a border is itself an approximation,
    /// such as the intersection of two slanted cylinders, the result is as good as that border: about
    /// 1e-8.
    ///
    /// # Errors
    /// When the kernel fails, the integrals do not settle to 1e-9, or a number comes out that is not
    /// finite.
    pub fn mass(&self) -> Result<Mass> {
        if let Some(known) = self.mass.get() {
            return Ok(*known);
        }
        let raw = bridge::mass(self.solid()?)
            .context(|| "the volume could not be computed".to_owned())?;
        let [a, b, c, d, e, f, g, h, i] = raw.inertia;
        let mass = Mass {
            volume: raw.volume,
            area: raw.area,
            center: raw.center,
            inertia: [[a, b, c], [d, e, f], [g, h, i]],
        };
        let numbers = raw
            .center
            .iter()
            .chain(&raw.inertia)
            .chain([&raw.volume, &raw.area]);
        if numbers.clone().any(|n| !n.is_finite()) {
            return Err(KernelError::invalid(
                "the volume could not be computed: it is not finite",
            ));
        }
        Ok(*self.mass.get_or_init(|| mass))
    }

    /// How many solids there are, whether they are closed, and what is wrong with them.
    ///
    /// # Errors
    /// When the check itself fails.
    pub fn validity(&self) -> Result<Validity> {
        let raw =
            bridge::check(self.solid()?).context(|| "the solid could not be checked".to_owned())?;
        Ok(Validity {
            solids: raw.solids,
            closed: raw.closed,
            reasons: raw.reasons,
        })
    }

    /// Which side each point is on; points nearer to the surface than `tolerance` mm are on it.
    ///
    /// # Errors
    /// When a number is out of range or the kernel cannot tell.
    pub fn classify(&self, points: &[[f64; 3]], tolerance: f64) -> Result<Vec<Side>> {
        length("tolerance", tolerance.max(SMALLEST))?;
        if tolerance.is_nan() || tolerance < 0.0 {
            return Err(KernelError::refused("the tolerance must not be negative"));
        }
        let flat = points.as_flattened();
        coordinates("point", flat)?;
        let sides = bridge::classify(self.solid()?, flat, tolerance)
            .context(|| "the points could not be classified".to_owned())?;
        if sides.len() != points.len() {
            return Err(KernelError::internal("a point was not classified"));
        }
        Ok(sides
            .into_iter()
            .map(|side| match side {
                0 => Side::Outside,
                1 => Side::Inside,
                _ => Side::Boundary,
            })
            .collect())
    }

    /// Where a round hole goes through material: from and to, in mm from its mouth, which is the origin of
    /// `from`; it goes along z. None where anything but plane faces square to it lies in its way: then only
    /// a boolean tells.
    pub(crate) fn bores(
        &self,
        from: &Frame,
        radius: f64,
        depth: f64,
    ) -> Result<Option<Vec<(f64, f64)>>> {
        let found = bridge::bores(self.solid()?, &frame(from)?, radius, depth)
            .context(|| "the way of the hole could not be found".to_owned())?;
        let pairs = found.ends.chunks_exact(2);
        let pairs = pairs.filter_map(|pair| Some((*pair.first()?, *pair.last()?)));
        Ok(found.known.then(|| pairs.collect()))
    }
}
