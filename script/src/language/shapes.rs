//! Functions that record the first operation of a solid.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use assemcad_model::frame::Frame as ModelFrame;
use assemcad_model::recipe::Op;
use starlark::environment::GlobalsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::Value;

use super::session::{Session, line};
use super::{number, positive, vector};
use crate::fault::Fault;
use crate::values::{Frame, Profile, Solid, pieces};

fn world(at: Option<&Frame>) -> ModelFrame {
    at.map_or(ModelFrame::WORLD, |at| at.frame)
}

fn record(op: Op, eval: &Evaluator<'_, '_, '_>) -> anyhow::Result<Solid> {
    let node = Session::of(eval)?
        .recorder
        .borrow_mut()
        .record(op, line(eval))?;
    Ok(Solid::new(node))
}

/// A radius that may be 0 (the tip of a cone).
fn radius(value: Value<'_>, what: &str) -> Result<f64, Fault> {
    let n = number(value, what)?;
    if n >= 0.0 {
        Ok(n)
    } else {
        Err(Fault::new(format!("{what} is 0 or more, not {n}")))
    }
}

#[starlark_module]
pub(super) fn functions(builder: &mut GlobalsBuilder) {
    /// `box(x, y, z, at = frame())`: from the origin of `at` along its axes.
    fn r#box<'v>(
        x: Value<'v>,
        y: Value<'v>,
        z: Value<'v>,
        at: Option<&'v Frame>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let size = [positive(x, "x")?, positive(y, "y")?, positive(z, "z")?];
        record(
            Op::Box {
                at: world(at),
                size,
            },
            eval,
        )
    }

    /// `cylinder(diameter, height, at = frame())`: along z of `at`, its base centred on the origin.
    fn cylinder<'v>(
        diameter: Value<'v>,
        height: Value<'v>,
        at: Option<&'v Frame>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let radius = positive(diameter, "diameter")? / 2.0;
        let height = positive(height, "height")?;
        record(
            Op::Cylinder {
                at: world(at),
                radius,
                height,
            },
            eval,
        )
    }

    /// `cone(diameter_base, diameter_top, height, at = frame())`: along z of `at`; one diameter may
    /// be 0.
    fn cone<'v>(
        diameter_base: Value<'v>,
        diameter_top: Value<'v>,
        height: Value<'v>,
        at: Option<&'v Frame>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let radius_base = radius(diameter_base, "diameter_base")? / 2.0;
        let radius_top = radius(diameter_top, "diameter_top")? / 2.0;
        if radius_base == radius_top {
            return Fault::new("a cone has two different diameters")
                .hint("write cylinder(diameter, height)")
                .raise();
        }
        let height = positive(height, "height")?;
        record(
            Op::Cone {
                at: world(at),
                radius_base,
                radius_top,
                height,
            },
            eval,
        )
    }

    /// `sphere(diameter, at = frame())`: about the origin of `at`.
    fn sphere<'v>(
        diameter: Value<'v>,
        at: Option<&'v Frame>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let radius = positive(diameter, "diameter")? / 2.0;
        record(
            Op::Sphere {
                at: world(at),
                radius,
            },
            eval,
        )
    }

    /// `prism(profile, length)`: the profile moved along z of its frame; a negative length goes
    /// against z.
    fn prism<'v>(
        profile: &'v Profile,
        length: Value<'v>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let length = number(length, "length")?;
        if length == 0.0 {
            return Fault::new("length is not 0").raise();
        }
        Session::of(eval)?.charge(pieces(&profile.profile))?;
        record(
            Op::Prism {
                profile: profile.profile.clone(),
                length,
            },
            eval,
        )
    }

    /// `revolve(profile, axis_point = (0, 0), axis_direction = (0, 1), angle_deg = 360)`: the profile
    /// turned about an axis in its plane.
    fn revolve<'v>(
        profile: &'v Profile,
        axis_point: Option<Value<'v>>,
        axis_direction: Option<Value<'v>>,
        angle_deg: Option<Value<'v>>,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Solid> {
        let axis_point = axis_point.map_or(Ok([0.0; 2]), |v| vector(v, "axis_point"))?;
        let axis_direction =
            axis_direction.map_or(Ok([0.0, 1.0]), |v| vector(v, "axis_direction"))?;
        if axis_direction == [0.0; 2] {
            return Fault::new("axis_direction has no length").raise();
        }
        let angle_deg = angle_deg.map_or(Ok(360.0), |v| positive(v, "angle_deg"))?;
        if angle_deg > 360.0 {
            return Fault::new("angle_deg is at most 360").raise();
        }
        Session::of(eval)?.charge(pieces(&profile.profile))?;
        let profile = profile.profile.clone();
        record(
            Op::Revolve {
                profile,
                axis_point,
                axis_direction,
                angle_deg,
            },
            eval,
        )
    }
}
