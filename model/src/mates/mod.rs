//! Mates: typed joints between ports, each a closed-form placement.
//!
//! One file per mate type, carrying everything about it: options, the pairs it joins, placement, the
//! freedom it leaves, residual, conditions, promised contact and allowed overlap. A part is placed by
//!
//! `T = L_b . R_flip . R_alpha . L_c^-1`
//!
//! where `L_b` is the base port's frame in the world and `L_c` the incoming port's frame in its part.
//! A mate type gives the middle of that product, with its offsets: the incoming port's frame seen
//! from the base port's frame.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::diagnostic::Diagnostic;
use crate::frame::{FrameError, Placement};
use crate::param::{ParamSpec, check_all};
use crate::ports::{Port, PortType};

mod coaxial;
mod coaxial_face;
mod effect;
mod face_to_face;
mod gear_mesh;
mod press_fit;
mod serving;
mod shared;
mod snap_to_face;
mod thread_engage;

pub use effect::{Contact, Coupling, Freedom, Overlap, Twist};
use effect::{SLIDE_X, SLIDE_Y, SLIDE_Z, SPIN};
pub use serving::{Once, serves_once};
use shared::{
    along_axis, at_most, axial_residual_deg, bond, common_length, degrees, direction, distance_mm,
    millimetres, no_conditions, no_overlap, no_play, off_axis_mm, opposed_residual_deg, over,
    unless_bonded, within,
};

/// The types of mates.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum MateType {
    /// Axes on one line.
    Coaxial,
    /// Axes on one line, seat on seat.
    CoaxialFace,
    /// Faces towards each other.
    FaceToFace,
    /// Gears with a tooth in a gap.
    GearMesh,
    /// A cylinder in a hole that is no wider.
    PressFit,
    /// A face on a point of a face.
    SnapToFace,
    /// A screw in a threaded hole.
    ThreadEngage,
}

/// Everything about a mate type.
#[derive(Debug)]
pub struct MateKind {
    /// The type.
    pub mate_type: MateType,
    /// The type's name as it is written.
    pub name: &'static str,
    /// What it does.
    pub doc: &'static str,
    /// The pairs it joins: base port type, incoming port type; sorted.
    pub pairs: &'static [(PortType, PortType)],
    /// Its options with units, ranges and defaults.
    pub options: fn() -> Vec<ParamSpec>,
    /// The incoming port's frame seen from the base port's frame.
    relative: fn(&Joint<'_>) -> Placement,
    /// How far an actual relative frame is from what the mate constrains.
    residual: fn(&Joint<'_>, &Placement) -> Residual,
    /// What speaks against joining these two ports, beyond their types.
    conditions: fn(&Joint<'_>) -> Vec<Condition>,
    /// The motion it leaves.
    freedom: fn(&Joint<'_>) -> Freedom,
    /// The contact it promises.
    contact: fn(&Joint<'_>) -> Option<Contact>,
    /// The overlap it allows.
    overlap: fn(&Joint<'_>) -> Overlap,
    /// The play between a hole and what is in it.
    radial_play: fn(&Joint<'_>) -> Option<f64>,
}

/// Every mate type, sorted by name.
pub static ALL: [&MateKind; 7] = [
    &coaxial::KIND,
    &coaxial_face::KIND,
    &face_to_face::KIND,
    &gear_mesh::KIND,
    &press_fit::KIND,
    &snap_to_face::KIND,
    &thread_engage::KIND,
];

/// Two ports and the options with which they are joined.
#[derive(Debug, Clone, Copy)]
pub struct Joint<'a> {
    /// The port that stays.
    pub base: &'a Port,
    /// The port that is brought in.
    pub incoming: &'a Port,
    /// The options.
    pub options: &'a Options,
}

impl Joint<'_> {
    fn number(&self, name: &str) -> f64 {
        let value = self.options.0.get(name);
        value.and_then(Value::as_f64).unwrap_or(f64::NAN)
    }

    fn flag(&self, name: &str) -> bool {
        let value = self.options.0.get(name);
        value.and_then(Value::as_bool).unwrap_or_default()
    }

    /// Whether it is stated that the two are joined for good: welded, glued, soldered.
    #[must_use]
    pub fn bonded(&self) -> bool {
        let value = self.options.0.get("bond");
        value.and_then(Value::as_str).is_some_and(|b| b != "none")
    }

    /// Whether the z axes look the same way.
    fn same(&self) -> bool {
        let value = self.options.0.get("direction");
        value.and_then(Value::as_str) == Some("same")
    }
}

/// How far a mate is from holding, in the directions that it constrains.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Residual {
    /// Distance in mm.
    pub distance_mm: f64,
    /// Angle in degrees.
    pub angle_deg: f64,
}

impl Residual {
    /// The largest distance at which a mate holds, in mm: far below any tolerance of manufacture, far
    /// above the rounding of a long chain of placements.
    pub const MAX_DISTANCE_MM: f64 = 1e-6;
    /// The largest angle at which a mate holds, in degrees.
    pub const MAX_ANGLE_DEG: f64 = 1e-6;

    /// Whether the mate holds. A residual that is not a number does not.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.distance_mm <= Self::MAX_DISTANCE_MM && self.angle_deg <= Self::MAX_ANGLE_DEG
    }
}

/// Something about a pair of ports that their mate does not allow.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    /// What is wrong, in one sentence.
    pub message: String,
    /// The offending value.
    pub found: f64,
    /// What is allowed.
    pub expected: String,
}

/// Checked options of a mate: every declared option is present.
#[derive(Debug, Clone, PartialEq)]
pub struct Options(Map<String, Value>);

impl Options {
    /// A text that is the same for equal options, and for no others.
    #[must_use]
    pub fn key(&self) -> String {
        let numbers = self
            .0
            .values()
            .map(|v| v.as_f64().map(|x| (x + 0.0).to_bits()));
        // Numbers by their value, however they are written; all else as it is written.
        let each = self
            .0
            .iter()
            .zip(numbers)
            .map(|((name, value), number)| match number {
                Some(bits) => format!("{name}={bits:x};"),
                None => format!("{name}={value};"),
            });
        each.collect()
    }
}

impl MateType {
    /// The description of the type.
    #[must_use]
    pub fn kind(self) -> &'static MateKind {
        match self {
            Self::Coaxial => &coaxial::KIND,
            Self::CoaxialFace => &coaxial_face::KIND,
            Self::FaceToFace => &face_to_face::KIND,
            Self::GearMesh => &gear_mesh::KIND,
            Self::PressFit => &press_fit::KIND,
            Self::SnapToFace => &snap_to_face::KIND,
            Self::ThreadEngage => &thread_engage::KIND,
        }
    }
}

impl core::fmt::Display for MateType {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.kind().name)
    }
}

impl MateKind {
    /// Checks given options and fills in the defaults.
    ///
    /// # Errors
    /// One diagnostic for each unknown option and each value out of range.
    pub fn check_options(
        &self,
        given: &Map<String, Value>,
        place: &str,
    ) -> Result<Options, Vec<Diagnostic>> {
        check_all(&(self.options)(), given, place).map(Options)
    }

    /// Whether the mate joins a base port of one type with an incoming port of another.
    #[must_use]
    pub fn joins(&self, base: PortType, incoming: PortType) -> bool {
        self.pairs.contains(&(base, incoming))
    }

    /// What speaks against joining these two ports with these options, beyond their types.
    #[must_use]
    pub fn conditions(&self, j: &Joint<'_>) -> Vec<Condition> {
        (self.conditions)(j)
    }

    /// The motion that the mate leaves, in the base port's frame.
    #[must_use]
    pub fn freedom(&self, j: &Joint<'_>) -> Freedom {
        (self.freedom)(j)
    }

    /// The contact that the mate promises; none where the parts may be apart.
    #[must_use]
    pub fn contact(&self, j: &Joint<'_>) -> Option<Contact> {
        (self.contact)(j)
    }

    /// How much the mated parts may overlap, and must.
    #[must_use]
    pub fn overlap(&self, j: &Joint<'_>) -> Overlap {
        (self.overlap)(j)
    }

    /// The radial play between a hole and what is in it, in mm; negative where it is pressed in.
    #[must_use]
    pub fn radial_play(&self, j: &Joint<'_>) -> Option<f64> {
        (self.radial_play)(j)
    }

    /// Where the incoming part goes: the world placement of the base part being given.
    ///
    /// # Errors
    /// When a port's frame is none.
    pub fn place_incoming(
        &self,
        base_part: &Placement,
        base: &Port,
        incoming: &Port,
        options: &Options,
    ) -> Result<Placement, FrameError> {
        let (b, c) = (base.frame.placement()?, incoming.frame.placement()?);
        Ok(*base_part
            * b
            * (self.relative)(&Joint {
                base,
                incoming,
                options,
            })
            * c.inverse())
    }

    /// Where the base part goes: the world placement of the incoming part being given.
    ///
    /// # Errors
    /// When a port's frame is none.
    pub fn place_base(
        &self,
        incoming_part: &Placement,
        base: &Port,
        incoming: &Port,
        options: &Options,
    ) -> Result<Placement, FrameError> {
        let (b, c) = (base.frame.placement()?, incoming.frame.placement()?);
        Ok(*incoming_part
            * c
            * (self.relative)(&Joint {
                base,
                incoming,
                options,
            })
            .inverse()
            * b.inverse())
    }

    /// How far the mate is from holding at the given placements of the two parts.
    ///
    /// # Errors
    /// When a port's frame is none.
    pub fn residual(
        &self,
        base_part: &Placement,
        base: &Port,
        incoming_part: &Placement,
        incoming: &Port,
        options: &Options,
    ) -> Result<Residual, FrameError> {
        let b = *base_part * base.frame.placement()?;
        let c = *incoming_part * incoming.frame.placement()?;
        Ok((self.residual)(
            &Joint {
                base,
                incoming,
                options,
            },
            &(b.inverse() * c),
        ))
    }
}

/// The mate types that join two port types, in order of their names.
#[must_use]
pub fn joining(base: PortType, incoming: PortType) -> Vec<MateType> {
    ALL.iter()
        .filter(|k| k.joins(base, incoming))
        .map(|k| k.mate_type)
        .collect()
}

/// The compatibility relation as a table of text: a line for each base port type, a column for each
/// incoming one, and in each cell the digits of the mate types that join them.
#[must_use]
pub fn compatibility_table() -> String {
    let mut out = String::new();
    for (i, kind) in ALL.iter().enumerate() {
        out.push_str(&format!("{} {}\n", i + 1, kind.name));
    }
    let cell = |text: &str| format!(" {text:>15}");
    out.push_str(&format!("\n{:15}", "base \\ incoming"));
    for incoming in crate::ports::ALL {
        out.push_str(&cell(incoming.name));
    }
    for base in crate::ports::ALL {
        out.push_str(&format!("\n{:15}", base.name));
        for incoming in crate::ports::ALL {
            let joins = |(i, k): (usize, &&MateKind)| {
                let joined = k.joins(base.port_type, incoming.port_type);
                joined.then(|| (i + 1).to_string())
            };
            let digits: String = ALL.iter().enumerate().filter_map(joins).collect();
            out.push_str(&cell(if digits.is_empty() { "-" } else { &digits }));
        }
    }
    out.push('\n');
    out
}

#[cfg(test)]
mod tests;
