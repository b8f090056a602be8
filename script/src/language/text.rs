//! Texts of guarded length, and the two ways to refuse parameters.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use assemcad_model::language::Type;
use assemcad_model::param::clip;
use starlark::environment::GlobalsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::none::NoneType;
use starlark::values::string::StarlarkStr;
use starlark::values::{StringValue, Value};

use super::guard::{check_text, written_length};
use super::items;
use super::session::{Session, line};
use crate::fault::Fault;

/// Rules beyond these are not collected.
const MOST_BROKEN_RULES: usize = 20;

fn refuse(message: String, eval: &Evaluator<'_, '_, '_>) -> Fault {
    // At the top level there are no parameters yet that could be at fault.
    let of_params = Session::of(eval).is_ok_and(|s| s.building.get());
    Fault {
        message,
        hint: None,
        line: Some(line(eval)),
        of_params,
    }
}

fn message_of<'v>(parts: &[Value<'v>], eval: &Evaluator<'v, '_, '_>) -> Result<String, Fault> {
    let limits = &Session::of(eval)?.limits;
    let mut message = String::new();
    for part in parts {
        written_length(*part, limits)?;
        if !message.is_empty() {
            message.push(' ');
        }
        message.push_str(&part.to_str());
    }
    Ok(message)
}

/// A value by the form that an f-string states: `!r`, `!s`, `:.2f`, `:d`, `:03d`, `:>8`, `:g` and so on
/// are Python's; of them only those that write numbers for people.
fn formed(x: Value<'_>, form: &str) -> Result<String, Fault> {
    let unknown = || {
        Fault::new(format!("the form '{}' has no meaning here", clip(form)))
            .hint("write {x}, {x!r}, {x:.2f}, {x:d} or {x:03d}")
    };
    let number = || super::number(x, "what is written with a form");
    match form {
        "" | "!s" | ":" | ":s" => return Ok(x.to_str()),
        "!r" => return Ok(x.to_repr()),
        _ => {}
    }
    let form = form.strip_prefix(':').ok_or_else(unknown)?;
    if let Some(width) = form.strip_suffix('d') {
        let n = super::whole(x, "what is written with the form d")?;
        let wide: usize = if width.is_empty() {
            0
        } else {
            width
                .parse()
                .ok()
                .filter(|w| *w < 100)
                .ok_or_else(unknown)?
        };
        return Ok(if width.starts_with('0') {
            format!("{n:0wide$}")
        } else {
            format!("{n:wide$}")
        });
    }
    let digits = form
        .strip_suffix('f')
        .and_then(|f| f.strip_prefix('.'))
        .and_then(|d| d.parse::<usize>().ok())
        .filter(|d| *d <= 20)
        .ok_or_else(unknown)?;
    Ok(format!("{:.digits$}", number()?))
}

#[starlark_module]
pub(crate) fn functions(builder: &mut GlobalsBuilder) {
    /// `str(x)`: x as a text.
    #[starlark(as_type = StarlarkStr)]
    fn str<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<StringValue<'v>> {
        if let Some(text) = StringValue::new(x) {
            return Ok(text);
        }
        written_length(x, &Session::of(eval)?.limits)?;
        Ok(eval.heap().alloc_str(&x.to_str()))
    }

    /// `repr(x)`: x as it is written in a source.
    fn repr<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<String> {
        written_length(x, &Session::of(eval)?.limits)?;
        Ok(x.to_repr())
    }

    /// `join(separator, items)`: texts in one.
    fn join<'v>(
        #[starlark(require = pos)] separator: &str,
        #[starlark(require = pos)] texts: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<String> {
        let limits = &Session::of(eval)?.limits;
        let Some(texts) = items(texts) else {
            return Fault::new("join takes a separator and a list of texts").raise();
        };
        let mut joined = String::new();
        for (i, part) in texts.into_iter().enumerate() {
            let Some(part) = part.unpack_str() else {
                return Fault::new(format!("join takes texts, not a {}", part.get_type()))
                    .hint("write `[str(x) for x in items]`")
                    .raise();
            };
            if i > 0 {
                joined.push_str(separator);
            }
            joined.push_str(part);
            check_text(joined.len(), limits)?;
        }
        Ok(joined)
    }

    /// `replace(text, old, new)`: every `old` in `text` made `new`.
    fn replace<'v>(
        #[starlark(require = pos)] text: &str,
        #[starlark(require = pos)] old: &str,
        #[starlark(require = pos)] new: &str,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<String> {
        let added = text.matches(old).count().saturating_mul(new.len());
        check_text(text.len().saturating_add(added), &Session::of(eval)?.limits)?;
        Ok(text.replace(old, new))
    }

    /// What an f-string is rewritten to: its pieces in one.
    fn __text<'v>(
        #[starlark(args)] pieces: starlark::values::tuple::UnpackTuple<Value<'v>>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<String> {
        let limits = &Session::of(eval)?.limits;
        let mut text = String::new();
        for piece in pieces.items {
            text.push_str(piece.unpack_str().unwrap_or_default());
            check_text(text.len(), limits)?;
        }
        Ok(text)
    }

    /// A value within an f-string, with what stands behind its `!` or `:`.
    fn __piece<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        #[starlark(require = pos)] form: &str,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<String> {
        written_length(x, &Session::of(eval)?.limits)?;
        Ok(formed(x, form)?)
    }

    /// `show_object(x)`: what a plain script gives where it leaves no `result`.
    fn show_object<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        #[starlark(args)] rest: starlark::values::tuple::UnpackTuple<Value<'v>>,
        #[starlark(kwargs)] options: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<NoneType> {
        let _ = (rest, options);
        let session = Session::of(eval)?;
        match crate::values::handle(x) {
            Some(part) if matches!(part.kind, Type::Workplane | Type::Shape) => {
                if session.shown.get().is_none() {
                    session.shown.set(Some(part.node.index));
                }
                Ok(NoneType)
            }
            _ => Fault::new(format!(
                "show_object takes a workplane, not {}",
                super::kind_of(x)
            ))
            .raise(),
        }
    }

    /// `debug(x)` goes nowhere.
    fn debug<'v>(
        #[starlark(args)] parts: starlark::values::tuple::UnpackTuple<Value<'v>>,
        #[starlark(kwargs)] options: Value<'v>,
    ) -> anyhow::Result<NoneType> {
        let _ = (parts, options);
        Ok(NoneType)
    }

    /// `print(x)` goes nowhere, and does not even write x as a text.
    fn print<'v>(
        #[starlark(args)] parts: starlark::values::tuple::UnpackTuple<Value<'v>>,
    ) -> anyhow::Result<NoneType> {
        let _ = parts;
        Ok(NoneType)
    }

    /// `fail(message)`: the parameters cannot be built; nothing after it is carried out.
    fn fail<'v>(
        #[starlark(args)] parts: starlark::values::tuple::UnpackTuple<Value<'v>>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<NoneType> {
        let message = message_of(&parts.items, eval)?;
        refuse(message, eval).raise()
    }

    /// `require(condition, message)`: a rule between parameters. The script goes on, so that every
    /// rule that does not hold is reported; its solid is not used then.
    fn require<'v>(
        #[starlark(require = pos)] condition: bool,
        #[starlark(args)] parts: starlark::values::tuple::UnpackTuple<Value<'v>>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<NoneType> {
        if parts.items.is_empty() {
            return Fault::new("require takes a condition and a message")
                .hint("write `require(d < width, \"d must be less than width\")`")
                .raise();
        }
        if condition {
            return Ok(NoneType);
        }
        let message = message_of(&parts.items, eval)?;
        let session = Session::of(eval)?;
        if !session.building.get() {
            return refuse(message, eval).raise();
        }
        let mut broken = session.broken_rules.borrow_mut();
        if broken.len() < MOST_BROKEN_RULES && !broken.contains(&message) {
            broken.push(message);
        }
        Ok(NoneType)
    }
}
