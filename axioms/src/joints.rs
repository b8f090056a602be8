//! What the checks of fasteners, seats and shafts share.

use std::collections::BTreeSet;

use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

use crate::class::Class;
use crate::facts::{MateFacts, PartFacts, Side};
use crate::indexed::Indexed;
use crate::ruling::About;

/// A screw in a threaded hole.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Screwed<'a> {
    pub(crate) mate: &'a MateFacts,
    pub(crate) screw: Side<'a>,
    pub(crate) hole: Side<'a>,
}

impl Screwed<'_> {
    pub(crate) fn about(&self) -> About {
        about(self.mate)
    }

    /// How deep the screw's end is below the hole's mouth: as placed, or else as the mate states it.
    pub(crate) fn depth(&self) -> f64 {
        match self.hole.sees(&self.screw) {
            Some(seen) => -seen.origin().z,
            None => self.mate.number("d_t_mm") + self.mate.number("through_mm"),
        }
    }

    /// The length over which thread is in thread.
    pub(crate) fn engaged(&self) -> f64 {
        let deep = self.depth();
        let low = deep.min(self.hole.port.value("depth"));
        // The screw's own thread may end before the mouth.
        let high = (deep - self.screw.port.value("length")).max(0.0);
        low - high
    }
}

/// Every screw that is fixed in a threaded hole; drives are not meant.
pub(crate) fn screwed(facts: &Indexed) -> Vec<Screwed<'_>> {
    let mut out = Vec::new();
    for mate in &facts.mates {
        if mate.mate_type != MateType::ThreadEngage {
            continue;
        }
        let Some((base, incoming)) = facts.sides(mate) else {
            continue;
        };
        let found = if base.is(PortType::ThreadExternal) && incoming.is(PortType::ThreadInternal) {
            Some((base, incoming))
        } else if base.is(PortType::ThreadInternal) && incoming.is(PortType::ThreadExternal) {
            Some((incoming, base))
        } else {
            None
        };
        out.extend(found.map(|(screw, hole)| Screwed { mate, screw, hole }));
    }
    out
}

/// The ends of a mate of which one is of one type and the other of another, in that order.
pub(crate) fn ends<'a>(
    facts: &'a Indexed,
    mate: &MateFacts,
    first: impl Fn(PortType) -> bool,
    second: impl Fn(PortType) -> bool,
) -> Option<(Side<'a>, Side<'a>)> {
    let (b, c) = facts.sides(mate)?;
    if first(b.port.port_type) && second(c.port.port_type) {
        Some((b, c))
    } else if first(c.port.port_type) && second(b.port.port_type) {
        Some((c, b))
    } else {
        None
    }
}

/// Whether a port is a hole that takes a cylinder.
pub(crate) fn is_hole(t: PortType) -> bool {
    matches!(t, PortType::Bore | PortType::Hole)
}

/// Whether a port is a cylinder that goes into a hole.
pub(crate) fn is_cylinder(t: PortType) -> bool {
    matches!(t, PortType::Shaft | PortType::PressFit)
}

/// About a mate and its parts.
pub(crate) fn about(mate: &MateFacts) -> About {
    let mut parts = vec![mate.base.part.clone(), mate.incoming.part.clone()];
    parts.dedup();
    About {
        parts,
        mates: vec![mate.id.clone()],
    }
}

/// About a part and some of its mates.
pub(crate) fn about_part<'a>(
    part: &PartFacts,
    mates: impl IntoIterator<Item = &'a MateFacts>,
) -> About {
    About {
        parts: vec![part.id.clone()],
        mates: mates.into_iter().map(|m| m.id.clone()).collect(),
    }
}

/// The parts of a class.
pub(crate) fn of_class(facts: &Indexed, class: Class) -> impl Iterator<Item = &PartFacts> {
    facts.parts.iter().filter(move |p| p.class() == class)
}

/// Where a cylindrical port lies along its own z: a hole behind its mouth, a cylinder about its middle.
pub(crate) fn reach(side: &Side<'_>) -> (f64, f64) {
    if side.port.params.contains_key("depth") {
        return (-side.port.value("depth"), 0.0);
    }
    let half = side.port.value("length") / 2.0;
    (-half, half)
}

/// Where another cylindrical port lies along this one's z, where both have a place.
pub(crate) fn reach_along(own: &Side<'_>, other: &Side<'_>) -> Option<(f64, f64)> {
    let seen = own.sees(other)?;
    let [_, _, z] = seen.axes();
    let (low, high) = reach(other);
    let at = seen.origin().z;
    let (a, b) = (at + z.z * low, at + z.z * high);
    Some((a.min(b), a.max(b)))
}

/// The parts that mates connect to a part, over others, and the part itself.
pub(crate) fn reached<'a>(facts: &'a Indexed, from: &'a str) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::from([from]);
    let mut open = vec![from];
    while let Some(part) = open.pop() {
        for m in facts.mates_of(part) {
            for end in [m.base.part.as_str(), m.incoming.part.as_str()] {
                if reached.insert(end) {
                    open.push(end);
                }
            }
        }
    }
    reached
}
