//! `list_assemblies`.

use assemcad_assembly::{Faults, Workshop};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool, Weight};

pub(crate) struct ListAssemblies;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The names, sorted.
    assemblies: Vec<String>,
}

impl Tool for ListAssemblies {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "list_assemblies";
    const TITLE: &'static str = "List assemblies";
    const DESCRIPTION: &'static str = "Lists the names of the assemblies below the server's root \
        folder, those of earlier sessions included. For what is in one call get_assembly.";
    const EFFECT: Effect = Effect::Reads;
    const WEIGHT: Weight = Weight::Light;

    async fn run(workshop: &Workshop, Arguments {}: Arguments) -> Result<Answer, Faults> {
        Ok(Answer {
            assemblies: workshop.store.names().map_err(|d| vec![d])?,
        })
    }
}
