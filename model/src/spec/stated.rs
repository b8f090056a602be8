//! What an author states beside parts and mates: which motions are meant, what may lie loose, which rule is broken
//! knowingly. Each is about named parts, is shown in the report, and switches no check off.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Assembly;
use crate::diagnostic::{Code, Diagnostic};
use crate::name::nearest;

/// A motion of one part: at most one of the two directions; without one, any motion.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PartMotion {
    /// Name of the part.
    pub part: String,
    /// The axis of the world along which it slides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slides_along: Option<WorldAxis>,
    /// The axis of the world about whose direction it turns.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turns_about: Option<WorldAxis>,
    /// Why.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub reason: String,
}

/// An axis of the world.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WorldAxis {
    /// The x axis.
    X,
    /// The y axis.
    Y,
    /// The z axis.
    Z,
}

/// A rule of experience that is broken knowingly.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Accepted {
    /// Id of the axiom.
    pub axiom: String,
    /// Names of the parts of which it is accepted.
    pub parts: Vec<String>,
    /// Why it is right here.
    pub reason: String,
}

impl WorldAxis {
    /// Whether a direction goes along it, either way.
    #[must_use]
    pub fn goes_along(self, direction: [f64; 3]) -> bool {
        let [x, y, z] = direction.map(f64::abs);
        let (along, rest) = match self {
            Self::X => (x, y.max(z)),
            Self::Y => (y, x.max(z)),
            Self::Z => (z, x.max(y)),
        };
        rest <= 1e-6 * along
    }
}

impl PartMotion {
    /// Whether a slide of the part along a direction is this motion.
    #[must_use]
    pub fn is_slide(&self, direction: [f64; 3]) -> bool {
        match (self.slides_along, self.turns_about) {
            (None, None) => true,
            (Some(axis), _) => axis.goes_along(direction),
            (None, Some(_)) => false,
        }
    }

    /// Whether a turn of the part about a direction is this motion.
    #[must_use]
    pub fn is_turn(&self, direction: [f64; 3]) -> bool {
        match (self.slides_along, self.turns_about) {
            (None, None) => true,
            (_, Some(axis)) => axis.goes_along(direction),
            (Some(_), None) => false,
        }
    }
}

impl Assembly {
    /// How many motions are stated as meant; none where nothing is said of them.
    #[must_use]
    pub fn motions_meant(&self) -> Option<u32> {
        let listed = u32::try_from(self.intended_motions.len()).ok();
        self.intended_mobility.or(listed.filter(|n| *n > 0))
    }

    /// What is wrong with the names in what is stated: places are those of the specification.
    #[must_use]
    pub fn stated_faults(&self) -> Vec<Diagnostic> {
        let mut out = Vec::new();
        let ids: Vec<&str> = self.parts.iter().map(|p| p.id.as_str()).collect();
        let mut named = |part: &str, place: String| {
            if ids.contains(&part) {
                return;
            }
            let d = Diagnostic::error(
                Code::PartUnknown,
                place,
                format!("there is no part '{}'", crate::param::clip(part)),
            )
            .found(part)
            .expected(serde_json::json!(ids));
            out.push(match nearest(part, ids.iter().copied(), 1).first() {
                Some(near) => d.hint(format!("did you mean '{near}'?")),
                None => d,
            });
        };
        for (i, m) in self.intended_motions.iter().enumerate() {
            named(&m.part, format!("intended_motions[{i}].part"));
        }
        for (i, m) in self.free.iter().enumerate() {
            named(&m.part, format!("free[{i}].part"));
        }
        for (i, a) in self.accept.iter().enumerate() {
            for (j, part) in a.parts.iter().enumerate() {
                named(part, format!("accept[{i}].parts[{j}]"));
            }
        }
        for (i, a) in self.accept.iter().enumerate() {
            for (empty, field) in [
                (a.parts.is_empty(), "parts"),
                (a.reason.trim().is_empty(), "reason"),
            ] {
                if empty {
                    out.push(Diagnostic::error(
                        Code::SpecificationInvalid,
                        format!("accept[{i}].{field}"),
                        "what is accepted names its parts and its reason",
                    ));
                }
            }
        }
        for (i, m) in self.intended_motions.iter().enumerate() {
            let place = format!("intended_motions[{i}]");
            if m.slides_along.is_some() == m.turns_about.is_some() {
                let said = "a motion that is meant slides along one axis or turns about one";
                let d = Diagnostic::error(Code::SpecificationInvalid, place, said);
                out.push(d.hint("state slides_along or turns_about: x, y or z"));
            } else if self.intended_motions.iter().take(i).any(|o| {
                (&o.part, o.slides_along, o.turns_about) == (&m.part, m.slides_along, m.turns_about)
            }) {
                let said = "this motion is stated already";
                out.push(Diagnostic::error(Code::SpecificationInvalid, place, said));
            }
        }
        let counted = self.intended_motions.len();
        if let Some(n) = self.intended_mobility
            && counted > 0
            && n as usize != counted
        {
            out.push(
                Diagnostic::error(
                    Code::SpecificationInvalid,
                    "intended_mobility",
                    format!("{n} motions are intended and {counted} are listed"),
                )
                .found(n)
                .expected(counted),
            );
        }
        out
    }
}
