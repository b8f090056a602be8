//! What the checks of single joints' freedom share.

use crate::facts::{Facts, JointMotion, MateFacts};
use crate::joints::about;
use crate::ruling::{Ruling, Status};

/// A verdict on each chosen mate from the motion that is left at it in the whole assembly; indeterminate
/// where that was not analysed.
pub(crate) fn at_each<'a>(
    facts: &'a Facts,
    axiom: &str,
    chosen: impl Fn(&MateFacts) -> bool,
    judge: impl Fn(&'a MateFacts, &JointMotion) -> Ruling,
) -> Vec<Ruling> {
    let motion = |mate: &MateFacts| {
        let all = facts.mobility.as_ref()?;
        all.joints.iter().find(|j| j.mate == mate.id)
    };
    facts
        .mates
        .iter()
        .filter(|m| chosen(m))
        .map(|m| match motion(m) {
            Some(left) => judge(m, left),
            None => {
                let message = format!("the motion at '{}' was not analysed", m.id);
                Ruling::new(axiom, Status::Indeterminate, about(m), message)
            }
        })
        .collect()
}
