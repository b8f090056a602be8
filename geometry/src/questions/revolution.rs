//! Whether a solid is one of revolution.

use assemcad_kernel::protocol::{Failure, Job, Named, Reply};

use crate::door::{Asker, Key, Question, nonsense};
use crate::kept::kept_as_json;

/// A line in a part's frame: a point in mm and a unit direction.
pub type Line = ([f64; 3], [f64; 3]);

/// Whether a solid is one of revolution about each of some axes in its frame, in order.
#[derive(Debug)]
pub struct Revolution<'a> {
    /// The solid.
    pub solid: &'a Named,
    /// The axes.
    pub axes: &'a [Line],
}

impl Question for Revolution<'_> {
    type Answer = Vec<bool>;
    const KIND: &'static str = "revolution";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        into.text(self.solid.hash());
        into.numbers(
            self.axes
                .iter()
                .flat_map(|(p, d)| p.iter().chain(d))
                .copied(),
        );
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Vec<bool>, Failure> {
        let job = Job::Revolution {
            recipe: self.solid.clone(),
            axes: self.axes.to_vec(),
        };
        match door.kernel(&job).await? {
            (Reply::Revolution(found), _) if found.len() == self.axes.len() => Ok(found),
            _ => Err(nonsense()),
        }
    }
}
