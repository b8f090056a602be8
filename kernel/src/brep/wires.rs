//! Wires from edges, points and numbers, and wires beside wires.

use assemcad_model::frame::Placement;

use super::ffi::bridge;
use super::{bundle, frame, gap, made, run, unbundle};
use crate::error::{KernelError, Result};
use crate::limits::{SMALLEST, length};
use crate::shape::{Shape, start};

/// What becomes of outer corners when a wire or the faces of a solid move outwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corner {
    /// They are rounded.
    Arc,
    /// Their sides are prolonged until they meet.
    Intersection,
    /// Their sides are prolonged along their tangents.
    Tangent,
}

impl Corner {
    fn code(self) -> u8 {
        match self {
            Self::Arc => 0,
            Self::Intersection => 1,
            Self::Tangent => 2,
        }
    }
}

/// Ends nearer than this, in mm, are one when loose edges are put together: CadQuery's value.
const JOINED: f64 = 1e-9;

/// More turns than this would keep the kernel busy for minutes.
const MOST_TURNS: f64 = 1000.0;

impl Shape {
    /// One wire of edges and wires that hang together, in any order.
    ///
    /// # Errors
    /// When they do not hang together.
    pub fn wire(edges: &[&Self]) -> Result<Self> {
        made(bridge::wire_of(&*bundle(edges)?), || {
            "the wire could not be built".into()
        })
    }

    /// The wires that edges and wires make which end where others begin, to 1e-9 mm.
    ///
    /// # Errors
    /// When something is no edge and no wire.
    pub fn connected_wires(edges_and_wires: &[&Self]) -> Result<Vec<Self>> {
        unbundle(
            bridge::wires_connected(&*bundle(edges_and_wires)?, JOINED),
            || "the edges could not be put together".into(),
        )
    }

    /// Straight edges from point to point, and back to the first one when closed. A last point that
    /// repeats the first one closes the wire too.
    ///
    /// # Errors
    /// When points that follow each other coincide, or a number is out of range.
    pub fn polyline_wire(points: &[[f64; 3]], close: bool) -> Result<Self> {
        start()?;
        let (points, close) = match points {
            [first, .., last] if points.len() > 3 && gap(first, last) < SMALLEST => {
                (points.split_last().map_or(points, |(_, rest)| rest), true)
            }
            _ => (points, close),
        };
        let flat = run("polyline", points)?;
        if close && points.len() < 3 {
            return Err(KernelError::refused(
                "a closed polyline needs at least 3 points",
            ));
        }
        made(bridge::wire_polyline(flat, close), || {
            "the polyline could not be built".into()
        })
    }

    /// A helix about the z axis of `at` from its x axis, that rises by `pitch` mm a turn until
    /// `height` mm; `left` turns against the right hand.
    ///
    /// With a half angle other than 0 (or 360, as CadQuery writes it) it lies on a cone that widens
    /// with z where the angle is positive; pitch and height are then measured along the cone's slant.
    ///
    /// # Errors
    /// When a number is out of range, there are over 1000 turns, or the cone ends before the helix.
    pub fn helix_wire(
        pitch: f64,
        height: f64,
        radius: f64,
        at: &Placement,
        angle_deg: f64,
        left: bool,
    ) -> Result<Self> {
        length("helix's pitch", pitch)?;
        length("helix's height", height)?;
        length("helix's radius", radius)?;
        if height / pitch > MOST_TURNS {
            return Err(KernelError::refused(format!(
                "the helix has {} turns, and at most {MOST_TURNS} are made",
                height / pitch
            )));
        }
        let half = if angle_deg == 360.0 { 0.0 } else { angle_deg };
        if half.is_nan() || half.abs() >= 90.0 {
            return Err(KernelError::refused(format!(
                "the half angle of the helix's cone is {angle_deg} degrees, and must lie between -90 \
                 and 90"
            )));
        }
        let half = half.to_radians();
        if radius + height * libm::sin(half) < 0.0 {
            return Err(KernelError::refused("the helix passes the tip of its cone"));
        }
        made(
            bridge::wire_helix(&frame(at)?, pitch, height, radius, half, left),
            || "the helix could not be built".into(),
        )
    }

    /// The wires beside a flat wire at a distance in mm, outwards where it is positive and the wire
    /// closed: several where a waist closes up, none where nothing is left.
    ///
    /// # Errors
    /// When the wire does not lie in one plane only.
    pub fn offset_2d(&self, distance: f64, corner: Corner) -> Result<Vec<Self>> {
        length("offset", distance.abs())?;
        unbundle(
            bridge::wire_offset(self.solid()?, distance, corner.code()),
            || format!("the offset by {distance} mm could not be built"),
        )
    }
}
