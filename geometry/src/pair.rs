//! Two solids in their places, as one question wherever they stand.

use assemcad_kernel::protocol::{Named, Placed};
use assemcad_model::frame::Placement;

use crate::door::Key;
use crate::pose::{before, numbers, relative};

/// A solid in its place.
#[derive(Debug, Clone)]
pub struct PlacedSolid {
    /// The solid.
    pub solid: Named,
    /// Where it is.
    pub at: Placement,
}

impl From<PlacedSolid> for Placed {
    fn from(of: PlacedSolid) -> Self {
        Self {
            recipe: of.solid,
            placement: of.at.into(),
        }
    }
}

/// Two solids and where the second is in the frame of the first.
#[derive(Debug)]
pub(crate) struct Pair {
    first: Named,
    second: Named,
    at: Placement,
}

impl Pair {
    /// The pair, and whether the two were exchanged: of either order the same one is taken.
    pub(crate) fn of(a: &PlacedSolid, b: &PlacedSolid) -> (Self, bool) {
        let there = relative(&a.at, &b.at);
        let exchanged = match a.solid.hash().cmp(b.solid.hash()) {
            core::cmp::Ordering::Less => false,
            core::cmp::Ordering::Greater => true,
            core::cmp::Ordering::Equal => before(&relative(&b.at, &a.at), &there),
        };
        let (first, second, at) = match exchanged {
            false => (a, b, there),
            true => (b, a, relative(&b.at, &a.at)),
        };
        let pair = Self {
            first: first.solid.clone(),
            second: second.solid.clone(),
            at,
        };
        (pair, exchanged)
    }

    pub(crate) fn parts(&self) -> (&Named, &Named, &Placement) {
        (&self.first, &self.second, &self.at)
    }

    pub(crate) fn key(&self, into: &mut Key) {
        into.text(self.first.hash());
        into.text(self.second.hash());
        into.numbers(numbers(&self.at));
    }
}
