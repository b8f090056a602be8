//! What tools answer with.

use assemcad_assembly::Faults;
use schemars::JsonSchema;
use serde::Serialize;
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
