//! G-08: backlash.

use super::Check;
use crate::gearing::pairs;
use crate::indexed::Indexed;
use crate::ruling::{Ruling, Status};

/// Some play between the free flanks, and not too much of it.
pub struct Backlash;

/// The most backlash in modules. Ours, and that of the built-in gear: beyond it a tooth is a fifth thinner.
const SHARE: f64 = 0.3;

/// Below this, in mm, flanks count as touching: the placement of the mate is exact to first order only.
const SAME_MM: f64 = 1e-4;

impl Check for Backlash {
    fn id(&self) -> &'static str {
        "backlash"
    }

    fn axiom(&self) -> &'static str {
        "G-08"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        let mut out = Vec::new();
        for p in pairs(facts) {
            if p.seen.is_none() {
                out.push(Ruling::unplaced(self.axiom(), p.about()));
                continue;
            }
            let Some(a) = p.distance() else { continue };
            let most = SHARE * p.a.module;
            let Some(play) = p.circular_play(a) else {
                continue;
            };
            let (status, what) = if play < -SAME_MM {
                (Status::Fail, "lie in each other")
            } else if play > most {
                (Status::Fail, "are too loose")
            } else if play <= SAME_MM {
                (
                    Status::Indeterminate,
                    "touch on both flanks as they are drawn",
                )
            } else {
                (Status::Pass, "have play")
            };
            let message = format!(
                "the teeth of {} {what}: {play:.4} mm along the working circles",
                p.names()
            );
            let mut v = Ruling::new(self.axiom(), status, p.about(), message)
                .value("backlash_mm", play)
                .value("most_mm", most);
            if status == Status::Indeterminate {
                v = v.assuming(
                    "tolerances of tooth thickness, which are not stated, may give the play",
                );
            }
            out.push(v);
        }
        out
    }
}
