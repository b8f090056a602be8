//! From values to text, in one form.

use core::fmt::Write as _;

use serde_json::{Map, Value};

use crate::canonical;

/// Words that some reader of YAML takes for something other than text.
const WORDS: [&str; 9] = ["null", "true", "false", "yes", "no", "on", "off", "y", "n"];

/// A value as a document: mappings in block form down to the items of lists; what is inside an item's
/// entries is in flow form, one entry to a line.
#[must_use]
pub fn write(document: &Map<String, Value>) -> String {
    let mut out = String::new();
    block(&mut out, document, 0);
    out
}

fn block(out: &mut String, map: &Map<String, Value>, indent: usize) {
    for (name, value) in map {
        for _ in 0..indent {
            out.push(' ');
        }
        text(out, name);
        out.push(':');
        match value {
            Value::Object(inner) if !inner.is_empty() => {
                out.push('\n');
                block(out, inner, indent + 2);
            }
            Value::Array(items) if is_records(items) => {
                out.push('\n');
                for item in items.iter().filter_map(Value::as_object) {
                    record(out, item, indent + 2);
                }
            }
            other => {
                out.push(' ');
                inline(out, other);
                out.push('\n');
            }
        }
    }
}

fn is_records(items: &[Value]) -> bool {
    let filled = |v: &Value| v.as_object().is_some_and(|o| !o.is_empty());
    !items.is_empty() && items.iter().all(filled)
}

fn record(out: &mut String, item: &Map<String, Value>, indent: usize) {
    for (i, (name, value)) in item.iter().enumerate() {
        for _ in 0..indent {
            out.push(' ');
        }
        out.push_str(if i == 0 { "- " } else { "  " });
        text(out, name);
        out.push_str(": ");
        inline(out, value);
        out.push('\n');
    }
}

/// A value on one line.
#[must_use]
pub fn flow(value: &Value) -> String {
    let mut out = String::new();
    inline(&mut out, value);
    out
}

fn inline(out: &mut String, value: &Value) {
    match value {
        Value::Null => out.push_str("null"),
        Value::Bool(b) => out.push_str(if *b { "true" } else { "false" }),
        Value::Number(n) => match canonical::number(n) {
            Some(n) => out.push_str(&n.to_string()),
            // Nothing that was checked holds such a number; as text it is refused when it is read.
            None => quoted(out, &n.to_string()),
        },
        Value::String(s) => text(out, s),
        Value::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate() {
                if i > 0 {
                    out.push_str(", ");
                }
                inline(out, item);
            }
            out.push(']');
        }
        Value::Object(map) => {
            out.push('{');
            for (i, (name, item)) in map.iter().enumerate() {
                if i > 0 {
                    out.push_str(", ");
                }
                text(out, name);
                out.push_str(": ");
                inline(out, item);
            }
            out.push('}');
        }
    }
}

fn text(out: &mut String, s: &str) {
    let first = s.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    let rest = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
    let word = WORDS.contains(&s.to_ascii_lowercase().as_str());
    if first && s.chars().all(rest) && !word {
        out.push_str(s);
    } else {
        quoted(out, s);
    }
}

fn quoted(out: &mut String, s: &str) {
    out.push('"');
    for c in s.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if unprintable(c) => {
                // Writing to a text cannot fail.
                let _ = write!(out, "\\U{:08X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
}

/// Characters that a YAML text may not hold, or that readers take for line ends or drop.
fn unprintable(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{2028}' | '\u{2029}' | '\u{FEFF}')
        || (u32::from(c) & 0xFFFE) == 0xFFFE
}
