//! Ports: typed, geometry-backed places at which parts are joined.
//!
//! One file per port type, each listing the parameters that such a port carries.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::frame::Frame;

mod bore;
mod flat_face;
mod press_fit;
mod shaft;

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
    /// A cylindrical hole that receives a shaft.
    Bore,
    /// A planar face.
    FlatFace,
    /// An outer cylinder that is pressed into a hole, such as a bearing's outer ring.
    PressFit,
    /// A cylinder that goes into a bore.
    Shaft,
}

/// What a port type is: its name, what it means and which parameters it carries.
#[derive(Debug)]
pub struct PortKind {
    /// The type.
    pub port_type: PortType,
    /// The type's name as it is written.
    pub name: &'static str,
    /// One line on what it is and where its frame sits.
    pub doc: &'static str,
    /// The parameters that every port of the type carries: name and meaning.
    pub params: &'static [(&'static str, &'static str)],
}

/// Every port type, sorted by name.
pub static ALL: [&PortKind; 4] = [
    &bore::KIND,
    &flat_face::KIND,
    &press_fit::KIND,
    &shaft::KIND,
];

impl PortType {
    /// The description of the type.
    #[must_use]
    pub fn kind(self) -> &'static PortKind {
        match self {
            Self::Bore => &bore::KIND,
            Self::FlatFace => &flat_face::KIND,
            Self::PressFit => &press_fit::KIND,
            Self::Shaft => &shaft::KIND,
        }
    }
}

impl core::fmt::Display for PortType {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.kind().name)
    }
}

impl Port {
    /// What keeps this port from being well formed: parameters that its type lacks or demands.
    #[must_use]
    pub fn faults(&self) -> Vec<String> {
        let kind = self.port_type.kind();
        let mut faults = Vec::new();
        for (name, doc) in kind.params {
            match self.params.get(*name) {
                None => faults.push(format!("a {} port needs '{name}' ({doc})", kind.name)),
                Some(v) if !(v.is_finite() && *v > 0.0) => {
                    faults.push(format!(
                        "'{name}' of a {} port is a positive number",
                        kind.name
                    ));
                }
                Some(_) => {}
            }
        }
        for name in self.params.keys() {
            if !kind.params.iter().any(|(known, _)| known == name) {
                faults.push(format!("a {} port has no '{name}'", kind.name));
            }
        }
        if let Err(e) = self.frame.placement() {
            faults.push(e.to_string());
        }
        faults
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
            .filter(|f| f != "mod.rs")
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
