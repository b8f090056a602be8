//! What the checks of single joints' freedom share.

use std::collections::BTreeMap;

use crate::facts::{JointMotion, MateFacts};
use crate::indexed::Indexed;
use crate::joints::about;
use crate::ruling::{Ruling, Status};

/// A verdict on each chosen mate from the motion that is left at it in the whole assembly; indeterminate
/// where that was not analysed.
pub(crate) fn at_each<'a>(
    facts: &'a Indexed,
    axiom: &str,
    chosen: impl Fn(&MateFacts) -> bool,
    judge: impl Fn(&'a MateFacts, &JointMotion) -> Ruling,
) -> Vec<Ruling> {
    let mut left: BTreeMap<&str, &JointMotion> = BTreeMap::new();
    for j in facts.mobility.iter().flat_map(|m| &m.joints) {
        left.entry(&j.mate).or_insert(j);
    }
    let motion = |mate: &MateFacts| left.get(mate.id.as_str()).copied();
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
