//! Solids and sheets from faces and wires that move.

use super::ffi::bridge;
use super::{bundle, gap, made, radians, unbundle};
use crate::error::{KernelError, Result};
use crate::limits::{SMALLEST, coordinates, direction, length};
use crate::shape::Shape;

/// On which side of a point a line is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Along the direction; not what lies at the point itself.
    Ahead,
    /// Against the direction; not what lies at the point itself.
    Behind,
    /// The whole line.
    Both,
}

/// What happens to a profile at the corners of its path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transition {
    /// The profile is carried over as it is.
    Transformed,
    /// The outside of the corner is rounded.
    Round,
    /// The sides are prolonged until they meet.
    Right,
}

/// How a profile follows a path.
#[derive(Debug, Clone, Copy)]
pub struct Sweep<'a> {
    /// The path: an edge or a wire.
    pub path: &'a Shape,
    /// Whether a closed profile makes a solid rather than a sheet.
    pub solid: bool,
    /// Whether the profile turns with the curvature of the path; else it turns as little as it can.
    pub frenet: bool,
    /// What happens at corners.
    pub transition: Transition,
    /// A direction that the profile keeps.
    pub normal: Option<[f64; 3]>,
    /// A second path beside the first one that the profile turns to, where no normal is given.
    pub aux_spine: Option<&'a Shape>,
}

/// Where a line meets a face, in mm; as a square too. CadQuery's value.
const LINE_TOLERANCE: f64 = 1e-4;

impl Shape {
    /// A face moved along a vector in mm, its sides leaning inwards by `taper_deg` as seen from the
    /// face (outwards where it is negative). With no taper, wires and groups are taken too: they make
    /// sheets and groups.
    ///
    /// A tapered face moves along its normal, by the vector's length, to the side to which the vector
    /// points.
    ///
    /// # Errors
    /// When a number is out of range, or the sides meet before the length is reached.
    pub fn extruded(&self, vector: [f64; 3], taper_deg: f64) -> Result<Self> {
        let distance = step("extrusion", &vector)?;
        let what = || format!("the extrusion of {distance} mm could not be built");
        if taper_deg == 0.0 {
            return made(bridge::extrude(self.solid()?, &vector), what);
        }
        let taper = taper(taper_deg)?;
        let normal = self.normal_at(None)?;
        let along: f64 = normal.iter().zip(vector).map(|(n, v)| n * v).sum();
        // Less than a right angle from the normal; the taper keeps its sense on either side.
        let side = if along > 0.0 { 1.0 } else { -1.0 };
        let slant = side * distance / libm::cos(taper);
        made(
            bridge::extrude_tapered(self.solid()?, slant, side * taper),
            what,
        )
    }

    /// A solid with material added (or taken away, where `additive` is false) from a face on, up to
    /// another face or surface, or through everything.
    ///
    /// A limit comes first, as in CadQuery; without one `through_all` must be set.
    ///
    /// # Errors
    /// When there is no solid, the profile does not reach what it shall end at, or there is neither
    /// a limit nor `through_all`.
    pub fn extruded_until(
        basis: &Self,
        profile_face: &Self,
        up_to: Option<&Self>,
        through_all: bool,
        additive: bool,
        taper_deg: f64,
    ) -> Result<Self> {
        let taper = if taper_deg == 0.0 {
            0.0
        } else {
            taper(taper_deg)?
        };
        if up_to.is_none() && !through_all {
            return Err(KernelError::refused(
                "the extrusion has nothing to end at: neither a face nor all of the solid",
            ));
        }
        let limit = bundle(up_to.as_slice())?;
        made(
            bridge::extrude_until(
                basis.solid()?,
                profile_face.solid()?,
                &limit,
                taper,
                additive,
            ),
            || "the extrusion up to a limit could not be built".into(),
        )
    }

    /// The faces that a line through `point` meets, the nearest first; one met twice is there twice.
    ///
    /// # Errors
    /// When the direction has no length or a number is out of range.
    pub fn faces_hit_by_line(
        &self,
        point: [f64; 3],
        along: [f64; 3],
        side: Side,
    ) -> Result<Vec<Self>> {
        coordinates("point of the line", &point)?;
        direction("direction of the line", &along)?;
        let side = match side {
            Side::Ahead => 0,
            Side::Behind => 1,
            Side::Both => 2,
        };
        unbundle(
            bridge::faces_on_line(self.solid()?, &point, &along, side, LINE_TOLERANCE),
            || "the faces on the line could not be found".into(),
        )
    }

    /// A face moved along a vector in mm while it turns by `angle_deg` about the line from `center`
    /// along the vector, right-handed. What comes out is a group around the solid.
    ///
    /// # Errors
    /// When a number is out of range or the angle is 0.
    pub fn twisted(&self, center: [f64; 3], vector: [f64; 3], angle_deg: f64) -> Result<Self> {
        coordinates("centre of the twist", &center)?;
        let distance = step("twisted extrusion", &vector)?;
        let angle = radians("twist", angle_deg)?;
        if angle_deg.abs() < SMALLEST {
            return Err(KernelError::refused(
                "the twist is 0 degrees: that is a plain extrusion",
            ));
        }
        made(
            bridge::extrude_twisted(self.solid()?, &center, &vector, angle),
            || {
                format!(
                    "the extrusion of {distance} mm with a twist of {angle_deg} degrees could not be \
                     built"
                )
            },
        )
    }

    /// A face turned about the axis from one point to another by `angle_deg`, right-handed; a wire
    /// makes a sheet.
    ///
    /// # Errors
    /// When the axis has no length, or the angle is 0 or over a full turn.
    pub fn turned(&self, axis_from: [f64; 3], axis_to: [f64; 3], angle_deg: f64) -> Result<Self> {
        coordinates("axis", &axis_from)?;
        coordinates("axis", &axis_to)?;
        if gap(&axis_from, &axis_to) < SMALLEST {
            return Err(KernelError::refused("the axis has no length"));
        }
        // Written so that NaN fails too.
        if !(angle_deg.abs() >= SMALLEST && angle_deg.abs() <= 360.0) {
            return Err(KernelError::refused(format!(
                "the angle of the revolution is {angle_deg} degrees, and must lie within a full turn \
                 and not be 0"
            )));
        }
        let [a, b, c] = axis_from;
        let [d, e, f] = axis_to;
        made(
            bridge::turn_about(
                self.solid()?,
                &axis_from,
                &[d - a, e - b, f - c],
                angle_deg.to_radians(),
            ),
            || format!("the revolution of {angle_deg} degrees could not be built"),
        )
    }

    /// A face, or a wire, carried along a path. The holes of a face are carried along too and taken
    /// out; what comes out is then a group.
    ///
    /// # Errors
    /// When the profile cannot follow the path.
    pub fn swept(&self, s: &Sweep<'_>) -> Result<Self> {
        let guide = guide(s)?;
        let transition = match s.transition {
            Transition::Transformed => 0,
            Transition::Round => 1,
            Transition::Right => 2,
        };
        made(
            bridge::sweep(
                self.solid()?,
                s.path.solid()?,
                &guide,
                kept(s),
                s.frenet,
                s.solid,
                transition,
            ),
            || "the sweep could not be built".into(),
        )
    }

    /// Several profiles carried along one path, each from where it stands to the next one. Of faces
    /// only the outer wire counts, and corners are carried over as they are, as in CadQuery.
    ///
    /// # Errors
    /// When there is no profile, or they cannot follow the path.
    pub fn swept_multi(sections: &[&Self], s: &Sweep<'_>) -> Result<Self> {
        if sections.is_empty() {
            return Err(KernelError::refused("the sweep has no profile"));
        }
        let guide = guide(s)?;
        let sections = bundle(sections)?;
        made(
            bridge::sweep_multi(
                &sections,
                s.path.solid()?,
                &guide,
                kept(s),
                s.frenet,
                s.solid,
            ),
            || "the sweep could not be built".into(),
        )
    }

    /// A skin over closed wires one after the other, straight between them where `ruled`, else smooth;
    /// a solid with flat ends where `solid`.
    ///
    /// # Errors
    /// When there are fewer than two wires, or one is open and a solid is asked for.
    pub fn lofted(wires: &[&Self], ruled: bool, solid: bool) -> Result<Self> {
        if wires.len() < 2 {
            return Err(KernelError::refused(format!(
                "the loft has {} outlines, and needs at least 2",
                wires.len()
            )));
        }
        made(bridge::loft(&*bundle(wires)?, ruled, solid), || {
            "the loft could not be built".into()
        })
    }
}

/// The length of a vector along which something moves.
fn step(what: &str, vector: &[f64; 3]) -> Result<f64> {
    coordinates(&format!("vector of the {what}"), vector)?;
    let distance = gap(vector, &[0.0; 3]);
    length(&format!("length of the {what}"), distance)?;
    Ok(distance)
}

fn taper(deg: f64) -> Result<f64> {
    // Written so that NaN fails too.
    if deg.abs() < 90.0 {
        Ok(deg.to_radians())
    } else {
        Err(KernelError::refused(format!(
            "the taper is {deg} degrees, and must lie between -90 and 90"
        )))
    }
}

fn guide(s: &Sweep<'_>) -> Result<cxx::UniquePtr<bridge::Bundle>> {
    if let Some(normal) = &s.normal {
        direction("normal of the sweep", normal)?;
    }
    bundle(s.aux_spine.as_slice())
}

fn kept<'a>(s: &'a Sweep<'_>) -> &'a [f64] {
    s.normal.as_ref().map_or(&[], |normal| normal)
}
