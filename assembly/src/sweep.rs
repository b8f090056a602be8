//! Motions of an assembly on disk.

use assemcad_motion::{Request, Sweep, sweep};

use crate::resolve;
use crate::{Faults, Workshop};

impl Workshop {
    /// Drives a part of an assembly through a range.
    ///
    /// # Errors
    /// When there is no such part, it cannot move so, or the range is none. What is hit is in the answer.
    pub async fn sweep(&self, request: &Request) -> Result<Sweep, Faults> {
        let spec = self.store.load(&request.assembly).map_err(|d| vec![d])?;
        let resolved = resolve::assembly(self, &spec).await?;
        sweep(self.door.asker(), &resolved, request).await
    }
}
