//! H-01: hinges of one leaf share one axis.

use std::collections::BTreeMap;

use super::Check;
use crate::geometry::{NEAR_DEG, NEAR_MM, askew_deg, off_axis_mm};
use crate::hinges::hinges;
use crate::indexed::Indexed;
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

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let all = hinges(facts);
        let mut of: BTreeMap<Vec<&str>, Vec<usize>> = BTreeMap::new();
        for (i, h) in all.iter().enumerate() {
            of.entry(h.leaves()).or_default().push(i);
        }
        let mut out = Vec::new();
        for (i, a) in all.iter().enumerate() {
            let same = of.get(&a.leaves()).into_iter().flatten();
            for b in same.filter(|k| **k > i).filter_map(|k| all.get(*k)) {
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
