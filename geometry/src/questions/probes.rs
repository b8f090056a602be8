//! What a solid has at some places.

use assemcad_kernel::protocol::{Failure, Job, Named, Reply};
use assemcad_model::probe::{Answer, Probe};

use crate::door::{Asker, Key, Question, nonsense};
use crate::kept::kept_as_json;

/// Probes of a solid: an answer to each, in order.
#[derive(Debug)]
pub struct Probes<'a> {
    /// The solid.
    pub solid: &'a Named,
    /// What is asked.
    pub probes: &'a [Probe],
}

impl Question for Probes<'_> {
    type Answer = Vec<Answer>;
    const KIND: &'static str = "probes";

    kept_as_json!();

    fn key(&self, into: &mut Key) {
        into.text(self.solid.hash());
        into.json(&self.probes);
    }

    fn bytes(answers: &Vec<Answer>) -> usize {
        200 + answers.len() * 200
    }

    async fn answer(&self, door: &Asker<'_>) -> Result<Vec<Answer>, Failure> {
        let job = Job::Probe {
            recipe: self.solid.clone(),
            probes: self.probes.to_vec(),
        };
        match door.kernel(&job).await? {
            (Reply::Probed(answers), _) if answers.len() == self.probes.len() => Ok(answers),
            _ => Err(nonsense()),
        }
    }
}
