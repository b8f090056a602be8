//! F-04: no two parts in one place.

use super::Check;
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling, Status};

/// No pair shares more volume than its mates mean.
pub struct NoUnmeantOverlap;

/// What counts as nothing, in mm3: the noise of a boolean on curved faces. Ours.
const TAU_MM3: f64 = 1e-3;

impl Check for NoUnmeantOverlap {
    fn id(&self) -> &'static str {
        "no_unmeant_overlap"
    }

    fn axiom(&self) -> &'static str {
        "F-04"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for o in facts.measured.overlaps.iter().flatten() {
            let about = About {
                parts: vec![o.a.clone(), o.b.clone()],
                mates: Vec::new(),
            };
            let names = format!("'{}' and '{}'", o.a, o.b);
            let Some(common) = o.common_mm3 else {
                let message = format!("what {names} have in common could not be measured");
                out.push(Ruling::new(
                    self.axiom(),
                    Status::Indeterminate,
                    about,
                    message,
                ));
                continue;
            };
            let message = format!(
                "{names} have {common:.3} mm3 in common; their mates mean {} mm3",
                o.allowed_mm3
            );
            out.push(
                Ruling::held(
                    self.axiom(),
                    common <= o.allowed_mm3 + TAU_MM3,
                    about,
                    message,
                )
                .value("common_mm3", common)
                .value("allowed_mm3", o.allowed_mm3),
            );
        }
        out
    }
}
