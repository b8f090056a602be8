//! `find_axioms`.

use assemcad_assembly::{Faults, Workshop};
use assemcad_axioms::axiom::{Axiom, Checking, Provenance};
use assemcad_axioms::entry::Scope;
use assemcad_axioms::query::{Query, find};
use assemcad_axioms::{Class, checks, knowledge};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::mates::MateType;
use assemcad_model::name::nearest;
use assemcad_model::param::clip;
use assemcad_model::ports::PortType;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::{Effect, Tool, Weight};

pub(crate) struct FindAxioms;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// Only axioms that apply to mates of this type.
    #[serde(default)]
    mate_type: Option<MateType>,
    /// Only axioms that apply to one of these types of ports.
    #[serde(default)]
    port_types: Vec<PortType>,
    /// Only axioms that apply to parts of one of these classes; a user's factory is 'custom'.
    #[serde(default)]
    classes: Vec<Class>,
    /// Words of which one at least occurs in title, statement or reason, such as 'bearing backlash'.
    #[serde(default)]
    words: String,
    /// One axiom with its reason, source and neighbours, such as 'C-02'.
    #[serde(default)]
    id: Option<String>,
    /// How many are told at most.
    #[serde(default = "default_limit")]
    #[schemars(range(min = 1, max = 62))]
    limit: usize,
    /// How many of those that were found are passed over, to see the next ones.
    #[serde(default)]
    #[schemars(range(max = 62))]
    offset: usize,
}

fn default_limit() -> usize {
    10
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// The axioms: those whose scope names what was asked first.
    axioms: Vec<Entry>,
    /// How many were found.
    total: usize,
    /// How many of these come after those that are told; ask for them with 'offset'.
    more: usize,
}

#[derive(Debug, Serialize, JsonSchema)]
struct Entry {
    /// Id, for the axioms of a mate.
    axiom: String,
    /// Title.
    title: String,
    /// What holds. MUST fails an assembly that breaks it, SHOULD warns.
    statement: String,
    /// What it applies to; a list that is left out leaves that side open.
    scope: Scope,
    /// The check that verify makes of it, or why there is none.
    checked: String,
    /// Why; where one axiom was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    /// Where it comes from; where one axiom was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<String>,
    /// Axioms on which it builds.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    follows: Vec<String>,
    /// Axioms that build on it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    precedes: Vec<String>,
}

impl Entry {
    fn short(a: &Axiom) -> Self {
        Self {
            axiom: a.id.clone(),
            title: a.title.clone(),
            statement: a.statement.clone(),
            scope: a.scope.clone(),
            checked: checked(a),
            reason: None,
            source: None,
            follows: Vec::new(),
            precedes: Vec::new(),
        }
    }

    fn long(a: &Axiom) -> Self {
        Self {
            reason: Some(a.rationale.clone()),
            source: Some(match &a.provenance {
                Provenance::Anchored {
                    source,
                    topic,
                    clause,
                } => {
                    let clause = clause.as_ref().map(|c| format!(", clause {c}"));
                    format!("{source}: {topic}{}", clause.unwrap_or_default())
                }
                Provenance::Synthesized { justification } => {
                    format!("synthesized: {justification}")
                }
            }),
            follows: a.follows.clone(),
            precedes: a.precedes.clone(),
            ..Self::short(a)
        }
    }
}

fn checked(a: &Axiom) -> String {
    match (&a.check, checks::of(a)) {
        (Checking::Checked { id, .. }, Some(_)) => id.clone(),
        (Checking::Checked { id, .. }, None) => format!("no: the check {id} is not written yet"),
        (Checking::None { why }, _) => format!("no: {why}"),
    }
}

fn unknown(id: &str) -> Diagnostic {
    let ids: Vec<&str> = knowledge::axioms().iter().map(|a| a.id.as_str()).collect();
    let message = format!("there is no axiom '{}'", clip(id));
    let d = Diagnostic::error(Code::AxiomUnknown, "id", message).found(id);
    let d = match nearest(id, ids.iter().copied(), 1).first() {
        Some(near) => d.next("find_axioms", json!({"id": near})),
        None => d,
    };
    d.expected(json!(ids))
}

impl Tool for FindAxioms {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "find_axioms";
    const TITLE: &'static str = "Find engineering axioms";
    const DESCRIPTION: &'static str = "Finds the engineering rules that mates cite and verify checks, by mate \
        type, port types, part classes, words or id; all conditions must be met. Call it before \
        validate_draft, to choose the 'axioms' of each mate: a draft needs one or more for every mate, and \
        each must apply to its type, ports and parts. With 'id' it tells the reason and the source too.";
    const EFFECT: Effect = Effect::Reads;
    const WEIGHT: Weight = Weight::Light;

    async fn run(_workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        let id = a.id.as_deref().map(str::trim);
        if let Some(id) = id.filter(|id| {
            let same = |axiom: &Axiom| axiom.id.eq_ignore_ascii_case(id);
            !knowledge::axioms().iter().any(same)
        }) {
            return Err(vec![unknown(id)]);
        }
        let found = find(&Query {
            mate_type: a.mate_type,
            port_types: a.port_types,
            classes: a.classes,
            words: a.words,
            id: id.map(str::to_owned),
        });
        let entry = if id.is_some() {
            Entry::long
        } else {
            Entry::short
        };
        let told = found.iter().skip(a.offset).take(a.limit);
        let axioms: Vec<Entry> = told.map(|a| entry(a)).collect();
        Ok(Answer {
            total: found.len(),
            more: found.len().saturating_sub(a.offset + axioms.len()),
            axioms,
        })
    }
}
