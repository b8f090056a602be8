//! Extent and centre of a placed part or of faces of it.

use assemcad_kernel::asked::{Chosen, Measured};
use assemcad_kernel::protocol::{Failure, Job, Reply};

use crate::door::{Asker, Key, Question, nonsense};
use crate::kept::kept_as_json;

/// Measures a placed part or faces of it.
#[derive(Debug)]
pub struct Measure<'a>(pub &'a Chosen);

/// Everything that says which part or faces are meant, and where.
pub(super) fn chosen(of: &Chosen, into: &mut Key) {
    into.text(of.part.recipe.hash());
    into.numbers(crate::pose::numbers(&of.part.placement.into()));
    into.json(&of.faces);
}

impl Question for Measure<'_> {
    type Answer = Measured;
    const KIND: &'static str = "measure";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        chosen(self.0, into);
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Measured, Failure> {
        let of = Box::new(self.0.clone());
        match door.kernel(&Job::Measure { of }).await? {
            (Reply::Measured(found), _) => Ok(found),
            _ => Err(nonsense()),
        }
    }
}
