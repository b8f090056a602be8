//! Primitive solids with CadQuery's angles, and edges and walls worked on.

use assemcad_model::frame::Placement;

use super::ffi::bridge;
use super::wires::Corner;
use super::{bundle, frame, made, radians};
use crate::error::{KernelError, Result};
use crate::limits::{SMALLEST, coordinates, length};
use crate::shape::Shape;

/// How well the walls of a hollow solid are computed, in mm: CadQuery's value.
const WALL_TOLERANCE: f64 = 1e-4;

impl Shape {
    /// The solid or solids with edges rounded at one radius in mm.
    ///
    /// # Errors
    /// When an edge is none of its own, there are none, or the rounding does not fit.
    pub fn filleted(&self, edges: &[&Self], radius: f64) -> Result<Self> {
        length("fillet's radius", radius)?;
        some("fillet", edges)?;
        let edges = bundle(edges)?;
        made(bridge::fillet_edges(self.solid()?, &edges, radius), || {
            format!("the fillet of {radius} mm could not be built")
        })
    }

    /// The solid or solids with edges cut off: `length1` mm from each edge on the face that the kernel
    /// lists first for it and `length2` mm on the other, the same where there is none.
    ///
    /// # Errors
    /// When an edge is none of its own, there are none, or the cut does not fit.
    pub fn chamfered(&self, edges: &[&Self], length1: f64, length2: Option<f64>) -> Result<Self> {
        let second = length2.unwrap_or(length1);
        length("chamfer's length", length1)?;
        length("chamfer's second length", second)?;
        some("chamfer", edges)?;
        let edges = bundle(edges)?;
        made(
            bridge::chamfer_edges(self.solid()?, &edges, length1, second),
            || format!("the chamfer of {length1} mm could not be built"),
        )
    }

    /// The solid as a wall of `thickness` mm along its faces, outside of them where it is positive and
    /// inside where it is negative, without a wall at the open faces. With no open face the solid gets
    /// a closed cavity.
    ///
    /// # Errors
    /// When a face is none of its own, the corners are [`Corner::Tangent`], or the walls do not fit.
    pub fn hollowed(&self, open_faces: &[&Self], thickness: f64, corner: Corner) -> Result<Self> {
        length("wall's thickness", thickness.abs())?;
        let corner = match corner {
            Corner::Arc => 0,
            Corner::Intersection => 1,
            Corner::Tangent => {
                return Err(KernelError::refused(
                    "the corners of a wall are arcs or intersections",
                ));
            }
        };
        let open = bundle(open_faces)?;
        made(
            bridge::hollow(self.solid()?, &open, thickness, corner, WALL_TOLERANCE),
            || format!("the wall of {thickness} mm could not be built"),
        )
    }

    /// A wedge: a box of `dx`, `dy`, `dz` mm whose face at y = `dy` spans `xmin` to `xmax` and `zmin`
    /// to `zmax` instead.
    ///
    /// # Errors
    /// When a size is no length the kernel takes, or the far face is inverted.
    #[allow(clippy::too_many_arguments)]
    pub fn wedge(
        at: &Placement,
        dx: f64,
        dy: f64,
        dz: f64,
        xmin: f64,
        zmin: f64,
        xmax: f64,
        zmax: f64,
    ) -> Result<Self> {
        for (what, size) in [
            ("wedge's x size", dx),
            ("wedge's y size", dy),
            ("wedge's z size", dz),
        ] {
            length(what, size)?;
        }
        coordinates("wedge's far face", &[xmin, zmin, xmax, zmax])?;
        if xmax < xmin || zmax < zmin {
            return Err(KernelError::refused(format!(
                "the wedge's far face runs from {xmin} to {xmax} mm in x and {zmin} to {zmax} mm in \
                 z, and must not be inverted"
            )));
        }
        made(
            bridge::solid_wedge(&frame(at)?, dx, dy, dz, xmin, zmin, xmax, zmax),
            || "the wedge could not be built".into(),
        )
    }

    /// A torus about the z axis of `at`: `r1` mm from the axis to the middle of the tube, whose radius
    /// is `r2` mm.
    ///
    /// # Errors
    /// When the tube reaches its axis, or a radius is no length the kernel takes.
    pub fn torus(at: &Placement, r1: f64, r2: f64) -> Result<Self> {
        length("torus's radius", r1)?;
        length("radius of the torus's tube", r2)?;
        if r1 - r2 < SMALLEST {
            return Err(KernelError::refused(format!(
                "the torus's tube of radius {r2} mm reaches its axis {r1} mm away"
            )));
        }
        made(bridge::solid_torus(&frame(at)?, r1, r2), || {
            "the torus could not be built".into()
        })
    }

    /// The part of a ball between two latitudes, `angle1_deg` below `angle2_deg` from -90 to 90, and
    /// over `angle3_deg` of longitude from the x axis.
    ///
    /// # Errors
    /// When a number is out of range.
    pub fn sphere_part(
        at: &Placement,
        radius: f64,
        angle1_deg: f64,
        angle2_deg: f64,
        angle3_deg: f64,
    ) -> Result<Self> {
        length("sphere's radius", radius)?;
        // Written so that NaN fails too.
        if !(-90.0 <= angle1_deg && angle1_deg < angle2_deg && angle2_deg <= 90.0) {
            return Err(KernelError::refused(format!(
                "the sphere's latitudes are {angle1_deg} to {angle2_deg} degrees, and must rise within \
                 -90 to 90"
            )));
        }
        let turn = part_of_turn("sphere", angle3_deg)?;
        let (low, high) = (angle1_deg.to_radians(), angle2_deg.to_radians());
        made(
            bridge::solid_sphere(&frame(at)?, radius, low, high, turn),
            || "the sphere could not be built".into(),
        )
    }

    /// A cylinder along z of `at`, or the part of one over `angle_deg` from the x axis.
    ///
    /// # Errors
    /// When a number is out of range.
    pub fn cylinder_part(at: &Placement, radius: f64, height: f64, angle_deg: f64) -> Result<Self> {
        length("cylinder's radius", radius)?;
        length("cylinder's height", height)?;
        let turn = part_of_turn("cylinder", angle_deg)?;
        made(
            bridge::solid_cylinder(&frame(at)?, radius, height, turn),
            || "the cylinder could not be built".into(),
        )
    }

    /// A cone or frustum along z of `at`, or the part of one over `angle_deg` from the x axis; one of
    /// the radii may be 0, and they differ.
    ///
    /// # Errors
    /// When a number is out of range.
    pub fn cone_part(
        at: &Placement,
        r1: f64,
        r2: f64,
        height: f64,
        angle_deg: f64,
    ) -> Result<Self> {
        for (what, radius) in [
            ("cone's radius at the base", r1),
            ("cone's radius at the top", r2),
        ] {
            if radius != 0.0 {
                length(what, radius)?;
            }
        }
        length("cone's height", height)?;
        if (r1 - r2).abs() < SMALLEST {
            return Err(KernelError::refused(format!(
                "both radii of the cone are {r1} mm: that is a cylinder"
            )));
        }
        let turn = part_of_turn("cone", angle_deg)?;
        made(
            bridge::solid_cone(&frame(at)?, r1, r2, height, turn),
            || "the cone could not be built".into(),
        )
    }
}

fn some(what: &str, edges: &[&Shape]) -> Result<()> {
    if edges.is_empty() {
        return Err(KernelError::refused(format!(
            "the {what} has no edges to work on"
        )));
    }
    Ok(())
}

fn part_of_turn(what: &str, deg: f64) -> Result<f64> {
    if deg > 0.0 && deg <= 360.0 {
        radians("angle", deg)
    } else {
        Err(KernelError::refused(format!(
            "the angle of the {what} is {deg} degrees, and must lie over 0 up to 360"
        )))
    }
}
