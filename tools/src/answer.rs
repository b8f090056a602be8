//! What tools answer with.

use assemcad_assembly::Faults;
use assemcad_model::told;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::{arguments, schema};

/// A tool's answer on its way to the protocol.
#[derive(Debug, Clone, PartialEq)]
pub enum Output {
    /// An object that holds everything.
    Object(Value),
    /// A picture and the words beside it. Clients that see an object show nothing but it, so there is none.
    Picture(Picture),
}

/// A picture and the words beside it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// What it shows.
    pub caption: String,
    /// The PNG file.
    pub png: Vec<u8>,
}

/// An answer all of whose lists of diagnostics are short, and say how many more there were.
pub(crate) fn short(output: Output) -> Output {
    match output {
        Output::Object(mut answer) => {
            shorten(&mut answer);
            Output::Object(answer)
        }
        picture @ Output::Picture(_) => picture,
    }
}

fn shorten(answer: &mut Value) {
    match answer {
        Value::Object(fields) => {
            for (name, value) in fields {
                // A specification may have fields of any name; what is no list of diagnostics stays as it is.
                let list = name == "diagnostics" || name == "warnings";
                let long = value
                    .as_array()
                    .is_some_and(|all| all.len() > told::MOST_TOLD + 1);
                if list
                    && long
                    && let Ok(all) = Faults::deserialize(&*value)
                    && let Ok(first) = serde_json::to_value(told::first_of(all))
                {
                    *value = first;
                } else {
                    shorten(value);
                }
            }
        }
        Value::Array(items) => items.iter_mut().for_each(shorten),
        _ => {}
    }
}

/// What a tool may answer with.
pub(crate) trait Answer {
    /// The JSON Schema of the object, where it is one.
    fn schema() -> Option<Map<String, Value>>;

    /// The answer for the protocol; `tool` is named where it cannot be written.
    fn output(self, tool: &str) -> Result<Output, Faults>;
}

impl<T: Serialize + JsonSchema> Answer for T {
    fn schema() -> Option<Map<String, Value>> {
        Some(schema::output::<T>())
    }

    fn output(self, tool: &str) -> Result<Output, Faults> {
        serde_json::to_value(self)
            .map(Output::Object)
            .map_err(|_| vec![arguments::unwritable(tool)])
    }
}

impl Answer for Picture {
    fn schema() -> Option<Map<String, Value>> {
        None
    }

    fn output(self, _tool: &str) -> Result<Output, Faults> {
        Ok(Output::Picture(self))
    }
}
