//! T-05: a bolt reaches through its nut.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::screwed;
use crate::ruling::Ruling;

/// The end of a bolt stands out of its nut by one pitch at least.
pub struct BoltLength;

impl Check for BoltLength {
    fn id(&self) -> &'static str {
        "bolt_length"
    }

    fn axiom(&self) -> &'static str {
        "T-05"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for s in screwed(facts) {
            if s.hole.part.class() != Class::Nut || s.mate.flag("free") {
                continue;
            }
            let out_mm = s.depth() - s.hole.port.value("depth");
            // EN 1090-2, 8.2.2: the bolt protrudes from the nut by the length of one thread pitch at least.
            let least = s.screw.port.value("pitch");
            let holds = out_mm >= least - 1e-9;
            let message = format!(
                "'{}' stands {out_mm:.3} mm out of '{}'; one pitch, {least} mm, is the least",
                s.screw.part.id, s.hole.part.id
            );
            out.push(
                Ruling::held(self.axiom(), holds, s.about(), message)
                    .value("protrusion_mm", out_mm)
                    .value("least_mm", least),
            );
        }
        out
    }
}
