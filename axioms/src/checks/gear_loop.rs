//! K-04: closed chains of gears can turn.

use std::collections::{BTreeMap, BTreeSet};

use super::Check;
use crate::gearing::pairs;
use crate::indexed::Indexed;
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
    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let pairs = pairs(facts);
        let mut speed: BTreeMap<&str, f64> = BTreeMap::new();
        let mut of: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (i, p) in pairs.iter().enumerate() {
            for gear in [&p.base.part.id, &p.incoming.part.id] {
                of.entry(gear).or_default().push(i);
            }
        }
        let mut open: BTreeSet<usize> = (0..pairs.len()).collect();
        // Those of them of which one gear has its speed.
        let mut near: BTreeSet<usize> = BTreeSet::new();
        let mut out = Vec::new();
        while let Some(next) = near.first().or(open.first()).copied() {
            open.remove(&next);
            near.remove(&next);
            let Some(p) = pairs.get(next) else {
                continue;
            };
            for gear in [p.base.part.id.as_str(), p.incoming.part.id.as_str()] {
                if !speed.contains_key(gear) {
                    let pairs = of.get(gear).into_iter().flatten();
                    near.extend(pairs.filter(|i| open.contains(i)));
                }
            }
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
