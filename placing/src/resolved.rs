//! Parts and mates all of whose names were found.

use std::collections::BTreeMap;
use std::sync::Arc;

use assemcad_factories::failure::failed_in;
use assemcad_geometry::PlacedSolid;
use assemcad_kernel::protocol::{Failure, Named};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::Placement;
use assemcad_model::mates::{Joint, Options};
use assemcad_model::name::{instead, nearest};
use assemcad_model::param::clip;
use assemcad_model::ports::Port;
use assemcad_model::spec::{End, Mate};
use serde_json::{Map, Value, json};

/// A part as its factory makes it of its parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// The solid.
    pub solid: Named,
    /// The line (1-based) of each call of the recipe in the factory's source.
    pub lines: Vec<u32>,
    /// The ports, in the part's frame.
    pub ports: Vec<Port>,
    /// The parameters as they were used: checked, with defaults filled in.
    pub params: Map<String, Value>,
    /// What a standard calls the part, where a built-in factory says so. Solids do not show whether such
    /// a claim is true, so that it is not taken from factories that were admitted on evidence of solids.
    pub designation: Option<String>,
}

/// A part with its recipe and ports.
#[derive(Debug, Clone)]
pub struct ResolvedPart {
    /// Name.
    pub id: String,
    /// Name of the factory.
    pub factory: String,
    /// Recipe, ports, and the source lines of the recipe's calls.
    pub made: Arc<Made>,
}

impl ResolvedPart {
    /// The part's ports.
    #[must_use]
    pub fn ports(&self) -> &[Port] {
        &self.made.ports
    }

    /// The part's solid in a place.
    #[must_use]
    pub fn solid_at(&self, at: &Placement) -> PlacedSolid {
        PlacedSolid {
            solid: self.made.solid.clone(),
            at: *at,
        }
    }

    /// A failure in making the part, with the line of its factory's source.
    #[must_use]
    pub fn failed(&self, failure: &Failure) -> Diagnostic {
        failed_in(failure, Some(&self.id), &self.factory, &self.made.lines)
    }
}

/// A mate with its parts (by index), ports and checked options.
#[derive(Debug, Clone)]
pub struct ResolvedMate {
    /// The mate as it is written.
    pub mate: Mate,
    /// Index of the base part.
    pub base: usize,
    /// Index of the incoming part.
    pub incoming: usize,
    /// The base port.
    pub base_port: Port,
    /// The incoming port.
    pub incoming_port: Port,
    /// The options, complete.
    pub options: Options,
}

impl ResolvedMate {
    /// The two ports and the options.
    #[must_use]
    pub fn joint(&self) -> Joint<'_> {
        Joint {
            base: &self.base_port,
            incoming: &self.incoming_port,
            options: &self.options,
        }
    }

    /// Whether it joins these two parts, either way round.
    #[must_use]
    pub fn joins(&self, i: usize, j: usize) -> bool {
        (self.base, self.incoming) == (i, j) || (self.base, self.incoming) == (j, i)
    }
}

/// A specification all of whose names were found.
#[derive(Debug, Clone)]
pub struct Resolved {
    /// The parts, in the specification's order.
    pub parts: Vec<ResolvedPart>,
    /// The mates, in the specification's order.
    pub mates: Vec<ResolvedMate>,
    /// Index of the root part; none in an assembly without parts.
    pub root: Option<usize>,
}

impl Resolved {
    /// The name of a part by its index.
    #[must_use]
    pub fn name(&self, part: usize) -> String {
        self.parts
            .get(part)
            .map(|p| p.id.clone())
            .unwrap_or_default()
    }

    /// The mates between each two parts, by their indices, the earlier part first.
    #[must_use]
    pub fn mates_by_pair(&self) -> BTreeMap<(usize, usize), Vec<&ResolvedMate>> {
        let mut out: BTreeMap<(usize, usize), Vec<&ResolvedMate>> = BTreeMap::new();
        for m in &self.mates {
            let pair = (m.base.min(m.incoming), m.base.max(m.incoming));
            out.entry(pair).or_default().push(m);
        }
        out
    }

    /// The mates that join two parts.
    pub fn between(&self, i: usize, j: usize) -> impl Iterator<Item = &ResolvedMate> {
        self.mates.iter().filter(move |m| m.joins(i, j))
    }
}

/// Finds the port that an end of a mate names, and its part's index; `place` is where the end is written.
///
/// # Errors
/// When there is no such part, or it has no such port.
pub fn port<'a>(
    parts: &'a [ResolvedPart],
    end: &End,
    place: &str,
) -> Result<(usize, &'a Port), Diagnostic> {
    let index = |id: &str| parts.iter().position(|p| p.id == id);
    port_among(parts, &index, end, place)
}

/// The same where the index of a part's name is known.
///
/// # Errors
/// As [`port`].
pub fn port_among<'a>(
    parts: &'a [ResolvedPart],
    named: &dyn Fn(&str) -> Option<usize>,
    end: &End,
    place: &str,
) -> Result<(usize, &'a Port), Diagnostic> {
    let Some((i, part)) = named(&end.part).and_then(|i| Some((i, parts.get(i)?))) else {
        return Err(part_unknown(parts, &end.part, place));
    };
    if let Some(port) = part.ports().iter().find(|p| p.name == end.port) {
        return Ok((i, port));
    }
    let names: Vec<&str> = part.ports().iter().map(|p| p.name.as_str()).collect();
    let d = Diagnostic::error(
        Code::PortUnknown,
        place,
        format!(
            "part '{}' ({}) has no port '{}'",
            part.id,
            part.factory,
            clip(&end.port)
        ),
    )
    .found(end.port.as_str())
    .expected(json!(names));
    Err(match nearest(&end.port, names, 1).first() {
        Some(near) => d.hint(format!("did you mean '{}:{near}'?", part.id)),
        None => d,
    })
}

/// The diagnostic for a part that is not there.
#[must_use]
pub fn part_unknown(parts: &[ResolvedPart], id: &str, place: &str) -> Diagnostic {
    let names: Vec<&str> = parts.iter().map(|p| p.id.as_str()).collect();
    let d = Diagnostic::error(
        Code::PartUnknown,
        place,
        format!("there is no part '{}'", clip(id)),
    )
    .found(id);
    let (offered, near) = instead(id, &names);
    let d = d.expected(offered);
    match near {
        Some(near) => d.hint(format!("did you mean '{near}'?")),
        None => d,
    }
}
