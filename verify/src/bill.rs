//! Mass and bill of materials.

use std::collections::BTreeMap;
use std::sync::Arc;

use assemcad_model::canonical;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{BillLine, Mass, PartFacts, STEEL_KG_M3, rounded};
use assemcad_placing::{Assembled, Made, Resolved};

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
    // The line of each factory, recipe and parameters; and of parts that were made as one.
    let mut by_content: BTreeMap<(&str, String, Vec<u8>), usize> = BTreeMap::new();
    let mut by_made: BTreeMap<(&str, *const Made), usize> = BTreeMap::new();
    for (part, fact) in resolved.parts.iter().zip(facts) {
        let as_one = (part.factory.as_str(), Arc::as_ptr(&part.made));
        let known = by_made.get(&as_one).copied();
        let at = match known {
            Some(at) => at,
            None => {
                let internal = |e: String| Diagnostic::error(Code::Internal, &part.id, e);
                let hash = part.made.solid.hash().to_owned();
                let params = canonical::to_bytes(&part.made.params);
                let params = params.map_err(|e| internal(e.to_string()))?;
                let key = (part.factory.as_str(), hash.clone(), params.clone());
                let at = *by_content.entry(key).or_insert(lines.len());
                if at == lines.len() {
                    // In the one form that equal ones have: 8, 8.0 and 8e0 are the same number, and a
                    // specification may have them in any order.
                    let params = serde_json::from_slice(&params);
                    lines.push(BillLine {
                        count: 0,
                        designation: part.made.designation.clone(),
                        factory: part.factory.clone(),
                        params: params.map_err(|e| internal(e.to_string()))?,
                        recipe_sha256: hash,
                        mass_kg: fact.mass_kg,
                        parts: Vec::new(),
                    });
                }
                by_made.insert(as_one, at);
                at
            }
        };
        if let Some(line) = lines.get_mut(at) {
            line.count += 1;
            line.parts.push(part.id.clone());
        }
    }
    Ok(lines)
}
