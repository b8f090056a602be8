//! The names that a script sees.

use std::sync::LazyLock;

use starlark::environment::{Globals, GlobalsBuilder};

mod arg;
mod declare;
mod gears;
pub(crate) mod guard;
mod math;
mod profiles;
pub(crate) mod session;
mod shapes;
mod text;

pub(crate) use arg::*;

static GLOBALS: LazyLock<Globals> = LazyLock::new(|| {
    // The standard names first; guarded ones of the same name take their places.
    GlobalsBuilder::standard()
        .with(guard::functions)
        .with(text::functions)
        .with(declare::functions)
        .with(profiles::functions)
        .with(gears::functions)
        .with(shapes::functions)
        .with(math::functions)
        .with(|builder| builder.namespace("math", math::namespace))
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
