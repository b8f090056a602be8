//! JSON Schemas of the tools' types, in the form that all clients take.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// The schema of a tool's arguments.
pub(crate) fn input<T: JsonSchema>() -> Map<String, Value> {
    let mut schema = of::<T>();
    // Left out where there are none, and missed by some clients then.
    schema.entry("properties").or_insert_with(|| json!({}));
    schema
}

/// The schema of a tool's answer: either the answer itself or, when the call is refused, diagnostics.
///
/// TypeScript clients hold refusals against this schema too and lose them where they do not fit; a
/// choice at the root (`oneOf`) is refused by others. So the root says: unless `diagnostics` stand
/// alone, all of the answer's own fields are there.
pub(crate) fn output<T: JsonSchema>() -> Map<String, Value> {
    let mut schema = of::<T>();
    let required = schema.remove("required").unwrap_or_else(|| json!([]));
    // The whole shape of a diagnostic is in verify's findings; ten times over it would be most of the
    // tools' list.
    let diagnostics = json!({
        "type": "array",
        "description": "Why the call was refused; then nothing else is here.",
        "items": {"type": "object", "required": ["code", "severity", "where", "message"]},
    });
    if let Some(properties) = schema
        .entry("properties")
        .or_insert_with(|| json!({}))
        .as_object_mut()
    {
        properties.entry("diagnostics").or_insert(diagnostics);
    }
    schema.insert(
        "if".to_owned(),
        json!({"required": ["diagnostics"], "maxProperties": 1}),
    );
    schema.insert("then".to_owned(), json!({}));
    schema.insert("else".to_owned(), json!({"required": required}));
    schema
}

/// The schema of a type with everything inlined: some clients do not follow references.
fn of<T: JsonSchema>() -> Map<String, Value> {
    let generator = SchemaSettings::draft2020_12().with(|s| s.inline_subschemas = true);
    let mut schema = generator
        .into_generator()
        .into_root_schema_for::<T>()
        .to_value();
    portable(&mut schema);
    match schema {
        Value::Object(mut object) => {
            object.remove("$schema");
            object.remove("title");
            object
        }
        _ => Map::new(),
    }
}

/// Takes out what some clients stumble over: formats that only Rust knows, and `null` as a second type
/// (an absent field says the same; a null argument is taken for an absent one).
fn portable(schema: &mut Value) {
    match schema {
        Value::Array(items) => items.iter_mut().for_each(portable),
        Value::Object(object) => {
            object.remove("format");
            if object.get("default") == Some(&Value::Null) {
                object.remove("default");
            }
            if let Some(Value::Array(types)) = object.get_mut("type") {
                types.retain(|t| t != "null");
                if let [one] = types.as_slice() {
                    let one = one.clone();
                    object.insert("type".to_owned(), one);
                }
            }
            if let Some(Value::Array(words)) = object.get_mut("enum") {
                words.retain(|word| !word.is_null());
            }
            if let Some(Value::Array(options)) = object.get_mut("anyOf") {
                options.retain(|o| o.get("type") != Some(&json!("null")));
                if let [Value::Object(one)] = options.as_slice() {
                    let one = one.clone();
                    object.remove("anyOf");
                    for (key, value) in one {
                        object.entry(key).or_insert(value);
                    }
                }
            }
            object.values_mut().for_each(portable);
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use schemars::JsonSchema;
    use serde_json::{Value, json};

    #[derive(JsonSchema)]
    #[allow(dead_code)]
    struct Answer {
        /// How many.
        count: usize,
        /// Which, if any.
        name: Option<String>,
        /// What kind, if any.
        kind: Option<Kind>,
    }

    #[derive(JsonSchema)]
    #[allow(dead_code)]
    enum Kind {
        A,
        B,
    }

    #[test]
    fn nothing_that_clients_stumble_over() {
        let schema = Value::Object(super::of::<Answer>());
        assert_eq!(
            schema["properties"],
            json!({
                "count": {"type": "integer", "minimum": 0, "description": "How many."},
                "name": {"type": "string", "description": "Which, if any."},
                "kind": {"type": "string", "enum": ["A", "B"], "description": "What kind, if any."},
            })
        );
        assert_eq!(schema["required"], json!(["count"]));
    }

    #[test]
    fn an_answer_is_whole_or_a_refusal() {
        let schema = Value::Object(super::output::<Answer>());
        let schema = jsonschema::validator_for(&schema).unwrap();
        for good in [
            json!({"count": 1}),
            json!({"diagnostics": [{"code": "c", "severity": "s", "where": "w", "message": "m"}]}),
        ] {
            assert!(schema.is_valid(&good), "{good}");
        }
        for bad in [
            json!({}),
            json!({"name": "x"}),
            json!({"diagnostics": ["x"]}),
        ] {
            assert!(!schema.is_valid(&bad), "{bad}");
        }
    }
}
