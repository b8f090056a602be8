//! What a plain word means where anything may stand.

use serde_json::Value;

use crate::canonical;

/// A plain scalar as a value: `null` and `~`, `true` and `false`, decimal numbers; all else is text.
///
/// Narrower than YAML's own rules on purpose: `yes`, `on`, `0x1F`, `1_000`, `012` and `.inf` mean
/// different things to different readers, so here they are text, and a check that wants a number says so.
pub(super) fn resolve(text: &str) -> Value {
    match text {
        "null" | "~" => Value::Null,
        "true" => Value::Bool(true),
        "false" => Value::Bool(false),
        _ => number(text).unwrap_or_else(|| Value::String(text.to_owned())),
    }
}

fn number(text: &str) -> Option<Value> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((m, e)) => (m, Some(e.strip_prefix(['-', '+']).unwrap_or(e))),
        None => (unsigned, None),
    };
    let (whole, fraction) = match mantissa.split_once('.') {
        Some((w, f)) => (w, Some(f)),
        None => (mantissa, None),
    };
    let digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
    let octal = whole.len() > 1 && whole.starts_with('0');
    let empty = whole.is_empty() && fraction.unwrap_or_default().is_empty();
    if octal || empty || !digits(whole) || !digits(fraction.unwrap_or_default()) {
        return None;
    }
    if exponent.is_some_and(|e| e.is_empty() || !digits(e)) {
        return None;
    }
    let text = text.strip_prefix('+').unwrap_or(text);
    if fraction.is_none() && exponent.is_none() {
        if let Ok(n) = text.parse::<i64>() {
            return Some(n.into());
        }
        if let Ok(n) = text.parse::<u64>() {
            return Some(n.into());
        }
    }
    let real: f64 = text.parse().ok()?;
    serde_json::Number::from_f64(real)
        .and_then(|n| canonical::number(&n))
        .map(Value::Number)
}

#[cfg(test)]
mod tests {
    use super::resolve;
    use serde_json::{Value, json};

    #[test]
    fn numbers_are_decimal_and_finite() {
        for (text, value) in [
            ("0", json!(0)),
            ("-0", json!(0)),
            ("+5", json!(5)),
            ("120", json!(120)),
            ("1.50", json!(1.5)),
            (".5", json!(0.5)),
            ("5.", json!(5.0)),
            ("1e3", json!(1000.0)),
            ("-2.5E-3", json!(-0.0025)),
            ("18446744073709551615", json!(u64::MAX)),
            ("null", Value::Null),
            ("~", Value::Null),
            ("true", json!(true)),
        ] {
            assert_eq!(resolve(text), value, "{text}");
        }
    }

    #[test]
    fn what_readers_differ_on_is_text() {
        for text in [
            "yes",
            "no",
            "on",
            "off",
            "True",
            "NULL",
            "0x1F",
            "0o17",
            "012",
            "1_000",
            ".inf",
            ".nan",
            "1e",
            "e3",
            ".",
            "-",
            "+",
            "1.2.3",
            "12:30",
            "2026-01-01",
            "1e999",
            "--1",
        ] {
            assert_eq!(resolve(text), json!(text), "{text}");
        }
    }
}
