//! B-04: one bearing fixed, the other floating.

use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

use super::Check;
use crate::class::Class;
use crate::facts::PartFacts;
use crate::indexed::Indexed;
use crate::joints::{about_part, of_class};
use crate::ruling::{Ruling, Status};

/// Of the bearings of a shaft one is held along the axis on both of its rings.
pub struct FixedAndFloating;

impl Check for FixedAndFloating {
    fn id(&self) -> &'static str {
        "fixed_and_floating"
    }

    fn axiom(&self) -> &'static str {
        "B-04"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for shaft in of_class(facts, Class::Shaft) {
            let mut mates = Vec::new();
            let mut fixed = 0_u32;
            for m in facts.mates_of(&shaft.id) {
                let Some((_, other)) = facts.seen_from(&shaft.id, m) else {
                    continue;
                };
                if other.part.class() == Class::BallBearing && other.is(PortType::Bore) {
                    mates.push(m);
                    let held = |ring| held(facts, other.part, ring);
                    fixed += u32::from(held(PortType::Bore) && held(PortType::PressFit));
                }
            }
            let n = mates.len();
            if n < 2 {
                continue;
            }
            let (status, what) = match fixed {
                0 => (
                    Status::Indeterminate,
                    "shoulders and rings that would locate it are not mated",
                ),
                1 => (Status::Pass, "one of them locates it"),
                _ => (Status::Fail, "more than one of them locates it"),
            };
            let message = format!("'{}' has {n} bearings: {what}", shaft.id);
            out.push(
                Ruling::new(self.axiom(), status, about_part(shaft, mates), message)
                    .value("bearings", n as f64)
                    .value("fixed", f64::from(fixed)),
            );
        }
        out
    }
}

/// Whether a ring is held along its axis by mates: pressed on its seat, or with two faces on something. A
/// face of a bearing is one of its outer ring.
fn held(facts: &Indexed, bearing: &PartFacts, ring: PortType) -> bool {
    let mut faces = 0;
    for m in facts.mates_of(&bearing.id) {
        let Some((own, _)) = facts.seen_from(&bearing.id, m) else {
            continue;
        };
        if own.is(ring) && m.mate_type == MateType::PressFit {
            return true;
        }
        faces += usize::from(ring == PortType::PressFit && own.is(PortType::FlatFace));
    }
    faces >= 2
}
