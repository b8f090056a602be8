//! `state_intent`.

use assemcad_assembly::edit::{Change, Intent};
use assemcad_assembly::state::Summary;
use assemcad_assembly::{Faults, Workshop};
use assemcad_model::spec::{Accepted, PartMotion};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool};

pub(crate) struct StateIntent;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// How many independent motions the finished machine is meant to have.
    #[serde(default)]
    intended_mobility: Option<u32>,
    /// The motions that it is meant to have, each by a part that makes it; replaces those stated before.
    #[serde(default)]
    #[schemars(length(max = 100))]
    intended_motions: Option<Vec<PartMotion>>,
    /// The parts that may lie loose, each with the motion that nothing has to stop; replaces those stated before.
    #[serde(default)]
    #[schemars(length(max = 100))]
    free: Option<Vec<PartMotion>>,
    /// The rules of experience that are broken knowingly, with parts and reason; replaces those stated before.
    #[serde(default)]
    #[schemars(length(max = 100))]
    accept: Option<Vec<Accepted>>,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// False where all was stated already.
    changed: bool,
    /// The assembly now, in short.
    state: Summary,
}

impl Tool for StateIntent {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "state_intent";
    const TITLE: &'static str = "State what is meant to move, lie loose or be accepted";
    const DESCRIPTION: &'static str = "States what parts and mates do not say: how many motions the machine is meant \
        to have and which parts make them, which parts may lie loose, and which rule of experience is broken \
        knowingly, with the reason. A motion that nobody states is a fault. What is left out stays as it was.";
    const EFFECT: Effect = Effect::Adds;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let intent = Intent {
            intended_mobility: a.intended_mobility,
            intended_motions: a.intended_motions,
            free: a.free,
            accept: a.accept,
        };
        let (change, state) = workshop.state_intent(&a.assembly, intent).await?;
        Ok(Answer {
            changed: change == Change::Made,
            state: state.into(),
        })
    }
}
