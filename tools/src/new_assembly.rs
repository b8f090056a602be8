//! `new_assembly`.

use assemcad_assembly::edit::Change;
use assemcad_assembly::state::Summary;
use assemcad_assembly::{Faults, Workshop};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool, Weight};

pub(crate) struct NewAssembly;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// The name that all other calls then use: letters, digits, '_' and '-', at most 64.
    assembly: String,
    /// What it is, in free text.
    #[serde(default)]
    #[schemars(length(max = 4000))]
    description: String,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// False where the assembly was there already.
    changed: bool,
    /// The assembly now, in short.
    state: Summary,
}

impl Tool for NewAssembly {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "new_assembly";
    const TITLE: &'static str = "Make a new assembly";
    const DESCRIPTION: &'static str = "Makes an assembly without parts, under a name that you choose \
        and that every later call gives. The first part added becomes its root: it stands still at \
        the origin and carries the others. To go on with one from before, call get_assembly.";
    const EFFECT: Effect = Effect::Adds;
    const WEIGHT: Weight = Weight::Usual;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let (change, state) = workshop.new_assembly(&a.assembly, &a.description).await?;
        Ok(Answer {
            changed: change == Change::Made,
            state: state.into(),
        })
    }
}
