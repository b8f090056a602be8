//! Short arithmetic over parameters: `2 * wall + bore_d`, `min(a, b)`, `math.sqrt(d)`.

use std::sync::Arc;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name::nearest;
use serde_json::{Map, Value, json};
use starlark::codemap::CodeMap;
use starlark_syntax::lexer::{Lexer, Token};

use crate::fault::UNKNOWN_NAME;
use crate::limits::Limits;
use crate::run::{Job, dialect};

/// Longest expression in bytes.
const MOST_BYTES: usize = 4 << 10;

/// The functions that are of use in an expression, beside those behind `math.`.
const FUNCTIONS: [&str; 9] = [
    "abs", "float", "int", "len", "max", "min", "pow", "round", "sum",
];

/// What an expression is, for whoever wrote something else.
const FORM: &str = "write one expression, such as `2 * wall + bore_d`, `min(a, b)` or \
    `math.sqrt(d)`: numbers, parameters, + - * / // %, abs, min, max, round, sum, math.*";

/// The values of expressions over the names in `params`; one answer each, in order.
///
/// Each is one expression of the factory language, evaluated by itself under the limits of a factory.
/// Numbers of `params` are numbers, lists are lists, and the fields of an object stand behind a point.
/// The place of a diagnostic is `expressions[INDEX]`; that of an unknown name lists the known ones as
/// `expected`.
#[must_use]
pub fn expressions(params: &Map<String, Value>, texts: &[String]) -> Vec<Result<f64, Diagnostic>> {
    let place = |i: usize| format!("expressions[{i}]");
    let one = |(i, text): (usize, &String)| value(params, text, &place(i));
    texts.iter().enumerate().map(one).collect()
}

fn value(params: &Map<String, Value>, text: &str, place: &str) -> Result<f64, Diagnostic> {
    let refused = |message: String| {
        Diagnostic::error(Code::ArgumentInvalid, place, message)
            .found(text)
            .hint(FORM)
    };
    let text = text.trim();
    if text.is_empty() {
        return Err(refused("the expression is empty".to_owned()));
    }
    if text.len() > MOST_BYTES {
        let bytes = text.len();
        return Err(refused(format!(
            "the expression has {bytes} bytes, more than {MOST_BYTES}"
        )));
    }
    if !is_closed(text) {
        return Err(refused("the brackets do not match".to_owned()));
    }
    let job = Job {
        name: place.to_owned(),
        // Within brackets only an expression can stand.
        source: Arc::from(format!("({text}\n)")),
        limits: Limits::default(),
    };
    job.number(params.clone()).map_err(|faults| {
        let first = faults.into_iter().next();
        let message = first.as_ref().map(|d| d.message.clone());
        let d = refused(message.unwrap_or_default());
        let Some(wanted) = d.message.strip_prefix(UNKNOWN_NAME) else {
            return match first.and_then(|d| d.hint) {
                Some(hint) => d.hint(hint),
                None => d,
            };
        };
        let known: Vec<&str> = params.keys().map(String::as_str).collect();
        let all = || known.iter().copied().chain(FUNCTIONS);
        let near = nearest(wanted.trim_matches([' ', '\'']), all(), 3);
        let hint = match near.as_slice() {
            [] => format!("there are the parameters, math, {}", FUNCTIONS.join(", ")),
            near => format!("did you mean {}?", near.join(" or ")),
        };
        let expected = json!(known);
        d.hint(hint).expected(expected)
    })
}

/// Whether no bracket of the text ends one that was opened before it.
fn is_closed(text: &str) -> bool {
    let codemap = CodeMap::new(String::new(), text.to_owned());
    let mut open = 0_usize;
    for (_, token, _) in
        Lexer::new(codemap.source(), &dialect(), codemap.clone()).map_while(Result::ok)
    {
        match token {
            Token::OpeningRound | Token::OpeningSquare | Token::OpeningCurly => open += 1,
            Token::ClosingRound | Token::ClosingSquare | Token::ClosingCurly => {
                let Some(fewer) = open.checked_sub(1) else {
                    return false;
                };
                open = fewer;
            }
            _ => {}
        }
    }
    open == 0
}
