//! What stands for the results of recorded calls: workplanes, shapes and places that are made after
//! the script has run.
#![allow(
    clippy::panic,
    reason = "derive(StarlarkPagablePanic); nothing here is ever paged out"
)]
#![allow(
    unsafe_code,
    reason = "derive(ProvidesStaticType) implements an unsafe trait; none of ours"
)]

use core::fmt;

use allocative::Allocative;
use assemcad_model::language::{Method, Type, method, methods};
use assemcad_model::recipe::Ref;
use starlark::eval::{Arguments, Evaluator};
use starlark::starlark_simple_value;
use starlark::typing::Ty;
use starlark::values::{
    Heap, NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, Value,
    starlark_value,
};

use super::native;
use crate::fault::Fault;
use crate::language::{call, whole};
use crate::recorder::Shared;

/// A recorded call.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    pub(crate) index: Ref,
    pub(crate) recorder: Shared,
}

/// A recorded call and what it gives.
pub(crate) struct Handle<'v> {
    pub(crate) kind: Type,
    pub(crate) node: &'v Node,
}

macro_rules! handles {
    ($($(#[$doc:meta])* $name:ident, $type:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
        pub(crate) struct $name(#[allocative(skip)] pub(crate) Node);
        starlark_simple_value!($name);

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(concat!("<", $type, ">"))
            }
        }

        #[starlark_value(type = $type)]
        impl<'v> StarlarkValue<'v> for $name {
            fn get_attr(&self, name: &str, heap: Heap<'v>) -> Option<Value<'v>> {
                let method = method(&format!(concat!($type, ".{}"), name))?;
                let on = Some(self.0.clone());
                Some(heap.alloc(Function { method, on }))
            }
            fn dir_attr(&self) -> Vec<String> {
                members($type).map(str::to_owned).collect()
            }
            fn add(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
                Some(operate($type, &self.0, "+", other, heap))
            }
            fn sub(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
                operate($type, &self.0, "-", other, heap)
            }
            fn mul(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
                Some(operate($type, &self.0, "*", other, heap))
            }
            fn div(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
                operate($type, &self.0, "/", other, heap)
            }
            fn bit_or(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
                operate($type, &self.0, "|", other, heap)
            }
            fn bit_and(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
                operate($type, &self.0, "&", other, heap)
            }
            fn at(&self, index: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
                member($type, &self.0, index, heap)
            }
        }
    )*};
}

handles! {
    /// A chain.
    Workplane, "Workplane";
    /// One solid, face, wire, edge or vertex.
    Shape, "Shape";
    /// A list of them, of a length that nobody knows yet.
    Shapes, "Shapes";
    /// A place that a function of `eachpoint` is given.
    Place, "Location";
}

/// The names of the methods of a type.
pub(crate) fn members(kind: &str) -> impl Iterator<Item = &'static str> {
    methods()
        .filter_map(|m| m.name.split_once('.').filter(|_| m.on.is_some()))
        .filter(move |(on, _)| *on == kind)
        .map(|(_, short)| short)
}

/// The recorded call that a value stands for.
pub(crate) fn handle(value: Value<'_>) -> Option<Handle<'_>> {
    let found = |kind, node| Some(Handle { kind, node });
    if let Some(it) = Workplane::from_value(value) {
        found(Type::Workplane, &it.0)
    } else if let Some(it) = Shape::from_value(value) {
        found(Type::Shape, &it.0)
    } else if let Some(it) = Shapes::from_value(value) {
        found(Type::Shapes, &it.0)
    } else if let Some(it) = Place::from_value(value) {
        found(Type::Location, &it.0)
    } else {
        None
    }
}

/// What stands for the result of a call.
pub(crate) fn value<'v>(kind: Type, node: Node, heap: Heap<'v>) -> Value<'v> {
    match kind {
        Type::Workplane => heap.alloc(Workplane(node)),
        Type::Shape => heap.alloc(Shape(node)),
        Type::Shapes => heap.alloc(Shapes(node)),
        Type::Location => heap.alloc(Place(node)),
    }
}

/// An operator between two chains or shapes.
fn operate<'v>(
    kind: &str,
    node: &Node,
    operator: &str,
    other: Value<'v>,
    heap: Heap<'v>,
) -> starlark::Result<Value<'v>> {
    let name = match (kind, operator) {
        ("Workplane", "+" | "|") => "Workplane.union",
        ("Workplane", "-") => "Workplane.cut",
        ("Workplane", "*" | "&") => "Workplane.intersect",
        ("Workplane", "/") => "Workplane.split",
        ("Shape", "+") => "Shape.fuse",
        ("Shape", "-") => "Shape.cut",
        ("Shape", "*") => "Shape.intersect",
        ("Location", "*") => {
            return Err(native(
                Fault::new("the location that a function is given has no '*': it is not known yet")
                    .hint("move the shape twice: write shape.moved(inner).moved(loc)"),
            ));
        }
        _ => "",
    };
    let Some(method) = method(name) else {
        return Err(native(Fault::new(format!(
            "there is no operator '{operator}' between a {kind} and {}",
            crate::language::kind_of(other)
        ))));
    };
    call::apply(method, node, vec![other], heap).map_err(native)
}

/// `workplane[i]` and `shapes[i]`.
fn member<'v>(
    kind: &str,
    node: &Node,
    index: Value<'v>,
    heap: Heap<'v>,
) -> starlark::Result<Value<'v>> {
    let step = |name: &str, on: &Node, args| match method(name) {
        Some(method) => call::apply(method, on, args, heap),
        None => Err(Fault::new(format!("there is no {name}"))),
    };
    // Of shapes the list is that of a chain's stack.
    let (on, shapes) = match kind {
        "Workplane" => (Some(node.index), false),
        "Shapes" => (
            node.recorder.get().call(node.index).and_then(|c| c.on),
            true,
        ),
        _ => (None, false),
    };
    let Some(on) = on else {
        return Err(native(Fault::new(format!("a {kind} has no members"))));
    };
    whole(index, "the index")
        .and_then(|_| {
            let chain = Node {
                index: on,
                recorder: node.recorder.clone(),
            };
            let item = step("Workplane.item", &chain, vec![index])?;
            match handle(item) {
                Some(item) if shapes => step("Workplane.val", item.node, Vec::new()),
                _ => Ok(item),
            }
        })
        .map_err(native)
}

/// A function of the table: a method of a recorded call, or a function of `cq`.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Function {
    #[allocative(skip)]
    pub(crate) method: &'static Method,
    #[allocative(skip)]
    pub(crate) on: Option<Node>,
}
starlark_simple_value!(Function);

impl fmt::Display for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "<{}>", self.method.name)
    }
}

#[starlark_value(type = "method")]
impl<'v> StarlarkValue<'v> for Function {
    // `-> cq.Workplane` may be written and means nothing.
    fn eval_type(&self) -> Option<Ty> {
        Some(Ty::any())
    }
    fn invoke(
        &self,
        _me: Value<'v>,
        args: &Arguments<'v, '_>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        call::invoke(self.method, self.on.as_ref(), args, eval)
    }
}
