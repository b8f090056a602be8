//! Fillets and chamfers of edges.

use crate::error::{Context, KernelError, Result};
use crate::facts::{Edge, Turn};
use crate::ffi::bridge;
use crate::limits::length;
use crate::shape::Shape;

impl Shape {
    /// Edges rounded by `radius` mm; edges by their position in [`Shape::edges`].
    ///
    /// # Errors
    /// When no edge is given, the radius does not fit, or the result is not plausible.
    pub fn fillet(&self, edges: &[u32], radius: f64) -> Result<Self> {
        length("fillet's radius", radius)?;
        let what = format!(
            "the fillet of {radius} mm could not be built on {}",
            many(edges.len())
        );
        self.ready(edges, &what)?;
        let solid = bridge::fillet(self.solid()?, edges, radius).context(|| what.clone())?;
        self.dressed(Self::wrap(solid)?, edges, &what)
    }

    /// Edges bevelled by `distance` mm on both faces; edges by their position in [`Shape::edges`].
    ///
    /// # Errors
    /// When no edge is given, the distance does not fit, or the result is not plausible.
    pub fn chamfer(&self, edges: &[u32], distance: f64) -> Result<Self> {
        length("chamfer's distance", distance)?;
        let what = format!(
            "the chamfer of {distance} mm could not be built on {}",
            many(edges.len())
        );
        self.ready(edges, &what)?;
        let solid = bridge::chamfer(self.solid()?, edges, distance).context(|| what.clone())?;
        self.dressed(Self::wrap(solid)?, edges, &what)
    }

    fn ready(&self, edges: &[u32], what: &str) -> Result<()> {
        if edges.is_empty() {
            return Err(KernelError::refused(format!("{what}: no edge is selected")));
        }
        let all = self.edges()?;
        for edge in edges {
            let position = usize::try_from(*edge).unwrap_or(usize::MAX);
            match all.get(position).map(|e| e.turn) {
                None => {
                    return Err(KernelError::refused(format!(
                        "{what}: there is no edge {edge}, the solid has {}",
                        all.len()
                    )));
                }
                Some(Turn::Seam | Turn::Smooth) => {
                    return Err(KernelError::refused(format!(
                        "{what}: at edge {edge} the faces do not meet at an angle"
                    )));
                }
                Some(Turn::Convex | Turn::Concave) => {}
            }
        }
        Ok(())
    }

    /// The result, when it is a solid that such an operation can make.
    fn dressed(&self, result: Self, edges: &[u32], what: &str) -> Result<Self> {
        let wrong = |why: String| KernelError::invalid(format!("{what}: {why}"));
        let parts = bridge::parts(result.solid()?).context(|| what.to_owned())?;
        if parts.solids != 1 || parts.loose != 0 {
            return Err(wrong(format!(
                "{} solids came out instead of one",
                parts.solids
            )));
        }
        let single = bridge::only_solid(result.solid()?).context(|| what.to_owned())?;
        let result = Self::wrap(single)?
            .checked("the result")
            .map_err(|e| KernelError {
                kind: e.kind,
                message: format!("{what}: {}", e.message),
            })?;

        let (before, after) = (self.mass()?.volume, result.mass()?.volume);
        let (old, new) = (self.bounds()?, result.bounds()?);
        // Rounding and bevelling stay within the convex hull, so within the box.
        let slack = 1e-6 * old.size().iter().fold(1.0_f64, |m, s| m.max(*s));
        let outside = old.min.iter().zip(&new.min).any(|(o, n)| *n < o - slack)
            || old.max.iter().zip(&new.max).any(|(o, n)| *n > o + slack);
        if outside || after > old.volume() {
            return Err(wrong("the result is larger than the solid was".to_owned()));
        }
        let all = self.edges()?;
        let turns = |turn: Turn| {
            edges.iter().all(|i| {
                usize::try_from(*i)
                    .ok()
                    .and_then(|i| all.get(i))
                    .map(|e: &Edge| e.turn)
                    == Some(turn)
            })
        };
        if turns(Turn::Convex) && after >= before {
            return Err(wrong(format!(
                "the volume grew from {before:.6} to {after:.6} mm3"
            )));
        }
        if turns(Turn::Concave) && after <= before {
            return Err(wrong(format!(
                "the volume shrank from {before:.6} to {after:.6} mm3"
            )));
        }
        Ok(result)
    }
}

fn many(edges: usize) -> String {
    match edges {
        1 => "the selected edge".to_owned(),
        n => format!("the {n} selected edges"),
    }
}
