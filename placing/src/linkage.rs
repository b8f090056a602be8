//! An assembly as bodies and links, of which its freedom is told.

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::Placement;
use assemcad_model::freedom::{Axis, Body, Freedom, System, analyse, link_of, spin_axis};
use assemcad_model::name::listed;

use crate::place::{self, Placements};
use crate::resolved::Resolved;

/// How many mates a sentence names.
const MOST_NAMED: usize = 3;

/// Bodies and links of an assembly; else the mates that do not hold, and why nothing can be told.
///
/// # Errors
/// When mates do not hold, or a port's frame is none.
pub fn system(
    resolved: &Resolved,
    placements: &Placements,
) -> Result<System, (Vec<String>, Diagnostic)> {
    let placements = with_islands(resolved, placements).map_err(|d| (Vec::new(), d))?;
    let open: Vec<String> = resolved
        .mates
        .iter()
        .filter(|m| !matches!(placements.residual(m), Ok(Some(r)) if r.holds()))
        .map(|m| m.mate.id.clone())
        .collect();
    if !open.is_empty() {
        let message = format!(
            "the free motions cannot be told while {} {} not hold",
            listed(&open, MOST_NAMED),
            if open.len() == 1 { "does" } else { "do" }
        );
        let d = Diagnostic::error(Code::Indeterminate, "freedom", message)
            .hint("mend the mates first: motions are those of parts in their places");
        return Err((open, d));
    }
    let at = |part: usize| placements.of(part).unwrap_or(Placement::IDENTITY);
    let bodies = resolved.parts.iter().enumerate().map(|(i, p)| Body {
        name: p.id.clone(),
        at: at(i).origin().into(),
        spin: spin_axis(p.ports()).map(|a| Axis {
            point: at(i).point(a.point),
            direction: at(i).direction(a.direction),
        }),
    });
    let links = resolved.mates.iter().map(|m| {
        let base = (m.base, &at(m.base));
        let incoming = (m.incoming, &at(m.incoming));
        link_of(&m.mate.id, m.mate.mate_type, &m.joint(), base, incoming).map_err(|e| {
            (
                vec![m.mate.id.clone()],
                frame_fault(&m.mate.id, &e.to_string()),
            )
        })
    });
    Ok(System {
        bodies: bodies.collect(),
        links: links.collect::<Result<_, _>>()?,
        root: resolved.root,
    })
}

fn frame_fault(mate: &str, why: &str) -> Diagnostic {
    Diagnostic::error(Code::Indeterminate, format!("mate '{mate}'"), why)
}

/// Places for the parts that the root does not reach: each island about the first of its parts. Where it
/// stands against the root does not matter for its freedom.
fn with_islands(resolved: &Resolved, placements: &Placements) -> Result<Placements, Diagnostic> {
    let mut out = placements.clone();
    while let Some(first) = out.parts.iter().position(Option::is_none) {
        let island = place::from(resolved, Some(first))?;
        for (slot, found) in out.parts.iter_mut().zip(island.parts) {
            *slot = slot.or(found);
        }
    }
    Ok(out)
}

/// The freedom of placed parts with some of their mates; none where those do not hold.
#[must_use]
pub fn freedom_of(resolved: &Resolved, placements: &Placements) -> Option<Freedom> {
    system(resolved, placements).ok().map(|s| analyse(&s))
}
