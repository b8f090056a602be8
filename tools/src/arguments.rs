//! Arguments checked against a tool's schema: every fault told in the shape of a diagnostic.

use assemcad_assembly::Faults;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name::nearest;
use assemcad_model::param::clip;
use assemcad_model::told::Capped;
use jsonschema::error::ValidationErrorKind as Kind;
use jsonschema::{ValidationError, Validator};
use serde_json::{Map, Value, json};

/// So many unknown arguments are named.
const MOST_NAMED: usize = 10;

/// Checks arguments against the schema.
///
/// # Errors
/// One diagnostic for every fault.
pub(crate) fn check(
    validator: &Validator,
    schema: &Map<String, Value>,
    given: &Value,
) -> Result<(), Faults> {
    let mut faults = Capped::new();
    for e in validator.iter_errors(given) {
        faults.push(|| fault(&e, schema));
    }
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults.told())
    }
}

/// The diagnostic for arguments that pass the schema and yet cannot be read.
pub(crate) fn unreadable(tool: &str) -> Diagnostic {
    Diagnostic::error(
        Code::ArgumentInvalid,
        "arguments",
        "the arguments could not be read",
    )
    .hint(format!("compare them with the input schema of {tool}"))
}

/// The diagnostic for an answer that is no JSON: a fault of the server.
pub(crate) fn unwritable(tool: &str) -> Diagnostic {
    Diagnostic::error(Code::Internal, tool, "the answer could not be written")
}

fn fault(error: &ValidationError<'_>, schema: &Map<String, Value>) -> Diagnostic {
    let place = place(error.instance_path().as_str());
    let found = error.instance().as_ref();
    let wrong = |message: String, expected: Value| {
        Diagnostic::error(Code::ArgumentInvalid, place.clone(), message)
            .found(found.clone())
            .expected(expected)
    };
    match error.kind() {
        Kind::Required { property } => {
            let name = property.as_str().unwrap_or_default();
            let d = Diagnostic::error(
                Code::ArgumentInvalid,
                join(&place, name),
                format!("'{name}' is missing"),
            );
            match meaning(schema, name) {
                Some(meaning) => d.expected(meaning),
                None => d,
            }
        }
        Kind::AdditionalProperties { unexpected } => {
            let names: Vec<&str> = schema
                .get("properties")
                .and_then(Value::as_object)
                .map(|p| p.keys().map(String::as_str).collect())
                .unwrap_or_default();
            let named = unexpected.iter().take(MOST_NAMED);
            let named: Vec<String> = named.map(|n| clip(n)).collect();
            let all = match unexpected.len().saturating_sub(named.len()) {
                0 => quoted(&named),
                more => format!("{} and {more} more", quoted(&named)),
            };
            let d = Diagnostic::error(
                Code::ArgumentInvalid,
                place.clone(),
                format!("there is no argument {all}"),
            )
            .found(json!(named))
            .expected(json!(names));
            match unexpected
                .first()
                .and_then(|n| nearest(n, names, 1).first().copied())
            {
                Some(near) => d.hint(format!("did you mean '{near}'?")),
                None => d,
            }
        }
        Kind::Type { .. } => {
            let expected = at(schema, &place).and_then(|s| s.get("type")).cloned();
            wrong(
                "this is of the wrong type".to_owned(),
                expected.unwrap_or_else(|| json!("an object")),
            )
        }
        Kind::Enum { options } => wrong(
            "this is none of the possible values".to_owned(),
            (**options).clone(),
        ),
        Kind::Minimum { limit } => wrong("this is too small".to_owned(), json!({"minimum": limit})),
        Kind::ExclusiveMinimum { limit } => wrong(
            "this is too small".to_owned(),
            json!({"greater_than": limit}),
        ),
        Kind::Maximum { limit } => wrong("this is too large".to_owned(), json!({"maximum": limit})),
        Kind::MaxLength { limit } => {
            wrong("this is too long".to_owned(), json!({"characters": limit}))
        }
        Kind::Pattern { pattern } => wrong(
            "this is not written as it should be".to_owned(),
            json!({"pattern": pattern}),
        ),
        _ => wrong(
            "this does not fit the tool's schema".to_owned(),
            json!(at(schema, &place)),
        ),
    }
}

/// The schema of the argument at a place, where the place is an argument.
fn at<'a>(schema: &'a Map<String, Value>, place: &str) -> Option<&'a Value> {
    schema.get("properties")?.get(place)
}

fn meaning(schema: &Map<String, Value>, name: &str) -> Option<Value> {
    at(schema, name)?.get("description").cloned()
}

/// A JSON pointer as a path of names: `/params/length` as `params.length`.
fn place(pointer: &str) -> String {
    if pointer.is_empty() {
        return "arguments".to_owned();
    }
    clip(
        &pointer
            .trim_start_matches('/')
            .replace('/', ".")
            .replace("~1", "/")
            .replace("~0", "~"),
    )
}

fn join(place: &str, name: &str) -> String {
    if place == "arguments" {
        name.to_owned()
    } else {
        format!("{place}.{name}")
    }
}

fn quoted(names: &[String]) -> String {
    names
        .iter()
        .map(|n| format!("'{n}'"))
        .collect::<Vec<_>>()
        .join(", ")
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    fn faults(given: Value) -> Vec<(String, String)> {
        let tool = crate::all().into_iter().find(|t| t.name == "mate").unwrap();
        let faults =
            super::check(tool.validator.as_ref().unwrap(), &tool.input_schema, &given).unwrap_err();
        faults.into_iter().map(|d| (d.place, d.message)).collect()
    }

    #[test]
    fn all_faults_are_told_at_once() {
        let found = faults(json!({
            "assembly": 7, "id": "m", "mate_type": "glue", "incoming": "b:f", "u_mm": "ten", "spin": 1
        }));
        let mut places: Vec<&str> = found.iter().map(|(p, _)| p.as_str()).collect();
        places.sort_unstable();
        assert_eq!(
            places,
            ["arguments", "assembly", "base", "mate_type", "u_mm"],
            "{found:?}"
        );
    }

    #[test]
    fn arguments_that_are_no_object_are_told() {
        assert_eq!(faults(json!([1]))[0].0, "arguments");
    }
}
