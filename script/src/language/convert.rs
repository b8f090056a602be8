//! Arguments as a recipe writes them: one rule for each [`Kind`].

use assemcad_model::frame::Frame;
use assemcad_model::language::{Default, Kind, Param, Type};
use assemcad_model::param::clip;
use assemcad_model::recipe::referring;
use serde_json::{Map, Value as Json, json};
use starlark::values::Value;
use starlark::values::dict::DictRef;

use super::{items, kind_of, number, vector, whole};
use crate::fault::Fault;
use crate::values::{Location, Outline, Plane, Selector, handle, handle::Handle};

/// The names of planes, as `cq.Plane.named` takes them.
pub(crate) const PLANES: [&str; 12] = [
    "XY", "YZ", "ZX", "XZ", "YX", "ZY", "front", "back", "left", "right", "top", "bottom",
];

/// The planes that `mirror` takes by name.
const MIRRORS: [&str; 6] = ["XY", "YX", "XZ", "ZX", "YZ", "ZY"];

/// A parameter's default as a recipe writes it; none where it is left out.
pub(crate) fn default(param: &Param) -> Option<Json> {
    match param.default {
        Default::Required | Default::None => None,
        Default::Flag(flag) => Some(of_flag(param.kind, flag)),
        Default::Real(n) => Some(json!(n)),
        Default::Count(n) => Some(json!(n)),
        Default::Text(text) => Some(json!(text)),
        Default::Vector(v) => Some(json!(v)),
    }
}

fn of_flag(kind: Kind, flag: bool) -> Json {
    match kind {
        Kind::Flags2 => json!([flag, flag]),
        Kind::Flags3 => json!([flag, flag, flag]),
        Kind::Combine => json!(if flag { "add" } else { "none" }),
        _ => json!(flag),
    }
}

/// An argument as a recipe writes it; `what` names it in messages.
pub(crate) fn write(kind: Kind, value: Value<'_>, what: &str) -> Result<Json, Fault> {
    let wrong = |takes: &str| Fault::new(format!("{what} is {takes}, not {}", kind_of(value)));
    let text = value.unpack_str();
    let flag = value.unpack_bool();
    match kind {
        Kind::Real => number(value, what).map(|n| json!(n)),
        Kind::Count => whole(value, what).map(|n| json!(n)),
        Kind::Flag => flag.map(|b| json!(b)).ok_or_else(|| wrong("True or False")),
        Kind::Text => text.map(|t| json!(t)).ok_or_else(|| wrong("a text")),
        Kind::Choice(choices) => one_of(value, choices, what),
        Kind::Vector => vector(value, what).map(|v| json!(v)),
        Kind::Vectors => each(value, what, "a list of points", |v, what| {
            vector(v, what).map(|v| json!(v))
        }),
        Kind::MaybeVectors => each(value, what, "a list of directions", |v, what| {
            if v.is_none() {
                Ok(Json::Null)
            } else {
                vector(v, what).map(|v| json!(v))
            }
        }),
        Kind::Reals => each(value, what, "a list of numbers", |v, what| {
            number(v, what).map(|n| json!(n))
        }),
        Kind::Flags2 => flags(kind, value, 2, what),
        Kind::Flags3 => flags(kind, value, 3, what),
        Kind::Combine => match (flag, text) {
            (Some(flag), _) => Ok(of_flag(kind, flag)),
            (_, Some("a")) => Ok(json!("add")),
            (_, Some("s" | "cut")) => Ok(json!("cut")),
            _ => Err(wrong("True, False, \"a\", \"s\" or \"cut\"")),
        },
        Kind::Selector => {
            let selector = if let Some(text) = text {
                Selector::parse(text)?
            } else if let Some(selector) = Selector::from_value(value) {
                selector.clone()
            } else {
                return Err(wrong("a selector such as \">Z\""));
            };
            json_of(&selector.selector)
        }
        Kind::Until => match (text, handle(value)) {
            (Some("next" | "last"), _) => Ok(json!(text)),
            (_, Some(face)) if face.kind == Type::Shape => Ok(referring(face.node.index)),
            (None, None) => number(value, what).map(|n| json!(n)),
            _ => Err(wrong(
                "a length, \"next\", \"last\" or a face (faces(...).val())",
            )),
        },
        Kind::Plane => {
            plane(value, &PLANES, what)?.ok_or_else(|| wrong("a plane's name or a cq.Plane"))
        }
        Kind::PlaneOrShape => match (plane(value, &PLANES, what)?, handle(value)) {
            (Some(plane), _) => Ok(plane),
            (None, Some(shape)) if shape.kind == Type::Shape => Ok(referring(shape.node.index)),
            _ => Err(wrong("a plane's name, a cq.Plane or a shape")),
        },
        Kind::MirrorPlane => match (text, solid(value)) {
            (Some(_), _) => one_of(value, &MIRRORS, what),
            (_, Some(face)) => Ok(face),
            _ if Plane::from_value(value).is_some() => {
                Err(wrong("a name such as \"XY\", a normal or a face")
                    .hint("write the plane's zDir, and its origin as basePointVector"))
            }
            _ => vector(value, what).map(|v| json!(v)),
        },
        Kind::Location => place(value).unwrap_or_else(|| Err(wrong("a cq.Location"))),
        Kind::Places => each(value, what, "a list of points", |v, what| {
            place(v).unwrap_or_else(|| vector(v, what).map(|v| json!(v)))
        }),
        Kind::Workplane => match handle(value) {
            Some(Handle {
                kind: Type::Workplane,
                node,
            }) => Ok(referring(node.index)),
            _ => Err(wrong("a workplane")),
        },
        Kind::Solid | Kind::PerLocation | Kind::PerObject => {
            solid(value).ok_or_else(|| match kind {
                Kind::Solid => wrong("a workplane or a shape"),
                Kind::PerLocation => wrong("a workplane, a shape or a function of a location"),
                _ => wrong("a function of an object"),
            })
        }
        Kind::Solids => match (solid(value), handle(value)) {
            (Some(one), _) => Ok(one),
            (
                None,
                Some(Handle {
                    kind: Type::Shapes,
                    node,
                }),
            ) => Ok(referring(node.index)),
            _ => each(
                value,
                what,
                "a workplane, a shape or a list of shapes",
                |v, what| {
                    solid(v).ok_or_else(|| {
                        Fault::new(format!(
                            "{what} is a workplane or a shape, not {}",
                            kind_of(v)
                        ))
                    })
                },
            ),
        },
        Kind::PortParams => port_params(value, what),
        Kind::Outline => match Outline::from_value(value) {
            Some(outline) => json_of(&outline.outline),
            None => Err(wrong("an outline such as cq.involute(...) gives")),
        },
    }
}

/// A value of the model as JSON.
pub(crate) fn json_of(value: &impl serde::Serialize) -> Result<Json, Fault> {
    serde_json::to_value(value).map_err(|e| Fault::new(e.to_string()))
}

fn one_of(value: Value<'_>, choices: &[&str], what: &str) -> Result<Json, Fault> {
    let quoted: Vec<String> = choices.iter().map(|c| format!("\"{c}\"")).collect();
    match value.unpack_str() {
        Some(text) if choices.contains(&text) => Ok(json!(text)),
        Some(text) => Err(Fault::new(format!("{what} is not \"{}\"", clip(text)))
            .hint(format!("it is one of {}", quoted.join(", ")))),
        None => Err(Fault::new(format!(
            "{what} is one of {}, not {}",
            quoted.join(", "),
            kind_of(value)
        ))),
    }
}

fn each(
    value: Value<'_>,
    what: &str,
    takes: &str,
    mut write: impl FnMut(Value<'_>, &str) -> Result<Json, Fault>,
) -> Result<Json, Fault> {
    let items = items(value)
        .ok_or_else(|| Fault::new(format!("{what} is {takes}, not {}", kind_of(value))))?;
    items
        .into_iter()
        .enumerate()
        .map(|(i, item)| write(item, &format!("{what}[{i}]")))
        .collect()
}

fn flags(kind: Kind, value: Value<'_>, n: usize, what: &str) -> Result<Json, Fault> {
    if let Some(flag) = value.unpack_bool() {
        return Ok(of_flag(kind, flag));
    }
    let all: Option<Vec<bool>> =
        items(value).and_then(|list| list.into_iter().map(Value::unpack_bool).collect());
    match all {
        Some(all) if all.len() == n => Ok(json!(all)),
        _ => Err(Fault::new(format!(
            "{what} is True, False or {n} of them in a tuple"
        ))),
    }
}

fn plane(value: Value<'_>, names: &[&str], what: &str) -> Result<Option<Json>, Fault> {
    if let Some(plane) = Plane::from_value(value) {
        return json_of(&plane.frame).map(Some);
    }
    value
        .unpack_str()
        .map(|_| one_of(value, names, what))
        .transpose()
}

/// A location, given or yet to be found.
fn place(value: Value<'_>) -> Option<Result<Json, Fault>> {
    if let Some(location) = Location::from_value(value) {
        return Some(Frame::try_from(location).and_then(|frame| json_of(&frame)));
    }
    let handle = handle(value)?;
    // What a function of `each` is given may be a place too: the stack of polarArray holds places.
    let object = || {
        handle
            .node
            .recorder
            .get()
            .call(handle.node.index)
            .is_some_and(|c| c.call == "eachObject")
    };
    match handle.kind {
        Type::Location => Some(Ok(referring(handle.node.index))),
        Type::Shape if object() => Some(Ok(referring(handle.node.index))),
        _ => None,
    }
}

fn solid(value: Value<'_>) -> Option<Json> {
    handle(value)
        .filter(|h| matches!(h.kind, Type::Workplane | Type::Shape))
        .map(|h| referring(h.node.index))
}

fn port_params(value: Value<'_>, what: &str) -> Result<Json, Fault> {
    let wrong = || {
        Fault::new(format!(
            "{what} is a dict of names and numbers, not {}",
            kind_of(value)
        ))
        .hint("write for example {\"diameter\": 8, \"depth\": 20}")
    };
    let dict = DictRef::from_value(value).ok_or_else(wrong)?;
    let mut params = Map::new();
    for (name, value) in dict.iter() {
        let name = name.unpack_str().ok_or_else(wrong)?;
        params.insert(
            name.to_owned(),
            json!(number(value, &format!("{what}[\"{}\"]", clip(name)))?),
        );
    }
    Ok(Json::Object(params))
}
