//! S-02: no fastener is buried.

use std::collections::BTreeMap;

use super::Check;
use crate::asked::tools;
use crate::facts::Reach;
use crate::indexed::Indexed;
use crate::ruling::{About, Ruling, Status};

/// The cylinder of the tool, from the head outward along the axis, is free.
pub struct FastenerAccess;

/// What counts as free, in mm: far below any tool, above the deviation of the triangles that it is seen on.
const SLACK_MM: f64 = 0.1;

impl Check for FastenerAccess {
    fn id(&self) -> &'static str {
        "fastener_access"
    }

    fn axiom(&self) -> &'static str {
        "S-02"
    }

    fn run(&self, facts: &Indexed) -> Vec<Ruling> {
        // A fastener by itself is no assembly.
        if facts.parts.len() == 1 {
            return Vec::new();
        }
        let mut reaches: BTreeMap<&str, &Reach> = BTreeMap::new();
        for r in facts.measured.reaches.iter().flatten() {
            reaches.entry(&r.part).or_insert(r);
        }
        tools(facts)
            .into_iter()
            .map(|tool| {
                let id = &tool.fastener.id;
                let reach = reaches.get(id.as_str());
                let Some((reach, free)) = reach.and_then(|r| Some((r, r.free_mm?))) else {
                    let message = format!("whether a tool reaches '{id}' was not measured");
                    return Ruling::new(
                        self.axiom(),
                        Status::Indeterminate,
                        About::parts([id]),
                        message,
                    );
                };
                let holds = free >= tool.length_mm - SLACK_MM;
                let (message, about) = match &reach.by {
                    Some(by) if !holds => (
                        format!(
                            "'{by}' stands before '{id}' at {free:.3} mm; its tool needs {:.3} mm",
                            tool.length_mm
                        ),
                        About::parts([id, by]),
                    ),
                    _ => (format!("a tool reaches '{id}' along its axis"), About::parts([id])),
                };
                Ruling::held(self.axiom(), holds, about, message)
                    .value("free_mm", free)
                    .value("tool_length_mm", tool.length_mm)
                    .value("tool_diameter_mm", tool.diameter_mm)
                    .assuming(
                        "the tool is a cylinder as wide as the head and three times as long, of a set screw half \
                         its thread: a rule of ours; a spanner from the side is not counted on",
                    )
            })
            .collect()
    }
}
