//! T-06: clearance holes suit their bolts.

use super::Check;
use crate::indexed::Indexed;
use crate::joints::{about, ends};
use crate::ruling::{About, Ruling, Status};
use crate::tables::clearance;
use assemcad_model::ports::PortType;

/// A hole for a bolt is as wide as a series of ISO 273, and is for the bolt that passes it.
pub struct ClearanceHole;

/// What decimal fractions may differ by, in mm.
const SAME_MM: f64 = 1e-6;

impl Check for ClearanceHole {
    fn id(&self) -> &'static str {
        "clearance_hole"
    }

    fn axiom(&self) -> &'static str {
        "T-06"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for part in &facts.parts {
            for port in part
                .ports
                .iter()
                .filter(|p| p.port_type == PortType::ClearanceHole)
            {
                let (wide, d) = (port.value("diameter"), port.value("bolt_diameter"));
                let about = About::parts([&part.id]);
                let name = format!("'{}' of '{}'", port.name, part.id);
                let Some(series) = clearance(d) else {
                    let message = format!(
                        "{name} is for a bolt of {d} mm, for which no clearance is on record"
                    );
                    out.push(Ruling::new(
                        self.axiom(),
                        Status::Indeterminate,
                        about,
                        message,
                    ));
                    continue;
                };
                // Wider than every series: made for adjustment, which is a matter of washers.
                if wide > series.coarse + SAME_MM {
                    continue;
                }
                let holds = wide >= series.fine - SAME_MM;
                let message = format!(
                    "{name} is {wide} mm wide for a bolt of {d} mm; ISO 273 has {} fine, {} medium, {} coarse",
                    series.fine, series.medium, series.coarse
                );
                out.push(
                    Ruling::held(self.axiom(), holds, about, message)
                        .value("hole_mm", wide)
                        .value("fine_mm", series.fine)
                        .value("medium_mm", series.medium)
                        .value("coarse_mm", series.coarse),
                );
            }
        }
        for mate in &facts.mates {
            let bolt = |t| t == PortType::ThreadExternal;
            let hole = |t| t == PortType::ClearanceHole;
            let Some((bolt, hole)) = ends(facts, mate, bolt, hole) else {
                continue;
            };
            let (d, wanted) = (
                bolt.port.value("diameter"),
                hole.port.value("bolt_diameter"),
            );
            let holds = (d - wanted).abs() <= SAME_MM;
            let message = format!(
                "'{}' is a bolt of {d} mm in a hole of '{}' for {wanted} mm",
                bolt.part.id, hole.part.id
            );
            out.push(
                Ruling::held(self.axiom(), holds, about(mate), message)
                    .value("bolt_mm", d)
                    .value("hole_is_for_mm", wanted),
            );
        }
        out
    }
}
