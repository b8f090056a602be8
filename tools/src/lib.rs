//! The tools that agents call: one file each, with its arguments, its answer and its handler.
//!
//! A tool knows nothing of the protocol that carries it. Its schemas come from its Rust types; its
//! arguments are checked against them before it runs, so that every fault is told in one shape.

use assemcad_assembly::{Faults, Workshop};
use assemcad_model::told;
use futures::future::BoxFuture;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

mod add_part;
mod answer;
mod arguments;
mod describe_factory;
mod export_step;
mod find_axioms;
mod get_assembly;
mod list_assemblies;
mod list_factories;
mod mate;
mod measure;
mod new_assembly;
pub mod prompts;
mod realize;
mod remove;
mod render;
mod schema;
mod state_intent;
mod sweep;
mod synthesize_factory;
mod validate_draft;
mod verify;

use answer::Answer;
pub use answer::Output;

/// A model that writes when it is asked to: the client's own, where the client offers it.
pub trait Writer: Send + Sync {
    /// What it writes for a prompt.
    ///
    /// # Errors
    /// Why it wrote nothing.
    fn write(&self, prompt: String) -> BoxFuture<'_, Result<String, String>>;
}

/// Who called, and what it offers meanwhile.
#[derive(Clone, Copy, Default)]
pub struct Caller<'a> {
    /// A model that writes.
    pub writer: Option<&'a dyn Writer>,
    /// Who is told how far the call has come, in a few words.
    pub progress: Option<&'a (dyn Fn(&str) + Send + Sync)>,
}

impl Caller<'_> {
    fn tell(&self, words: &str) {
        if let Some(progress) = self.progress {
            progress(words);
        }
    }
}

/// One tool.
trait Tool: 'static {
    /// Its arguments, a flat object.
    type Arguments: DeserializeOwned + JsonSchema + Send;
    /// Its answer: an object, or a picture.
    type Answer: Answer + Send;
    /// Verb and noun in snake case, at most 32 characters.
    const NAME: &'static str;
    /// For people: a few words.
    const TITLE: &'static str;
    /// For models: the point first, and when not to use it; at most 600 characters.
    const DESCRIPTION: &'static str;
    /// What it does to the assemblies.
    const EFFECT: Effect;
    /// How much work it is.
    const WEIGHT: Weight = Weight::Heavy;

    /// Does it.
    fn run(
        workshop: &Workshop,
        arguments: Self::Arguments,
    ) -> impl Future<Output = Result<Self::Answer, Faults>> + Send;

    /// Does it with what the caller offers.
    fn run_with(
        workshop: &Workshop,
        arguments: Self::Arguments,
        _caller: &Caller<'_>,
    ) -> impl Future<Output = Result<Self::Answer, Faults>> + Send {
        Self::run(workshop, arguments)
    }
}

/// What a tool does to the assemblies. All tools may be called twice with the same effect as once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effect {
    /// Nothing is changed.
    Reads,
    /// Something is added; nothing is lost.
    Adds,
    /// Something is removed or replaced.
    Removes,
}

/// How much work a call is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weight {
    /// Something is looked up: it waits for nobody.
    Light,
    /// A few questions to the kernel.
    Usual,
    /// Work on whole assemblies, pictures and trials: seconds, and hundreds of megabytes, so that only a few run
    /// at once.
    Heavy,
}

type Handler = for<'a> fn(&'a Workshop, Value, Caller<'a>) -> BoxFuture<'a, Result<Output, Faults>>;

/// A tool as a server offers it.
#[derive(Debug)]
pub struct Offer {
    /// Name.
    pub name: &'static str,
    /// For people.
    pub title: &'static str,
    /// For models.
    pub description: &'static str,
    /// What it does to the assemblies.
    pub effect: Effect,
    /// How much work it is.
    pub weight: Weight,
    /// JSON Schema of the arguments; an object at the root.
    pub input_schema: Map<String, Value>,
    /// JSON Schema of the answer, an object at the root; none where the answer is a picture.
    pub output_schema: Option<Map<String, Value>>,
    validator: Option<jsonschema::Validator>,
    handler: Handler,
}

impl Offer {
    fn of<T: Tool>() -> Self {
        let input_schema = schema::input::<T::Arguments>();
        Self {
            name: T::NAME,
            title: T::TITLE,
            description: T::DESCRIPTION,
            effect: T::EFFECT,
            weight: T::WEIGHT,
            validator: jsonschema::validator_for(&Value::Object(input_schema.clone())).ok(),
            input_schema,
            output_schema: T::Answer::schema(),
            handler: |workshop, arguments, caller| {
                Box::pin(async move {
                    let arguments = serde_json::from_value(arguments)
                        .map_err(|_| vec![arguments::unreadable(T::NAME)])?;
                    let answer = T::run_with(workshop, arguments, &caller).await?;
                    answer.output(T::NAME)
                })
            },
        }
    }

    /// Checks the arguments and runs the tool.
    ///
    /// # Errors
    /// Everything that is wrong with the arguments, or else with what they ask for.
    pub async fn call(
        &self,
        workshop: &Workshop,
        mut given: Map<String, Value>,
        caller: Caller<'_>,
    ) -> Result<Output, Faults> {
        // Models write null for what they leave out.
        given.retain(|_, value| !value.is_null());
        let given = Value::Object(given);
        let Some(validator) = &self.validator else {
            return Err(vec![arguments::unreadable(self.name)]);
        };
        arguments::check(validator, &self.input_schema, &given).map_err(told::first_of)?;
        // Another server over the same folder, or an editor, may have written there since the last call.
        for fault in workshop.load_admitted().await {
            tracing::warn!("{fault}");
        }
        let done = (self.handler)(workshop, given, caller).await;
        let done = done.map(answer::short).map_err(told::first_of);
        let counts = workshop.door.counts();
        tracing::info!(
            "geometry: asked={} computed={} kernel_calls={} recalled={}",
            counts.asked,
            counts.computed,
            counts.kernel_calls,
            counts.recalled
        );
        done
    }
}

/// Every tool, sorted by name.
#[must_use]
pub fn all() -> Vec<Offer> {
    vec![
        Offer::of::<add_part::AddPart>(),
        Offer::of::<describe_factory::DescribeFactory>(),
        Offer::of::<export_step::ExportStep>(),
        Offer::of::<find_axioms::FindAxioms>(),
        Offer::of::<get_assembly::GetAssembly>(),
        Offer::of::<list_assemblies::ListAssemblies>(),
        Offer::of::<list_factories::ListFactories>(),
        Offer::of::<mate::MakeMate>(),
        Offer::of::<measure::Measure>(),
        Offer::of::<new_assembly::NewAssembly>(),
        Offer::of::<realize::Realize>(),
        Offer::of::<remove::Remove>(),
        Offer::of::<render::Render>(),
        Offer::of::<state_intent::StateIntent>(),
        Offer::of::<sweep::SweepMotion>(),
        Offer::of::<synthesize_factory::SynthesizeFactory>(),
        Offer::of::<validate_draft::ValidateDraft>(),
        Offer::of::<verify::Verify>(),
    ]
}

#[cfg(test)]
mod tests {
    use super::{Effect, all};
    use serde_json::Value;

    #[test]
    fn every_file_is_a_tool_that_is_listed() {
        let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/src")).unwrap();
        let mut files: Vec<String> = files
            .map(|f| f.unwrap().file_name().into_string().unwrap())
            .map(|f| f.trim_end_matches(".rs").to_owned())
            .filter(|f| !["lib", "answer", "arguments", "prompts", "schema"].contains(&f.as_str()))
            .collect();
        files.sort();
        let listed: Vec<&str> = all().iter().map(|t| t.name).collect();
        assert_eq!(files, listed);
    }

    #[test]
    fn every_tool_is_fit_for_clients() {
        for tool in all() {
            let name = tool.name;
            assert!(name.len() <= 32 && name.chars().all(|c| c.is_ascii_lowercase() || c == '_'));
            assert!(
                tool.description.len() <= 600,
                "{name}: {}",
                tool.description.len()
            );
            assert!(tool.validator.is_some(), "{name}");
            for schema in core::iter::once(&tool.input_schema).chain(&tool.output_schema) {
                assert_eq!(schema["type"], "object", "{name}");
                for key in ["oneOf", "anyOf", "allOf", "$ref", "$defs"] {
                    assert!(!schema.contains_key(key), "{name} has {key} at the root");
                }
            }
            assert_eq!(tool.input_schema["additionalProperties"], false, "{name}");
            for (field, schema) in tool
                .input_schema
                .get("properties")
                .and_then(Value::as_object)
                .into_iter()
                .flatten()
            {
                assert!(
                    schema.get("description").is_some(),
                    "{name}.{field} has no description"
                );
            }
            // Clients that find a schema want structured content, and show nothing else.
            assert_eq!(tool.output_schema.is_none(), name == "render");
            assert!(tool.effect != Effect::Removes || ["realize", "remove"].contains(&name));
        }
    }
}
