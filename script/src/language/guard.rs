//! Guarded operators and functions: what can make a value of any size in one step looks at the size
//! first. The interpreter's own memory limit looks only now and then, which is too late for
//! `"x" * 1000000000`.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use std::collections::HashMap;

use starlark::environment::GlobalsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::dict::DictRef;
use starlark::values::list::ListRef;
use starlark::values::range::Range;
use starlark::values::structs::StructRef;
use starlark::values::tuple::TupleRef;
use starlark::values::{UnpackValue, Value};

use super::session::Session;
use crate::fault::{Fault, too_much_memory};
use crate::limits::Limits;
use crate::values::native;

/// Operators and the functions that take their places; the names are out of a script's reach.
pub(crate) fn operators() -> HashMap<String, String> {
    [
        ("+", "__add"),
        ("*", "__mul"),
        ("%", "__percent"),
        ("<<", "__shift_left"),
    ]
    .map(|(operator, function)| (operator.to_owned(), function.to_owned()))
    .into()
}

/// How long a list, tuple or text is.
enum Size {
    Text(usize),
    Items(usize),
    Other,
}

fn size(value: Value<'_>) -> Size {
    if let Some(text) = value.unpack_str() {
        Size::Text(text.len())
    } else if let Some(list) = ListRef::from_value(value) {
        Size::Items(list.len())
    } else if let Some(tuple) = TupleRef::from_value(value) {
        Size::Items(tuple.len())
    } else {
        Size::Other
    }
}

pub(crate) fn check_text(bytes: usize, limits: &Limits) -> Result<(), Fault> {
    if bytes <= limits.text_bytes {
        return Ok(());
    }
    Err(Fault::new(format!(
        "a text would have {bytes} bytes, more than {} (limit text_bytes)",
        limits.text_bytes
    )))
}

fn check_items(items: usize, limits: &Limits) -> Result<(), Fault> {
    if items <= limits.list_items {
        return Ok(());
    }
    Err(Fault::new(format!(
        "a list would have {items} items, more than {} (limit list_items)",
        limits.list_items
    )))
}

fn check_heap(eval: &Evaluator<'_, '_, '_>, limits: &Limits) -> Result<(), Fault> {
    if eval.heap().allocated_bytes() <= limits.heap_bytes {
        Ok(())
    } else {
        Err(too_much_memory(limits))
    }
}

fn check_int(value: Value<'_>) -> Result<(), Fault> {
    let small = value.get_type() != "int" || matches!(i64::unpack_value(value), Ok(Some(_)));
    if small {
        Ok(())
    } else {
        Err(Fault::new("a whole number is outside of 64 bits"))
    }
}

/// An upper bound of the length of the text that a value is written as.
///
/// The same list may be a member of many; a count of what is written, not of what is stored, ends the
/// walk through such a net early.
pub(crate) fn written_length(value: Value<'_>, limits: &Limits) -> Result<usize, Fault> {
    let most = limits.text_bytes;
    let (mut length, mut rest) = (0_usize, vec![value]);
    while let Some(value) = rest.pop() {
        length += 4;
        if let Some(text) = value.unpack_str() {
            length += text.len();
        } else if let Some(list) = ListRef::from_value(value) {
            rest.extend(list.content().iter().take(most));
        } else if let Some(tuple) = TupleRef::from_value(value) {
            rest.extend(tuple.content().iter().take(most));
        } else if let Some(dict) = DictRef::from_value(value) {
            rest.extend(dict.iter().flat_map(|(k, v)| [k, v]).take(most));
        } else if let Some(fields) = StructRef::from_value(value) {
            rest.extend(fields.iter().map(|(_, v)| v).take(most));
            length += 16;
        } else {
            length += 24;
        }
        check_text(length.saturating_add(rest.len()), limits)?;
    }
    Ok(length)
}

#[starlark_module]
pub(crate) fn functions(builder: &mut GlobalsBuilder) {
    fn __add<'v>(
        #[starlark(require = pos)] a: Value<'v>,
        #[starlark(require = pos)] b: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        let limits = &Session::of(eval).map_err(anyhow::Error::new)?.limits;
        match (size(a), size(b)) {
            (Size::Text(a), Size::Text(b)) => check_text(a + b, limits),
            (Size::Items(a), Size::Items(b)) => check_items(a + b, limits),
            _ => Ok(()),
        }
        .and_then(|()| check_heap(eval, limits))
        .map_err(native)?;
        a.add(b, eval.heap())
    }

    fn __mul<'v>(
        #[starlark(require = pos)] a: Value<'v>,
        #[starlark(require = pos)] b: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        let limits = &Session::of(eval).map_err(anyhow::Error::new)?.limits;
        let times = |n: Value<'v>| {
            n.unpack_i32()
                .map_or(0, |n| usize::try_from(n).unwrap_or(0))
        };
        match (size(a), size(b)) {
            (Size::Text(n), _) => check_text(n.saturating_mul(times(b)), limits),
            (_, Size::Text(n)) => check_text(n.saturating_mul(times(a)), limits),
            (Size::Items(n), _) => check_items(n.saturating_mul(times(b)), limits),
            (_, Size::Items(n)) => check_items(n.saturating_mul(times(a)), limits),
            _ => check_int(a).and_then(|()| check_int(b)),
        }
        .and_then(|()| check_heap(eval, limits))
        .map_err(native)?;
        a.mul(b, eval.heap())
    }

    fn __percent<'v>(
        #[starlark(require = pos)] a: Value<'v>,
        #[starlark(require = pos)] b: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        let limits = &Session::of(eval).map_err(anyhow::Error::new)?.limits;
        if let Some(text) = a.unpack_str() {
            let places = text.matches('%').count();
            let length = written_length(b, limits).map_err(native)?;
            check_text(
                text.len().saturating_add(places.saturating_mul(length)),
                limits,
            )
            .and_then(|()| check_heap(eval, limits))
            .map_err(native)?;
        }
        a.percent(b, eval.heap())
    }

    fn __shift_left<'v>(
        #[starlark(require = pos)] a: Value<'v>,
        #[starlark(require = pos)] b: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        check_int(a).map_err(native)?;
        if b.unpack_i32().is_none_or(|n| n > 62) {
            return Err(native(Fault::new(
                "a whole number is shifted by 0 to 62 places",
            )));
        }
        a.left_shift(b, eval.heap())
    }

    /// `range(stop)`, `range(start, stop)`, `range(start, stop, step)`.
    #[starlark(as_type = Range)]
    fn range(
        #[starlark(require = pos)] a: i32,
        #[starlark(require = pos)] b: Option<i32>,
        #[starlark(require = pos, default = 1)] step: i32,
        eval: &mut Evaluator<'_, '_, '_>,
    ) -> anyhow::Result<Range> {
        let (start, stop) = b.map_or((0, a), |b| (a, b));
        let Some(step) = core::num::NonZeroI32::new(step) else {
            return Fault::new("the step of a range is not 0").raise();
        };
        let span = i64::from(stop) - i64::from(start);
        let steps = usize::try_from(span / i64::from(step.get())).unwrap_or(0);
        check_items(steps, &Session::of(eval)?.limits)?;
        Ok(Range::new(start, stop, step))
    }

    /// `getattr(x, name)` and `getattr(x, name, default)`.
    fn getattr<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        #[starlark(require = pos)] name: &str,
        #[starlark(require = pos)] default: Option<Value<'v>>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        if crate::scan::UNGUARDED_METHODS
            .iter()
            .any(|(method, _)| *method == name)
        {
            return Err(native(Fault::new(format!("there is no method '{name}'"))));
        }
        match (x.get_attr(name, eval.heap())?, default) {
            (Some(value), _) | (None, Some(value)) => Ok(value),
            (None, None) => Err(native(Fault::new(format!(
                "a value of type {} has no '{}'",
                x.get_type(),
                assemcad_model::param::clip(name)
            )))),
        }
    }
}
