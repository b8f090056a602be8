//! Canonical JSON and its hash: the one way in which values become bytes that are compared.

use serde::Serialize;
use serde_json::{Number, Value};
use sha2::{Digest, Sha256};

/// Canonical JSON of a value: RFC 8785 (sorted keys, no white space, ECMAScript numbers).
///
/// # Errors
/// When the value holds a number that JSON cannot carry (NaN, an infinity) or a map key that is not text.
pub fn to_bytes<T: Serialize>(value: &T) -> Result<Vec<u8>, serde_json::Error> {
    serde_json_canonicalizer::to_vec(value)
}

/// SHA-256 of bytes in lower-case hexadecimal.
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    hex::encode(Sha256::digest(bytes))
}

/// SHA-256 of the canonical JSON of a value.
///
/// # Errors
/// As [`to_bytes`].
pub fn hash<T: Serialize>(value: &T) -> Result<String, serde_json::Error> {
    Ok(sha256(&to_bytes(value)?))
}

/// A number in its one form: a whole number as it is, any other as the shortest text that reads back
/// as the same double. None for one that no double holds.
#[must_use]
pub fn number(n: &Number) -> Option<Number> {
    n.as_i64()
        .map(Number::from)
        .or_else(|| n.as_u64().map(Number::from))
        .or_else(|| n.as_f64().and_then(Number::from_f64))
}

/// A value with every number in its one form.
#[must_use]
pub fn normal(value: Value) -> Value {
    match value {
        Value::Number(n) => Value::Number(number(&n).unwrap_or(n)),
        Value::Array(items) => Value::Array(items.into_iter().map(normal).collect()),
        Value::Object(map) => Value::Object(map.into_iter().map(|(k, v)| (k, normal(v))).collect()),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    #[test]
    fn a_number_has_one_form() {
        for (text, form) in [
            ("1.50", "1.5"),
            ("1e2", "100.0"),
            ("-0", "0"),
            ("120.0", "120.0"),
            ("18446744073709551615", "18446744073709551615"),
            ("0.1000000000000000055511151231257827", "0.1"),
        ] {
            let value: Value = serde_json::from_str(text).unwrap();
            let once = super::normal(value);
            assert_eq!(once.to_string(), form);
            assert_eq!(super::normal(once).to_string(), form);
        }
    }

    #[test]
    fn order_and_number_form_do_not_matter() {
        let a = json!({"b": 1.0, "a": [10, -0.0]});
        let b = json!({"a": [10.0, 0], "b": 1});
        assert_eq!(super::to_bytes(&a).unwrap(), br#"{"a":[10,0],"b":1}"#);
        assert_eq!(super::hash(&a).unwrap(), super::hash(&b).unwrap());
    }

    #[test]
    fn sha256_of_the_empty_text() {
        // FIPS 180-4 test value.
        assert_eq!(
            super::sha256(b""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
        );
    }
}
