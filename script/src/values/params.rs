//! Declarations of parameters, and checked parameters as a script sees them.
#![allow(
    clippy::panic,
    reason = "derive(StarlarkPagablePanic); nothing here is ever paged out"
)]
#![allow(missing_docs, reason = "the macros make public items of the values")]
#![allow(
    unsafe_code,
    reason = "derive(ProvidesStaticType) implements an unsafe trait; none of ours"
)]

use core::fmt;

use allocative::Allocative;
use assemcad_model::param::{ParamKind, ParamSpec};
use serde_json::{Map, Value as Json};
use starlark::environment::Module;
use starlark::starlark_simple_value;
use starlark::values::list::AllocList;
use starlark::values::structs::AllocStruct;
use starlark::values::{
    Heap, NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, Value,
    starlark_value,
};

/// What `number(...)`, `choice(...)` and the like give.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Param {
    pub(crate) doc: String,
    #[allocative(skip)]
    pub(crate) kind: ParamKind,
}
starlark_simple_value!(Param);

impl fmt::Display for Param {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("<parameter>")
    }
}

#[starlark_value(type = "Param")]
impl<'v> StarlarkValue<'v> for Param {}

/// Checked parameters as one value: `p.length`, `p.segments[0].d`.
pub(crate) fn record<'v>(
    heap: Heap<'v>,
    specs: &[ParamSpec],
    params: &Map<String, Json>,
) -> Value<'v> {
    let fields: Vec<(&str, Value<'v>)> = specs
        .iter()
        .map(|spec| {
            let value = params.get(&spec.name).unwrap_or(&Json::Null);
            (spec.name.as_str(), value_of(heap, &spec.kind, value))
        })
        .collect();
    heap.alloc(AllocStruct(fields))
}

/// The kind decides the type: a number written as 3 is a real number all the same.
fn value_of<'v>(heap: Heap<'v>, kind: &ParamKind, value: &Json) -> Value<'v> {
    match (kind, value) {
        (ParamKind::Number { .. }, Json::Number(n)) => heap.alloc(n.as_f64().unwrap_or(f64::NAN)),
        (ParamKind::Integer { .. }, Json::Number(n)) => heap.alloc(n.as_i64().unwrap_or_default()),
        (ParamKind::Choice { .. }, Json::String(word)) => heap.alloc(word.as_str()),
        (ParamKind::Flag { .. }, Json::Bool(flag)) => Value::new_bool(*flag),
        (ParamKind::Records { fields, .. }, Json::Array(items)) => {
            let empty = Map::new();
            heap.alloc(AllocList(items.iter().map(|item| {
                record(heap, fields, item.as_object().unwrap_or(&empty))
            })))
        }
        _ => Value::new_none(),
    }
}

/// Binds values at the top level of a module, except under names that are the language's own.
pub(crate) fn bind(module: &Module<'_>, given: &Map<String, Json>) {
    for (name, value) in given {
        if !name.starts_with(crate::scan::RESERVED_PREFIX) {
            module.set(name, plain(module.heap(), value));
        }
    }
}

/// A value without a declaration: a number written as 3 is a whole one, as it would be in a script.
fn plain<'v>(heap: Heap<'v>, value: &Json) -> Value<'v> {
    match value {
        Json::Null => Value::new_none(),
        Json::Bool(flag) => Value::new_bool(*flag),
        Json::Number(n) => match (n.as_i64(), n.as_f64()) {
            (Some(whole), _) => heap.alloc(whole),
            (None, Some(real)) => heap.alloc(real),
            (None, None) => Value::new_none(),
        },
        Json::String(text) => heap.alloc(text.as_str()),
        Json::Array(items) => heap.alloc(AllocList(items.iter().map(|item| plain(heap, item)))),
        Json::Object(fields) => {
            let fields = fields.iter().map(|(k, v)| (k.as_str(), plain(heap, v)));
            heap.alloc(AllocStruct(fields.collect::<Vec<_>>()))
        }
    }
}
