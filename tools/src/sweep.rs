//! `sweep`.

use assemcad_assembly::{Faults, Workshop};
use assemcad_model::freedom::DriveKind;
use assemcad_motion::{Request, Sweep};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::verify::default_tau;
use crate::{Effect, Tool};

pub(crate) struct SweepMotion;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Name of the assembly.
    assembly: String,
    /// The part whose motion drives, such as the crank.
    part: String,
    /// What it does, where it can do both; else what it can.
    kind: Option<Kind>,
    /// Where the range of a turn begins, in degrees from the pose as assembled; 0 where it is left out.
    #[schemars(range(min = -36000.0, max = 36000.0))]
    from_deg: Option<f64>,
    /// Where it ends; a whole turn further where it is left out.
    #[schemars(range(min = -36000.0, max = 36000.0))]
    to_deg: Option<f64>,
    /// Step between samples; 5 degrees where it is left out.
    #[schemars(range(min = 0.001, max = 360.0))]
    step_deg: Option<f64>,
    /// Where the range of a slide begins, in mm from the pose as assembled; 0 where it is left out.
    #[schemars(range(min = -1e5, max = 1e5))]
    from_mm: Option<f64>,
    /// Where it ends.
    #[schemars(range(min = -1e5, max = 1e5))]
    to_mm: Option<f64>,
    /// Step between samples; a fortieth of the range where it is left out.
    #[schemars(range(min = 1e-6, max = 1e5))]
    step_mm: Option<f64>,
    /// Common volume above which two parts collide, in mm3.
    #[serde(default = "default_tau")]
    #[schemars(range(min = 0.0, max = 1e6))]
    tau_mm3: f64,
}

#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Rotate,
    Slide,
}

impl Tool for SweepMotion {
    type Arguments = Arguments;
    type Answer = Sweep;
    const NAME: &'static str = "sweep";
    const TITLE: &'static str = "Sweep a motion for collisions";
    const DESCRIPTION: &'static str = "Drives one part through a range, everything coupled to it \
        following (linkages, gears by their ratio, screws), and reports the first collision: where, \
        which parts, how much. Or where the motion is blocked. Pairs that only turn about one axis and \
        are round about it are proven; all others are sampled at the step and may collide between two \
        samples. Other free motions stand still. verify looks at the pose as assembled only; call it \
        first.";
    const EFFECT: Effect = Effect::Reads;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Sweep, Faults> {
        let request = Request {
            assembly: a.assembly,
            part: a.part,
            kind: a.kind.map(|k| match k {
                Kind::Rotate => DriveKind::Rotate,
                Kind::Slide => DriveKind::Slide,
            }),
            degrees: [a.from_deg, a.to_deg, a.step_deg],
            millimetres: [a.from_mm, a.to_mm, a.step_mm],
            tau_mm3: a.tau_mm3,
        };
        workshop.sweep(&request).await
    }
}
