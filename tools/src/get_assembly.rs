//! `get_assembly`.

use assemcad_assembly::state::State;
use assemcad_assembly::{Faults, Workshop};
use assemcad_model::spec::Assembly;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::verify::Detail;
use crate::{Effect, Tool, Weight};

pub(crate) struct GetAssembly;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// How much is told; 'full' adds the whole specification, with all parameters and options.
    #[serde(default)]
    detail: Detail,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The assembly now.
    state: State,
    /// The specification; with detail 'full' only.
    #[serde(skip_serializing_if = "Option::is_none")]
    specification: Option<Assembly>,
}

impl Tool for GetAssembly {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "get_assembly";
    const TITLE: &'static str = "Get an assembly";
    const DESCRIPTION: &'static str = "Tells the state of an assembly: its parts with their places, \
        its mates, and which parts have no place yet. With detail 'full', its whole specification. \
        Use it to go on after a break; answers of the changing tools tell in short what there is.";
    const EFFECT: Effect = Effect::Reads;
    const WEIGHT: Weight = Weight::Usual;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let state = workshop.state(&a.assembly).await?;
        let specification = match a.detail {
            Detail::Concise => None,
            Detail::Full => Some(workshop.store.load(&a.assembly).map_err(|d| vec![d])?),
        };
        Ok(Answer {
            state,
            specification,
        })
    }
}
