//! What a caller asks of a factory that is not there yet.

use std::collections::BTreeMap;

use assemcad_model::canonical::{self, sha256};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name;
use assemcad_model::param::{ParamKind, ParamSpec, clip};
use assemcad_model::ports::PortType;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

/// The longest description, in characters.
const MOST_DESCRIPTION: usize = 4000;

/// The most expected ports, and the most parameters.
const MOST_ITEMS: usize = 64;

/// What the factory is to make, with which ports, and what can be varied.
///
/// Its hash names it: the same request has the same answer for ever.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// What the part is, in words.
    pub description: String,
    /// The ports that the part has at every set of parameters.
    pub expected_ports: Vec<ExpectedPort>,
    /// What the caller wants to vary.
    pub params: Vec<AskedParam>,
}

/// A port that the part must have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExpectedPort {
    /// Name.
    pub name: String,
    /// Type.
    #[serde(rename = "type")]
    pub port_type: PortType,
    /// Its parameters (mm, degrees), as far as they matter: a number that holds at every set of
    /// parameters, or an expression over the factory's parameters such as "2 * wall + bore_d".
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    #[schemars(schema_with = "wanted_schema")]
    pub params: BTreeMap<String, Value>,
}

fn wanted_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({
        "type": "object", "additionalProperties": {"type": ["number", "string"]},
    })
}

/// A parameter that the factory must have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AskedParam {
    /// Name: lower-case letters, digits and '_', the first a letter.
    pub name: String,
    /// What values it takes.
    #[serde(default)]
    pub kind: AskedKind,
    /// The value where none is given: a number, a word or true/false, as the kind has it.
    #[schemars(schema_with = "default_schema")]
    pub default: Value,
    /// Smallest value, of numbers and whole numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Largest value, of numbers and whole numbers.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
    /// The words of a choice.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<String>,
    /// 'mm', 'deg', 'N', or empty for a ratio.
    #[serde(default = "mm")]
    pub unit: String,
    /// What it means.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub doc: String,
}

fn mm() -> String {
    "mm".to_owned()
}

fn default_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({
        "type": ["number", "string", "boolean"],
        "description": "The value where none is given: a number, a word or true/false, as the kind has it.",
    })
}

/// The kinds of parameters that can be asked for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AskedKind {
    /// A real number from min to max.
    #[default]
    Number,
    /// A whole number from min to max.
    Integer,
    /// One of the choices.
    Choice,
    /// True or false.
    Flag,
}

impl Request {
    /// The request's name: SHA-256 over description, expected ports and parameters, each in its
    /// canonical form and led by its length, so that nothing of one can pass for the other. The order
    /// of ports and parameters does not count.
    #[must_use]
    pub fn hash(&self) -> String {
        let mut ports: Vec<_> = self.expected_ports.clone();
        ports.sort_by(|a, b| a.name.cmp(&b.name));
        let mut params: Vec<_> = self.params.clone();
        params.sort_by(|a, b| a.name.cmp(&b.name));
        let mut bytes = b"assemcad factory request 1\n".to_vec();
        let parts = [
            self.description.trim().as_bytes().to_vec(),
            // Numbers were checked to be finite when they were read: there is nothing else that fails.
            canonical::to_bytes(&ports).unwrap_or_default(),
            canonical::to_bytes(&params).unwrap_or_default(),
        ];
        for part in parts {
            bytes.extend(part.len().to_string().into_bytes());
            bytes.push(b':');
            bytes.extend(part);
        }
        sha256(&bytes)
    }

    /// Everything that is wrong with the request itself.
    #[must_use]
    pub fn faults(&self) -> Vec<Diagnostic> {
        let mut found = Vec::new();
        let length = self.description.trim().chars().count();
        if length == 0 || length > MOST_DESCRIPTION {
            found.push(
                invalid("description", "a request says what the part is")
                    .expected(format!("1 to {MOST_DESCRIPTION} characters")),
            );
        }
        for (place, count) in [
            ("expected_ports", self.expected_ports.len()),
            ("params", self.params.len()),
        ] {
            if count > MOST_ITEMS {
                let message =
                    format!("there are {count} of them, and at most {MOST_ITEMS} are taken");
                found.push(invalid(place, &message));
            }
        }
        for (i, port) in self.expected_ports.iter().take(MOST_ITEMS).enumerate() {
            let place = format!("expected_ports[{i}]");
            let twice = self
                .expected_ports
                .iter()
                .take(i)
                .any(|p| p.name == port.name);
            port.faults(&place, twice, &mut found);
        }
        for (i, param) in self.params.iter().take(MOST_ITEMS).enumerate() {
            let place = format!("params[{i}]");
            if self.params.iter().take(i).any(|p| p.name == param.name) {
                let message = format!("'{}' is asked for twice", clip(&param.name));
                found.push(invalid(&format!("{place}.name"), &message));
            }
            if let Err(faults) = param.spec(&place) {
                found.extend(faults);
            }
        }
        found
    }

    /// The parameters as a factory declares them; those at fault are left out.
    #[must_use]
    pub fn specs(&self) -> Vec<ParamSpec> {
        self.params.iter().filter_map(|p| p.spec("").ok()).collect()
    }

    /// The defaults of the parameters.
    #[must_use]
    pub fn defaults(&self) -> Map<String, Value> {
        let of = |s: &ParamSpec| (s.name.clone(), s.default_value());
        self.specs().iter().map(of).collect()
    }
}

fn invalid(place: &str, message: &str) -> Diagnostic {
    Diagnostic::error(Code::ArgumentInvalid, place, message)
}

impl ExpectedPort {
    fn faults(&self, place: &str, twice: bool, found: &mut Vec<Diagnostic>) {
        if !name::is_valid(&self.name) {
            found.push(
                Diagnostic::error(
                    Code::NameInvalid,
                    format!("{place}.name"),
                    "this is no name",
                )
                .found(self.name.as_str())
                .expected(name::RULE),
            );
        }
        if twice {
            let message = format!("the port '{}' is asked for twice", clip(&self.name));
            found.push(invalid(&format!("{place}.name"), &message));
        }
        let kind = self.port_type.kind();
        let known: Vec<&str> = kind.params.iter().map(|p| p.name).collect();
        for (name, value) in &self.params {
            let at = format!("{place}.params.{}", clip(name));
            if !known.contains(&name.as_str()) {
                let message = format!("a {} port has no '{}'", kind.name, clip(name));
                found.push(invalid(&at, &message).expected(json!(known)));
            }
            if !matches!(value, Value::Number(_) | Value::String(_)) {
                let message = "expected a number, or an expression over the parameters as text";
                found.push(invalid(&at, message).found(value.clone()));
            }
        }
    }

    /// The parameters that are expressions, and the numbers as texts: what is to be evaluated.
    #[must_use]
    pub fn expressions(&self) -> Vec<(&str, String)> {
        let text = |value: &Value| match value {
            Value::String(text) => text.clone(),
            other => other.to_string(),
        };
        self.params
            .iter()
            .map(|(k, v)| (k.as_str(), text(v)))
            .collect()
    }
}

impl AskedParam {
    /// As a factory declares it.
    ///
    /// # Errors
    /// Everything that is wrong with it, `place` leading the paths.
    pub fn spec(&self, place: &str) -> Result<ParamSpec, Vec<Diagnostic>> {
        let mut found = Vec::new();
        if !is_identifier(&self.name) {
            found.push(
                Diagnostic::error(
                    Code::NameInvalid,
                    format!("{place}.name"),
                    "this is no name of a parameter",
                )
                .found(self.name.as_str())
                .expected("lower-case letters, digits and '_', the first a letter, at most 64"),
            );
        }
        let kind = self.kind(place, &mut found);
        match kind {
            Some(kind) if found.is_empty() => Ok(ParamSpec {
                name: self.name.clone(),
                doc: self.doc.clone(),
                kind,
            }),
            _ => Err(found),
        }
    }

    fn kind(&self, place: &str, found: &mut Vec<Diagnostic>) -> Option<ParamKind> {
        let mut wrong = |field: &str, message: &str| {
            found.push(invalid(&format!("{place}.{field}"), message).found(self.default.clone()));
            None
        };
        match self.kind {
            AskedKind::Number | AskedKind::Integer => {
                let (Some(min), Some(max)) = (self.min, self.max) else {
                    return wrong(
                        "min",
                        "a number has a smallest and a largest value: 'min' and 'max'",
                    );
                };
                let default = match self.default.as_f64() {
                    Some(v) if v >= min && v <= max => v,
                    _ => return wrong("default", "the default is a number from min to max"),
                };
                if self.kind == AskedKind::Number {
                    let unit = self.unit.clone();
                    return Some(ParamKind::Number {
                        unit,
                        min,
                        max,
                        default,
                    });
                }
                let whole = |v: f64| libm::trunc(v) == v && v.abs() <= 1e15;
                if ![min, max, default].into_iter().all(whole) {
                    return wrong(
                        "default",
                        "min, max and default of a whole number are whole",
                    );
                }
                Some(ParamKind::Integer {
                    min: min as i64,
                    max: max as i64,
                    default: default as i64,
                })
            }
            AskedKind::Choice => match self.default.as_str() {
                Some(word) if self.choices.iter().any(|c| c == word) => Some(ParamKind::Choice {
                    choices: self.choices.clone(),
                    default: word.to_owned(),
                }),
                _ => wrong("default", "the default of a choice is one of its 'choices'"),
            },
            AskedKind::Flag => match self.default.as_bool() {
                Some(default) => Some(ParamKind::Flag { default }),
                None => wrong("default", "the default of a flag is true or false"),
            },
        }
    }
}

fn is_identifier(text: &str) -> bool {
    text.len() <= 64
        && text.starts_with(|c: char| c.is_ascii_lowercase())
        && text
            .chars()
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}
