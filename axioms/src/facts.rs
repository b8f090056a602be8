//! What checks read: plain data about an assembly, filled in as far as they are known.

use assemcad_model::frame::{Frame, Placement};
use assemcad_model::mates::MateType;
use assemcad_model::ports::{Port, PortType};
use assemcad_model::spec::End;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::class::Class;
pub use crate::measured::{
    Geometry, JointMotion, MateContact, Measured, Mobility, PairOverlap, Reach, Redundant, Stop,
    Thrust, TipSeat, Unseen, Wall, Way, Ways,
};

/// Everything that is known of an assembly.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Facts {
    /// The part that stands still.
    #[serde(default)]
    pub root: Option<String>,
    /// The parts, in the order of the specification.
    #[serde(default)]
    pub parts: Vec<PartFacts>,
    /// The mates, in the order of the specification.
    #[serde(default)]
    pub mates: Vec<MateFacts>,
    /// How many independent motions are meant; none where it is not stated.
    #[serde(default)]
    pub intended_mobility: Option<u32>,
    /// The parts of which a motion is stated as meant.
    #[serde(default)]
    pub meant_to_move: Vec<String>,
    /// What the analysis of motion found; none where there was none.
    #[serde(default)]
    pub mobility: Option<Mobility>,
    /// What was measured between solids.
    #[serde(default)]
    pub measured: Measured,
}

/// A part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartFacts {
    /// Name.
    pub id: String,
    /// Name of the factory.
    pub factory: String,
    /// The class, where something better than the factory's name tells it.
    #[serde(default)]
    pub class: Option<Class>,
    /// The parameters, with defaults filled in.
    #[serde(default)]
    pub params: Map<String, Value>,
    /// Whether it is stated to spring on its way in.
    #[serde(default)]
    pub elastic: bool,
    /// The ports, in the part's frame.
    #[serde(default)]
    pub ports: Vec<Port>,
    /// Where it is, if it has a place.
    #[serde(default)]
    pub placement: Option<Placement>,
    /// The material, where it is stated.
    #[serde(default)]
    pub material: Option<Material>,
    /// What was measured of its solid.
    #[serde(default)]
    pub geometry: Option<Geometry>,
}

/// Families of materials, as far as the checks tell them apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Material {
    /// Aluminium alloys.
    Aluminium,
    /// Cast iron.
    CastIron,
    /// Steel.
    Steel,
}

/// A mate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MateFacts {
    /// Name.
    pub id: String,
    /// Type.
    pub mate_type: MateType,
    /// The port that stays.
    pub base: End,
    /// The port whose part is brought in.
    pub incoming: End,
    /// The options; the mate type's defaults stand for those that are left out.
    #[serde(default)]
    pub options: Map<String, Value>,
    /// The axioms that it cites.
    #[serde(default)]
    pub axioms: Vec<String>,
    /// Whether it is accepted, with a reason, that it takes freedoms again.
    #[serde(default)]
    pub reason_stated: bool,
}

/// One end of a mate, resolved.
#[derive(Debug, Clone, Copy)]
pub struct Side<'a> {
    /// The part.
    pub part: &'a PartFacts,
    /// The port.
    pub port: &'a Port,
}

impl PartFacts {
    /// The class: the stated one, or that of the factory.
    #[must_use]
    pub fn class(&self) -> Class {
        self.class
            .unwrap_or_else(|| Class::of_factory(&self.factory))
    }

    /// The port of a name.
    #[must_use]
    pub fn port(&self, name: &str) -> Option<&Port> {
        self.ports.iter().find(|p| p.name == name)
    }

    /// A port's frame in the world, where the part has a place.
    #[must_use]
    pub fn world(&self, port: &Port) -> Option<Placement> {
        Some(self.placement? * port.frame.placement().ok()?)
    }

    /// The ports with their frames in the world, where the part has a place.
    #[must_use]
    pub fn placed_ports(&self) -> Vec<(&Port, Frame)> {
        let Some(at) = self.placement else {
            return Vec::new();
        };
        self.ports.iter().map(|p| (p, at.frame(&p.frame))).collect()
    }
}

impl<'a> Side<'a> {
    /// The port's frame in the world.
    #[must_use]
    pub fn world(&self) -> Option<Placement> {
        self.part.world(self.port)
    }

    /// The other frame seen from this one.
    #[must_use]
    pub fn sees(&self, other: &Side<'_>) -> Option<Placement> {
        Some(self.world()?.inverse() * other.world()?)
    }

    /// Whether the port is of a type.
    #[must_use]
    pub fn is(&self, port_type: PortType) -> bool {
        self.port.port_type == port_type
    }
}

impl MateFacts {
    /// A number among the options; none where it is left out.
    #[must_use]
    pub fn option(&self, name: &str) -> Option<f64> {
        self.options.get(name).and_then(Value::as_f64)
    }

    /// A number among the options whose default is 0.
    #[must_use]
    pub fn number(&self, name: &str) -> f64 {
        self.option(name).unwrap_or(0.0)
    }

    /// Whether a flag is set.
    #[must_use]
    pub fn flag(&self, name: &str) -> bool {
        let value = self.options.get(name);
        value.and_then(Value::as_bool).unwrap_or_default()
    }

    /// Whether it joins a part.
    #[must_use]
    pub fn has(&self, part: &str) -> bool {
        self.base.part == part || self.incoming.part == part
    }

    /// Whether it cites an axiom.
    #[must_use]
    pub fn cites(&self, axiom: &str) -> bool {
        self.axioms.iter().any(|a| a == axiom)
    }
}

impl Facts {
    /// The part of a name.
    #[must_use]
    pub fn part(&self, id: &str) -> Option<&PartFacts> {
        self.parts.iter().find(|p| p.id == id)
    }

    /// The name of the part that stands still: the stated one, or the first.
    #[must_use]
    pub fn root(&self) -> Option<&str> {
        self.root
            .as_deref()
            .or_else(|| self.parts.first().map(|p| p.id.as_str()))
    }

    /// The mates of a part.
    pub fn mates_of<'a>(&'a self, part: &'a str) -> impl Iterator<Item = &'a MateFacts> {
        self.mates.iter().filter(move |m| m.has(part))
    }

    /// One end, where its part and port exist.
    #[must_use]
    pub fn side(&self, end: &End) -> Option<Side<'_>> {
        let part = self.part(&end.part)?;
        let port = part.port(&end.port)?;
        Some(Side { part, port })
    }

    /// Base and incoming end, where their parts and ports exist.
    #[must_use]
    pub fn sides(&self, mate: &MateFacts) -> Option<(Side<'_>, Side<'_>)> {
        Some((self.side(&mate.base)?, self.side(&mate.incoming)?))
    }

    /// The ends of a mate, that of a part first.
    #[must_use]
    pub fn seen_from(&self, part: &str, mate: &MateFacts) -> Option<(Side<'_>, Side<'_>)> {
        let (base, incoming) = self.sides(mate)?;
        Some(if base.part.id == part {
            (base, incoming)
        } else {
            (incoming, base)
        })
    }
}
