//! An assembly as far as it can be made and placed.

use assemcad_model::spec::Assembly;
use assemcad_placing::partial::no_parts;
use assemcad_placing::{Partial, Resolved, place};

use crate::resolve;
use crate::{Faults, Workshop};

/// Makes and places what can be.
///
/// # Errors
/// When there is no part, or none that can be made.
pub(crate) async fn of(workshop: &Workshop, spec: &Assembly) -> Result<Partial, Faults> {
    if spec.parts.is_empty() {
        return Err(vec![no_parts(&spec.id)]);
    }
    let wanted: Vec<_> = spec.parts.iter().enumerate().collect();
    let made = resolve::parts(workshop, &wanted).await;
    let (mut parts, mut missing, mut faults) = (Vec::new(), Vec::new(), Vec::new());
    for (result, part) in made.into_iter().zip(&spec.parts) {
        match result {
            Ok(part) => parts.push(part),
            Err(more) => {
                let why = more.first().map(|d| d.message.clone()).unwrap_or_default();
                missing.push(format!("{}: it could not be made: {why}", part.id));
                faults.extend(more);
            }
        }
    }
    if parts.is_empty() {
        return Err(faults);
    }
    let by_name = resolve::by_name(&parts);
    let named = |id: &str| by_name.get(id).copied();
    let mut mates = Vec::new();
    for (i, m) in spec.mates.iter().enumerate() {
        let there = |id: &str| named(id).is_some();
        // A mate of a part that is missing has been accounted for with the part.
        if !there(&m.base.part) || !there(&m.incoming.part) {
            continue;
        }
        let at = |field: &str| format!("mates[{i}].{field}");
        match resolve::mate_among(&parts, &named, &spec.id, m, &at) {
            Ok(mate) => mates.push(mate),
            Err(more) => {
                let why = more.first().map(|d| d.message.clone()).unwrap_or_default();
                missing.push(format!("mate {}: {why}", m.id));
            }
        }
    }
    let wanted = spec.root().and_then(named);
    if wanted.is_none()
        && let (Some(first), Some(root)) = (parts.first(), spec.root())
    {
        missing.push(format!(
            "the root {root} is missing: {} stands at the origin instead",
            first.id
        ));
    }
    let resolved = Resolved {
        parts,
        mates,
        root: Some(wanted.unwrap_or_default()),
    };
    let placements = place::assembly(&resolved).map_err(|d| vec![d])?;
    for (i, part) in resolved.parts.iter().enumerate() {
        if placements.of(i).is_none() {
            missing.push(format!("{}: no mate joins it to the root", part.id));
        }
    }
    Ok(Partial {
        resolved,
        placements,
        missing,
    })
}
