//! G-02: a gear pair is of one tooth system.

use super::Check;
use crate::gearing::pairs;
use crate::geometry::askew_deg;
use crate::indexed::Indexed;
use crate::ruling::Ruling;

/// Equal module and pressure angle; parallel axes where both gears are straight.
pub struct ToothSystem;

/// What decimal fractions may differ by.
const SAME: f64 = 1e-9;

impl Check for ToothSystem {
    fn id(&self) -> &'static str {
        "tooth_system"
    }

    fn axiom(&self) -> &'static str {
        "G-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        pairs(facts)
            .iter()
            .map(|p| {
                let mut wrong = Vec::new();
                // Written so that an unknown value is equal to nothing.
                let same = |a: f64, b: f64| (a - b).abs() <= SAME;
                if !same(p.a.module, p.b.module) {
                    wrong.push("their modules differ");
                }
                if !same(p.a.pressure_deg, p.b.pressure_deg) {
                    wrong.push("their pressure angles differ");
                }
                if p.a.straight() && p.b.straight() && p.parallel() == Some(false) {
                    wrong.push("their axes are not parallel");
                }
                if wrong.is_empty() && p.seen.is_none() {
                    return Ruling::unplaced(self.axiom(), p.about());
                }
                let message = if wrong.is_empty() {
                    format!("{} are of one tooth system", p.names())
                } else {
                    format!("{} do not go together: {}", p.names(), wrong.join(", "))
                };
                let mut v = Ruling::held(self.axiom(), wrong.is_empty(), p.about(), message)
                    .value("module_base_mm", p.a.module)
                    .value("module_incoming_mm", p.b.module)
                    .value("pressure_angle_base_deg", p.a.pressure_deg)
                    .value("pressure_angle_incoming_deg", p.b.pressure_deg);
                if let Some(seen) = p.seen {
                    v = v.value("axes_deg", askew_deg(&seen));
                }
                v
            })
            .collect()
    }
}
