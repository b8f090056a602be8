//! Solids from numbers: box, cylinder, cone, sphere; and the check that a shape is one sound solid.

use assemcad_model::frame::Frame;

use crate::error::{Context, KernelError, Result};
use crate::ffi::bridge;
use crate::limits::{SMALLEST, coordinates, length};
use crate::shape::{Shape, frame, start};

impl Shape {
    /// A box from the origin of `at` along its axes.
    ///
    /// # Errors
    /// When a side is not a length the kernel takes, or the frame is none.
    pub fn cuboid(at: &Frame, size: [f64; 3]) -> Result<Self> {
        let at = begin(at)?;
        let [x, y, z] = size;
        for (what, side) in [
            ("box's x size", x),
            ("box's y size", y),
            ("box's z size", z),
        ] {
            length(what, side)?;
        }
        bridge::make_box(&at, x, y, z)
            .context(|| format!("the box of {x} x {y} x {z} mm could not be built"))
            .and_then(Self::wrap)?
            .checked("the box")
    }

    /// A cylinder along z of `at`.
    ///
    /// # Errors
    /// When a number is not a length the kernel takes, or the frame is none.
    pub fn cylinder(at: &Frame, radius: f64, height: f64) -> Result<Self> {
        let at = begin(at)?;
        length("cylinder's radius", radius)?;
        length("cylinder's height", height)?;
        bridge::make_cylinder(&at, radius, height)
            .context(|| format!("the cylinder of radius {radius} mm could not be built"))
            .and_then(Self::wrap)?
            .checked("the cylinder")
    }

    /// A cone or frustum along z of `at`; one of the radii may be 0, and they differ.
    ///
    /// # Errors
    /// When a number is not a length the kernel takes, or the frame is none.
    pub fn cone(at: &Frame, radius_base: f64, radius_top: f64, height: f64) -> Result<Self> {
        let at = begin(at)?;
        for (what, radius) in [
            ("cone's radius at the base", radius_base),
            ("cone's radius at the top", radius_top),
        ] {
            if radius != 0.0 {
                length(what, radius)?;
            }
        }
        length("cone's height", height)?;
        if (radius_base - radius_top).abs() < SMALLEST {
            return Err(KernelError::refused(format!(
                "both radii of the cone are {radius_base} mm: that is a cylinder"
            )));
        }
        bridge::make_cone(&at, radius_base, radius_top, height)
            .context(|| {
                format!("the cone of radii {radius_base} and {radius_top} mm could not be built")
            })
            .and_then(Self::wrap)?
            .checked("the cone")
    }

    /// A sphere about the origin of `at`.
    ///
    /// # Errors
    /// When the radius is not a length the kernel takes, or the frame is none.
    pub fn sphere(at: &Frame, radius: f64) -> Result<Self> {
        let at = begin(at)?;
        length("sphere's radius", radius)?;
        bridge::make_sphere(&at, radius)
            .context(|| format!("the sphere of radius {radius} mm could not be built"))
            .and_then(Self::wrap)?
            .checked("the sphere")
    }

    /// The shape, when it is one valid closed solid of positive volume.
    pub(crate) fn checked(self, what: &str) -> Result<Self> {
        let validity = self.validity()?;
        if validity.solids != 1 {
            return Err(KernelError::invalid(format!(
                "{what} is made of {} solids instead of one",
                validity.solids
            )));
        }
        if !validity.reasons.is_empty() {
            return Err(KernelError::invalid(format!(
                "{what} is no valid solid: {}",
                validity.reasons.join("; ")
            )));
        }
        if !validity.closed {
            return Err(KernelError::invalid(format!("{what} is not closed")));
        }
        let volume = self.mass()?.volume;
        if volume.is_nan() || volume <= 0.0 {
            return Err(KernelError::invalid(format!(
                "the volume of {what} is {volume} mm3"
            )));
        }
        Ok(self)
    }
}

fn begin(at: &Frame) -> Result<bridge::At> {
    start()?;
    coordinates("frame", &at.origin)?;
    frame(at)
}
