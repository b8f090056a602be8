//! What the gate found, and the evidence on which a factory is admitted.

use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::ports::PortType;
use assemcad_model::report::{Verdict, rounded};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::gate::Tried;
use super::sets::{Origin, Set};
use super::stages::{Extent, Stage, stages};
use super::trial::Outcome;

/// The layers, in the order in which they are tried.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Layer {
    /// The source parses, declares what was asked for, and runs within the limits.
    Execution,
    /// The kernel makes one valid closed solid of positive volume.
    Geometry,
    /// Expected ports are there, and the solid shows all declared ones.
    Ports,
}

/// Something that is wrong with a factory.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Finding {
    /// The layer that found it.
    pub layer: Layer,
    /// Line of the source (1-based), where it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// Name of the port that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub port: Option<String>,
    /// The parameters at which it was found first, where they differ from the defaults; empty at the
    /// defaults.
    pub at: Map<String, Value>,
    /// At how many of the tried sets of parameters it is so.
    pub sets: usize,
    /// What is wrong, what was found, and what to do.
    pub diagnostic: Diagnostic,
}

impl Finding {
    pub(super) fn of(layer: Layer, diagnostic: Diagnostic) -> Self {
        Self {
            layer,
            line: line_in(&diagnostic.place),
            port: None,
            at: Map::new(),
            sets: 1,
            diagnostic,
        }
    }

    pub(super) fn of_port(port: &str, diagnostic: Diagnostic) -> Self {
        Self {
            port: Some(port.to_owned()),
            ..Self::of(Layer::Ports, diagnostic)
        }
    }

    /// Whether it is the same fault at another set of parameters.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        (
            self.layer,
            self.line,
            &self.port,
            self.diagnostic.code,
            &self.diagnostic.place,
        ) == (
            other.layer,
            other.line,
            &other.port,
            other.diagnostic.code,
            &other.diagnostic.place,
        )
    }
}

/// The line in a place such as `factory user.arm, line 12`.
fn line_in(place: &str) -> Option<u32> {
    let (_, rest) = place.rsplit_once("line ")?;
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    digits.parse().ok()
}

/// What became of the sets of parameters.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Tally {
    /// How many sets belong to the ranges.
    pub sets: usize,
    /// At how many the part was made and shows everything.
    pub made: usize,
    /// How many the factory's own rules refuse.
    pub refused_by_rules: usize,
    /// How many fail.
    pub failed: usize,
    /// How many are left: not asked for, behind a stage that fails, or behind the limit on time.
    pub not_tried: usize,
}

/// What a layer says in all.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LayerVerdict {
    /// The layer.
    pub layer: Layer,
    /// Pass, fail, or indeterminate where an earlier layer left nothing to look at.
    pub verdict: Verdict,
    /// How many findings.
    pub findings: usize,
}

/// What a port showed at the defaults.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PortEvidence {
    /// Name.
    pub name: String,
    /// Type.
    #[serde(rename = "type")]
    pub port_type: PortType,
    /// How many probes of the solid hold.
    pub probes: usize,
}

/// On what a factory was admitted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Evidence {
    /// The sets of parameters.
    pub tally: Tally,
    /// At which sets it was to be tried.
    #[serde(default)]
    pub sets: Extent,
    /// The sets by stages.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stages: Vec<Stage>,
    /// SHA-256 of the recipe at the defaults.
    pub recipe_sha256: String,
    /// Volume at the defaults in mm3.
    pub volume_mm3: f64,
    /// Smallest corner of the box at the defaults, in mm.
    pub box_min_mm: [f64; 3],
    /// Largest corner of the box at the defaults, in mm.
    pub box_max_mm: [f64; 3],
    /// The ports at the defaults.
    pub ports: Vec<PortEvidence>,
}

/// What the gate found.
#[derive(Debug)]
pub struct Report {
    /// Everything that is wrong, the defaults' faults first.
    pub findings: Vec<Finding>,
    /// The three layers.
    pub layers: Vec<LayerVerdict>,
    /// The sets of parameters.
    pub tally: Tally,
    /// The sets by stages.
    pub stages: Vec<Stage>,
    /// Whether the limit on time was reached before all sets that were asked for had been tried.
    pub unfinished: bool,
    /// The evidence; none where anything is wrong, or unfinished.
    pub evidence: Option<Evidence>,
}

impl Report {
    /// A source that was not tried at any set.
    pub(super) fn refused(findings: Vec<Finding>) -> Self {
        Self::of(findings, Extent::All, &[], &[], false)
    }

    pub(super) fn of(
        findings: Vec<Finding>,
        extent: Extent,
        all: &[(Origin, Set)],
        tried: &[Tried],
        unfinished: bool,
    ) -> Self {
        let count = |which: fn(&Outcome) -> bool| tried.iter().filter(|(_, _, o)| which(o)).count();
        let tally = Tally {
            sets: all.len(),
            made: count(|o| matches!(o, Outcome::Made(_))),
            refused_by_rules: count(|o| matches!(o, Outcome::Refused(_))),
            failed: count(|o| matches!(o, Outcome::Failed(_))),
            not_tried: all.len() - tried.len(),
        };
        let stages = stages(all, tried);
        let evidence = match tried.first() {
            Some((_, _, Outcome::Made(made))) if findings.is_empty() && !unfinished => {
                Some(Evidence {
                    tally,
                    sets: extent,
                    stages: stages.clone(),
                    recipe_sha256: made.built.recipe.clone(),
                    volume_mm3: rounded(made.built.volume),
                    box_min_mm: made.built.min.map(rounded),
                    box_max_mm: made.built.max.map(rounded),
                    ports: made.built.ports.iter().map(PortEvidence::of).collect(),
                })
            }
            _ => None,
        };
        Self {
            layers: layers(&findings, tried),
            findings,
            tally,
            stages,
            unfinished,
            evidence,
        }
    }
}

impl PortEvidence {
    fn of(port: &assemcad_model::ports::Port) -> Self {
        Self {
            name: port.name.clone(),
            port_type: port.port_type,
            probes: port.evidence().map_or(0, |probes| probes.len()),
        }
    }
}

fn layers(findings: &[Finding], tried: &[Tried]) -> Vec<LayerVerdict> {
    // A layer was reached where some set got as far.
    let reached = |layer: Layer| {
        tried.iter().any(|(_, _, o)| match o {
            Outcome::Made(_) => true,
            Outcome::Failed(found) => found.iter().any(|f| f.layer >= layer),
            Outcome::Refused(_) => false,
        })
    };
    [Layer::Execution, Layer::Geometry, Layer::Ports]
        .into_iter()
        .map(|layer| {
            let count = findings.iter().filter(|f| f.layer == layer).count();
            let verdict = match count {
                0 if layer == Layer::Execution || reached(layer) => Verdict::Pass,
                0 => Verdict::Indeterminate,
                _ => Verdict::Fail,
            };
            LayerVerdict {
                layer,
                verdict,
                findings: count,
            }
        })
        .collect()
}
