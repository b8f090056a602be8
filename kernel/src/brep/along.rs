//! Points and directions along edges and wires.

use super::ffi::bridge;
use crate::error::{Context, KernelError, Result};
use crate::shape::Shape;

impl Shape {
    /// The unit tangent of an edge or wire at a share of its length, 0 to 1.
    ///
    /// # Errors
    /// When it is no edge and no wire, or the share is out of range.
    pub fn tangent_at(&self, share: f64) -> Result<[f64; 3]> {
        bridge::curve_tangent(self.solid()?, within(share)?)
            .context(|| "the tangent could not be found".into())
    }

    /// The point of an edge or wire at a share of its length, 0 to 1.
    ///
    /// # Errors
    /// When it is no edge and no wire, or the share is out of range.
    pub fn position_at(&self, share: f64) -> Result<[f64; 3]> {
        bridge::curve_position(self.solid()?, within(share)?)
            .context(|| "the point on the curve could not be found".into())
    }

    /// Where an edge or wire begins, in mm.
    ///
    /// # Errors
    /// When it is no edge and no wire.
    pub fn start_point(&self) -> Result<[f64; 3]> {
        bridge::curve_end(self.solid()?, false)
            .context(|| "the start of the curve could not be found".into())
    }

    /// Where an edge or wire ends, in mm.
    ///
    /// # Errors
    /// When it is no edge and no wire.
    pub fn end_point(&self) -> Result<[f64; 3]> {
        bridge::curve_end(self.solid()?, true)
            .context(|| "the end of the curve could not be found".into())
    }

    /// Whether an edge or wire ends in the vertex where it begins.
    ///
    /// # Errors
    /// When it is no edge and no wire.
    pub fn is_closed_curve(&self) -> Result<bool> {
        bridge::curve_closed(self.solid()?)
            .context(|| "whether the curve is closed could not be told".into())
    }

    /// The radius of a circular edge, or of the first edge of a wire, in mm.
    ///
    /// # Errors
    /// When it is no circle.
    pub fn radius(&self) -> Result<f64> {
        bridge::curve_radius(self.solid()?).context(|| "there is no radius".into())
    }
}

fn within(share: f64) -> Result<f64> {
    if (0.0..=1.0).contains(&share) {
        Ok(share)
    } else {
        Err(KernelError::refused(format!(
            "the place on the curve is {share} of its length, and must lie between 0 and 1"
        )))
    }
}
