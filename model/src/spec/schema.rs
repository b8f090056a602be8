//! The JSON Schemas of the two forms, made from the types.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value};

use super::Document;
use super::tree::Tree;

/// The schema of the YAML form.
#[must_use]
pub fn document() -> Value {
    of::<Document>()
}

/// The schema of the tree form.
#[must_use]
pub fn tree() -> Value {
    of::<Tree>()
}

/// The schema of a type with everything inlined, so that a place in a document is a place in the schema.
#[must_use]
pub fn of<T: JsonSchema>() -> Value {
    let mut schema = SchemaSettings::draft2020_12()
        .with(|s| s.inline_subschemas = true)
        .into_generator()
        .into_root_schema_for::<T>()
        .to_value();
    closed(&mut schema);
    schema
}

/// An optional field may be left out; that it may be `null` too is serde's habit, not the format's.
fn closed(schema: &mut Value) {
    match schema {
        Value::Object(map) => {
            if let Some(Value::Array(types)) = map.get_mut("type") {
                types.retain(|t| t != "null");
                if let [only] = types.as_slice() {
                    let only = only.clone();
                    map.insert("type".to_owned(), only);
                }
            }
            if map.get("default") == Some(&Value::Null) {
                map.remove("default");
            }
            simple(map);
            map.values_mut().for_each(closed);
        }
        Value::Array(items) => items.iter_mut().for_each(closed),
        _ => {}
    }
}

/// Described words (`oneOf` of constants) as a plain enumeration with one description.
fn simple(map: &mut Map<String, Value>) {
    let Some(all) = map.get("oneOf").and_then(Value::as_array) else {
        return;
    };
    let words: Option<Vec<Value>> = all.iter().map(|s| s.get("const").cloned()).collect();
    let Some(words) = words else { return };
    let word = |s: &Value| {
        Some(format!(
            "{}: {}",
            s.get("const")?.as_str()?,
            s.get("description")?.as_str()?
        ))
    };
    let described: Vec<String> = all.iter().filter_map(word).collect();
    map.remove("oneOf");
    map.insert("type".to_owned(), "string".into());
    map.insert("enum".to_owned(), Value::Array(words));
    let before = map
        .get("description")
        .and_then(Value::as_str)
        .unwrap_or_default();
    let description = format!("{before} {}", described.join(" "));
    map.insert("description".to_owned(), description.trim().into());
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    #[test]
    fn the_published_schemas_are_those_of_the_types() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/schema");
        for (file, schema) in [
            ("specification.json", super::document()),
            ("specification-tree.json", super::tree()),
        ] {
            let path = format!("{folder}/{file}");
            let text = format!("{}\n", serde_json::to_string_pretty(&schema).unwrap());
            if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
                std::fs::create_dir_all(folder).unwrap();
                std::fs::write(&path, &text).unwrap();
            }
            assert_eq!(
                std::fs::read_to_string(&path).unwrap_or_default(),
                text,
                "{path} is not what the types say; accept it with\n  \
                 ASSEMCAD_ACCEPT=1 cargo test -p assemcad-model published_schemas"
            );
        }
    }

    #[test]
    fn every_object_of_the_format_is_closed_and_every_field_described() {
        fn look(schema: &Value, path: &str) {
            if let Some(fields) = schema.get("properties").and_then(Value::as_object) {
                assert_eq!(schema["additionalProperties"], false, "{path}");
                for (name, field) in fields {
                    assert!(field.get("description").is_some(), "{path}.{name}");
                    look(field, &format!("{path}.{name}"));
                }
            }
            for key in ["items", "additionalProperties"] {
                if let Some(inner) = schema.get(key) {
                    look(inner, &format!("{path}.{key}"));
                }
            }
        }
        look(&super::document(), "document");
        look(&super::tree(), "tree");
    }
}
