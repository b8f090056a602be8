//! `math`: functions that give the same digits on every platform.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use assemcad_model::angle::sin_cos_deg;
use starlark::environment::GlobalsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::float::UnpackFloat;
use starlark::values::none::NoneOr;
use starlark::values::tuple::UnpackTuple;
use starlark::values::{UnpackValue, Value};

use super::{items, number, vector};
use crate::fault::Fault;
use crate::values::native;

/// A result that is a finite number, or the fault that it is none.
fn finite(result: f64, what: &str) -> anyhow::Result<f64> {
    if result.is_finite() {
        Ok(result)
    } else {
        Fault::new(format!("{what} has no finite value here")).raise()
    }
}

fn whole(result: f64, what: &str) -> anyhow::Result<i64> {
    // Beyond 2^53 a float no longer tells whole numbers apart.
    if result.abs() <= 9.0e15 {
        Ok(result as i64)
    } else {
        Fault::new(format!("{what} is too large for a whole number")).raise()
    }
}

#[starlark_module]
pub(super) fn namespace(builder: &mut GlobalsBuilder) {
    const pi: f64 = core::f64::consts::PI;
    const tau: f64 = core::f64::consts::TAU;
    const e: f64 = core::f64::consts::E;

    fn sin(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::sin(x.0), "math.sin")
    }
    fn cos(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::cos(x.0), "math.cos")
    }
    fn tan(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::tan(x.0), "math.tan")
    }
    fn asin(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::asin(x.0), "math.asin")
    }
    fn acos(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::acos(x.0), "math.acos")
    }
    fn atan(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::atan(x.0), "math.atan")
    }
    fn atan2(
        #[starlark(require = pos)] y: UnpackFloat,
        #[starlark(require = pos)] x: UnpackFloat,
    ) -> anyhow::Result<f64> {
        finite(libm::atan2(y.0, x.0), "math.atan2")
    }
    /// Sine of an angle in degrees; exact at multiples of 90.
    fn sin_deg(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(sin_cos_deg(x.0).0, "math.sin_deg")
    }
    /// Cosine of an angle in degrees; exact at multiples of 90.
    fn cos_deg(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(sin_cos_deg(x.0).1, "math.cos_deg")
    }
    fn sqrt(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::sqrt(x.0), "math.sqrt")
    }
    fn pow(
        #[starlark(require = pos)] x: UnpackFloat,
        #[starlark(require = pos)] y: UnpackFloat,
    ) -> anyhow::Result<f64> {
        finite(libm::pow(x.0, y.0), "math.pow")
    }
    fn exp(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::exp(x.0), "math.exp")
    }
    /// The natural logarithm, or that to a base.
    fn log(
        #[starlark(require = pos)] x: UnpackFloat,
        #[starlark(require = pos)] base: Option<UnpackFloat>,
    ) -> anyhow::Result<f64> {
        let log = libm::log(x.0);
        finite(base.map_or(log, |b| log / libm::log(b.0)), "math.log")
    }
    fn log2(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::log2(x.0), "math.log2")
    }
    fn log10(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::log10(x.0), "math.log10")
    }
    fn sinh(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::sinh(x.0), "math.sinh")
    }
    fn cosh(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::cosh(x.0), "math.cosh")
    }
    fn tanh(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::tanh(x.0), "math.tanh")
    }
    fn fabs(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(x.0.abs(), "math.fabs")
    }
    fn fmod(
        #[starlark(require = pos)] x: UnpackFloat,
        #[starlark(require = pos)] y: UnpackFloat,
    ) -> anyhow::Result<f64> {
        finite(libm::fmod(x.0, y.0), "math.fmod")
    }
    fn copysign(
        #[starlark(require = pos)] x: UnpackFloat,
        #[starlark(require = pos)] y: UnpackFloat,
    ) -> anyhow::Result<f64> {
        finite(libm::copysign(x.0, y.0), "math.copysign")
    }
    fn trunc(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<i64> {
        whole(libm::trunc(x.0), "math.trunc")
    }
    /// The length of a vector of any number of coordinates.
    fn hypot<'v>(#[starlark(args)] all: UnpackTuple<UnpackFloat>) -> anyhow::Result<f64> {
        let length = all.items.iter().fold(0.0, |sum, x| libm::hypot(sum, x.0));
        finite(length, "math.hypot")
    }
    /// The distance of two points.
    fn dist<'v>(
        #[starlark(require = pos)] p: Value<'v>,
        #[starlark(require = pos)] q: Value<'v>,
    ) -> anyhow::Result<f64> {
        let ([a, b, c], [x, y, z]) = (vector(p, "p")?, vector(q, "q")?);
        finite(libm::hypot(libm::hypot(a - x, b - y), c - z), "math.dist")
    }
    fn isclose(
        #[starlark(require = pos)] a: UnpackFloat,
        #[starlark(require = pos)] b: UnpackFloat,
        #[starlark(require = named)] rel_tol: Option<UnpackFloat>,
        #[starlark(require = named)] abs_tol: Option<UnpackFloat>,
    ) -> anyhow::Result<bool> {
        let relative = rel_tol.map_or(1e-9, |t| t.0) * a.0.abs().max(b.0.abs());
        Ok((a.0 - b.0).abs() <= relative.max(abs_tol.map_or(0.0, |t| t.0)))
    }
    /// The greatest common divisor.
    fn gcd(
        #[starlark(require = pos)] a: i32,
        #[starlark(require = pos)] b: i32,
    ) -> anyhow::Result<i64> {
        let (mut a, mut b) = (i64::from(a).abs(), i64::from(b).abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        Ok(a)
    }
    fn radians(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(x.0 * core::f64::consts::PI / 180.0, "math.radians")
    }
    fn degrees(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(x.0 * 180.0 / core::f64::consts::PI, "math.degrees")
    }
    fn floor(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<i64> {
        whole(libm::floor(x.0), "math.floor")
    }
    fn ceil(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<i64> {
        whole(libm::ceil(x.0), "math.ceil")
    }
}

#[starlark_module]
pub(super) fn functions(builder: &mut GlobalsBuilder) {
    /// `pow(x, y)`: x to the power of y; a whole number where both are and y is not negative.
    fn pow<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        #[starlark(require = pos)] y: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Value<'v>> {
        let heap = eval.heap();
        if let (Some(base), Some(exponent)) = (int(x), int(y).and_then(|n| u32::try_from(n).ok())) {
            return match base.checked_pow(exponent) {
                Some(power) => Ok(heap.alloc(power)),
                None => Fault::new("a whole number is outside of 64 bits").raise(),
            };
        }
        let power = libm::pow(number(x, "the base")?, number(y, "the exponent")?);
        Ok(heap.alloc(finite(power, "pow")?))
    }

    /// `round(x)`: the nearest whole number, of two the even one; `round(x, n)`: to n decimals.
    fn round<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        #[starlark(default = NoneOr::None)] ndigits: NoneOr<i32>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Value<'v>> {
        let heap = eval.heap();
        let at = number(x, "what is rounded")?;
        let NoneOr::Other(digits) = ndigits else {
            return Ok(heap.alloc(whole(libm::rint(at), "round")?));
        };
        let Some(digits) = usize::try_from(digits).ok().filter(|d| *d <= 20) else {
            return Fault::new("round keeps 0 to 20 decimals").raise();
        };
        // Writing out rounds the exact value, as Python does.
        let rounded = format!("{at:.digits$}").parse::<f64>().unwrap_or(at);
        Ok(heap.alloc(rounded))
    }

    /// `divmod(x, y)`: `(x // y, x % y)`.
    fn divmod<'v>(
        #[starlark(require = pos)] x: Value<'v>,
        #[starlark(require = pos)] y: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> starlark::Result<Value<'v>> {
        let heap = eval.heap();
        number(x, "x")
            .and_then(|_| number(y, "y"))
            .map_err(native)?;
        Ok(heap.alloc((x.floor_div(y, heap)?, x.percent(y, heap)?)))
    }

    /// `sum(items, start = 0)`: the sum of numbers, added from first to last.
    fn sum<'v>(
        #[starlark(require = pos)] numbers: Value<'v>,
        start: Option<Value<'v>>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Value<'v>> {
        let heap = eval.heap();
        let Some(numbers) = items(numbers) else {
            return Fault::new(format!(
                "sum takes a list of numbers, not {}",
                super::kind_of(numbers)
            ))
            .raise();
        };
        let all = || start.iter().chain(&numbers);
        if let Some(whole) = all().map(|n| int(*n)).collect::<Option<Vec<i64>>>() {
            return match whole.into_iter().try_fold(0_i64, i64::checked_add) {
                Some(sum) => Ok(heap.alloc(sum)),
                None => Fault::new("a whole number is outside of 64 bits").raise(),
            };
        }
        let mut sum = 0.0;
        for n in all() {
            sum += number(*n, "an item of sum")?;
        }
        Ok(heap.alloc(finite(sum, "sum")?))
    }
}

/// A whole number of 64 bits.
fn int(value: Value<'_>) -> Option<i64> {
    i64::unpack_value(value).ok().flatten()
}
