//! T-03: enough thread is engaged.

use super::Check;
use crate::class::Class;
use crate::facts::{Material, PartFacts};
use crate::indexed::Indexed;
use crate::joints::screwed;
use crate::ruling::Ruling;

/// The engaged length against the nominal diameter, by the material of the hole.
pub struct EngagementLength;

/// The least engagement by nominal diameters, and what was assumed for it.
///
/// A nut of full strength is at least 0.8 d high (ISO 898-2, regular nuts): that is what the standard's nuts
/// and bolts are matched for. In tapped holes: 1 d in steel, 1.5 d in cast iron, 2 d in aluminium, the rules
/// of thumb of the trade on their safe side; VDI 2230 Part 1 has the calculation, which needs the strengths
/// of screw and part.
fn factor(hole: &PartFacts) -> (f64, Option<&'static str>) {
    match (hole.class(), hole.material) {
        (Class::Nut, _) => (0.8, Some("a nut of the strength that belongs to its bolt")),
        (_, Some(Material::Aluminium)) => (2.0, None),
        (_, Some(Material::CastIron)) => (1.5, None),
        (_, Some(Material::Steel)) => (1.0, None),
        (_, None) => (
            1.0,
            Some("the part with the thread is of steel: its material is not stated"),
        ),
    }
}

impl Check for EngagementLength {
    fn id(&self) -> &'static str {
        "engagement_length"
    }

    fn axiom(&self) -> &'static str {
        "T-03"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for s in screwed(facts) {
            // A drive is sized for wear, not for the strength of its shank.
            if s.mate.flag("free") {
                continue;
            }
            let (factor, assumption) = factor(s.hole.part);
            let (engaged, d) = (s.engaged(), s.screw.port.value("diameter"));
            let least = factor * d;
            let holds = engaged >= least - 1e-9;
            let message = format!(
                "'{}' is engaged over {engaged:.3} mm in '{}'; {least:.3} mm is the least ({factor} of {d} mm)",
                s.screw.part.id, s.hole.part.id
            );
            let mut v = Ruling::held(self.axiom(), holds, s.about(), message)
                .value("engaged_mm", engaged)
                .value("least_mm", least)
                .value("factor", factor);
            v.assumption = assumption.map(str::to_owned);
            out.push(v);
        }
        out
    }
}
