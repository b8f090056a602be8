//! `cq.Vector`.
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
use starlark::environment::{Methods, MethodsBuilder};
use starlark::values::{
    Heap, NoSerialize, ProvidesStaticType, StarlarkPagablePanic, StarlarkValue, Value,
    starlark_value,
};
use starlark::{starlark_module, starlark_simple_value};

use super::native;
use crate::fault::Fault;
use crate::language::{number, vector};

/// A point or direction.
#[derive(Debug, Clone, Copy, ProvidesStaticType, NoSerialize, Allocative, StarlarkPagablePanic)]
pub(crate) struct Vector {
    pub(crate) at: [f64; 3],
}
starlark_simple_value!(Vector);
starlark::methods_static!(VECTOR_METHODS = vector_methods);

impl Vector {
    /// A vector of finite numbers.
    pub(crate) fn new(at: [f64; 3]) -> Result<Self, Fault> {
        if at.iter().all(|n| n.is_finite()) {
            Ok(Self {
                at: at.map(|n| n + 0.0),
            })
        } else {
            Err(Fault::new("a vector is not finite"))
        }
    }

    fn with(&self, other: [f64; 3], how: fn(f64, f64) -> f64) -> Result<Self, Fault> {
        let ([a, b, c], [x, y, z]) = (self.at, other);
        Self::new([how(a, x), how(b, y), how(c, z)])
    }

    fn times(&self, by: f64) -> Result<Self, Fault> {
        Self::new(self.at.map(|n| n * by))
    }

    fn dot_with(&self, [x, y, z]: [f64; 3]) -> f64 {
        let [a, b, c] = self.at;
        a * x + b * y + c * z
    }

    pub(crate) fn cross_with(&self, [x, y, z]: [f64; 3]) -> Result<Self, Fault> {
        let [a, b, c] = self.at;
        Self::new([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    fn length_of(&self) -> f64 {
        let [a, b, c] = self.at;
        libm::hypot(libm::hypot(a, b), c)
    }

    /// Of length 1; directions along an axis stay exact.
    pub(crate) fn unit(&self) -> Result<Self, Fault> {
        let length = self.length_of();
        if length == 0.0 {
            return Err(Fault::new("a vector without length has no direction"));
        }
        Self::new(self.at.map(|n| n / length))
    }
}

impl fmt::Display for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.at;
        write!(f, "Vector: ({x}, {y}, {z})")
    }
}

#[starlark_value(type = "Vector")]
impl<'v> StarlarkValue<'v> for Vector {
    fn get_methods() -> Option<&'static Methods> {
        Some(VECTOR_METHODS.methods())
    }
    fn equals(&self, other: Value<'v>) -> starlark::Result<bool> {
        Ok(Self::from_value(other).is_some_and(|o| o.at == self.at))
    }
    fn add(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
        let sum = vector(other, "what is added").and_then(|o| self.with(o, |a, b| a + b));
        Some(sum.map(|v| heap.alloc(v)).map_err(native))
    }
    fn sub(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
        vector(other, "what is subtracted")
            .and_then(|o| self.with(o, |a, b| a - b))
            .map(|v| heap.alloc(v))
            .map_err(native)
    }
    fn mul(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
        Some(scaled(self, other, heap))
    }
    fn rmul(&self, other: Value<'v>, heap: Heap<'v>) -> Option<starlark::Result<Value<'v>>> {
        Some(scaled(self, other, heap))
    }
    fn div(&self, other: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
        number(other, "the divisor of a Vector")
            .and_then(|by| self.times(1.0 / by))
            .map(|v| heap.alloc(v))
            .map_err(native)
    }
    fn minus(&self, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
        self.times(-1.0).map(|v| heap.alloc(v)).map_err(native)
    }
}

fn scaled<'v>(of: &Vector, by: Value<'v>, heap: Heap<'v>) -> starlark::Result<Value<'v>> {
    number(by, "the factor of a Vector")
        .and_then(|by| of.times(by))
        .map(|v| heap.alloc(v))
        .map_err(native)
}

#[starlark_module]
fn vector_methods(builder: &mut MethodsBuilder) {
    #[starlark(attribute)]
    fn x(this: &Vector) -> anyhow::Result<f64> {
        Ok(this.at[0])
    }
    #[starlark(attribute)]
    fn y(this: &Vector) -> anyhow::Result<f64> {
        Ok(this.at[1])
    }
    #[starlark(attribute)]
    fn z(this: &Vector) -> anyhow::Result<f64> {
        Ok(this.at[2])
    }
    #[starlark(attribute)]
    fn Length(this: &Vector) -> anyhow::Result<f64> {
        Ok(this.length_of())
    }
    fn add<'v>(this: &Vector, v: Value<'v>) -> anyhow::Result<Vector> {
        Ok(this.with(vector(v, "v")?, |a, b| a + b)?)
    }
    fn sub<'v>(this: &Vector, v: Value<'v>) -> anyhow::Result<Vector> {
        Ok(this.with(vector(v, "v")?, |a, b| a - b)?)
    }
    fn multiply<'v>(this: &Vector, scale: Value<'v>) -> anyhow::Result<Vector> {
        Ok(this.times(number(scale, "scale")?)?)
    }
    fn cross<'v>(this: &Vector, v: Value<'v>) -> anyhow::Result<Vector> {
        Ok(this.cross_with(vector(v, "v")?)?)
    }
    fn dot<'v>(this: &Vector, v: Value<'v>) -> anyhow::Result<f64> {
        Ok(this.dot_with(vector(v, "v")?))
    }
    fn normalized(this: &Vector) -> anyhow::Result<Vector> {
        Ok(this.unit()?)
    }
    fn toTuple(this: &Vector) -> anyhow::Result<(f64, f64, f64)> {
        Ok(this.at.into())
    }
}
