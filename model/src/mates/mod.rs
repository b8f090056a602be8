//! Mates: typed joints between ports, each a closed-form placement.
//!
//! One file per mate type, carrying everything about it. A part is placed by
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
use crate::param::{ParamKind, ParamSpec, check_all};
use crate::ports::{Port, PortType};

mod coaxial;
mod face_to_face;

/// The types of mates.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum MateType {
    /// Axes on one line.
    Coaxial,
    /// Faces towards each other.
    FaceToFace,
}

/// Everything about a mate type.
#[derive(Debug)]
pub struct MateKind {
    /// The type.
    pub mate_type: MateType,
    /// The type's name as it is written.
    pub name: &'static str,
    /// One line on what it does.
    pub doc: &'static str,
    /// The pairs it joins: base port type, incoming port type.
    pub pairs: &'static [(PortType, PortType)],
    /// Its options with units, ranges and defaults.
    pub options: fn() -> Vec<ParamSpec>,
    /// The incoming port's frame seen from the base port's frame.
    relative: fn(&Options) -> Placement,
    /// How far an actual relative frame is from what the mate constrains.
    residual: fn(&Options, &Placement) -> Residual,
    /// What speaks against joining these two ports, beyond their types: `(what, expected)`.
    conditions: fn(&Port, &Port) -> Vec<Condition>,
}

/// Every mate type, sorted by name.
pub static ALL: [&MateKind; 2] = [&coaxial::KIND, &face_to_face::KIND];

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
    fn number(&self, name: &str) -> f64 {
        self.0.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN)
    }

    fn word(&self, name: &str) -> &str {
        self.0.get(name).and_then(Value::as_str).unwrap_or_default()
    }
}

impl MateType {
    /// The description of the type.
    #[must_use]
    pub fn kind(self) -> &'static MateKind {
        match self {
            Self::Coaxial => &coaxial::KIND,
            Self::FaceToFace => &face_to_face::KIND,
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

    /// What speaks against joining these two ports, beyond their types.
    #[must_use]
    pub fn conditions(&self, base: &Port, incoming: &Port) -> Vec<Condition> {
        (self.conditions)(base, incoming)
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
        Ok(*base_part * b * (self.relative)(options) * c.inverse())
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
        Ok(*incoming_part * c * (self.relative)(options).inverse() * b.inverse())
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
        Ok((self.residual)(options, &(b.inverse() * c)))
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

fn millimetres(name: &str, doc: &str) -> ParamSpec {
    number(name, doc, "mm", 1e5)
}

fn degrees(name: &str, doc: &str) -> ParamSpec {
    number(name, doc, "deg", 360.0)
}

fn number(name: &str, doc: &str, unit: &str, most: f64) -> ParamSpec {
    ParamSpec {
        name: name.to_owned(),
        doc: doc.to_owned(),
        kind: ParamKind::Number {
            unit: unit.to_owned(),
            min: -most,
            max: most,
            default: 0.0,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::{ALL, MateType, Options, Residual};
    use crate::frame::{Frame, Placement};
    use crate::ports::{Port, PortType};
    use proptest::prelude::*;
    use serde_json::{Map, Value, json};
    use std::collections::BTreeMap;

    fn port(port_type: PortType, frame: Frame) -> Port {
        Port {
            name: "p".to_owned(),
            port_type,
            frame,
            params: BTreeMap::new(),
        }
    }

    fn options(t: MateType, given: Value) -> Options {
        t.kind()
            .check_options(given.as_object().unwrap(), "options")
            .unwrap()
    }

    #[test]
    fn every_file_is_listed_once_and_in_order() {
        let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/mates")).unwrap();
        let mut files: Vec<String> = files
            .map(|f| f.unwrap().file_name().into_string().unwrap())
            .filter(|f| f != "mod.rs")
            .map(|f| f.trim_end_matches(".rs").to_owned())
            .collect();
        files.sort();
        let listed: Vec<&str> = ALL.iter().map(|k| k.name).collect();
        assert_eq!(files, listed);
        for kind in ALL {
            assert_eq!(serde_json::to_value(kind.mate_type).unwrap(), kind.name);
            assert!(std::ptr::eq(kind.mate_type.kind(), kind));
        }
    }

    #[test]
    fn a_block_on_a_plate() {
        // Plate top at z = 15, block bottom at z = 0 looking down. u = 10, v = -20, no spin.
        let base = port(
            PortType::FlatFace,
            Frame::new([0.0, 0.0, 15.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]).unwrap(),
        );
        let incoming = port(
            PortType::FlatFace,
            Frame::new([0.0; 3], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]).unwrap(),
        );
        let kind = MateType::FaceToFace.kind();
        let o = options(
            MateType::FaceToFace,
            json!({"u_mm": 10, "v_mm": -20, "d_n_mm": 0.5}),
        );
        let t = kind
            .place_incoming(&Placement::IDENTITY, &base, &incoming, &o)
            .unwrap();
        // The block stands upright, its bottom half a millimetre above the plate, exactly.
        assert_eq!(t, Placement::translation(10.0, -20.0, 15.5));
        let spun = options(MateType::FaceToFace, json!({"alpha_deg": 90}));
        let t = kind
            .place_incoming(&Placement::IDENTITY, &base, &incoming, &spun)
            .unwrap();
        // alpha turns right-handed about the incoming face's outward normal (here -Z).
        assert_eq!(
            t,
            Placement::translation(0.0, 0.0, 15.0) * Placement::rotation_z(-90.0)
        );
    }

    #[test]
    fn a_shaft_in_a_bore() {
        // Bore along -Y from its mouth at y = 20, z = 40; shaft along Z.
        let bore = port(
            PortType::Bore,
            Frame::new([0.0, 20.0, 40.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]).unwrap(),
        );
        let shaft = port(PortType::Shaft, Frame::WORLD);
        let kind = MateType::Coaxial.kind();
        for (given, end) in [
            (json!({"d_mm": -20}), [0.0, -1.0, 40.0]),
            (json!({"d_mm": -20, "direction": "same"}), [0.0, 1.0, 40.0]),
        ] {
            let o = options(MateType::Coaxial, given);
            let t = kind
                .place_incoming(&Placement::IDENTITY, &bore, &shaft, &o)
                .unwrap();
            assert_eq!(t.point([0.0, 0.0, 0.0]), [0.0, 0.0, 40.0]);
            assert_eq!(t.point([0.0, 0.0, 1.0]), end);
        }
    }

    fn any_frame() -> impl Strategy<Value = Frame> {
        let n = prop::array::uniform3(-1.0..1.0f64);
        (prop::array::uniform3(-500.0..500.0f64), n.clone(), n).prop_filter_map(
            "degenerate",
            |(o, z, s)| {
                let (z, s) = (nalgebra::Vector3::from(z), nalgebra::Vector3::from(s));
                let x = z.cross(&s);
                (x.norm() > 0.1).then(|| Frame::new(o, z.into(), x.into()).ok())?
            },
        )
    }

    fn given(t: MateType, a: f64, b: f64, c: f64, alpha: f64, same: bool) -> Map<String, Value> {
        let v = match t {
            MateType::FaceToFace => json!({"u_mm": a, "v_mm": b, "d_n_mm": c, "alpha_deg": alpha}),
            MateType::Coaxial => json!({
                "d_mm": c, "alpha_deg": alpha, "direction": if same { "same" } else { "opposed" }
            }),
        };
        v.as_object().unwrap().clone()
    }

    proptest! {
        #[test]
        fn a_placed_mate_holds_and_a_disturbed_one_tells_by_how_much(
            world in any_frame(), fb in any_frame(), fc in any_frame(),
            a in -50.0..50.0f64, b in -50.0..50.0f64, c in -50.0..50.0f64,
            alpha in -360.0..360.0f64, same in any::<bool>(), off in 0.01..10.0f64,
            tilt in 0.01..30.0f64,
        ) {
            for kind in ALL {
                let o = kind.check_options(&given(kind.mate_type, a, b, c, alpha, same), "").unwrap();
                let (base, incoming) = (port(PortType::Bore, fb), port(PortType::Shaft, fc));
                let at = world.placement().unwrap();
                let t = kind.place_incoming(&at, &base, &incoming, &o).unwrap();
                prop_assert!(t.orthonormality_error() < 1e-12);
                let r = kind.residual(&at, &base, &t, &incoming, &o).unwrap();
                prop_assert!(r.holds(), "{r:?}");
                // Placing the base from the incoming part leads back.
                let back = kind.place_base(&t, &base, &incoming, &o).unwrap();
                let p = [1.0, 2.0, 3.0];
                for (u, v) in back.point(p).iter().zip(at.point(p)) {
                    prop_assert!((u - v).abs() < 1e-9);
                }
                // A shift across what the mate constrains is found with its size.
                let lb = at * base.frame.placement().unwrap();
                let shift = match kind.mate_type {
                    MateType::FaceToFace => Placement::translation(3.0, -4.0, off),
                    MateType::Coaxial => Placement::translation(0.6 * off, 0.8 * off, 7.0),
                };
                let moved = lb * shift * lb.inverse() * t;
                let r = kind.residual(&at, &base, &moved, &incoming, &o).unwrap();
                prop_assert!((r.distance_mm - off).abs() < 1e-8 && r.angle_deg < 1e-6, "{r:?}");
                // So is a tilt.
                let lc = t * incoming.frame.placement().unwrap();
                let tilted = lc * Placement::rotation_x(tilt) * lc.inverse() * t;
                let r = kind.residual(&at, &base, &tilted, &incoming, &o).unwrap();
                prop_assert!((r.angle_deg - tilt).abs() < 1e-8, "{r:?}");
            }
        }
    }

    #[test]
    fn no_number_is_no_hold() {
        assert!(
            !Residual {
                distance_mm: f64::NAN,
                angle_deg: 0.0
            }
            .holds()
        );
    }
}
