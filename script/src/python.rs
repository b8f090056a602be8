//! What of Python a source may hold although Starlark lacks it: imports of what is there already, and
//! f-strings. Both are rewritten before the parser sees them, on the lines on which they stand.

use core::fmt::Write as _;

use starlark::codemap::CodeMap;
use starlark::syntax::Dialect;
use starlark_syntax::lexer::{Lexer, Token};

use crate::fault::Fault;
use crate::imports::{end_of_import, import};
use crate::scan::RESERVED_PREFIX;

/// A stretch of the source and what takes its place.
struct Edit {
    from: usize,
    to: usize,
    text: String,
}

/// The source with imports and f-strings written out.
pub(crate) fn rewrite(source: &str, dialect: &Dialect) -> Result<String, Vec<Fault>> {
    let (edits, faults) = edits(source, dialect);
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut text = String::new();
    let mut at = 0;
    for edit in edits {
        let kept = source.get(at..edit.from).unwrap_or_default();
        text.push_str(kept);
        text.push_str(&edit.text);
        // Lines stay where they are.
        let cut = source.get(edit.from..edit.to).unwrap_or_default();
        text.extend(cut.chars().filter(|c| *c == '\n'));
        at = edit.to;
    }
    text.push_str(source.get(at..).unwrap_or_default());
    Ok(text)
}

/// An f-string that is open.
struct Open {
    /// Brackets open in the expression.
    brackets: usize,
    /// Where the text after the expression's `!` or `:` begins.
    form: Option<usize>,
    lambdas: usize,
}

fn edits(source: &str, dialect: &Dialect) -> (Vec<Edit>, Vec<Fault>) {
    let codemap = CodeMap::new(String::new(), source.to_owned());
    let line = |at: usize| {
        let before = source.as_bytes().iter().take(at);
        u32::try_from(before.filter(|b| **b == b'\n').count() + 1).unwrap_or(u32::MAX)
    };
    let (mut edits, mut faults): (Vec<Edit>, Vec<Fault>) = (Vec::new(), Vec::new());
    let mut open: Vec<Open> = Vec::new();
    let (mut begins, mut past, mut beyond) = (true, 0, 0);
    for lexeme in Lexer::new(codemap.source(), dialect, codemap.clone()) {
        let (from, token, to) = match lexeme {
            Ok(lexeme) => lexeme,
            Err(error) => {
                let error = error.into_error();
                let word = error.span().map(|span| {
                    let (from, to) = (span.span.begin(), span.span.end());
                    (from.get() as usize, to.get() as usize)
                });
                // After a fault of its own within an f-string the lexer gives the same one for ever.
                let Some((from, to)) = word.filter(|(from, _)| *from >= beyond) else {
                    break;
                };
                beyond = from + 1;
                let is_import = matches!(source.get(from..to), Some("import" | "from"));
                if is_import && begins && from >= past {
                    let end = end_of_import(source, from);
                    match import(source.get(from..end).unwrap_or_default()) {
                        Ok(text) => edits.push(Edit {
                            from,
                            to: end,
                            text,
                        }),
                        Err(fault) => faults.push(fault.line(line(from))),
                    }
                    past = end;
                }
                begins = false;
                continue;
            }
        };
        if from < past {
            continue;
        }
        begins = matches!(
            token,
            Token::Newline | Token::Indent | Token::Dedent | Token::Semicolon | Token::Colon
        ) || (begins && matches!(token, Token::Comment(_)));
        if let Token::Identifier(name) = &token
            && name.starts_with(RESERVED_PREFIX)
        {
            let fault = Fault::new(format!("names do not begin with '{RESERVED_PREFIX}'"));
            faults.push(
                if name == "__name__" {
                    fault.hint("leave the condition out: write its lines at the top level")
                } else {
                    fault
                }
                .line(line(from)),
            );
        }
        fstring(source, from, &token, to, &mut open, &mut edits);
        if faults.len() >= 20 {
            break;
        }
    }
    (edits, faults)
}

/// An f-string becomes `__text(piece, piece)`, whose pieces are `"text", ` and `__piece((x), "form"), `.
fn fstring(
    source: &str,
    from: usize,
    token: &Token,
    to: usize,
    open: &mut Vec<Open>,
    edits: &mut Vec<Edit>,
) {
    let mut edit = |from: usize, text: String| {
        // What stands in a form was read as tokens too.
        while edits.pop_if(|e: &mut Edit| e.from >= from).is_some() {}
        edits.push(Edit { from, to, text });
    };
    match token {
        Token::FStringStart(_) => {
            open.push(Open {
                brackets: 0,
                form: None,
                lambdas: 0,
            });
            edit(from, "__text(".to_owned());
        }
        Token::FStringText(text) if from < to => {
            let text: &str = text;
            edit(from, format!("{}, ", literal(text)));
        }
        Token::FStringExprStart => edit(from, "__piece((".to_owned()),
        Token::FStringExprEnd => {
            if let Some(state) = open.last_mut() {
                let form = state.form.take();
                let text = form.and_then(|at| source.get(at..from)).unwrap_or_default();
                edit(form.unwrap_or(from), format!("), {}), ", literal(text)));
            }
        }
        Token::FStringEnd => {
            open.pop();
            edit(from, ")".to_owned());
        }
        _ => {
            if let Some(state) = open.last_mut() {
                match token {
                    Token::OpeningRound | Token::OpeningSquare | Token::OpeningCurly => {
                        state.brackets += 1;
                    }
                    Token::ClosingRound | Token::ClosingSquare | Token::ClosingCurly => {
                        state.brackets = state.brackets.saturating_sub(1);
                    }
                    Token::Lambda => state.lambdas += 1,
                    Token::Colon if state.brackets == 0 && state.lambdas > 0 => state.lambdas -= 1,
                    Token::Colon | Token::FStringBang if state.brackets == 0 => {
                        state.form.get_or_insert(from);
                    }
                    _ => {}
                }
            }
        }
    }
}

/// A text as a source writes it, on one line.
fn literal(text: &str) -> String {
    let mut written = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => written.push_str("\\\""),
            '\\' => written.push_str("\\\\"),
            '\n' => written.push_str("\\n"),
            '\r' => written.push_str("\\r"),
            '\t' => written.push_str("\\t"),
            c if c.is_control() => {
                let _ = write!(written, "\\U{:08x}", u32::from(c));
            }
            c => written.push(c),
        }
    }
    written.push('"');
    written
}

#[cfg(test)]
mod tests {
    use super::rewrite;

    #[track_caller]
    fn rewritten(source: &str) -> String {
        let text = rewrite(source, &crate::run::dialect()).unwrap();
        assert_eq!(text.lines().count(), source.lines().count(), "{text}");
        text
    }

    #[test]
    fn imports_bind_names_and_keep_lines() {
        for (source, expected) in [
            ("import cadquery as cq\nx = 1\n", "pass\nx = 1\n"),
            ("import cadquery\n", "pass\n"),
            ("import cadquery as c, math as m\n", "c = cq; m = math\n"),
            ("import math # why\n", "pass# why\n"),
            (
                "from math import sin, pi as p\n",
                "sin = math.sin; p = math.pi\n",
            ),
            (
                "from cadquery import (\n    Workplane,  # w\n    Vector,\n)\n",
                "Workplane = cq.Workplane; Vector = cq.Vector\n\n\n\n",
            ),
            (
                "from cadquery.selectors import BoxSelector\n",
                "BoxSelector = cq.selectors.BoxSelector\n",
            ),
            (
                "def f():\n    import math\n    return 1\n",
                "def f():\n    pass\n    return 1\n",
            ),
            (
                "x = \"\"\"\nimport os\n\"\"\"\n",
                "x = \"\"\"\nimport os\n\"\"\"\n",
            ),
        ] {
            assert_eq!(rewritten(source), expected);
        }
        assert!(rewritten("from math import *\n").contains("; sqrt = math.sqrt"));
        for source in [
            "import os\n",
            "from cadquery import Assembly\n",
            "import numpy as np\n",
        ] {
            assert_eq!(
                rewrite(source, &crate::run::dialect()).unwrap_err().len(),
                1
            );
        }
    }

    #[test]
    fn f_strings_become_guarded_texts() {
        for (source, expected) in [
            (
                "x = f\"a {b} c\"\n",
                "x = __text(\"a \", __piece((b), \"\"), \" c\", )\n",
            ),
            (
                "x = f'{a[\"k\"]:.2f}{b!r}'\n",
                "x = __text(__piece((a[\"k\"]), \":.2f\"), __piece((b), \"!r\"), )\n",
            ),
            (
                "x = f\"{f'{a}'}{{}}\"\n",
                "x = __text(__piece((__text(__piece((a), \"\"), )), \"\"), \"{}\", )\n",
            ),
            (
                "x = f\"\"\"a\n{b}\n\"\"\"\ny = 1\n",
                "x = __text(\"a\\n\", \n__piece((b), \"\"), \"\\n\", \n)\ny = 1\n",
            ),
        ] {
            assert_eq!(rewritten(source), expected);
        }
    }
}
