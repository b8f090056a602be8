//! What the fits and screws that were found cannot be.

use assemcad_facts::Held;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name::listed;
use assemcad_model::report::{Finding, Verdict, rounded};
use assemcad_placing::Resolved;
use serde_json::{Map, json};

/// The most interference on the diameter that a press fit of metals is made with, in mm: a share of the diameter,
/// about twice the strain at which steel yields, and what the tolerances of small parts add. H7/u8 of ISO 286 stays
/// below it. Ours.
fn most_mm(diameter: f64) -> f64 {
    0.003 * diameter + 0.03
}

/// Press fits that would burst or crush their parts, and screws that press nothing.
pub(super) fn told(resolved: &Resolved, held: &Held) -> Vec<Finding> {
    let mut out = Vec::new();
    for t in &held.tight {
        let (by, most) = (t.inner_mm - t.hole_mm, most_mm(t.hole_mm));
        if by <= most {
            continue;
        }
        let (hole, inner) = (resolved.name(t.hole), resolved.name(t.inner));
        let mut values = Map::new();
        values.insert("interference_mm".to_owned(), json!(rounded(by)));
        values.insert("hole_diameter_mm".to_owned(), json!(rounded(t.hole_mm)));
        values.insert("inner_diameter_mm".to_owned(), json!(rounded(t.inner_mm)));
        values.insert("at_mm".to_owned(), json!(t.at.map(rounded)));
        let d = Diagnostic::error(
            Code::Clash,
            format!("parts '{hole}' and '{inner}'"),
            format!(
                "'{inner}' is {} mm thick and the hole of '{hole}' about it {} mm wide: no press fit has {} mm of \
                 interference",
                rounded(t.inner_mm),
                rounded(t.hole_mm),
                rounded(by)
            ),
        )
        .found(rounded(by))
        .expected(format!("at most {} mm on the diameter", rounded(most)))
        .hint("make the hole wider or what is in it thinner; H7/r6 or H7/s6 of ISO 286 are usual press fits");
        out.push(finding(vec![hole, inner], values, d));
    }
    for s in &held.idle_screws {
        let screw = resolved.name(s.screw);
        let through: Vec<String> = s.through.iter().map(|p| resolved.name(*p)).collect();
        let d = Diagnostic::error(
            Code::NotHeld,
            format!("part '{screw}'"),
            format!(
                "'{screw}' goes through {} and does not press it: somewhere between its head and its thread in \
                 '{}' faces do not touch",
                listed(&through, 4),
                resolved.name(s.nut)
            ),
        )
        .hint("seat its head and its nut, or choose its length for the stack");
        let mut parts = vec![screw, resolved.name(s.nut)];
        parts.extend(through);
        out.push(finding(parts, Map::new(), d));
    }
    out
}

fn finding(
    parts: Vec<String>,
    values: Map<String, serde_json::Value>,
    diagnostic: Diagnostic,
) -> Finding {
    Finding {
        verdict: Verdict::Fail,
        check: super::CHECK.to_owned(),
        parts,
        mates: Vec::new(),
        values,
        axioms: Vec::new(),
        diagnostic,
    }
}
