//! `remove`.

use assemcad_assembly::state::Summary;
use assemcad_assembly::{Faults, Workshop};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool, Weight};

pub(crate) struct Remove;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// What is removed.
    kind: Kind,
    /// Its name.
    name: String,
}

#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Part,
    Mate,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The assembly now, in short.
    state: Summary,
}

impl Tool for Remove {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "remove";
    const TITLE: &'static str = "Remove a part or mate";
    const DESCRIPTION: &'static str = "Takes a part or a mate out of an assembly. A part can be \
        removed only when no mate uses it; the refusal names the mates that do. Use it to change a \
        part or a mate: remove it, then add it again.";
    const EFFECT: Effect = Effect::Removes;
    const WEIGHT: Weight = Weight::Usual;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let state = match a.kind {
            Kind::Part => workshop.remove_part(&a.assembly, &a.name).await?,
            Kind::Mate => workshop.remove_mate(&a.assembly, &a.name).await?,
        };
        Ok(Answer {
            state: state.into(),
        })
    }
}
