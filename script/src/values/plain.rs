//! Selectors, outlines, and the names behind `cq.`, as values.
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
use assemcad_model::{language, selector};
use starlark::eval::{Arguments, Evaluator};
use starlark::starlark_simple_value;
use starlark::typing::Ty;
use starlark::values::{
    Heap, NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, Value,
    starlark_value,
};

use super::native;
use crate::fault::Fault;
use crate::language::{cq, kind_of};

/// Longest text of a selector.
const LONGEST_SELECTOR: usize = 1000;

/// Most simple selectors in one.
const LARGEST_SELECTOR: usize = 100;

/// Deepest nesting of a selector: readers walk it by recursion.
const DEEPEST_SELECTOR: usize = 32;

/// A choice among faces, edges and so on.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Selector {
    #[allocative(skip)]
    pub(crate) selector: selector::Selector,
    depth: usize,
    /// How many simple ones it joins: of one that is joined to itself they double.
    size: usize,
}
starlark_simple_value!(Selector);

impl Selector {
    pub(crate) fn new(selector: selector::Selector) -> Self {
        let (depth, size) = extent(&selector);
        Self {
            selector,
            depth,
            size,
        }
    }

    /// Reads the text form.
    pub(crate) fn parse(text: &str) -> Result<Self, Fault> {
        if text.len() > LONGEST_SELECTOR {
            return Err(Fault::new(format!(
                "a selector has at most {LONGEST_SELECTOR} characters"
            )));
        }
        let selector = selector::Selector::parse(text).map_err(Fault::new)?;
        Self::new(selector).checked()
    }

    /// Two selectors joined.
    fn joined(&self, other: Value<'_>, how: Join) -> Result<Self, Fault> {
        let other = match (Self::from_value(other), other.unpack_str()) {
            (Some(selector), _) => selector.clone(),
            (None, Some(text)) => Self::parse(text)?,
            _ => {
                return Err(Fault::new(format!(
                    "a selector is joined to a selector, not to {}",
                    kind_of(other)
                )));
            }
        };
        let depth = self.depth.max(other.depth) + 1;
        let size = self.size + other.size;
        if depth > DEEPEST_SELECTOR || size > LARGEST_SELECTOR {
            return Err(Self::too_large());
        }
        let selector = how(
            Box::new(self.selector.clone()),
            Box::new(other.selector.clone()),
        );
        Ok(Self {
            selector,
            depth,
            size,
        })
    }

    fn checked(self) -> Result<Self, Fault> {
        if self.depth > DEEPEST_SELECTOR || self.size > LARGEST_SELECTOR {
            Err(Self::too_large())
        } else {
            Ok(self)
        }
    }

    fn too_large() -> Fault {
        Fault::new(format!(
            "a selector joins at most {LARGEST_SELECTOR} others, at most {DEEPEST_SELECTOR} deep"
        ))
        .hint("select in steps: .faces(\"|Z\").faces(\">Z\"), or add(...) what several select")
    }
}

type Join = fn(Box<selector::Selector>, Box<selector::Selector>) -> selector::Selector;

/// How deep a selector is and how many simple ones it joins.
fn extent(of: &selector::Selector) -> (usize, usize) {
    use selector::Selector::{And, Except, Not, Or};
    match of {
        And(a, b) | Or(a, b) | Except(a, b) => {
            let ((p, m), (q, n)) = (extent(a), extent(b));
            (1 + p.max(q), m + n)
        }
        Not(a) => {
            let (depth, size) = extent(a);
            (depth + 1, size)
        }
        _ => (1, 1),
    }
}

impl fmt::Display for Selector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("<Selector>")
    }
}

#[starlark_value(type = "Selector")]
impl<'v> StarlarkValue<'v> for Selector {
    fn add(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
        Some(join(self, other, selector::Selector::Or, heap))
    }
    fn sub(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
        join(self, other, selector::Selector::Except, heap)
    }
    fn mul(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
        Some(join(self, other, selector::Selector::And, heap))
    }
    fn bit_and(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
        join(self, other, selector::Selector::And, heap)
    }
    fn minus(&self, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
        let negated = Self {
            selector: selector::Selector::Not(Box::new(self.selector.clone())),
            depth: self.depth + 1,
            size: self.size,
        };
        negated.checked().map(|s| heap.alloc(s)).map_err(native)
    }
}

fn join<'v>(a: &Selector, b: Value<'v>, how: Join, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
    a.joined(b, how).map(|s| heap.alloc(s)).map_err(native)
}

/// A closed outline in a plane.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Outline {
    #[allocative(skip)]
    pub(crate) outline: language::Outline,
}
starlark_simple_value!(Outline);

impl fmt::Display for Outline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("<Outline>")
    }
}

#[starlark_value(type = "Outline")]
impl<'v> StarlarkValue<'v> for Outline {}

/// `cq` and what is behind its points, where it is no function of the table.
#[derive(Debug, Clone, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Item {
    /// What was written after `cq.`; empty for `cq` itself.
    #[allocative(skip)]
    pub(crate) path: &'static str,
}
starlark_simple_value!(Item);

impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "<cq.{}>", self.path)
    }
}

#[starlark_value(type = "cq")]
impl<'v> StarlarkValue<'v> for Item {
    // `-> cq.Vector` may be written and means nothing.
    fn eval_type(&self) -> Option<Ty> {
        Some(Ty::any())
    }
    fn get_attr(&self, name: &str, heap: Heap<'v>) -> Option<Value<'v>> {
        cq::attribute(self.path, name, heap)
    }
    fn dir_attr(&self) -> Vec<String> {
        cq::members(self.path).map(str::to_owned).collect()
    }
    fn invoke(
        &self,
        _me: Value<'v>,
        args: &Arguments<'v, '_>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        cq::invoke(self.path, args, eval)
    }
}
