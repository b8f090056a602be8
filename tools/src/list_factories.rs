//! `list_factories`.

use std::sync::Arc;

use assemcad_assembly::{Faults, Workshop};
use assemcad_factories::Factory;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Effect, Tool, Weight};

pub(crate) struct ListFactories;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Only factories whose name holds this text, such as 'bearing'. All where it is left out.
    #[serde(default)]
    name_contains: String,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The factories, sorted by name.
    factories: Vec<Entry>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct Entry {
    /// Name, for add_part and describe_factory.
    factory: String,
    /// What it makes.
    summary: String,
    /// Names of its parameters; all have defaults.
    params: Vec<String>,
}

impl Tool for ListFactories {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "list_factories";
    const TITLE: &'static str = "List part factories";
    const DESCRIPTION: &'static str = "Lists the factories that make parts, with one line and the \
        parameter names of each. Call it first, to see what an assembly can be made of. For ranges, \
        defaults and ports of one factory call describe_factory.";
    const EFFECT: Effect = Effect::Reads;
    const WEIGHT: Weight = Weight::Light;

    async fn run(workshop: &Workshop, arguments: Arguments) -> Result<Answer, Faults> {
        let wanted = workshop
            .registry
            .all()
            .into_iter()
            .filter(|f| f.name().contains(&arguments.name_contains));
        let entry = |factory: Arc<Factory>| Entry {
            factory: factory.name().to_owned(),
            summary: first_sentence(factory.doc()).to_owned(),
            params: factory.params().iter().map(|p| p.name.clone()).collect(),
        };
        Ok(Answer {
            factories: wanted.map(entry).collect(),
        })
    }
}

fn first_sentence(doc: &str) -> &str {
    let doc = doc.trim();
    doc.split_once(". ")
        .map_or(doc, |(first, _)| first)
        .trim_end_matches('.')
}
