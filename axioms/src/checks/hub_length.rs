//! P-03: a hub is long enough for its shaft.

use super::Check;
use crate::class::Class;
use crate::indexed::Indexed;
use crate::joints::{about, ends, is_hole};
use crate::ruling::Ruling;
use assemcad_model::ports::PortType;

/// The bore of a hub is as long as its diameter at least.
pub struct HubLength;

/// The least length of a hub in shaft diameters. Ours: the guide values of textbooks lie about 1.5, and what
/// is shorter than its shaft is thick is short by any of them.
const LEAST: f64 = 1.0;

impl Check for HubLength {
    fn id(&self) -> &'static str {
        "hub_length"
    }

    fn axiom(&self) -> &'static str {
        "P-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for m in &facts.mates {
            let shaft = |t| t == PortType::Shaft;
            let Some((bore, shaft)) = ends(facts, m, is_hole, shaft) else {
                continue;
            };
            if !matches!(bore.part.class(), Class::SpurGear | Class::Coupling) {
                continue;
            }
            let (length, d) = (bore.port.value("depth"), shaft.port.value("diameter"));
            let least = LEAST * d;
            let message = format!(
                "the hub of '{}' is {length} mm long on a shaft of {d} mm; {least:.3} mm is the least",
                bore.part.id
            );
            out.push(
                Ruling::held(self.axiom(), length >= least - 1e-9, about(m), message)
                    .value("length_mm", length)
                    .value("least_mm", least),
            );
        }
        out
    }
}
