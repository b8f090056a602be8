//! Whether two placed solids enter each other for sure.

use assemcad_kernel::protocol::Failure;

use crate::door::{Asker, Key, Question};
use crate::kept::kept_as_json;
use crate::narrow::enter;
use crate::pair::Pair;

/// Whether some point of one solid's skin is shown to lie within the other. No shows nothing.
#[derive(Debug)]
pub struct Enters(pub(crate) Pair);

impl Question for Enters {
    type Answer = bool;
    const KIND: &'static str = "enters";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        self.0.key(into);
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<bool, Failure> {
        let (one, two) = self.0.skins(door).await?;
        let at = self.0.at();
        door.work(move || enter(&one, &two, &at)).await
    }
}
