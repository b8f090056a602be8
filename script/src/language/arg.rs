//! Arguments of the language's functions, read with messages of our own.

use starlark::values::float::UnpackFloat;
use starlark::values::list_or_tuple::UnpackListOrTuple;
use starlark::values::{UnpackValue, Value};

use crate::fault::Fault;
use crate::values::Vector;

/// A finite real number.
pub(crate) fn number(value: Value<'_>, what: &str) -> Result<f64, Fault> {
    match UnpackFloat::unpack_value(value) {
        // Adding 0.0 turns -0.0 into 0.0, which would otherwise print differently.
        Ok(Some(UnpackFloat(n))) if n.is_finite() => Ok(n + 0.0),
        Ok(Some(_)) => Err(Fault::new(format!("{what} is not finite"))),
        _ => Err(Fault::new(format!(
            "{what} is a number, not {}",
            kind_of(value)
        ))),
    }
}

/// A whole number.
pub(crate) fn whole(value: Value<'_>, what: &str) -> Result<i32, Fault> {
    if let Some(n) = value.unpack_i32().filter(|_| value.get_type() == "int") {
        return Ok(n);
    }
    if value.get_type() == "int" {
        return Err(Fault::new(format!("{what} is too large a number")));
    }
    let fault = Fault::new(format!("{what} is a whole number, not {}", kind_of(value)));
    Err(if value.get_type() == "float" {
        fault.hint("write int(x), or x // y instead of x / y")
    } else {
        fault
    })
}

/// A point or direction: a `Vector`, or two or three numbers.
pub(crate) fn vector(value: Value<'_>, what: &str) -> Result<[f64; 3], Fault> {
    if let Some(vector) = Vector::from_value(value) {
        return Ok(vector.at);
    }
    let wrong = || {
        Fault::new(format!(
            "{what} is a tuple of 2 or 3 numbers, not {}",
            kind_of(value)
        ))
        .hint("write for example (10, 0) or (10, 0, 5)")
    };
    let items = items(value).ok_or_else(wrong)?;
    let numbers: Vec<f64> = items
        .iter()
        .take(4)
        .map(|v| number(*v, what))
        .collect::<Result<_, _>>()?;
    match *numbers.as_slice() {
        [x, y] => Ok([x, y, 0.0]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err(Fault::new(format!(
            "{what} is a tuple of 2 or 3 numbers, not of {}",
            items.len()
        ))
        .hint("write for example (10, 0) or (10, 0, 5)")),
    }
}

/// The members of a list or tuple.
pub(crate) fn items(value: Value<'_>) -> Option<Vec<Value<'_>>> {
    UnpackListOrTuple::<Value<'_>>::unpack_value(value)
        .ok()
        .flatten()
        .map(|list| list.items)
}

/// What a value is, with its article.
pub(crate) fn kind_of(value: Value<'_>) -> String {
    match value.get_type() {
        "NoneType" => "None".to_owned(),
        "int" => "an int".to_owned(),
        kind => format!("a {kind}"),
    }
}
