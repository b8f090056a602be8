//! H-01: hinges of one leaf share one axis.

use super::Check;
use crate::facts::Facts;
use crate::geometry::{NEAR_DEG, NEAR_MM, askew_deg, off_axis_mm};
use crate::hinges::hinges;
use crate::ruling::Ruling;

/// The pins between the same leaves lie on one line.
pub struct HingeLine;

impl Check for HingeLine {
    fn id(&self) -> &'static str {
        "hinge_line"
    }

    fn axiom(&self) -> &'static str {
        "H-01"
    }

    fn run(&self, facts: &Facts) -> Vec<Ruling> {
        let all = hinges(facts);
        let mut out = Vec::new();
        for (i, a) in all.iter().enumerate() {
            for b in all.iter().skip(i + 1).filter(|b| b.leaves() == a.leaves()) {
                let (Some(p), Some(q)) = (a.knuckles.first(), b.knuckles.first()) else {
                    continue;
                };
                let Some(seen) = p.pin.sees(&q.pin) else {
                    out.push(Ruling::unplaced(self.axiom(), a.about()));
                    continue;
                };
                let (off, askew) = (off_axis_mm(&seen), askew_deg(&seen));
                let holds = off <= NEAR_MM && askew <= NEAR_DEG;
                let message = if holds {
                    format!("'{}' and '{}' lie on one line", a.pin.id, b.pin.id)
                } else {
                    format!(
                        "'{}' and '{}' carry the same leaves {off:.3} mm and {askew:.3} degrees off one line",
                        a.pin.id, b.pin.id
                    )
                };
                let mut about = a.about();
                about.mates.extend(b.about().mates);
                about.parts.push(b.pin.id.clone());
                out.push(
                    Ruling::held(self.axiom(), holds, about, message)
                        .value("off_axis_mm", off)
                        .value("askew_deg", askew),
                );
            }
        }
        out
    }
}
