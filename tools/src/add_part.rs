//! `add_part`.

use assemcad_assembly::edit::Change;
use assemcad_assembly::state::Summary;
use assemcad_assembly::{Faults, Workshop};
use assemcad_model::ports::PortType;
use assemcad_model::report::rounded;
use assemcad_model::spec::Part;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::{Effect, Tool, Weight};

pub(crate) struct AddPart;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// The part's name, unique in the assembly: letters, digits, '_' and '-', at most 64.
    part: String,
    /// Name of the factory, as list_factories gives it.
    factory: String,
    /// The factory's parameters (mm); its defaults fill in what is left out.
    #[serde(default)]
    params: Map<String, Value>,
    /// Whether it springs, as a retaining ring, a clip or a seal does: on its way in it may open or close.
    #[serde(default)]
    elastic: bool,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// False where the same part was there already.
    changed: bool,
    /// The part's name.
    part: String,
    /// Volume in mm3.
    volume_mm3: f64,
    /// Smallest corner of its box, in its own frame, in mm.
    box_min_mm: [f64; 3],
    /// Largest corner of its box, in its own frame, in mm.
    box_max_mm: [f64; 3],
    /// Its ports, for the mate tool.
    ports: Vec<PortShort>,
    /// The assembly now, in short.
    state: Summary,
}

#[derive(Debug, Serialize, JsonSchema)]
struct PortShort {
    /// Name.
    name: String,
    /// Type.
    #[serde(rename = "type")]
    port_type: PortType,
}

impl Tool for AddPart {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "add_part";
    const TITLE: &'static str = "Add a part";
    const DESCRIPTION: &'static str = "Adds a part to an assembly: a factory with parameters, under a \
        name that you choose. The solid is made and checked before the part is accepted. The first \
        part becomes the root and stands at the origin; every other part gets its place by the mate \
        tool. To change a part's parameters, remove it and add it again.";
    const EFFECT: Effect = Effect::Adds;
    const WEIGHT: Weight = Weight::Usual;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let part = Part {
            id: a.part,
            factory: a.factory,
            params: a.params,
            elastic: a.elastic,
            notes: String::new(),
        };
        let added = workshop.add_part(&a.assembly, part).await?;
        let short = |p: &assemcad_model::ports::Port| PortShort {
            name: p.name.clone(),
            port_type: p.port_type,
        };
        Ok(Answer {
            changed: added.change == Change::Made,
            part: added.part.id.clone(),
            volume_mm3: rounded(added.built.volume),
            box_min_mm: added.built.min.map(rounded),
            box_max_mm: added.built.max.map(rounded),
            ports: added.part.ports().iter().map(short).collect(),
            state: added.state.into(),
        })
    }
}
