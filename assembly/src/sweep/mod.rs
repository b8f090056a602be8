//! The sweep: one free motion driven through a range, and the first collision on the way.
//!
//! What is coupled to the driven part follows by the mates' constraints. Two parts collide where they have more in
//! common than their mates mean, as at rest. Of two parts that only turn against each other about one axis, of which
//! one is a solid of revolution about it or which bounds about it keep apart, one pose tells all others: they are
//! proven. All other pairs are sampled, and may collide between two samples.

mod answer;
mod hulls;
mod pairs;
mod request;
mod walk;

use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::freedom::{Drive, DriveKind, NoDrive};
use assemcad_model::report::rounded;
use futures::future::join_all;
use serde_json::json;

pub use self::answer::{Collision, Open, Pairs, Proof, Proven, Stop, Sweep, Unit};
pub use self::request::{DEFAULT_STEP_DEG, DEFAULT_STEPS, MOST_POSES, Request};
use self::walk::Walk;
use crate::freedom_check::system;
use crate::place;
use crate::resolve::{self, Resolved, part_unknown};
use crate::{Faults, Workshop};

impl Workshop {
    /// Drives a part of an assembly through a range.
    ///
    /// # Errors
    /// When there is no such part, it cannot move so, or the range is none. What is hit is in the answer.
    pub async fn sweep(&self, request: &Request) -> Result<Sweep, Faults> {
        let spec = self.store.load(&request.assembly).map_err(|d| vec![d])?;
        let resolved = resolve::assembly(self, &spec).await?;
        let part = resolved.parts.iter().position(|p| p.id == request.part);
        let part =
            part.ok_or_else(|| vec![part_unknown(&resolved.parts, &request.part, "part")])?;
        let placed = place::assembly(&resolved).map_err(|d| vec![d])?;
        let wanted = request.kind()?;
        let model = system(&resolved, &placed).map_err(|(_, d)| vec![d])?;
        let drive = Drive::new(&model, part, wanted)
            .map_err(|why| vec![refusal(&resolved, request, wanted, &why)])?;
        let range = request.range(drive.kind)?;
        let built: Vec<Option<Built>> = join_all(resolved.parts.iter().map(|p| self.build(p)))
            .await
            .into_iter()
            .map(Result::ok)
            .collect();
        let walk = Walk {
            workshop: self,
            resolved: &resolved,
            placed: &placed,
            built: &built,
            drive: &drive,
            range,
            tau: request.tau_mm3,
        };
        Ok(walk.run(request).await)
    }
}

/// Why a part cannot be driven.
fn refusal(
    resolved: &Resolved,
    request: &Request,
    wanted: Option<DriveKind>,
    why: &NoDrive,
) -> Diagnostic {
    let part = &request.part;
    match why {
        NoDrive::Floats => Diagnostic::error(
            Code::Unconnected,
            "part",
            format!("nothing holds '{part}' to the root, so that it has no motion of its own"),
        )
        .found(part.as_str())
        .hint("join it with the mate tool first"),
        NoDrive::Unknown => Diagnostic::error(
            Code::Indeterminate,
            "part",
            format!("how '{part}' moves away from this pose cannot be told from its mates"),
        )
        .found(part.as_str())
        .hint(
            "verify says which constraints are neither clearly dependent nor clearly independent",
        ),
        NoDrive::Held(others) => {
            let how = match wanted {
                None => "moves",
                Some(DriveKind::Rotate) => "turns",
                Some(DriveKind::Slide) => "slides without turning",
            };
            let names = others.iter().filter_map(|i| resolved.parts.get(*i));
            let names: Vec<&str> = names.map(|p| p.id.as_str()).collect();
            let d = Diagnostic::error(
                Code::PartHeld,
                "part",
                format!("no free motion is left in which '{part}' {how}"),
            )
            .found(part.as_str())
            .expected(json!({"parts_that_can_move": names}));
            match names.first() {
                // It may be the kind that is wrong.
                Some(_) if names.contains(&part.as_str()) => d.hint("leave out 'kind'"),
                Some(first) => d.next(
                    "sweep",
                    json!({"assembly": request.assembly, "part": first}),
                ),
                None => d.hint("take out the mate that holds what should move"),
            }
        }
    }
}

/// A coordinate as it is reported: degrees or millimetres.
fn shown(kind: DriveKind, value: f64) -> f64 {
    rounded(match kind {
        DriveKind::Rotate => value.to_degrees(),
        DriveKind::Slide => value,
    })
}
