//! Union, difference, intersection and splits as CadQuery does them: of any shapes, unjudged.
//!
//! What comes out is a group, even around a single solid, and an empty one where nothing is left: it
//! is the kernel's own, and whoever asked takes it apart. A group takes part with each of its children.

use super::bundle;
use super::ffi::bridge;
use super::made;
use crate::error::{KernelError, Result};
use crate::limits::LARGEST;
use crate::shape::Shape;

impl Shape {
    /// The union with others. `glue` is for shapes that touch and do not overlap; `tolerance`, in mm,
    /// takes what is nearer than that for one.
    ///
    /// The children of a group are fused with each other too; a group of one child fused with nothing
    /// is that child itself, without the group.
    ///
    /// # Errors
    /// When there is nothing to fuse with, or the kernel fails.
    pub fn fused(&self, others: &[&Self], glue: bool, tolerance: Option<f64>) -> Result<Self> {
        let others = bundle(others)?;
        made(
            bridge::fuse_all(self.solid()?, &others, glue, fuzzy(tolerance)?),
            || "the shapes could not be fused".into(),
        )
    }

    /// This shape without others.
    ///
    /// # Errors
    /// When there is nothing to take away, or the kernel fails.
    pub fn without(&self, tools: &[&Self], tolerance: Option<f64>) -> Result<Self> {
        let tools = bundle(tools)?;
        made(
            bridge::cut_all(self.solid()?, &tools, fuzzy(tolerance)?),
            || "the cut could not be computed".into(),
        )
    }

    /// What this shape has in common with others taken together.
    ///
    /// # Errors
    /// When there is nothing to intersect with, or the kernel fails.
    pub fn shared(&self, others: &[&Self], tolerance: Option<f64>) -> Result<Self> {
        let others = bundle(others)?;
        made(
            bridge::common_all(self.solid()?, &others, fuzzy(tolerance)?),
            || "the common part could not be computed".into(),
        )
    }

    /// This shape cut apart along others, every piece kept.
    ///
    /// # Errors
    /// When there is nothing to split with, or the kernel fails.
    pub fn split_by(&self, tools: &[&Self]) -> Result<Self> {
        let tools = bundle(tools)?;
        made(bridge::split_all(self.solid()?, &tools), || {
            "the shape could not be split".into()
        })
    }

    /// The shape with faces of one surface and edges of one curve joined; the shape itself where that
    /// fails.
    ///
    /// # Errors
    /// When memory runs out.
    pub fn cleaned(&self) -> Result<Self> {
        made(bridge::cleaned(self.solid()?), || {
            "the faces of the shape could not be joined".into()
        })
    }
}

/// The tolerance as the kernel takes it, where 0 is its own.
fn fuzzy(tolerance: Option<f64>) -> Result<f64> {
    let tolerance = tolerance.unwrap_or_default();
    if (0.0..=LARGEST).contains(&tolerance) {
        Ok(tolerance)
    } else {
        Err(KernelError::refused(format!(
            "the tolerance is {tolerance} mm, and must lie between 0 and {LARGEST}"
        )))
    }
}
