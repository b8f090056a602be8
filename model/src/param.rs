//! Parameters of factories: declared once, from which come the checks and the JSON Schema.

use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::diagnostic::{Code, Diagnostic};
use crate::name::nearest;
use crate::told::Capped;

/// One declared parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ParamSpec {
    /// Name, as in a specification's `params`.
    pub name: String,
    /// What it means, in one line.
    pub doc: String,
    /// Type, range and default.
    #[serde(flatten)]
    pub kind: ParamKind,
}

/// Type, range and default of a parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum ParamKind {
    /// A real number.
    Number {
        /// `mm`, `deg`, or empty for a ratio.
        unit: String,
        /// Smallest value.
        min: f64,
        /// Largest value.
        max: f64,
        /// Value where none is given.
        default: f64,
    },
    /// A whole number.
    Integer {
        /// Smallest value.
        min: i64,
        /// Largest value.
        max: i64,
        /// Value where none is given.
        default: i64,
    },
    /// One of a list of words.
    Choice {
        /// The words.
        choices: Vec<String>,
        /// Word where none is given.
        default: String,
    },
    /// Yes or no.
    Flag {
        /// Value where none is given.
        default: bool,
    },
    /// A list of records with the same fields.
    Records {
        /// The fields of each record.
        fields: Vec<ParamSpec>,
        /// Fewest records.
        min_items: usize,
        /// Most records.
        max_items: usize,
        /// The list where none is given.
        default: Vec<Value>,
    },
}

impl ParamSpec {
    /// The value where none is given.
    #[must_use]
    pub fn default_value(&self) -> Value {
        match &self.kind {
            ParamKind::Number { default, .. } => json!(default),
            ParamKind::Integer { default, .. } => json!(default),
            ParamKind::Choice { default, .. } => json!(default),
            ParamKind::Flag { default } => json!(default),
            ParamKind::Records { default, .. } => json!(default),
        }
    }

    /// Smallest and largest value, where the values are numbers.
    #[must_use]
    pub fn range(&self) -> Option<[f64; 2]> {
        match &self.kind {
            ParamKind::Number { min, max, .. } => Some([*min, *max]),
            ParamKind::Integer { min, max, .. } => Some([*min as f64, *max as f64]),
            _ => None,
        }
    }

    /// Gives numbers another range; what has none stays as it is. Of whole numbers, the parts before the point.
    pub fn set_range(&mut self, [low, high]: [f64; 2]) {
        match &mut self.kind {
            ParamKind::Number { min, max, .. } => (*min, *max) = (low, high),
            ParamKind::Integer { min, max, .. } => (*min, *max) = (low as i64, high as i64),
            _ => {}
        }
    }

    /// What is accepted, in plain words.
    #[must_use]
    pub fn expected(&self) -> String {
        match &self.kind {
            ParamKind::Number { unit, min, max, .. } => {
                let unit = if unit.is_empty() {
                    String::new()
                } else {
                    format!(" {unit}")
                };
                format!("a number from {min} to {max}{unit}")
            }
            ParamKind::Integer { min, max, .. } => format!("a whole number from {min} to {max}"),
            ParamKind::Choice { choices, .. } => format!("one of: {}", choices.join(", ")),
            ParamKind::Flag { .. } => "true or false".to_owned(),
            ParamKind::Records {
                fields,
                min_items,
                max_items,
                ..
            } => {
                let names: Vec<&str> = fields.iter().map(|f| f.name.as_str()).collect();
                format!(
                    "a list of {min_items} to {max_items} records with the fields {}",
                    names.join(", ")
                )
            }
        }
    }

    /// The JSON Schema of the value.
    #[must_use]
    pub fn schema(&self) -> Value {
        let mut schema = match &self.kind {
            ParamKind::Number {
                min, max, default, ..
            } => {
                json!({"type": "number", "minimum": min, "maximum": max, "default": default})
            }
            ParamKind::Integer { min, max, default } => {
                json!({"type": "integer", "minimum": min, "maximum": max, "default": default})
            }
            ParamKind::Choice { choices, default } => {
                json!({"type": "string", "enum": choices, "default": default})
            }
            ParamKind::Flag { default } => json!({"type": "boolean", "default": default}),
            ParamKind::Records {
                fields,
                min_items,
                max_items,
                default,
            } => json!({
                "type": "array", "minItems": min_items, "maxItems": max_items,
                "default": default, "items": object_schema(fields),
            }),
        };
        if let Some(object) = schema.as_object_mut() {
            let unit = match &self.kind {
                ParamKind::Number { unit, .. } if !unit.is_empty() => format!(" ({unit})"),
                _ => String::new(),
            };
            object.insert(
                "description".to_owned(),
                json!(format!("{}{unit}", self.doc)),
            );
        }
        schema
    }

    /// Checks one value and gives it in normal form (whole numbers of a `Number` become reals).
    fn check(&self, value: &Value, place: &str, found: &mut Vec<Diagnostic>) -> Value {
        let ok = match (&self.kind, value) {
            (ParamKind::Number { min, max, .. }, Value::Number(n)) => n
                .as_f64()
                .filter(|v| v >= min && v <= max)
                .map(|v| json!(v)),
            (ParamKind::Integer { min, max, .. }, Value::Number(n)) => {
                whole(n).filter(|v| v >= min && v <= max).map(|v| json!(v))
            }
            (ParamKind::Choice { choices, .. }, Value::String(s)) => {
                choices.contains(s).then(|| value.clone())
            }
            (ParamKind::Flag { .. }, Value::Bool(_)) => Some(value.clone()),
            (
                ParamKind::Records {
                    fields,
                    min_items,
                    max_items,
                    ..
                },
                Value::Array(items),
            ) if (*min_items..=*max_items).contains(&items.len()) => {
                let mut normal = Vec::new();
                for (i, item) in items.iter().enumerate() {
                    let place = format!("{place}[{i}]");
                    match item {
                        Value::Object(item) => match check_all(fields, item, &place) {
                            Ok(values) => normal.push(Value::Object(values)),
                            Err(more) => found.extend(more),
                        },
                        other => found.push(wrong(&place, other, "an object")),
                    }
                }
                Some(Value::Array(normal))
            }
            _ => None,
        };
        ok.unwrap_or_else(|| {
            found.push(wrong(place, value, &self.expected()));
            Value::Null
        })
    }
}

fn whole(n: &serde_json::Number) -> Option<i64> {
    n.as_i64().or_else(|| {
        let v = n.as_f64()?;
        // Beyond 2^53 a float no longer tells whole numbers apart.
        (v.abs() <= 9.0e15 && libm::trunc(v) == v).then_some(v as i64)
    })
}

fn wrong(place: &str, value: &Value, expected: &str) -> Diagnostic {
    Diagnostic::error(Code::ParamInvalid, place, format!("expected {expected}"))
        .found(value.clone())
        .expected(json!(expected))
}

/// Checks given values against the declared parameters and fills in the defaults.
///
/// The answer holds every declared parameter in order of declaration.
///
/// # Errors
/// One diagnostic for every unknown name and every value out of type or range, `place` leading its path.
pub fn check_all(
    specs: &[ParamSpec],
    given: &Map<String, Value>,
    place: &str,
) -> Result<Map<String, Value>, Vec<Diagnostic>> {
    let mut unknown = Capped::new();
    for (name, value) in given {
        if specs.iter().any(|s| s.name == *name) {
            continue;
        }
        unknown.push(|| {
            let names: Vec<&str> = specs.iter().map(|s| s.name.as_str()).collect();
            let mut d = Diagnostic::error(
                Code::ParamUnknown,
                format!("{place}.{}", clip(name)),
                format!("there is no parameter '{}'", clip(name)),
            )
            .found(value.clone())
            .expected(json!(names));
            if let Some(near) = nearest(name, names, 1).first() {
                d = d.hint(format!("did you mean '{near}'?"));
            }
            d
        });
    }
    let mut found = unknown.told();
    let mut values = Map::new();
    for spec in specs {
        let value = match given.get(&spec.name) {
            Some(value) => spec.check(value, &format!("{place}.{}", spec.name), &mut found),
            None => spec.default_value(),
        };
        values.insert(spec.name.clone(), value);
    }
    if found.is_empty() {
        Ok(values)
    } else {
        Err(found)
    }
}

/// The JSON Schema of an object with the given parameters, none of which is required.
#[must_use]
pub fn object_schema(specs: &[ParamSpec]) -> Value {
    let properties: Map<String, Value> =
        specs.iter().map(|s| (s.name.clone(), s.schema())).collect();
    json!({"type": "object", "additionalProperties": false, "properties": properties})
}

/// A text cut to a length that fits a message.
#[must_use]
pub fn clip(text: &str) -> String {
    const MOST: usize = 80;
    if text.chars().count() <= MOST {
        return text.to_owned();
    }
    let head: String = text.chars().take(MOST).collect();
    format!("{head}... ({} characters)", text.chars().count())
}

#[cfg(test)]
mod tests {
    use super::{ParamKind, ParamSpec, check_all};
    use serde_json::{Map, Value, json};

    fn specs() -> Vec<ParamSpec> {
        let number = |name: &str| ParamSpec {
            name: name.to_owned(),
            doc: "a length".to_owned(),
            kind: ParamKind::Number {
                unit: "mm".to_owned(),
                min: 1.0,
                max: 10.0,
                default: 2.0,
            },
        };
        vec![
            number("length"),
            ParamSpec {
                name: "teeth".to_owned(),
                doc: "tooth count".to_owned(),
                kind: ParamKind::Integer {
                    min: 5,
                    max: 9,
                    default: 6,
                },
            },
            ParamSpec {
                name: "rows".to_owned(),
                doc: "rows".to_owned(),
                kind: ParamKind::Records {
                    fields: vec![number("d")],
                    min_items: 1,
                    max_items: 2,
                    default: vec![json!({"d": 3.0})],
                },
            },
        ]
    }

    fn object(v: Value) -> Map<String, Value> {
        v.as_object().unwrap().clone()
    }

    #[test]
    fn defaults_are_filled_in() {
        let values = check_all(&specs(), &object(json!({"length": 3})), "params").unwrap();
        assert_eq!(
            Value::Object(values),
            json!({"length": 3.0, "teeth": 6, "rows": [{"d": 3.0}]})
        );
    }

    #[test]
    fn every_fault_is_reported_with_its_place() {
        let given = object(json!({
            "lenght": 3, "length": -1, "teeth": 6.5, "rows": [{"d": "x"}, 7]
        }));
        let found = check_all(&specs(), &given, "params").unwrap_err();
        let places: Vec<&str> = found.iter().map(|d| d.place.as_str()).collect();
        assert_eq!(
            places,
            [
                "params.lenght",
                "params.length",
                "params.teeth",
                "params.rows[0].d",
                "params.rows[1]"
            ]
        );
        assert_eq!(found[0].hint.as_deref(), Some("did you mean 'length'?"));
    }
}
