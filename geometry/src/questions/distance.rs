//! The smallest distance of two placed parts, or of faces of them.

use assemcad_kernel::asked::Chosen;
use assemcad_kernel::pair::Distance as Gap;
use assemcad_kernel::protocol::{Failure, Job, Reply};

use super::measured::chosen;
use crate::door::{Asker, Key, Question, nonsense};
use crate::kept::kept_as_json;

/// The smallest distance.
#[derive(Debug)]
pub struct Distance<'a> {
    /// The first.
    pub a: &'a Chosen,
    /// The second.
    pub b: &'a Chosen,
}

impl Question for Distance<'_> {
    type Answer = Gap;
    const KIND: &'static str = "distance";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        chosen(self.a, into);
        chosen(self.b, into);
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Gap, Failure> {
        let job = Job::Distance {
            a: Box::new(self.a.clone()),
            b: Box::new(self.b.clone()),
        };
        match door.kernel(&job).await? {
            (Reply::Distance(gap), _) => Ok(gap),
            _ => Err(nonsense()),
        }
    }
}
