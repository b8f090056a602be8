//! K-04: closed chains of gears can turn.

use std::collections::BTreeMap;

use super::Check;
use crate::facts::Facts;
use crate::gearing::pairs;
use crate::ruling::{About, Ruling};

/// Around every ring of gears that mesh, the ratios agree in size and sense.
pub struct GearLoop;

impl Check for GearLoop {
    fn id(&self) -> &'static str {
        "gear_loop"
    }

    fn axiom(&self) -> &'static str {
        "K-04"
    }

    /// Each gear gets its speed from the first one of its train; a pair that closes a ring must agree. The
    /// speeds are those against whatever carries the axes, be it a frame or a planet carrier.
    fn run(&self, facts: &Facts) -> Vec<Ruling> {
        let pairs = pairs(facts);
        let mut speed: BTreeMap<&str, f64> = BTreeMap::new();
        let mut open: Vec<usize> = (0..pairs.len()).collect();
        let mut out = Vec::new();
        while !open.is_empty() {
            let known = |i: &usize| {
                pairs.get(*i).is_some_and(|p| {
                    speed.contains_key(p.base.part.id.as_str())
                        || speed.contains_key(p.incoming.part.id.as_str())
                })
            };
            let at = open.iter().position(known).unwrap_or(0);
            let Some(p) = pairs.get(open.remove(at)) else {
                continue;
            };
            // Outside the gears turn against each other, a ring and its pinion the same way.
            let sense = if p.inside() { 1.0 } else { -1.0 };
            let ratio = sense * p.a.teeth / p.b.teeth;
            let (base, incoming) = (p.base.part.id.as_str(), p.incoming.part.id.as_str());
            match (speed.get(base).copied(), speed.get(incoming).copied()) {
                (Some(a), Some(b)) => {
                    let holds = (a * ratio - b).abs() <= 1e-9 * b.abs().max(1.0);
                    let message = if holds {
                        format!("the ring of gears that {} close can turn", p.names())
                    } else {
                        format!("the ring of gears that {} close locks itself", p.names())
                    };
                    let about = About {
                        parts: speed.keys().map(|s| (*s).to_owned()).collect(),
                        mates: vec![p.mate.id.clone()],
                    };
                    out.push(
                        Ruling::held(self.axiom(), holds, about, message)
                            .value("speed_along_the_ring", b)
                            .value("speed_by_this_pair", a * ratio)
                            .assuming(
                                "one part, standing or turning, carries all axes of the ring",
                            ),
                    );
                }
                (Some(a), None) => {
                    speed.insert(incoming, a * ratio);
                }
                (None, Some(b)) => {
                    speed.insert(base, b / ratio);
                }
                (None, None) => {
                    speed.insert(base, 1.0);
                    speed.insert(incoming, ratio);
                }
            }
        }
        out
    }
}
