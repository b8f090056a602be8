//! The JSON Schema of a report, made from its types.

use serde_json::Value;

use super::Report;

/// The schema of `report.json`.
#[must_use]
pub fn report() -> Value {
    crate::spec::schema::of::<Report>()
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    #[test]
    fn the_published_schema_is_that_of_the_types() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/schema/report.json");
        let text = format!(
            "{}\n",
            serde_json::to_string_pretty(&super::report()).unwrap()
        );
        if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
            std::fs::write(path, &text).unwrap();
        }
        assert_eq!(
            std::fs::read_to_string(path).unwrap_or_default(),
            text,
            "{path} is not what the types say; accept it with\n  \
             ASSEMCAD_ACCEPT=1 cargo test -p assemcad-model published_schema"
        );
    }

    #[test]
    fn every_field_of_a_report_is_described() {
        fn look(schema: &Value, path: &str) {
            if let Some(fields) = schema.get("properties").and_then(Value::as_object) {
                for (name, field) in fields {
                    assert!(field.get("description").is_some(), "{path}.{name}");
                    look(field, &format!("{path}.{name}"));
                }
            }
            if let Some(items) = schema.get("items") {
                look(items, &format!("{path}[]"));
            }
        }
        let schema = super::report();
        look(&schema, "report");
        assert!(schema["properties"]["findings"]["items"]["properties"]["diagnostic"].is_object());
    }
}
