//! T-04: a screw does not bottom.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::screwed;
use crate::ruling::{Ruling, Status};

/// The end of a screw stays short of the end of the thread in its hole.
pub struct ThreadBottoming;

/// Within this, in mm, the end of the screw counts as at the end of the thread.
const SAME_MM: f64 = 1e-6;

impl Check for ThreadBottoming {
    fn id(&self) -> &'static str {
        "thread_bottoming"
    }

    fn axiom(&self) -> &'static str {
        "T-04"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for s in screwed(facts) {
            // A nut is open at its far end, and so is a hole that the mate lets the screw stand out of.
            if s.hole.part.class() == Class::Nut || s.mate.number("through_mm") > 0.0 {
                continue;
            }
            let (end, depth) = (s.depth(), s.hole.port.value("depth"));
            let spare = depth - end;
            let (status, what) = if spare > SAME_MM {
                (Status::Pass, "stays short of the end of")
            } else if spare >= -SAME_MM {
                (Status::Indeterminate, "reaches just the end of")
            } else {
                (Status::Fail, "goes beyond the end of")
            };
            let message = format!(
                "'{}' {what} the thread in '{}'",
                s.screw.part.id, s.hole.part.id
            );
            let v = Ruling::new(self.axiom(), status, s.about(), message)
                .value("screw_end_mm", end)
                .value("thread_depth_mm", depth);
            out.push(if status == Status::Pass {
                v
            } else {
                v.assuming("the hole is blind where its thread ends: the port does not say that it goes on")
            });
        }
        out
    }
}
