//! Two solids in their places, as one question wherever they stand.

use std::sync::Arc;

use assemcad_kernel::protocol::{Failure, Named, Placed};
use assemcad_model::frame::Placement;

use crate::door::{Asker, Key};
use crate::narrow::Boundary;
use crate::pose::{before, numbers, relative};
use crate::questions::skin::Skin;

/// The skins of a pair's two solids.
type Skins = (Arc<Boundary>, Arc<Boundary>);

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

    /// The two as a job of the kernel has them: the first at the origin.
    pub(crate) fn placed(&self) -> [Box<Placed>; 2] {
        let of = |solid: &Named, at: &Placement| {
            Box::new(Placed {
                recipe: solid.clone(),
                placement: (*at).into(),
            })
        };
        [
            of(&self.first, &Placement::IDENTITY),
            of(&self.second, &self.at),
        ]
    }

    /// The skins of both.
    pub(crate) async fn skins(&self, door: &Asker<'_>) -> Result<Skins, Failure> {
        let (first, second) = (Skin(&self.first), Skin(&self.second));
        futures::try_join!(door.ask(&first), door.ask(&second))
    }

    pub(crate) fn at(&self) -> Placement {
        self.at
    }

    pub(crate) fn key(&self, into: &mut Key) {
        into.text(self.first.hash());
        into.text(self.second.hash());
        into.numbers(numbers(&self.at));
    }
}
