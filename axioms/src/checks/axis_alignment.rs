//! C-02: axis on axis.

use super::Check;
use crate::geometry::{NEAR_DEG, NEAR_MM, askew_deg, off_axis_mm};
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::Ruling;
use assemcad_model::mates::MateType;
use assemcad_model::ports::PortType;

/// One line, and what goes inside is no thicker than the hole.
pub struct AxisAlignment;

/// By how much a hole is wider than what goes into it; none for two holes in line.
fn play(a: &assemcad_model::ports::Port, b: &assemcad_model::ports::Port) -> Option<f64> {
    let inside = |t| {
        matches!(
            t,
            PortType::PressFit | PortType::Shaft | PortType::ThreadExternal
        )
    };
    match (inside(a.port_type), inside(b.port_type)) {
        (true, false) => Some(b.value("diameter") - a.value("diameter")),
        (false, true) => Some(a.value("diameter") - b.value("diameter")),
        _ => None,
    }
}

impl Check for AxisAlignment {
    fn id(&self) -> &'static str {
        "axis_alignment"
    }

    fn axiom(&self) -> &'static str {
        "C-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for m in facts
            .mates
            .iter()
            .filter(|m| m.mate_type == MateType::Coaxial)
        {
            let Some((b, c)) = facts.sides(m) else {
                continue;
            };
            let Some(seen) = b.sees(&c) else {
                out.push(Ruling::unplaced(self.axiom(), about(m)));
                continue;
            };
            let (off, askew) = (off_axis_mm(&seen), askew_deg(&seen));
            let line = off <= NEAR_MM && askew <= NEAR_DEG;
            let play = play(b.port, c.port);
            let room = play.is_none_or(|p| p >= 0.0);
            let message = if !line {
                format!(
                    "the axes of {} and {} are {off:.4} mm apart and {askew:.3} degrees askew",
                    m.base, m.incoming
                )
            } else if !room {
                format!(
                    "what {} and {} join does not go in: it is thicker than its hole",
                    m.base, m.incoming
                )
            } else {
                format!("the axes of {} and {} are on one line", m.base, m.incoming)
            };
            out.push(
                Ruling::held(self.axiom(), line && room, about(m), message)
                    .value("off_axis_mm", off)
                    .value("askew_deg", askew)
                    .value("diameters_differ_mm", play.unwrap_or(f64::NAN)),
            );
        }
        out
    }
}
