//! What the functions of the language share during one evaluation.
#![allow(
    unsafe_code,
    reason = "derive(ProvidesStaticType) implements an unsafe trait; none of ours"
)]

use std::cell::{Cell, RefCell};

use assemcad_model::param::ParamSpec;
use assemcad_model::recipe::Ref;
use starlark::any::ProvidesStaticType;
use starlark::eval::Evaluator;

use crate::fault::{Fault, Lines};
use crate::limits::Limits;
use crate::recorder::Shared;

/// What `factory(...)` declared.
#[derive(Debug)]
pub(crate) struct Declaration {
    pub(crate) doc: String,
    pub(crate) params: Vec<ParamSpec>,
}

/// The state of one evaluation.
#[derive(Debug, ProvidesStaticType)]
pub(crate) struct Session {
    pub(crate) limits: Limits,
    pub(crate) recorder: Shared,
    pub(crate) lines: Lines,
    pub(crate) declaration: RefCell<Option<Declaration>>,
    /// Whether `build(p)` is running and not the top level.
    pub(crate) building: Cell<bool>,
    /// What `show_object` was given first.
    pub(crate) shown: Cell<Option<Ref>>,
    /// Messages of `require` whose condition did not hold.
    pub(crate) broken_rules: RefCell<Vec<String>>,
}

impl Session {
    pub(crate) fn new(limits: &Limits, lines: Lines, source: &str) -> Self {
        Self {
            limits: limits.clone(),
            recorder: Shared::new(limits, source),
            lines,
            declaration: RefCell::new(None),
            building: Cell::new(false),
            shown: Cell::new(None),
            broken_rules: RefCell::new(Vec::new()),
        }
    }

    /// The session of a running evaluation.
    pub(crate) fn of<'a>(eval: &Evaluator<'_, 'a, '_>) -> Result<&'a Self, Fault> {
        eval.extra
            .and_then(|extra| extra.downcast_ref::<Self>())
            .ok_or_else(|| Fault::new("this function works in a script only"))
    }
}

/// The 1-based line of the call that runs; 0 where the interpreter does not say.
pub(crate) fn line(eval: &Evaluator<'_, '_, '_>) -> u32 {
    let Ok(session) = Session::of(eval) else {
        return 0;
    };
    eval.call_stack_top_location()
        .as_ref()
        .and_then(|span| session.lines.of(span))
        .unwrap_or(0)
}
