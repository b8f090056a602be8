//! Whether a line is a message that the protocol's library takes, and if not, whose request it was.
//!
//! The library passes over lines that it cannot read, and answers others without saying whom it answers. Here
//! every line is read once, without keeping anything of it but what an answer needs: where it is refused, the
//! request's id goes with the refusal, as far as it came before what is wrong.

use std::fmt;

use rmcp::RoleServer;
use rmcp::model::JsonRpcMessage;
use rmcp::service::RxJsonRpcMessage;
use serde::Deserializer;
use serde::de::{self, DeserializeSeed, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::{Value, json};

/// The longest id that is given back, in bytes: one that is longer is no id but a burden.
const LONGEST_ID: usize = 4096;

/// The protocol's codes for what is wrong with a line.
const NO_JSON: i32 = -32700;
const NO_REQUEST: i32 = -32600;

/// The fields of messages.
const FIELDS: [&str; 6] = ["jsonrpc", "id", "method", "params", "result", "error"];

/// What keeps a line from the library.
#[derive(Debug, PartialEq)]
pub(crate) struct Refusal {
    id: Value,
    code: i32,
    why: String,
}

impl Refusal {
    /// The answer, a line without its end.
    pub(crate) fn answer(&self) -> String {
        json!({
            "jsonrpc": "2.0", "id": self.id, "error": {"code": self.code, "message": self.why},
        })
        .to_string()
    }

    /// Of a line that was read over because of its length; `head` is how it began.
    pub(crate) fn too_long(head: &[u8], most: usize) -> Self {
        let mut seen = Seen::default();
        // It breaks off, so it cannot be read to its end; what came first may still say whose it is.
        let _ = seen.read(head, Depth::Shallow);
        Self {
            id: seen.asker(),
            code: NO_JSON,
            why: format!("the line is longer than {most} bytes"),
        }
    }
}

/// Checks a line.
///
/// # Errors
/// Why the library would not take it.
pub(crate) fn check(line: &[u8]) -> Result<(), Refusal> {
    let mut seen = Seen::default();
    let Err(e) = seen.read(line, Depth::Whole) else {
        seen.is_message()?;
        return seen.is_taken(line);
    };
    let why = if std::str::from_utf8(line).is_err() {
        "the line is not UTF-8".to_owned()
    } else {
        // The words of the reader, which name no more of the text than a column.
        format!("the line is not JSON that can be read: {e}")
    };
    // What stands in a text does not hide what stands behind it: the id may be there.
    let mut again = Seen::default();
    let _ = again.read(line, Depth::Shallow);
    Err(Refusal {
        id: match again.asker() {
            Value::Null => seen.asker(),
            id => id,
        },
        code: NO_JSON,
        why,
    })
}

/// What a visitor has to say of plain values.
macro_rules! plain {
    ($flat:expr, $null:expr) => {
        fn visit_bool<E: de::Error>(self, _: bool) -> Result<Self::Value, E> {
            Ok($flat)
        }

        fn visit_i64<E: de::Error>(self, _: i64) -> Result<Self::Value, E> {
            Ok($flat)
        }

        fn visit_u64<E: de::Error>(self, _: u64) -> Result<Self::Value, E> {
            Ok($flat)
        }

        fn visit_f64<E: de::Error>(self, _: f64) -> Result<Self::Value, E> {
            Ok($flat)
        }

        fn visit_str<E: de::Error>(self, _: &str) -> Result<Self::Value, E> {
            Ok($flat)
        }

        fn visit_unit<E: de::Error>(self) -> Result<Self::Value, E> {
            Ok($null)
        }
    };
}

/// How closely a line is looked at.
#[derive(Clone, Copy, PartialEq)]
enum Depth {
    /// Every text and number in it, as the library does.
    Whole,
    /// The brackets only: whatever stands in a text is passed over.
    Shallow,
}

/// What was read of a line so far; it is kept even where the rest cannot be read.
#[derive(Debug, Default)]
struct Seen {
    object: bool,
    version: Option<Value>,
    id: Option<Value>,
    method: Option<Value>,
    answers: bool,
    /// Whether its parameters are no object.
    flat: bool,
    /// How often each of [`FIELDS`] came.
    fields: [usize; FIELDS.len()],
}

impl Seen {
    fn read(&mut self, line: &[u8], depth: Depth) -> Result<(), serde_json::Error> {
        let mut reader = serde_json::Deserializer::from_slice(line.trim_ascii());
        Top { seen: self, depth }.deserialize(&mut reader)?;
        reader.end()
    }

    /// Whose request it is. An id without a method is that of a request of ours: to answer it would
    /// answer another request of the client's.
    fn asker(&self) -> Value {
        let id = self.id.clone().filter(is_id);
        id.filter(|_| self.method.is_some()).unwrap_or_default()
    }

    fn is_message(&self) -> Result<(), Refusal> {
        let wrong = |why: &str| {
            Err(Refusal {
                id: self.asker(),
                code: NO_REQUEST,
                why: format!("this is no request: {why}"),
            })
        };
        if !self.object {
            return wrong("a message is one JSON object; several in a list are not taken");
        }
        if self.version != Some(json!("2.0")) {
            return wrong("\"jsonrpc\" is not \"2.0\"");
        }
        if !matches!(&self.id, None | Some(Value::Null)) && !self.id.as_ref().is_some_and(is_id) {
            return wrong("the id is neither a whole number nor a text of reasonable length");
        }
        // The library takes a request with two ids for a notification, and never answers it.
        let mut counted = self.fields.iter().zip(FIELDS);
        if let Some((_, field)) = counted.find(|(count, _)| **count > 1) {
            return wrong(&format!("it has more than one \"{field}\""));
        }
        if self.flat {
            return wrong("its parameters are no object");
        }
        match &self.method {
            Some(Value::String(_)) => Ok(()),
            Some(_) => wrong("the method is no text"),
            None if self.answers => Ok(()),
            None => wrong("it has no method"),
        }
    }
}

impl Seen {
    /// Whether the library reads it as what it is. What it cannot read it answers without an id, and a request that
    /// it takes for a notification it never answers.
    fn is_taken(&self, line: &[u8]) -> Result<(), Refusal> {
        let request = self.method.is_some() && self.id.is_some();
        match serde_json::from_slice::<RxJsonRpcMessage<RoleServer>>(line.trim_ascii()) {
            Ok(JsonRpcMessage::Request(_)) if request => Ok(()),
            Ok(_) if !request => Ok(()),
            // Notifications of other protocols are passed over, as the library does.
            Err(_) if self.method.is_some() && self.id.is_none() => Ok(()),
            _ => Err(Refusal {
                id: self.asker(),
                code: NO_REQUEST,
                why: "this is no request: the protocol has other parameters".to_owned(),
            }),
        }
    }
}

fn is_id(id: &Value) -> bool {
    match id {
        Value::Number(n) => n.as_i64().is_some(),
        Value::String(s) => s.len() <= LONGEST_ID,
        _ => false,
    }
}

/// The outermost value.
struct Top<'a> {
    seen: &'a mut Seen,
    depth: Depth,
}

impl<'de> DeserializeSeed<'de> for Top<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, reader: D) -> Result<(), D::Error> {
        reader.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Top<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a message")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            // Numbers come as maps of their own, whose one key the library of JSON has chosen.
            self.seen.object |= !key.starts_with('$');
            for (count, field) in self.seen.fields.iter_mut().zip(FIELDS) {
                *count += usize::from(field == key);
            }
            match key.as_str() {
                "jsonrpc" => self.seen.version = Some(map.next_value_seed(Small)?),
                "id" => self.seen.id = Some(map.next_value_seed(Small)?),
                "method" => self.seen.method = Some(map.next_value_seed(Small)?),
                other => {
                    self.seen.answers |= other == "result" || other == "error";
                    match self.depth {
                        Depth::Whole => {
                            let kind = map.next_value_seed(Any)?;
                            self.seen.flat |= other == "params" && kind == Kind::Flat;
                        }
                        Depth::Shallow => {
                            map.next_value::<IgnoredAny>()?;
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<(), A::Error> {
        Any.visit_seq(seq).map(drop)
    }

    plain!((), ());
}

/// What kind of value it is, as far as it matters.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Object,
    Null,
    /// A list, a text, a number or a truth value.
    Flat,
}

/// A value that is one text or number; anything else counts as no id.
struct Small;

impl<'de> DeserializeSeed<'de> for Small {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, reader: D) -> Result<Value, D::Error> {
        de::Deserialize::deserialize(reader)
    }
}

/// Any value: looked at, and not kept.
struct Any;

impl<'de> DeserializeSeed<'de> for Any {
    type Value = Kind;

    fn deserialize<D: Deserializer<'de>>(self, reader: D) -> Result<Kind, D::Error> {
        reader.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Any {
    type Value = Kind;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("any value")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Kind, A::Error> {
        while map.next_key_seed(Self)?.is_some() {
            map.next_value_seed(Self)?;
        }
        Ok(Kind::Object)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Kind, A::Error> {
        while seq.next_element_seed(Self)?.is_some() {}
        Ok(Kind::Flat)
    }

    plain!(Kind::Flat, Kind::Null);
}

#[cfg(test)]
mod tests {
    use super::{Refusal, check};
    use serde_json::{Value, json};

    fn refused(line: &[u8]) -> (Value, i64) {
        let answer: Value = serde_json::from_str(&check(line).unwrap_err().answer()).unwrap();
        let code = answer["error"]["code"].as_i64().unwrap();
        assert!(!answer["error"]["message"].as_str().unwrap().is_empty());
        (answer["id"].clone(), code)
    }

    #[test]
    fn messages_pass() {
        for line in [
            r#"{"jsonrpc":"2.0","id":1,"method":"ping"}"#,
            r#"{"jsonrpc":"2.0","id":"a","method":"x","params":{"n":1e999,"l":[1,-2,0.5,null,true,"\u00e9"]}}"#,
            r#"{"jsonrpc":"2.0","method":"notifications/initialized"}"#,
            r#"{"jsonrpc":"2.0","id":7,"result":{}}"#,
            r#"{"jsonrpc":"2.0","id":7,"error":{"code":1,"message":"m"}}"#,
        ] {
            assert_eq!(check(line.as_bytes()), Ok(()), "{line}");
        }
    }

    #[test]
    fn what_cannot_be_read_is_answered_with_its_id() {
        let deep = format!(r#"{}1{}"#, "[".repeat(130), "]".repeat(130));
        let with = |value: &[u8]| {
            let head = br#"{"jsonrpc":"2.0","params":{"x":"#;
            let tail = br#"},"id":"mine","method":"tools/call"}"#;
            [head, value, tail].concat()
        };
        for value in [br#""\ud800""#.as_slice(), b"\"\xff\"", deep.as_bytes()] {
            assert_eq!(refused(&with(value)), (json!("mine"), -32700));
        }
        // What came before the fault is known, what comes behind it is not.
        let broken = br#"{"jsonrpc":"2.0","id":4,"method":"ping","params":{]}"#;
        assert_eq!(refused(broken), (json!(4), -32700));
        assert_eq!(
            refused(br#"{"params":{],"id":4,"method":"m"}"#).0,
            Value::Null
        );
    }

    #[test]
    fn what_is_no_request_is_answered_with_its_id() {
        for (line, id) in [
            ("[]", Value::Null),
            ("42", Value::Null),
            ("null", Value::Null),
            (r#"{"jsonrpc":"2.0"}"#, Value::Null),
            (
                r#"{"jsonrpc":"1.0","id":901,"method":"tools/list"}"#,
                json!(901),
            ),
            (r#"{"jsonrpc":"2.0","id":902,"method":7}"#, json!(902)),
            (
                r#"{"jsonrpc":"2.0","id":903,"id":903,"method":"m"}"#,
                json!(903),
            ),
            (
                r#"{"jsonrpc":"2.0","id":{"a":1},"method":"m"}"#,
                Value::Null,
            ),
            (r#"{"jsonrpc":"2.0","id":1.5,"method":"m"}"#, Value::Null),
            (
                r#"{"jsonrpc":"2.0","id":null,"method":"ping"}"#,
                Value::Null,
            ),
            (
                r#"{"jsonrpc":"2.0","id":906,"method":"tools/call","params":{"name":"x","_meta":7}}"#,
                json!(906),
            ),
            (
                r#"{"jsonrpc":"2.0","id":904,"method":"m","params":"x"}"#,
                json!(904),
            ),
            (
                r#"{"jsonrpc":"2.0","id":905,"method":"m","params":[1]}"#,
                json!(905),
            ),
        ] {
            assert_eq!(refused(line.as_bytes()), (id, -32600), "{line}");
        }
    }

    #[test]
    fn an_answer_to_us_is_never_answered_with_its_id() {
        let line = br#"{"jsonrpc":"2.0","id":3,"result":{"text":"\ud800"}}"#;
        assert_eq!(refused(line).0, Value::Null);
    }

    #[test]
    fn the_beginning_of_a_long_line_says_whose_it_is() {
        let head = br#"{"jsonrpc":"2.0","id":9,"method":"tools/call","params":{"x":"aaaa"#;
        assert!(Refusal::too_long(head, 10).answer().contains("\"id\":9"));
    }
}
