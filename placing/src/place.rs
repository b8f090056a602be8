//! Placement: from the root along the mates, each part by the first mate that reaches it.

use std::collections::BTreeSet;

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::{FrameError, Placement};
use assemcad_model::mates::Residual;

use crate::resolved::{Resolved, ResolvedMate};

/// Where the parts are.
#[derive(Debug, Clone, PartialEq)]
pub struct Placements {
    /// The placement of each part that the root reaches, in the specification's order.
    pub parts: Vec<Option<Placement>>,
    /// The mate (by index) that placed each part; none for the root and for parts without a place.
    pub placed_by: Vec<Option<usize>>,
}

/// Places the parts of an assembly. The root stands in the world's origin.
///
/// Mates are taken in the order in which they were made, again and again until none reaches a new
/// part, so that the result depends on the specification alone.
///
/// # Errors
/// When a port's frame is none: a fault of its factory.
pub fn assembly(resolved: &Resolved) -> Result<Placements, Diagnostic> {
    from(resolved, resolved.root)
}

/// The same from another part, which stands in the world's origin.
pub(crate) fn from(resolved: &Resolved, root: Option<usize>) -> Result<Placements, Diagnostic> {
    let n = resolved.parts.len();
    let mut placements = Placements {
        parts: vec![None; n],
        placed_by: vec![None; n],
    };
    let mut of: Vec<Vec<usize>> = vec![Vec::new(); n];
    for (i, m) in resolved.mates.iter().enumerate() {
        for part in [m.base, m.incoming] {
            if let Some(list) = of.get_mut(part) {
                list.push(i);
            }
        }
    }
    let of = |part: usize| of.get(part).into_iter().flatten().copied();
    // The mates of placed parts: those whose turn comes yet in this round, and those of the next one.
    let (mut now, mut later) = (BTreeSet::new(), BTreeSet::new());
    if let Some((slot, root)) = root.and_then(|r| Some((placements.parts.get_mut(r)?, r))) {
        *slot = Some(Placement::IDENTITY);
        now.extend(of(root));
    }
    loop {
        let Some(i) = now.pop_first() else {
            if later.is_empty() {
                return Ok(placements);
            }
            now = core::mem::take(&mut later);
            continue;
        };
        let Some(m) = resolved.mates.get(i) else {
            continue;
        };
        let at = |part: usize| placements.parts.get(part).copied().flatten();
        let (reached, placement) = match (at(m.base), at(m.incoming)) {
            (Some(base), None) => (m.incoming, place_incoming(m, &base)),
            (None, Some(incoming)) => (m.base, place_base(m, &incoming)),
            _ => continue,
        };
        let placement = placement.map_err(|e| frame_fault(m, e))?;
        if let Some(slot) = placements.parts.get_mut(reached) {
            *slot = Some(placement);
        }
        if let Some(slot) = placements.placed_by.get_mut(reached) {
            *slot = Some(i);
        }
        for k in of(reached) {
            if k > i {
                now.insert(k);
            } else {
                later.insert(k);
            }
        }
    }
}

impl Placements {
    /// The placement of a part.
    #[must_use]
    pub fn of(&self, part: usize) -> Option<Placement> {
        self.parts.get(part).copied().flatten()
    }

    /// How far a mate is from holding; none while one of its parts has no place.
    ///
    /// # Errors
    /// When a port's frame is none.
    pub fn residual(&self, m: &ResolvedMate) -> Result<Option<Residual>, Diagnostic> {
        let (Some(base), Some(incoming)) = (self.of(m.base), self.of(m.incoming)) else {
            return Ok(None);
        };
        let kind = m.mate.mate_type.kind();
        kind.residual(&base, &m.base_port, &incoming, &m.incoming_port, &m.options)
            .map(Some)
            .map_err(|e| frame_fault(m, e))
    }
}

fn place_incoming(m: &ResolvedMate, base: &Placement) -> Result<Placement, FrameError> {
    m.mate
        .mate_type
        .kind()
        .place_incoming(base, &m.base_port, &m.incoming_port, &m.options)
}

fn place_base(m: &ResolvedMate, incoming: &Placement) -> Result<Placement, FrameError> {
    m.mate
        .mate_type
        .kind()
        .place_base(incoming, &m.base_port, &m.incoming_port, &m.options)
}

fn frame_fault(m: &ResolvedMate, e: FrameError) -> Diagnostic {
    Diagnostic::error(
        Code::FactoryFailed,
        format!("mate {}", m.mate.id),
        e.to_string(),
    )
    .hint("the factory of one of the two parts states an impossible port frame")
}
