//! `math`: functions that give the same digits on every platform.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use assemcad_model::angle::sin_cos_deg;
use starlark::environment::GlobalsBuilder;
use starlark::starlark_module;
use starlark::values::Value;
use starlark::values::float::UnpackFloat;

use super::{items, number};
use crate::fault::Fault;

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
    fn log(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<f64> {
        finite(libm::log(x.0), "math.log")
    }
    fn hypot(
        #[starlark(require = pos)] x: UnpackFloat,
        #[starlark(require = pos)] y: UnpackFloat,
    ) -> anyhow::Result<f64> {
        finite(libm::hypot(x.0, y.0), "math.hypot")
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
    /// `pow(x, y)`: x to the power of y.
    fn pow(
        #[starlark(require = pos)] x: UnpackFloat,
        #[starlark(require = pos)] y: UnpackFloat,
    ) -> anyhow::Result<f64> {
        finite(libm::pow(x.0, y.0), "pow")
    }

    /// `round(x)`: the nearest whole number; halves go away from 0.
    fn round(#[starlark(require = pos)] x: UnpackFloat) -> anyhow::Result<i64> {
        whole(libm::round(x.0), "round")
    }

    /// `sum(items)`: the sum of numbers, added from first to last.
    fn sum<'v>(#[starlark(require = pos)] numbers: Value<'v>) -> anyhow::Result<f64> {
        let Some(numbers) = items(numbers) else {
            return Fault::new("sum takes a list of numbers").raise();
        };
        let mut sum = 0.0;
        for n in numbers {
            sum += number(n, "an item of sum")?;
        }
        finite(sum, "sum")
    }
}
