//! Ports: typed, geometry-backed places at which parts are joined.
//!
//! One file per port type: the parameters that such a port carries, and the geometric evidence that it
//! demands of the part's solid.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::frame::Frame;
use crate::probe::{Probe, Site};

mod bolt_seat;
mod bore;
mod cbore_seat;
mod clearance_hole;
mod flat_face;
pub(crate) mod gear_mesh;
mod hole;
mod press_fit;
mod shaft;
mod snap_fit;
mod thread_external;
mod thread_internal;
mod values;

pub use values::{Allowed, MOST_MM, PortParam, Values};
use values::{HAND, MODELLED, PITCH, depth, diameter, length, no_rule, thread_rule};

/// A port of a part, in the part's frame.
///
/// The frame's z points out of the material along the port's axis: a face's outward normal, a hole's
/// way out of its mouth, a shaft's way out of its end. x is stated, never derived.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Port {
    /// Name, unique within the part.
    pub name: String,
    /// Type.
    #[serde(rename = "type")]
    pub port_type: PortType,
    /// Where, in the part's frame.
    pub frame: Frame,
    /// The parameters that the type demands, in mm and degrees.
    pub params: BTreeMap<String, f64>,
}

/// The types of ports.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "SCREAMING_SNAKE_CASE")]
pub enum PortType {
    /// The plane ring on which a fastener sits.
    BoltSeat,
    /// A cylindrical hole that receives a shaft.
    Bore,
    /// The floor of a counterbore.
    CboreSeat,
    /// A through hole that a bolt passes with play.
    ClearanceHole,
    /// A plane face.
    FlatFace,
    /// The teeth of a gear.
    GearMesh,
    /// A plain cylindrical hole.
    Hole,
    /// An outer cylinder that is pressed into a hole, such as a bearing's outer ring.
    PressFit,
    /// A cylinder that goes into a bore.
    Shaft,
    /// The locking face of a snap hook or of its catch.
    SnapFit,
    /// A screw's thread.
    ThreadExternal,
    /// A threaded hole.
    ThreadInternal,
}

/// What a port type is: its name, what it means, which parameters it carries and what shows it.
#[derive(Debug)]
pub struct PortKind {
    /// The type.
    pub port_type: PortType,
    /// The type's name as it is written.
    pub name: &'static str,
    /// What it is and where its frame sits.
    pub doc: &'static str,
    /// The parameters that every port of the type carries.
    pub params: &'static [PortParam],
    /// What is wrong between parameters that are each in their range.
    rule: fn(&Values<'_>) -> Vec<String>,
    /// The geometric evidence of a port whose parameters are in order.
    evidence: fn(&Values<'_>, &Site) -> Vec<Probe>,
}

/// Every port type, sorted by name.
pub static ALL: [&PortKind; 12] = [
    &bolt_seat::KIND,
    &bore::KIND,
    &cbore_seat::KIND,
    &clearance_hole::KIND,
    &flat_face::KIND,
    &gear_mesh::KIND,
    &hole::KIND,
    &press_fit::KIND,
    &shaft::KIND,
    &snap_fit::KIND,
    &thread_external::KIND,
    &thread_internal::KIND,
];

impl PortType {
    /// The description of the type.
    #[must_use]
    pub fn kind(self) -> &'static PortKind {
        match self {
            Self::BoltSeat => &bolt_seat::KIND,
            Self::Bore => &bore::KIND,
            Self::CboreSeat => &cbore_seat::KIND,
            Self::ClearanceHole => &clearance_hole::KIND,
            Self::FlatFace => &flat_face::KIND,
            Self::GearMesh => &gear_mesh::KIND,
            Self::Hole => &hole::KIND,
            Self::PressFit => &press_fit::KIND,
            Self::Shaft => &shaft::KIND,
            Self::SnapFit => &snap_fit::KIND,
            Self::ThreadExternal => &thread_external::KIND,
            Self::ThreadInternal => &thread_internal::KIND,
        }
    }
}

impl PortKind {
    /// The first sentence of what it is.
    #[must_use]
    pub fn summary(&self) -> &'static str {
        let first = self.doc.split(". ").next().unwrap_or_default();
        first.trim_end_matches('.')
    }
}

impl core::fmt::Display for PortType {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.kind().name)
    }
}

impl Port {
    /// The value of a parameter, or its default where the type has one; NaN where there is neither.
    #[must_use]
    pub fn value(&self, name: &str) -> f64 {
        Values::of(self).get(name)
    }

    /// What keeps this port from being well formed: parameters that its type lacks or demands.
    #[must_use]
    pub fn faults(&self) -> Vec<String> {
        let kind = self.port_type.kind();
        let mut faults = Vec::new();
        for p in kind.params {
            match self.params.get(p.name) {
                None if p.optional.is_some() => {}
                None => faults.push(format!(
                    "a {} port needs '{}' ({})",
                    kind.name, p.name, p.doc
                )),
                Some(v) if !p.allowed.allows(*v) => faults.push(format!(
                    "'{}' of a {} port is {}, not {v}",
                    p.name,
                    kind.name,
                    p.expected()
                )),
                Some(_) => {}
            }
        }
        for name in self.params.keys() {
            if !kind.params.iter().any(|p| p.name == name) {
                faults.push(format!("a {} port has no '{name}'", kind.name));
            }
        }
        if faults.is_empty() {
            faults.extend((kind.rule)(&Values::of(self)));
        }
        if let Err(e) = self.frame.placement() {
            faults.push(e.to_string());
        }
        faults
    }

    /// What the part's solid must show where this port is, in the part's frame.
    ///
    /// # Errors
    /// The port's [`Port::faults`]: a port that is not well formed has no evidence.
    pub fn evidence(&self) -> Result<Vec<Probe>, Vec<String>> {
        let faults = self.faults();
        match self.frame.placement() {
            Ok(at) if faults.is_empty() => Ok((self.port_type.kind().evidence)(
                &Values::of(self),
                &Site::new(at),
            )),
            _ => Err(faults),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{ALL, Port, PortType};
    use crate::frame::Frame;
    use std::collections::BTreeMap;

    #[test]
    fn every_file_is_listed_once_and_in_order() {
        let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src/ports")).unwrap();
        let mut files: Vec<String> = files
            .map(|f| f.unwrap().file_name().into_string().unwrap())
            .filter(|f| f != "mod.rs" && f != "values.rs")
            .map(|f| f.trim_end_matches(".rs").to_uppercase())
            .collect();
        files.sort();
        let listed: Vec<&str> = ALL.iter().map(|k| k.name).collect();
        assert_eq!(files, listed);
        for kind in ALL {
            assert_eq!(serde_json::to_value(kind.port_type).unwrap(), kind.name);
            assert!(std::ptr::eq(kind.port_type.kind(), kind));
        }
    }

    #[test]
    fn a_bore_without_its_diameter_is_at_fault() {
        let mut port = Port {
            name: "bore".to_owned(),
            port_type: PortType::Bore,
            frame: Frame::WORLD,
            params: BTreeMap::from([("diameter".to_owned(), 8.0), ("depth".to_owned(), 20.0)]),
        };
        assert_eq!(port.faults(), Vec::<String>::new());
        port.params.remove("diameter");
        port.params.insert("module".to_owned(), 1.0);
        port.frame.x = [0.0, 0.0, 1.0];
        assert_eq!(port.faults().len(), 3, "{:?}", port.faults());
    }
}
