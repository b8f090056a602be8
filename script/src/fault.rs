//! Faults of a script and how they become diagnostics.

use std::collections::BTreeMap;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::param::clip;
use starlark::ErrorKind;
use starlark::codemap::FileSpan;

use crate::language::session::Session;
use crate::limits::Limits;

/// What a function of the language answers when it refuses its arguments.
///
/// Travels through the interpreter as the cause of its error and is found again at the other end.
#[derive(Debug, Clone, thiserror::Error)]
#[error("{message}")]
pub(crate) struct Fault {
    pub(crate) message: String,
    pub(crate) hint: Option<String>,
    /// Line where the one that raised the fault knows better than the interpreter.
    pub(crate) line: Option<u32>,
    /// Whether the parameters are at fault and not the script.
    pub(crate) of_params: bool,
}

impl Fault {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            hint: None,
            line: None,
            of_params: false,
        }
    }

    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    pub(crate) fn line(mut self, line: u32) -> Self {
        self.line = Some(line);
        self
    }

    /// As the interpreter's error.
    pub(crate) fn raise<T>(self) -> anyhow::Result<T> {
        Err(anyhow::Error::new(self))
    }

    /// As a diagnostic of the factory `name`; `line` where the fault names none itself.
    pub(crate) fn diagnostic(self, name: &str, line: Option<u32>) -> Diagnostic {
        if self.of_params {
            return of_params(&self.message);
        }
        let d = Diagnostic::error(
            Code::FactoryFailed,
            place(name, self.line.or(line)),
            capped(&self.message),
        );
        match self.hint {
            Some(hint) => d.hint(hint),
            None => d,
        }
    }
}

/// A rule between parameters that does not hold.
pub(crate) fn of_params(message: &str) -> Diagnostic {
    Diagnostic::error(Code::ParamInvalid, "params", capped(message))
}

/// `factory NAME, line LINE`.
pub(crate) fn place(name: &str, line: Option<u32>) -> String {
    match line {
        Some(line) => format!("factory {name}, line {line}"),
        None => format!("factory {name}"),
    }
}

fn capped(message: &str) -> String {
    const MOST: usize = 400;
    let message = message.trim();
    if message.chars().count() <= MOST {
        return message.to_owned();
    }
    let head: String = message.chars().take(MOST).collect();
    format!("{head}...")
}

/// The interpreter's error as a diagnostic.
pub(crate) fn diagnostic(name: &str, session: &Session, error: &starlark::Error) -> Diagnostic {
    let limits = &session.limits;
    // Of some faults the interpreter does not say where; they came up in the statement of the moment.
    let line = line_of(error, &session.lines).or_else(|| session.recorder.get().line());
    let (ErrorKind::Fail(cause)
    | ErrorKind::StackOverflow(cause)
    | ErrorKind::Value(cause)
    | ErrorKind::Function(cause)
    | ErrorKind::Scope(cause)
    | ErrorKind::Parser(cause)
    | ErrorKind::Freeze(cause)
    | ErrorKind::Internal(cause)
    | ErrorKind::Native(cause)
    | ErrorKind::Other(cause)) = error.kind()
    else {
        return Fault::new("the script cannot be evaluated").diagnostic(name, line);
    };
    if let Some(fault) = cause.downcast_ref::<Fault>() {
        return fault.clone().diagnostic(name, line);
    }
    let text = cause.to_string();
    let fault = match error.kind() {
        ErrorKind::StackOverflow(_) => too_deep(limits),
        ErrorKind::Parser(_) => syntax(&text),
        ErrorKind::Scope(_) => unknown_name(&text),
        ErrorKind::Internal(_) => Fault::new("the interpreter met a fault of its own here")
            .hint("write the statement in another way"),
        _ => crate::hints::missing(&text, written(error)).unwrap_or_else(|| other(&text, limits)),
    };
    fault.diagnostic(name, line)
}

/// The line of the statement or call at fault, 1-based.
fn line_of(error: &starlark::Error, lines: &Lines) -> Option<u32> {
    let span = error.span().or_else(|| {
        error
            .call_stack()
            .frames
            .iter()
            .rev()
            .find_map(|frame| frame.location.as_ref())
    })?;
    // What is missing behind a point is named at the end of the expression.
    if error.kind().to_string().contains("has no attribute") {
        return u32::try_from(span.resolve_span().end.line + 1).ok();
    }
    lines.of(span)
}

/// What stands in the source where the interpreter found fault.
fn written(error: &starlark::Error) -> &str {
    error.span().map(FileSpan::source_span).unwrap_or_default()
}

/// Where calls stand in a source.
#[derive(Debug, Default)]
pub(crate) struct Lines(pub(crate) BTreeMap<u32, u32>);

impl Lines {
    /// The 1-based line of a call's name, which in a chain over several lines is not where the
    /// expression begins; of anything else the line where it begins.
    pub(crate) fn of(&self, span: &FileSpan) -> Option<u32> {
        let end = span.span.end().get();
        self.0.get(&end).copied().or_else(|| line_at(span))
    }
}

/// The 1-based line at which a span begins.
pub(crate) fn line_at(span: &FileSpan) -> Option<u32> {
    u32::try_from(span.resolve_span().begin.line + 1).ok()
}

pub(crate) fn too_deep(limits: &Limits) -> Fault {
    Fault::new(format!(
        "calls are nested more than {} deep (limit call_depth)",
        limits.call_depth
    ))
    .hint("a function must not call itself: write a for loop over a list or a range")
}

pub(crate) fn too_much_memory(limits: &Limits) -> Fault {
    Fault::new(format!(
        "values use more than {} bytes (limit heap_bytes)",
        limits.heap_bytes
    ))
    .hint("keep lists short; do not join texts in a loop")
}

pub(crate) fn too_long(limits: &Limits) -> Fault {
    Fault::new(format!(
        "the evaluation took longer than {:?} (limit time)",
        limits.time
    ))
    .hint("do less work in loops")
}

pub(crate) fn too_many_ticks(limits: &Limits) -> Fault {
    Fault::new(format!(
        "more than {} calls and turns of loops (limit ticks)",
        limits.ticks
    ))
    .hint("do less work in loops")
}

fn syntax(text: &str) -> Fault {
    let text = text.trim_start_matches("Parse error: ");
    let text = clip(text.lines().next().unwrap_or_default());
    Fault::new(format!("this line is not Starlark: {text}"))
}

/// How the fault of an unknown name begins.
pub(crate) const UNKNOWN_NAME: &str = "there is nothing of the name";

fn unknown_name(text: &str) -> Fault {
    let wanted = text.split('`').nth(1).unwrap_or_default();
    let fault = Fault::new(format!("{UNKNOWN_NAME} '{}'", clip(wanted)));
    if let Some(hint) = crate::hints::name_hint(wanted) {
        return fault.hint(hint);
    }
    match assemcad_model::name::nearest(wanted, crate::language::names(), 3).as_slice() {
        [] => fault.hint(format!(
            "there are: {}",
            crate::language::names().join(", ")
        )),
        near => fault.hint(format!("did you mean {}?", near.join(" or "))),
    }
}

/// Errors without a kind of their own; the interpreter keeps their types to itself, so that limits can
/// be told only by the beginnings of their texts (a test goes through every one of them).
fn other(text: &str, limits: &Limits) -> Fault {
    if text.starts_with("Heap memory limit") {
        too_much_memory(limits)
    } else if text.starts_with("Execution duration limit") {
        too_many_ticks(limits)
    } else if text.starts_with("Evaluation cancelled") {
        too_long(limits)
    } else if text.contains("type annotation") || text.contains("is implemented only for") {
        Fault::new("this type has no meaning here").hint("leave the type out")
    } else if text.contains("recursion level") {
        Fault::new("values are nested too deeply").hint("keep lists and dicts flat")
    } else {
        let text = text.trim_start_matches("fail: ");
        Fault::new(clip_long(text))
    }
}

fn clip_long(text: &str) -> String {
    text.lines().map(str::trim).collect::<Vec<_>>().join(" ")
}
