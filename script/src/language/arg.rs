//! Arguments of the language's functions, read with messages of our own.

use starlark::values::float::UnpackFloat;
use starlark::values::list_or_tuple::UnpackListOrTuple;
use starlark::values::{UnpackValue, Value};

use crate::fault::Fault;

/// A finite real number.
pub(crate) fn number(value: Value<'_>, what: &str) -> Result<f64, Fault> {
    match UnpackFloat::unpack_value(value) {
        Ok(Some(UnpackFloat(n))) if n.is_finite() => Ok(n),
        Ok(Some(_)) => Err(Fault::new(format!("{what} is not finite"))),
        _ => Err(Fault::new(format!(
            "{what} is a number, not a {}",
            value.get_type()
        ))),
    }
}

/// A finite number over 0.
pub(crate) fn positive(value: Value<'_>, what: &str) -> Result<f64, Fault> {
    let n = number(value, what)?;
    if n > 0.0 {
        Ok(n)
    } else {
        Err(Fault::new(format!("{what} is over 0, not {n}")))
    }
}

/// `N` finite numbers in a list or tuple.
pub(crate) fn vector<const N: usize>(value: Value<'_>, what: &str) -> Result<[f64; N], Fault> {
    let wrong = || {
        let example = if N == 2 { "(10, 0)" } else { "(10, 0, 5)" };
        Fault::new(format!("{what} is a tuple of {N} numbers"))
            .hint(format!("write for example {example}"))
    };
    let items = items(value).ok_or_else(wrong)?;
    let numbers: Vec<f64> = items
        .into_iter()
        .map(|v| number(v, what))
        .collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| wrong())
}

/// The members of a list or tuple.
pub(crate) fn items(value: Value<'_>) -> Option<Vec<Value<'_>>> {
    UnpackListOrTuple::<Value<'_>>::unpack_value(value)
        .ok()
        .flatten()
        .map(|list| list.items)
}
