//! A look at the tokens before the parser sees them: how deep the source nests, and what of Python it
//! uses that Starlark or this language lacks.

use std::collections::BTreeMap;

use starlark::codemap::CodeMap;
use starlark::syntax::Dialect;
use starlark_syntax::lexer::{Lexer, Token};

use crate::fault::Fault;
use crate::limits::Limits;

/// Names that begin so belong to the language itself.
pub(crate) const RESERVED_PREFIX: &str = "__";

/// Methods of texts and lists whose result can be of any size, with what to write instead. They are
/// methods of built-in types, which cannot be guarded one by one.
pub(crate) const UNGUARDED_METHODS: [(&str, &str); 4] = [
    ("extend", "write `items += more`"),
    ("format", "write `\"bore %s leaves no wall\" % d`"),
    ("join", "write `join(\", \", items)`"),
    ("replace", "write `replace(text, old, new)`"),
];

/// Every fault that the tokens show, in order of lines.
///
/// Stops without a word at what is not a token: the parser says it better.
pub(crate) fn scan(source: &str, dialect: &Dialect, limits: &Limits) -> Vec<Fault> {
    let codemap = CodeMap::new(String::new(), source.to_owned());
    let line = |at: usize| {
        let before = source
            .as_bytes()
            .iter()
            .take(at)
            .filter(|b| **b == b'\n')
            .count();
        u32::try_from(before + 1).unwrap_or(u32::MAX)
    };
    let mut faults = Vec::new();
    let mut depth = Depth::default();
    let mut compared = Compared::default();
    let mut previous = Previous::Nothing;
    for lexeme in Lexer::new(codemap.source(), dialect, codemap.clone()) {
        let (begin, token, end) = match lexeme {
            Ok(lexeme) => lexeme,
            Err(e) => match reserved_word(&e.into_error()) {
                Some(fault) if faults.len() < MOST_FAULTS => {
                    faults.push(fault);
                    previous = Previous::Nothing;
                    continue;
                }
                _ => break,
            },
        };
        if depth.step(&token) > limits.nesting {
            faults.push(too_deep(limits).line(line(begin)));
            break;
        }
        let text = source.get(begin..end).unwrap_or_default();
        let fault = match &token {
            Token::Load => Some(reserved("import")),
            Token::StarStar if previous == Previous::Operand => {
                Some(Fault::new("there is no operator '**'").hint("write `x * x`, or `pow(x, y)`"))
            }
            Token::StarEqual | Token::PercentEqual | Token::LessLessEqual => {
                let operator = text.trim_end_matches('=');
                Some(
                    Fault::new(format!("there is no operator '{text}'"))
                        .hint(format!("write `x = x {operator} y`")),
                )
            }
            Token::Identifier(name) if previous == Previous::Dot => method(name),
            _ => None,
        };
        let fault = fault.or_else(|| compared.step(&token));
        faults.extend(fault.map(|f| f.line(line(begin))));
        if faults.len() >= MOST_FAULTS {
            break;
        }
        previous = match token {
            Token::Dot => Previous::Dot,
            Token::Identifier(_)
            | Token::Int(_)
            | Token::Float(_)
            | Token::String(_)
            | Token::ClosingRound
            | Token::ClosingSquare
            | Token::ClosingCurly => Previous::Operand,
            _ => Previous::Nothing,
        };
    }
    faults
}

/// The end of every bracket's `)` and the line of its `(`: where a call ends and where its name stands.
pub(crate) fn calls(source: &str, dialect: &Dialect) -> BTreeMap<u32, u32> {
    let codemap = CodeMap::new(String::new(), source.to_owned());
    let (mut open, mut found) = (Vec::new(), BTreeMap::new());
    let (mut line, mut counted) = (1, 0);
    for (begin, token, end) in
        Lexer::new(codemap.source(), dialect, codemap.clone()).map_while(Result::ok)
    {
        match token {
            Token::OpeningRound => {
                let before = source.as_bytes().get(counted..begin).unwrap_or_default();
                line += before.iter().filter(|b| **b == b'\n').count();
                counted = begin;
                open.push(u32::try_from(line).unwrap_or(u32::MAX));
            }
            Token::ClosingRound => {
                if let (Some(line), Ok(end)) = (open.pop(), u32::try_from(end)) {
                    found.insert(end, line);
                }
            }
            _ => {}
        }
    }
    found
}

/// More faults than these are of one kind.
const MOST_FAULTS: usize = 20;

#[derive(PartialEq)]
enum Previous {
    Nothing,
    Operand,
    Dot,
}

/// An upper bound of the depth of the syntax tree at a token.
///
/// One counter per open bracket: how many tokens since the last comma in it may each put the tree one
/// level deeper (`a + b + c`, `not not a`, `f()()`, `a if b else c if d else e`).
#[derive(Default)]
struct Depth {
    outer: usize,
    open: Vec<usize>,
    blocks: usize,
    /// `elif` branches; each nests in the one before.
    branches: usize,
}

impl Depth {
    fn step(&mut self, token: &Token) -> usize {
        match token {
            Token::OpeningRound | Token::OpeningSquare | Token::OpeningCurly => {
                *self.level() += 1;
                self.open.push(0);
            }
            Token::ClosingRound | Token::ClosingSquare | Token::ClosingCurly => {
                self.open.pop();
            }
            Token::Comma => *self.level() = 0,
            Token::Newline | Token::Semicolon => {
                *self.level() = 0;
            }
            Token::Indent => self.blocks += 1,
            Token::Dedent => self.blocks = self.blocks.saturating_sub(1),
            Token::Elif => self.branches += 1,
            // An operand neither deepens the tree nor ends what does.
            Token::Identifier(_) | Token::Int(_) | Token::Float(_) | Token::String(_) => {}
            _ => *self.level() += 1,
        }
        let open = self
            .open
            .iter()
            .fold(self.open.len(), |sum, n| sum.saturating_add(*n));
        open + self.outer + self.blocks + self.branches
    }

    fn level(&mut self) -> &mut usize {
        self.open.last_mut().unwrap_or(&mut self.outer)
    }
}

/// Whether a comparison stands before, in the same bracket and the same operand of `and` and `or`.
#[derive(Default)]
struct Compared {
    outer: bool,
    open: Vec<bool>,
}

impl Compared {
    fn step(&mut self, token: &Token) -> Option<Fault> {
        match token {
            Token::LessThan
            | Token::LessEqual
            | Token::GreaterThan
            | Token::GreaterEqual
            | Token::EqualEqual
            | Token::BangEqual
                if core::mem::replace(self.here(), true) =>
            {
                return Some(
                    Fault::new("there are no chained comparisons")
                        .hint("write `0 < x and x < 5` for `0 < x < 5`"),
                );
            }
            Token::OpeningRound | Token::OpeningSquare | Token::OpeningCurly => {
                self.open.push(false);
            }
            Token::ClosingRound | Token::ClosingSquare | Token::ClosingCurly => {
                self.open.pop();
            }
            Token::And
            | Token::Or
            | Token::Not
            | Token::If
            | Token::Else
            | Token::For
            | Token::Lambda
            | Token::Return
            | Token::Comma
            | Token::Colon
            | Token::Equal
            | Token::Semicolon
            | Token::Newline => *self.here() = false,
            _ => {}
        }
        None
    }

    fn here(&mut self) -> &mut bool {
        self.open.last_mut().unwrap_or(&mut self.outer)
    }
}

fn too_deep(limits: &Limits) -> Fault {
    Fault::new(format!(
        "the source is nested more than {} deep (limit nesting)",
        limits.nesting
    ))
    .hint("split the statement: give its pieces names")
}

fn method(name: &str) -> Option<Fault> {
    let (_, hint) = UNGUARDED_METHODS
        .iter()
        .find(|(method, _)| *method == name)?;
    Some(Fault::new(format!("there is no method '{name}'")).hint(*hint))
}

/// The lexer itself refuses words that Python has reserved; its error spans the word.
fn reserved_word(error: &starlark::Error) -> Option<Fault> {
    let span = error.span()?;
    let word = span.source_span();
    let is_word = !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase());
    let fault = reserved(word);
    let fault = crate::fault::line_at(span).map_or(fault.clone(), |line| fault.line(line));
    is_word.then_some(fault)
}

fn reserved(word: &str) -> Fault {
    let hint = match word {
        "while" => "write `for i in range(1000):` and leave it with `break`",
        "try" | "except" | "finally" => {
            "there are no exceptions: look before with `if`, or refuse with require(condition, message)"
        }
        "raise" => "write `fail(message)`",
        "assert" => "write `require(condition, message)`",
        "class" => "there are no classes: write functions, and `dict(a = 1)` for records",
        "import" | "from" => "cadquery and math are there already; nothing else can be imported",
        "is" => "write `==`, for example `x == None`",
        "del" => "write `items.pop(index)`",
        "with" => "there is nothing to open or close: write the block without it",
        "global" | "nonlocal" => "give the value to the function and let it return the new one",
        "yield" | "async" | "await" => "write a function that returns a list",
        _ => "this word is reserved: take another name",
    };
    Fault::new(format!("there is no '{word}'")).hint(hint)
}

#[cfg(test)]
mod tests {
    use super::Depth;
    use starlark::codemap::CodeMap;
    use starlark::syntax::Dialect;
    use starlark_syntax::lexer::Lexer;

    fn deepest(source: &str) -> usize {
        let codemap = CodeMap::new(String::new(), source.to_owned());
        let mut depth = Depth::default();
        Lexer::new(codemap.source(), &Dialect::Standard, codemap.clone())
            .map_while(Result::ok)
            .map(|(_, token, _)| depth.step(&token))
            .max()
            .unwrap()
    }

    #[test]
    fn depth_follows_brackets_chains_and_blocks_and_not_length() {
        assert!(deepest(&"x = [1, 2, 3]\n".repeat(500)) < 5);
        assert!(deepest(&format!("x = [{}]\n", "[1, 2], ".repeat(500))) < 6);
        assert!(deepest(&format!("x = {}1{}\n", "(".repeat(50), ")".repeat(50))) >= 50);
        assert!(deepest(&format!("x = 1{}\n", " + 1".repeat(50))) >= 50);
        assert!(deepest(&format!("x = {}1\n", "not ".repeat(50))) >= 50);
        assert!(deepest(&format!("x = {}1\n", "lambda: ".repeat(50))) >= 50);
        assert!(deepest(&format!("x = f{}\n", "()".repeat(50))) >= 50);
        assert!(deepest(&format!("if a:\n  b\n{}", "elif a:\n  b\n".repeat(50))) >= 50);
    }
}
