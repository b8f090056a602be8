//! Outlines of gears.
#![allow(missing_docs, reason = "the macro makes public items of the functions")]

use starlark::environment::GlobalsBuilder;
use starlark::eval::Evaluator;
use starlark::starlark_module;
use starlark::values::Value;

use super::session::Session;
use super::{number, positive};
use crate::fault::Fault;
use crate::involute::Toothing;
use crate::values::Outline;

/// As many teeth as an outline may have.
const TEETH: core::ops::RangeInclusive<i32> = 3..=1000;

#[starlark_module]
pub(super) fn functions(builder: &mut GlobalsBuilder) {
    /// `involute_outline(module, teeth, pressure_angle_deg = 20, profile_shift = 0, thinning = 0,
    /// internal = False)`: the closed outline of a spur gear about the origin, a tooth on +x; with
    /// `internal` that of the hole in a ring with internal teeth. Basic rack of ISO 53, profile A:
    /// addendum 1 module, dedendum 1.25 modules. The profile shift is in modules, positive away from
    /// the axis; teeth are thinner by `thinning` along the pitch circle. Flanks are arcs that stay
    /// within 0.5 micrometres of the involute, on the side of the material; below the base circle they
    /// are radial, without undercut and without a rounded root.
    fn involute_outline<'v>(
        module: Value<'v>,
        teeth: i32,
        pressure_angle_deg: Option<Value<'v>>,
        profile_shift: Option<Value<'v>>,
        thinning: Option<Value<'v>>,
        #[starlark(default = false)] internal: bool,
        eval: &mut Evaluator<'v, '_, '_>,
    ) -> anyhow::Result<Outline> {
        let or = |value: Option<Value<'v>>, default: f64, what: &str| {
            value.map_or(Ok(default), |v| number(v, what))
        };
        let pressure_angle_deg = or(pressure_angle_deg, 20.0, "pressure_angle_deg")?;
        if !(5.0..=45.0).contains(&pressure_angle_deg) {
            return Fault::new("pressure_angle_deg is 5 to 45").raise();
        }
        let Some(count) = u32::try_from(teeth).ok().filter(|_| TEETH.contains(&teeth)) else {
            return Fault::new(format!("teeth is {} to {}", TEETH.start(), TEETH.end())).raise();
        };
        let toothing = Toothing {
            module: positive(module, "module")?,
            teeth: count,
            pressure_angle_deg,
            profile_shift: or(profile_shift, 0.0, "profile_shift")?,
            thinning: or(thinning, 0.0, "thinning")?,
            internal,
        };
        let outline = match toothing.outline() {
            Ok(outline) => outline,
            Err(why) => return Fault::new(why).raise(),
        };
        if let assemcad_model::recipe::Outline::Path { segments, .. } = &outline {
            Session::of(eval)?.charge(segments.len() + 1)?;
        }
        Ok(Outline { outline })
    }
}
