//! What is asked of a sweep.

use assemcad_model::diagnostic::{Code, Diagnostic, Faults};
use assemcad_model::freedom::DriveKind;
use serde_json::json;

/// The step where none is given and the part turns, in degrees.
pub const DEFAULT_STEP_DEG: f64 = 5.0;

/// How many steps a range has where none is given and the part slides.
pub const DEFAULT_STEPS: f64 = 40.0;

/// The most poses of a sweep.
pub const MOST_POSES: usize = 2000;

/// A part and the range through which it is driven, from the pose in which it stands.
#[derive(Debug, Clone)]
pub struct Request {
    /// The assembly.
    pub assembly: String,
    /// The part.
    pub part: String,
    /// Turning or sliding, where it is said.
    pub kind: Option<DriveKind>,
    /// From, to, and step, in degrees.
    pub degrees: [Option<f64>; 3],
    /// From, to, and step, in mm.
    pub millimetres: [Option<f64>; 3],
    /// Common volume above which two parts collide, in mm3.
    pub tau_mm3: f64,
}

/// A range in radians or mm.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Range {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) step: f64,
}

const FIELDS: [[&str; 3]; 2] = [
    ["from_deg", "to_deg", "step_deg"],
    ["from_mm", "to_mm", "step_mm"],
];

impl Request {
    /// Turning or sliding, by what is said or by the units.
    pub(crate) fn kind(&self) -> Result<Option<DriveKind>, Faults> {
        let given = |values: &[Option<f64>; 3]| values.iter().any(Option::is_some);
        let by_units = match (given(&self.degrees), given(&self.millimetres)) {
            (true, true) => {
                return Err(vec![wrong(
                    "arguments",
                    "a range is in degrees or in millimetres, and here are both",
                    FIELDS.concat(),
                )]);
            }
            (true, false) => Some(DriveKind::Rotate),
            (false, true) => Some(DriveKind::Slide),
            (false, false) => None,
        };
        match (self.kind, by_units) {
            (Some(DriveKind::Rotate), Some(DriveKind::Slide)) => Err(vec![wrong(
                "kind",
                "what rotates has its range in degrees",
                FIELDS[0].to_vec(),
            )]),
            (Some(DriveKind::Slide), Some(DriveKind::Rotate)) => Err(vec![wrong(
                "kind",
                "what slides has its range in millimetres",
                FIELDS[1].to_vec(),
            )]),
            (said, by_units) => Ok(said.or(by_units)),
        }
    }

    /// The range, complete.
    pub(crate) fn range(&self, kind: DriveKind) -> Result<Range, Faults> {
        let range = match kind {
            DriveKind::Rotate => {
                let [from, to, step] = self.degrees;
                let from = from.unwrap_or(0.0);
                Range {
                    from: from.to_radians(),
                    to: to.unwrap_or(from + 360.0).to_radians(),
                    step: step.unwrap_or(DEFAULT_STEP_DEG).to_radians(),
                }
            }
            DriveKind::Slide => {
                let [from, to, step] = self.millimetres;
                let from = from.unwrap_or(0.0);
                let Some(to) = to else {
                    return Err(vec![wrong(
                        "to_mm",
                        &format!("'{}' slides: state how far", self.part),
                        FIELDS[1].to_vec(),
                    )]);
                };
                Range {
                    from,
                    to,
                    step: step.unwrap_or((to - from).abs() / DEFAULT_STEPS),
                }
            }
        };
        let names = match kind {
            DriveKind::Rotate => FIELDS[0],
            DriveKind::Slide => FIELDS[1],
        };
        if range.from == range.to {
            return Err(vec![wrong(
                names[1],
                "the range has no length",
                names.to_vec(),
            )]);
        }
        let steps = (range.to - range.from).abs() / range.step;
        // Written so that a step that is no number is not taken for one.
        if steps > 0.0 && steps < MOST_POSES as f64 {
            return Ok(range);
        }
        let message = format!("the step must be above 0 and leave at most {MOST_POSES} poses");
        Err(vec![wrong(names[2], &message, names.to_vec())])
    }
}

fn wrong(place: &str, message: &str, fields: Vec<&str>) -> Diagnostic {
    Diagnostic::error(Code::ArgumentInvalid, place, message).expected(json!(fields))
}

impl Range {
    /// The values that are tried, from one end to the other.
    pub(crate) fn values(&self) -> Vec<f64> {
        let length = self.to - self.from;
        // A last step that is only rounding is none.
        let steps = libm::ceil(length.abs() / self.step - 1e-9).max(1.0);
        let mut out = vec![self.from];
        let mut i = 1.0;
        while i < steps {
            out.push(self.from + (i * self.step).copysign(length));
            i += 1.0;
        }
        out.push(self.to);
        out
    }
}

#[cfg(test)]
mod tests {
    use super::Range;

    #[test]
    fn values_reach_from_end_to_end() {
        let values = |from, to, step| Range { from, to, step }.values();
        assert_eq!(values(0.0, 10.0, 4.0), [0.0, 4.0, 8.0, 10.0]);
        assert_eq!(values(5.0, -1.0, 3.0), [5.0, 2.0, -1.0]);
        assert_eq!(values(0.0, 1.0, 7.0), [0.0, 1.0]);
        // Ten tenths are not quite 1.
        assert_eq!(values(0.0, 1.0, 0.1).len(), 11);
    }
}
