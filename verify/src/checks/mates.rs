//! The check `mates`: every mate holds where its parts are.

use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::report::{Finding, MateFacts, Verdict, rounded};
use assemcad_placing::{Placements, Resolved};
use serde_json::{Value, json};

use crate::results::Results;

/// Measures how far every mate is from holding.
pub(crate) fn check(
    resolved: &Resolved,
    placements: &Placements,
    results: &mut Results,
) -> Vec<MateFacts> {
    let mut verdict = Verdict::Pass;
    let mut facts = Vec::new();
    for m in &resolved.mates {
        let (residual, held) = match placements.residual(m) {
            Ok(Some(r)) => (
                Some(r),
                if r.holds() {
                    Verdict::Pass
                } else {
                    Verdict::Fail
                },
            ),
            Ok(None) | Err(_) => (None, Verdict::Indeterminate),
        };
        let parts = vec![m.mate.base.part.clone(), m.mate.incoming.part.clone()];
        let place = format!("mate '{}'", m.mate.id);
        let (d, values) = match residual {
            Some(r) => (
                Diagnostic::error(
                    Code::MateResidual,
                    place,
                    format!(
                        "'{}' and '{}' are {} mm and {} degrees from where the mate has them",
                        m.mate.base,
                        m.mate.incoming,
                        rounded(r.distance_mm),
                        rounded(r.angle_deg)
                    ),
                )
                .hint("change the options of the mates that placed these parts"),
                json!({"distance_mm": rounded(r.distance_mm), "angle_deg": rounded(r.angle_deg)}),
            ),
            None => (
                Diagnostic::error(
                    Code::Indeterminate,
                    place,
                    "it cannot be checked: its parts have no place yet",
                )
                .hint("join one of its parts to a part that has a place"),
                Value::Null,
            ),
        };
        if held != Verdict::Pass {
            results.findings.push(Finding {
                verdict: held,
                check: "mates".to_owned(),
                parts,
                mates: vec![m.mate.id.clone()],
                values: values.as_object().cloned().unwrap_or_default(),
                axioms: Vec::new(),
                diagnostic: d,
            });
        }
        verdict = verdict.and(held);
        facts.push(MateFacts {
            mate: m.mate.id.clone(),
            mate_type: m.mate.mate_type,
            base: m.mate.base.to_string(),
            incoming: m.mate.incoming.to_string(),
            axioms: m.mate.axioms.clone(),
            verdict: held,
            contact: None,
            contact_area_mm2: None,
            radial_play_mm: m.mate.mate_type.kind().radial_play(&m.joint()).map(rounded),
            residual: residual.map(|r| assemcad_model::mates::Residual {
                distance_mm: rounded(r.distance_mm),
                angle_deg: rounded(r.angle_deg),
            }),
        });
    }
    results.check(
        "mates",
        verdict,
        facts.len(),
        "residual of every mate in the directions that it constrains",
    );
    facts
}
