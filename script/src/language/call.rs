//! Calls of the language's functions: arguments in, a recorded call out.

use std::collections::BTreeMap;

use assemcad_model::language::{Default, Kind, Method, Param, Type, method};
use assemcad_model::recipe::referring;
use serde_json::Value as Json;
use starlark::eval::{Arguments, Evaluator};
use starlark::values::{Heap, Value};

use super::bind::{Given, signature};
use super::session::{Session, line};
use super::{convert, kind_of, ports};
use crate::fault::Fault;
use crate::values::handle::{self, Node};
use crate::values::native;

/// Calls a function of the table on what the script wrote.
pub(crate) fn invoke<'v>(
    method: &'static Method,
    on: Option<&Node>,
    args: &Arguments<'v, '_>,
    eval: &mut Evaluator<'v, '_, '_>,
) -> starlark::Result<Value<'v>> {
    let line = line(eval);
    let at = |fault: Fault| native(fault.line(line));
    let session = Session::of(eval).map_err(at)?;
    let given = splitting(method, Given::of(args, eval.heap())?);
    let params = params(method);
    let mut bound = given.bind(method.short(), params).map_err(at)?;
    let mut args = BTreeMap::new();
    for (param, slot) in params.iter().zip(&mut bound) {
        if let (Kind::PerLocation | Kind::PerObject, Some(function)) = (param.kind, *slot)
            && function.get_type() == "function"
        {
            let node = on.ok_or_else(|| at(Fault::new("there is no stack to go through")))?;
            let (variable, result) = per(param, function, node, session, line, eval)?;
            args.insert(param.name.to_owned(), result);
            args.insert("variable".to_owned(), variable);
            *slot = None;
        }
    }
    record(method, on, &session.recorder, &bound, args, line)
        .map(|node| handle::value(method.gives, node, eval.heap()))
        .map_err(at)
}

/// Calls a method from an operator, which knows only its operands.
pub(crate) fn apply<'v>(
    method: &'static Method,
    on: &Node,
    positions: Vec<Value<'v>>,
    heap: Heap<'v>,
) -> Result<Value<'v>, Fault> {
    let given = Given {
        positions,
        named: Vec::new(),
    };
    let bound = splitting(method, given).bind(method.short(), params(method))?;
    let line = on.recorder.get().line().unwrap_or(0);
    let node = record(
        method,
        Some(on),
        &on.recorder,
        &bound,
        BTreeMap::new(),
        line,
    )?;
    Ok(handle::value(method.gives, node, heap))
}

/// The parameters that a script may give; the outline of a gear is ours to write.
pub(crate) fn params(method: &Method) -> &'static [Param] {
    match method.params.split_last() {
        Some((last, rest)) if last.kind == Kind::Outline && last.default == Default::None => rest,
        _ => method.params,
    }
}

/// How a method is called.
fn shown(method: &Method) -> String {
    signature(method.short(), params(method).iter())
}

/// `split(other)`, which CadQuery has beside `split(keepTop, keepBottom)`.
fn splitting<'v>(method: &Method, mut given: Given<'v>) -> Given<'v> {
    if method.name == "Workplane.split"
        && let [only] = *given.positions.as_slice()
        && handle::handle(only).is_some()
    {
        given.positions.clear();
        given.named.push(("splitter", only));
    }
    given
}

/// Calls the function of `each` or `eachpoint` once, with what stands for its argument; gives that and
/// the result as arguments.
fn per<'v>(
    param: &Param,
    function: Value<'v>,
    on: &Node,
    session: &Session,
    line: u32,
    eval: &mut Evaluator<'v, '_, '_>,
) -> starlark::Result<(Json, Json)> {
    let at = |fault: Fault| native(fault.line(line));
    let name = match param.kind {
        Kind::PerLocation => "eachLocation",
        _ => "eachObject",
    };
    let each = method(name).ok_or_else(|| at(Fault::new(format!("there is no {name}"))))?;
    let node = record(
        each,
        Some(on),
        &session.recorder,
        &[],
        BTreeMap::new(),
        line,
    )
    .map_err(at)?;
    let variable = referring(node.index);
    let symbol = handle::value(each.gives, node, eval.heap());
    let result = eval.eval_function(function, &[symbol], &[])?;
    match handle::handle(result) {
        Some(made) if matches!(made.kind, Type::Workplane | Type::Shape) => {
            Ok((variable, referring(made.node.index)))
        }
        _ => Err(at(Fault::new(format!(
            "the function given to '{}' returned {} and not a shape",
            param.name,
            kind_of(result)
        ))
        .hint("write for example lambda loc: shape.moved(loc)"))),
    }
}

/// Records a call whose bound arguments join those that are there already.
fn record(
    method: &'static Method,
    on: Option<&Node>,
    recorder: &crate::recorder::Shared,
    bound: &[Option<Value<'_>>],
    mut args: BTreeMap<String, Json>,
    line: u32,
) -> Result<Node, Fault> {
    for (param, value) in params(method).iter().zip(bound) {
        let given = value.filter(|v| !(v.is_none() && param.default == Default::None));
        let written = match given {
            Some(value) => Some(convert::write(param.kind, value, param.name).map_err(
                |fault| {
                    if fault.hint.is_some() {
                        fault
                    } else {
                        fault.hint(shown(method))
                    }
                },
            )?),
            None => convert::default(param),
        };
        if let Some(written) = written {
            args.entry(param.name.to_owned()).or_insert(written);
        }
    }
    ports::complete(method, &mut args)?;
    let index = recorder
        .get()
        .record(method.name, on.map(|node| node.index), args, line)?;
    Ok(Node {
        index,
        recorder: recorder.clone(),
    })
}
