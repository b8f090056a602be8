//! Declarations of parameters as they go over the socket.
//!
//! [`ParamSpec`] is written for readers of JSON, with its type among its fields; serde cannot read
//! numbers back from such a form. Here the type stands outside.

use assemcad_model::param::{ParamKind, ParamSpec};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::factory::Factory;

/// What a factory's source declares.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Declared {
    doc: String,
    params: Vec<Spec>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct Spec {
    name: String,
    doc: String,
    kind: Kind,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Number {
        unit: String,
        min: f64,
        max: f64,
        default: f64,
    },
    Integer {
        min: i64,
        max: i64,
        default: i64,
    },
    Choice {
        choices: Vec<String>,
        default: String,
    },
    Flag {
        default: bool,
    },
    Records {
        fields: Vec<Spec>,
        min_items: usize,
        max_items: usize,
        default: Vec<Value>,
    },
}

impl Declared {
    pub(super) fn of(factory: &Factory) -> Self {
        Self {
            doc: factory.doc().to_owned(),
            params: factory.params().iter().map(Spec::of).collect(),
        }
    }

    /// The factory of a source that declares this.
    pub(super) fn factory(self, name: &str, source: &str) -> Factory {
        let params = self.params.into_iter().map(Spec::spec).collect();
        Factory::declared(name, source, self.doc, params)
    }
}

impl Spec {
    fn of(spec: &ParamSpec) -> Self {
        let kind = match spec.kind.clone() {
            ParamKind::Number {
                unit,
                min,
                max,
                default,
            } => Kind::Number {
                unit,
                min,
                max,
                default,
            },
            ParamKind::Integer { min, max, default } => Kind::Integer { min, max, default },
            ParamKind::Choice { choices, default } => Kind::Choice { choices, default },
            ParamKind::Flag { default } => Kind::Flag { default },
            ParamKind::Records {
                fields,
                min_items,
                max_items,
                default,
            } => Kind::Records {
                fields: fields.iter().map(Self::of).collect(),
                min_items,
                max_items,
                default,
            },
        };
        Self {
            name: spec.name.clone(),
            doc: spec.doc.clone(),
            kind,
        }
    }

    fn spec(self) -> ParamSpec {
        let kind = match self.kind {
            Kind::Number {
                unit,
                min,
                max,
                default,
            } => ParamKind::Number {
                unit,
                min,
                max,
                default,
            },
            Kind::Integer { min, max, default } => ParamKind::Integer { min, max, default },
            Kind::Choice { choices, default } => ParamKind::Choice { choices, default },
            Kind::Flag { default } => ParamKind::Flag { default },
            Kind::Records {
                fields,
                min_items,
                max_items,
                default,
            } => ParamKind::Records {
                fields: fields.into_iter().map(Self::spec).collect(),
                min_items,
                max_items,
                default,
            },
        };
        ParamSpec {
            name: self.name,
            doc: self.doc,
            kind,
        }
    }
}
