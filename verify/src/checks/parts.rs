//! The check `parts`: every part is one valid closed solid.

use assemcad_geometry::Asker;
use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::Code;
use assemcad_model::report::{PartFacts, Verdict, rounded};
use assemcad_placing::solids::{box_of, build_all, reported};
use assemcad_placing::{Placements, Resolved};

use crate::results::Results;

/// Makes the parts, and gives what was measured of each solid and what is reported of each part.
pub(crate) async fn check(
    door: Asker<'_>,
    resolved: &Resolved,
    placements: &Placements,
    results: &mut Results,
) -> (Vec<Option<Built>>, Vec<PartFacts>) {
    let all = build_all(door, resolved).await;
    let mut built = Vec::new();
    let mut facts = Vec::new();
    let mut verdict = Verdict::Pass;
    for (i, (part, solid)) in resolved.parts.iter().zip(all).enumerate() {
        let placement = placements.of(i);
        let mut fact = PartFacts {
            part: part.id.clone(),
            factory: part.factory.clone(),
            recipe_sha256: None,
            verdict: Verdict::Pass,
            volume_mm3: None,
            mass_kg: None,
            centre_mm: None,
            box_mm: None,
            placement: placement.map(Into::into),
        };
        match solid {
            Ok(b) => {
                fact.recipe_sha256 = Some(b.recipe.clone());
                fact.volume_mm3 = Some(rounded(b.volume));
                fact.centre_mm = placement.map(|p| p.point(b.centre).map(rounded));
                fact.box_mm = placement.map(|p| reported(&box_of(&b, &p)));
                built.push(Some(b));
            }
            Err(d) => {
                // A refused geometry is wrong; a worker that was lost leaves the question open.
                fact.verdict = match d.code {
                    Code::KernelFailed => Verdict::Fail,
                    _ => Verdict::Indeterminate,
                };
                results.find(fact.verdict, "parts", vec![part.id.clone()], d);
                built.push(None);
            }
        }
        verdict = verdict.and(fact.verdict);
        facts.push(fact);
    }
    results.check(
        "parts",
        verdict,
        facts.len(),
        "each part replayed to one valid closed solid of positive volume",
    );
    (built, facts)
}
