//! Whether two placed solids overlap beyond where they are meant to.

use assemcad_kernel::protocol::Failure;
use serde::{Deserialize, Serialize};

use crate::door::{Asker, Key, Question};
use crate::kept::kept_as_json;
use crate::narrow::{Common, Sleeve, common_beside, strays};
use crate::pair::Pair;

/// What two solids have in common outside of some sleeves.
#[derive(Debug)]
pub struct Beyond {
    pair: Pair,
    /// In the frame of the pair's first solid.
    sleeves: Vec<Sleeve>,
}

/// What is known of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Stray {
    /// They have nothing in common there.
    Nothing,
    /// They have: at this point, in mm.
    At([f64; 3]),
    /// Neither could be shown.
    Open,
}

impl Beyond {
    pub(crate) fn new(pair: Pair, sleeves: Vec<Sleeve>) -> Self {
        Self { pair, sleeves }
    }
}

impl Question for Beyond {
    type Answer = Stray;
    const KIND: &'static str = "beyond";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        self.pair.key(into);
        for s in &self.sleeves {
            into.numbers(s.point.into_iter().chain(s.direction).chain([s.radius]));
        }
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Stray, Failure> {
        let (one, two) = self.pair.skins(door).await?;
        let (at, sleeves) = (self.pair.at(), self.sleeves.clone());
        door.work(move || match common_beside(&one, &two, &at, &sleeves) {
            Common::Nothing => Stray::Nothing,
            Common::Open => strays(&one, &two, &at, &sleeves).map_or(Stray::Open, Stray::At),
        })
        .await
    }
}
