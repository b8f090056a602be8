//! Mass and bill of materials.

use assemcad_model::canonical;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{BillLine, Mass, PartFacts, STEEL_KG_M3, rounded};
use assemcad_placing::{Assembled, Resolved};
use serde_json::{Map, Value};

/// What the parts weigh, alone and together. The mass of each is noted in its facts.
pub(crate) fn mass(
    assembled: &Assembled<'_>,
    density: Option<f64>,
    facts: &mut [PartFacts],
) -> Mass {
    let density_kg_m3 = density.unwrap_or(STEEL_KG_M3);
    // Of rounded values nothing is summed up.
    let (mut total, mut moment) = (Some(0.0), Some([0.0; 3]));
    for (i, (built, fact)) in assembled.built.iter().zip(facts).enumerate() {
        let mass = built.as_ref().map(|b| b.volume * density_kg_m3 * 1e-9);
        fact.mass_kg = mass.map(rounded);
        total = total.zip(mass).map(|(sum, m)| sum + m);
        let at = built.as_ref().zip(assembled.placements.of(i));
        let at = at.map(|(b, placement)| placement.point(b.centre));
        moment = moment.zip(mass.zip(at)).map(|(mut sum, (m, at))| {
            for (s, x) in sum.iter_mut().zip(at) {
                *s += m * x;
            }
            sum
        });
    }
    Mass {
        density_kg_m3,
        density_assumed: density.is_none(),
        total_kg: total.map(rounded),
        centre_mm: total
            .filter(|t| *t > 0.0)
            .zip(moment)
            .map(|(t, sum)| sum.map(|s| rounded(s / t))),
    }
}

/// The parts, equal ones together, in the order in which they first appear.
pub(crate) fn lines(resolved: &Resolved, facts: &[PartFacts]) -> Result<Vec<BillLine>, Diagnostic> {
    let mut lines: Vec<BillLine> = Vec::new();
    for (part, fact) in resolved.parts.iter().zip(facts) {
        let recipe_sha256 = part.made.solid.hash();
        let params = written(&part.made.params)
            .map_err(|e| Diagnostic::error(Code::Internal, &part.id, e.to_string()))?;
        let same = |l: &&mut BillLine| {
            l.factory == part.factory && l.recipe_sha256 == recipe_sha256 && l.params == params
        };
        if let Some(line) = lines.iter_mut().find(same) {
            line.count += 1;
            line.parts.push(part.id.clone());
            continue;
        }
        lines.push(BillLine {
            count: 1,
            designation: part.made.designation.clone(),
            factory: part.factory.clone(),
            params,
            recipe_sha256: recipe_sha256.to_owned(),
            mass_kg: fact.mass_kg,
            parts: vec![part.id.clone()],
        });
    }
    Ok(lines)
}

/// Parameters in the one form that equal ones have: 8, 8.0 and 8e0 are the same number, and a specification
/// may have them in any order.
fn written(params: &Map<String, Value>) -> Result<Map<String, Value>, serde_json::Error> {
    serde_json::from_slice(&canonical::to_bytes(params)?)
}
