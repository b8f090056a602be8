//! `describe_factory`.

use assemcad_assembly::{Faults, Workshop};
use assemcad_model::frame::Frame;
use assemcad_model::mates;
use assemcad_model::ports::{Port, PortType};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::{Effect, Tool, Weight};

pub(crate) struct DescribeFactory;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the factory, as list_factories gives it.
    factory: String,
    /// Parameters at which the ports are told; the defaults for what is left out.
    #[serde(default)]
    params: Map<String, Value>,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// Name.
    factory: String,
    /// What it makes, and how its frame lies.
    doc: String,
    /// JSON Schema of its parameters: types, ranges, defaults, units.
    params_schema: Map<String, Value>,
    /// The ports of the part at the given parameters, in the part's frame.
    ports: Vec<PortAnswer>,
    /// SHA-256 of the factory's source.
    source_sha256: String,
}

/// A port, in the part's frame.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PortAnswer {
    /// Name.
    name: String,
    /// Type.
    #[serde(rename = "type")]
    port_type: PortType,
    /// Origin in mm, x and z direction.
    frame: Frame,
    /// Parameters of the port, in mm and degrees.
    params: Map<String, Value>,
    /// The mate types that can use it, and the port types at their other end.
    mates_with: Vec<String>,
}

impl From<&Port> for PortAnswer {
    fn from(port: &Port) -> Self {
        let mut mates_with = Vec::new();
        for kind in mates::ALL {
            let mut others: Vec<PortType> = Vec::new();
            for (base, incoming) in kind.pairs {
                if *base == port.port_type && !others.contains(incoming) {
                    others.push(*incoming);
                }
                if *incoming == port.port_type && !others.contains(base) {
                    others.push(*base);
                }
            }
            others.sort();
            let others: Vec<&str> = others.iter().map(|t| t.kind().name).collect();
            if !others.is_empty() {
                mates_with.push(format!("{} with {}", kind.name, others.join(", ")));
            }
        }
        Self {
            name: port.name.clone(),
            port_type: port.port_type,
            frame: port.frame,
            params: port
                .params
                .iter()
                .map(|(k, v)| (k.clone(), Value::from(*v)))
                .collect(),
            mates_with,
        }
    }
}

impl Tool for DescribeFactory {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "describe_factory";
    const TITLE: &'static str = "Describe a part factory";
    const DESCRIPTION: &'static str = "Tells one factory's parameters (types, ranges, defaults) and \
        the ports of the part that it makes: name, type, frame, size and what each can be mated \
        with. Call it before add_part. Give params to see the ports of a part of those sizes.";
    const EFFECT: Effect = Effect::Reads;
    const WEIGHT: Weight = Weight::Usual;

    async fn run(workshop: &Workshop, arguments: Arguments) -> Result<Answer, Faults> {
        let factory = workshop
            .registry
            .get(&arguments.factory)
            .map_err(|d| vec![*d])?;
        let made = workshop
            .make(&arguments.factory, &arguments.params, None)
            .await?;
        Ok(Answer {
            factory: factory.name().to_owned(),
            doc: factory.doc().to_owned(),
            params_schema: factory.schema().as_object().cloned().unwrap_or_default(),
            ports: made.ports.iter().map(PortAnswer::from).collect(),
            source_sha256: factory.source_sha256(),
        })
    }
}
