//! The names that a script sees.

use std::sync::LazyLock;

use starlark::environment::{Globals, GlobalsBuilder};

use crate::values::Item;

mod arg;
pub(crate) mod bind;
pub(crate) mod call;
mod convert;
pub(crate) mod cq;
mod declare;
pub(crate) mod guard;
mod math;
mod ports;
mod pure;
pub(crate) mod session;
mod text;

pub(crate) use arg::*;

static GLOBALS: LazyLock<Globals> = LazyLock::new(|| {
    // The standard names first; guarded ones of the same name take their places.
    GlobalsBuilder::standard()
        .with(guard::functions)
        .with(text::functions)
        .with(declare::functions)
        .with(math::functions)
        .with(|builder| {
            builder.namespace("math", math::namespace);
            for name in ["cq", "cadquery"] {
                builder.set(name, Item { path: "" });
            }
        })
        .build()
});

/// Every global of the language.
pub(crate) fn globals() -> &'static Globals {
    &GLOBALS
}

/// The names of every global that a script may use, sorted.
pub(crate) fn names() -> Vec<&'static str> {
    GLOBALS
        .names()
        .map(|n| n.as_str())
        .filter(|n| !n.starts_with(crate::scan::RESERVED_PREFIX))
        .collect()
}

/// The names behind `math.`, sorted.
pub(crate) fn math_names() -> Vec<&'static str> {
    static NAMES: LazyLock<Vec<String>> = LazyLock::new(|| {
        let math = GlobalsBuilder::new().with(math::namespace).build();
        let mut names: Vec<String> = math.names().map(|n| n.as_str().to_owned()).collect();
        names.sort();
        names
    });
    NAMES.iter().map(String::as_str).collect()
}
