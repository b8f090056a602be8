//! One free motion driven through a range.

use assemcad_geometry::Asker;
use assemcad_kernel::protocol::Built;
use assemcad_model::diagnostic::{Code, Diagnostic, Faults};
use assemcad_model::freedom::{Drive, DriveKind, NoDrive};
use assemcad_placing::linkage::system;
use assemcad_placing::resolved::part_unknown;
use assemcad_placing::solids::build_all;
use assemcad_placing::{Assembled, Resolved, place};
use serde_json::json;

use crate::answer::Sweep;
use crate::mechanism::Mechanism;
use crate::request::Request;
use crate::walk::Walk;

/// Drives a part of an assembly through a range.
///
/// # Errors
/// When there is no such part, it cannot move so, or the range is none. What is hit is in the answer.
pub async fn sweep(
    door: Asker<'_>,
    resolved: &Resolved,
    request: &Request,
) -> Result<Sweep, Faults> {
    let part = resolved.parts.iter().position(|p| p.id == request.part);
    let part = part.ok_or_else(|| vec![part_unknown(&resolved.parts, &request.part, "part")])?;
    let placements = place::assembly(resolved).map_err(|d| vec![d])?;
    let wanted = request.kind()?;
    let model = system(resolved, &placements).map_err(|(_, d)| vec![d])?;
    let drive = Drive::new(&model, part, wanted)
        .map_err(|why| vec![refusal(resolved, request, wanted, &why)])?;
    let range = request.range(drive.kind)?;
    let built = build_all(door, resolved).await;
    let built: Vec<Option<Built>> = built.into_iter().map(Result::ok).collect();
    let mechanism = Mechanism {
        door,
        assembled: Assembled {
            resolved,
            placements: &placements,
            built: &built,
        },
        drive: &drive,
    };
    let walk = Walk {
        mechanism: &mechanism,
        range,
        tau: request.tau_mm3,
    };
    Ok(walk.run(request).await)
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
