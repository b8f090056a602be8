//! Where two placed solids meet face to face.

use std::sync::Arc;

use assemcad_kernel::protocol::Failure;

use crate::door::{Asker, Key, Question};
use crate::kept::kept_as_json;
use crate::narrow::meet::{Meeting, meetings};
use crate::pair::Pair;

/// Every contact of two solids, and every gap across which one soon stops the other.
#[derive(Debug)]
pub struct Meetings(pub(crate) Pair);

impl Question for Meetings {
    /// In the frame of the pair's first solid.
    type Answer = Arc<Vec<Meeting>>;
    const KIND: &'static str = "meetings";

    fn key(&self, into: &mut Key) {
        self.0.key(into);
    }

    kept_as_json!();

    fn bytes(found: &Self::Answer) -> usize {
        let spots: usize = found.iter().map(|m| m.spots.len()).sum();
        found.len() * size_of::<Meeting>() + spots * 56 + 200
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Self::Answer, Failure> {
        let (one, two) = self.0.skins(door).await?;
        let at = self.0.at();
        door.work(move || Arc::new(meetings(&one, &two, &at))).await
    }
}
