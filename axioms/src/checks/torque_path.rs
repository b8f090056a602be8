//! P-02: torque has a way from shaft to hub.

use std::collections::BTreeSet;

use super::Check;
use crate::class::Class;
use crate::facts::{MateFacts, PartFacts};
use crate::indexed::Indexed;
use crate::joints::{about, ends, is_hole};
use crate::ruling::{Ruling, Status};
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

/// A hub that passes torque is pressed on its shaft, or something joins both.
pub struct TorquePath;

/// Whether a hub passes torque: a coupling's does, and a gear that meshes with one other; a gear between two
/// others may run free. A mate that cites the axiom says that it is meant to.
fn passes_torque(facts: &Indexed, hub: &PartFacts, mate: &MateFacts, axiom: &str) -> bool {
    let meshes = || {
        let own = facts.mates_of(&hub.id);
        own.filter(|m| m.mate_type == MateType::GearMesh).count()
    };
    match hub.class() {
        Class::Coupling => true,
        Class::SpurGear => meshes() == 1 || mate.cites(axiom),
        Class::BallBearing => false,
        _ => mate.cites(axiom),
    }
}

/// A key, set screw or other part that is joined to both and is neither bearing nor gear.
fn between<'a>(facts: &'a Indexed, hub: &PartFacts, shaft: &PartFacts) -> Option<&'a str> {
    let link = |p: &PartFacts| {
        let kind = matches!(
            p.class(),
            Class::Key | Class::SetScrew | Class::Bolt | Class::Custom
        );
        let joins = |id: &str| facts.mates_of(&p.id).any(|m| m.has(id));
        kind && p.id != hub.id && p.id != shaft.id && joins(&hub.id) && joins(&shaft.id)
    };
    let ends = facts
        .mates_of(&hub.id)
        .flat_map(|m| [&m.base.part, &m.incoming.part]);
    let beside: BTreeSet<usize> = ends.filter_map(|id| facts.place(id)).collect();
    let mut beside = beside.into_iter().filter_map(|i| facts.parts.get(i));
    beside.find(|p| link(p)).map(|p| p.id.as_str())
}

impl Check for TorquePath {
    fn id(&self) -> &'static str {
        "torque_path"
    }

    fn axiom(&self) -> &'static str {
        "P-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for m in &facts.mates {
            let shaft = |t| t == PortType::Shaft;
            let Some((bore, shaft)) = ends(facts, m, is_hole, shaft) else {
                continue;
            };
            let (hub, shaft) = (bore.part, shaft.part);
            // A wheel that is meant to turn, on a shaft that is not, runs free on its axle.
            let moves = |p: &PartFacts| facts.meant_to_move.contains(&p.id);
            if moves(hub) && !moves(shaft) {
                continue;
            }
            if shaft.class() != Class::Shaft || !passes_torque(facts, hub, m, self.axiom()) {
                continue;
            }
            let (status, message) = if m.mate_type == MateType::PressFit {
                (
                    Status::Pass,
                    format!("'{}' is pressed on '{}'", hub.id, shaft.id),
                )
            } else if let Some(key) = between(facts, hub, shaft) {
                (
                    Status::Pass,
                    format!("'{key}' joins '{}' and '{}'", hub.id, shaft.id),
                )
            } else {
                let message = format!(
                    "'{}' turns freely on '{}': nothing passes the torque between them",
                    hub.id, shaft.id
                );
                (Status::Fail, message)
            };
            out.push(Ruling::new(self.axiom(), status, about(m), message));
        }
        out
    }
}
