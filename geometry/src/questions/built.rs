//! A solid made and measured.

use assemcad_kernel::protocol::{Built, Failure, Job, Named, Reply};

use crate::door::{Asker, Key, Question, nonsense};
use crate::kept::kept_as_json;

/// Makes a solid and measures it. The kernel answers only for one valid closed solid of positive volume.
#[derive(Debug)]
pub struct Build<'a>(pub &'a Named);

impl Question for Build<'_> {
    type Answer = Built;
    const KIND: &'static str = "built";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        into.text(self.0.hash());
    }

    fn bytes(built: &Built) -> usize {
        600 + built.ports.len() * 600
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Built, Failure> {
        let recipe = self.0.clone();
        match door.kernel(&Job::Build { recipe }).await? {
            (Reply::Built(built), _) => Ok(built),
            _ => Err(nonsense()),
        }
    }
}
