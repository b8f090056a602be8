//! What can be asked of two placed solids: how far apart, how much in common.

use assemcad_model::frame::Placement;
use serde::{Deserialize, Serialize};

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge;
use crate::query::{Bounds, Side};
use crate::shape::{Shape, pose};

/// The smallest distance of two placed solids, in mm.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Distance {
    /// The distance; 0 where the solids touch or overlap.
    pub distance: f64,
    /// A point of the first solid where it is that near, in the world; between curved faces good to
    /// about 1e-5 mm only, while the distance itself is good to 1e-9.
    pub on_a: [f64; 3],
    /// The point of the second solid.
    pub on_b: [f64; 3],
}

/// What two placed solids have in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Common {
    /// Volume in mm3; 0 where they do not overlap.
    pub volume: f64,
    /// How many pieces it is in.
    pub pieces: u32,
    /// Centre of the volume and tight box, in the world; `None` where there is no volume.
    pub place: Option<(Bounds, [f64; 3])>,
    /// What the kernel warned of. A volume with a warning is not to be trusted alone.
    pub warnings: Vec<String>,
}

/// An estimate of a common volume by sampling.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Sampled {
    /// Points tried.
    pub tried: u32,
    /// Points inside both solids.
    pub inside: u32,
    /// Volume of the box that was sampled, in mm3; 0 where the solids' boxes do not overlap.
    pub box_volume: f64,
}

impl Sampled {
    /// The estimated common volume in mm3.
    #[must_use]
    pub fn volume(&self) -> f64 {
        if self.tried == 0 {
            return 0.0;
        }
        self.box_volume * f64::from(self.inside) / f64::from(self.tried)
    }
}

/// The smallest distance of two placed solids and where it is.
///
/// # Errors
/// When a placement is not rigid or the kernel finds none.
pub fn distance(a: &Shape, at_a: &Placement, b: &Shape, at_b: &Placement) -> Result<Distance> {
    let found = bridge::distance(a.solid()?, &pose(at_a)?, b.solid()?, &pose(at_b)?)
        .context(|| "the distance of the two solids could not be found".to_owned())?;
    if !found.distance.is_finite() {
        return Err(KernelError::invalid(
            "the distance of the two solids came out not finite",
        ));
    }
    Ok(Distance {
        distance: found.distance,
        on_a: found.on_a,
        on_b: found.on_b,
    })
}

/// The common volume of two placed solids, by a boolean operation.
///
/// Solids whose boxes are apart have none. The boolean may be wrong without a word:
/// compare with [`sampled_common`] where it matters.
///
/// # Errors
/// When a placement is not rigid or the boolean did not end properly; never taken for 0.
pub fn common(a: &Shape, at_a: &Placement, b: &Shape, at_b: &Placement) -> Result<Common> {
    let raw = bridge::common_part(a.solid()?, &pose(at_a)?, b.solid()?, &pose(at_b)?)
        .context(|| "the common volume of the two solids could not be computed".to_owned())?;
    let smaller = a.mass()?.volume.min(b.mass()?.volume);
    // Larger than either solid, and more than integration can be off.
    if raw.volume.is_nan() || raw.volume > smaller * (1.0 + 1e-6) {
        return Err(KernelError::invalid(format!(
            "the common volume of the two solids came out as {} mm3, and the smaller one has only {} \
             mm3",
            raw.volume, smaller
        )));
    }
    let place = (raw.solids > 0).then(|| (raw.bounds.into(), raw.center));
    Ok(Common {
        volume: raw.volume,
        pieces: raw.solids,
        place,
        warnings: raw.warnings,
    })
}

/// The common volume of two placed solids, estimated from `count` points: independent of any boolean.
///
/// The points are those of an additive recurrence of low discrepancy (R. 3, after M. Roberts, "The
/// unreasonable effectiveness of quasirandom sequences", 2018) in the common part of the two tight
/// boxes: the same for the same input.
///
/// # Errors
/// When a placement is not rigid or a point cannot be classified.
pub fn sampled_common(
    a: &Shape,
    at_a: &Placement,
    b: &Shape,
    at_b: &Placement,
    count: u32,
) -> Result<Sampled> {
    let Some(region) = a.bounds_at(at_a)?.common(&b.bounds_at(at_b)?) else {
        return Ok(Sampled {
            tried: count,
            inside: 0,
            box_volume: 0.0,
        });
    };
    let points = samples(&region, count);
    let within = inside(a, at_a, &points)?;
    let both = inside(b, at_b, &within)?;
    let inside = u32::try_from(both.len())
        .map_err(|_| KernelError::internal("more points were found than tried"))?;
    Ok(Sampled {
        tried: count,
        inside,
        box_volume: region.volume(),
    })
}

/// The points in the material of a placed solid.
fn inside(shape: &Shape, at: &Placement, points: &[[f64; 3]]) -> Result<Vec<[f64; 3]>> {
    let back = at.inverse();
    let own: Vec<[f64; 3]> = points.iter().map(|p| back.point(*p)).collect();
    let sides = shape.classify(&own, 1e-7)?;
    Ok(points
        .iter()
        .zip(sides)
        .filter(|(_, s)| *s == Side::Inside)
        .map(|(p, _)| *p)
        .collect())
}

/// Points spread evenly over a box, the same for the same box.
pub(crate) fn samples(region: &Bounds, count: u32) -> Vec<[f64; 3]> {
    (0..count).map(|n| sample(region, n)).collect()
}

fn sample(region: &Bounds, n: u32) -> [f64; 3] {
    // The real root of x^4 = x + 1, and its inverse powers.
    const G: f64 = 1.220_744_084_605_759_5;
    const STEP: [f64; 3] = [1.0 / G, 1.0 / (G * G), 1.0 / (G * G * G)];
    let size = region.size();
    let mut out = region.min;
    for ((o, s), step) in out.iter_mut().zip(size).zip(STEP) {
        let whole = 0.5 + f64::from(n) * step;
        *o += s * (whole - whole.floor());
    }
    out
}
