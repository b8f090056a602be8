//! `synthesize_factory`.

use std::collections::BTreeMap;
use std::time::Duration;

use assemcad_assembly::synthesis::{Asked, Refusal, Synthesis};
use assemcad_assembly::{Faults, Workshop};
use assemcad_factories::Admitted;
use assemcad_factories::admission::{
    AskedParam, Evidence, ExpectedPort, Extent, Finding, LayerVerdict, Progress, Report, Request,
    Stage, Tally, evidence, nearest,
};
use assemcad_model::diagnostic::{Code, Diagnostic};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Caller, Effect, Tool, prompts};

pub(crate) struct SynthesizeFactory;

/// How many findings an answer holds at most.
const MOST_FINDINGS: usize = 12;

/// How many factories are shown as examples, and how long each is at most, in bytes.
const EXAMPLES: usize = 2;
const MOST_EXAMPLE: usize = 3500;

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Arguments {
    /// The factory's name: 'user.' and a name of your choice, such as 'user.clevis'.
    name: String,
    /// What the part is, in one to three sentences: function, form, how its frame lies.
    description: String,
    /// The ports that the part must have at every set of parameters.
    expected_ports: Vec<ExpectedPort>,
    /// What is to be varied, with defaults and ranges; the source must declare the same.
    params: Vec<AskedParam>,
    /// The source; or give 'file'. Leave both out to learn what is needed to write it.
    #[serde(default)]
    source: Option<String>,
    /// A file below the server's root folder that holds the source.
    #[serde(default)]
    file: Option<String>,
    /// What is to happen where the source works in a part of its ranges only.
    #[serde(default)]
    ranges: Ranges,
    /// At which sets of parameters the source is tried, the defaults always first: 'defaults' alone, 'ends' of
    /// each range too, or 'all' (corners of all ranges together and samples between). The record says which.
    #[serde(default)]
    sets: Extent,
    /// Whether the client's own model is to write and mend the source, all in this call. Where the client
    /// offers none, the answer is what is needed to write it.
    #[serde(default)]
    write: bool,
}

/// What is to happen where a source works in a part of its ranges only.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Ranges {
    /// It is refused.
    #[default]
    AsDeclared,
    /// It is admitted for the ranges in which it was shown to work.
    AsShown,
}

/// What became of the request.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Status {
    /// A factory was admitted for this very request before: use it.
    Known,
    /// There is none: write the source.
    Wanted,
    /// The source was admitted: use it.
    Admitted,
    /// The source is at fault: mend it.
    Refused,
    /// The limit on time was reached and nothing was wrong so far: see 'next'.
    Unfinished,
}

#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Answer {
    /// What became of the request.
    status: Status,
    /// The factory to use in add_part, with its version.
    #[serde(skip_serializing_if = "Option::is_none")]
    factory: Option<String>,
    /// SHA-256 of description, expected ports and parameters: what names the request.
    request_sha256: String,
    /// Which round of this request this was, where the source was refused.
    #[serde(skip_serializing_if = "Option::is_none")]
    round: Option<usize>,
    /// How many rounds there are before the synthesis counts as failed.
    rounds: usize,
    /// The three layers of a refusal.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    layers: Vec<LayerVerdict>,
    /// What is wrong, each fault once, at the simplest set of parameters that shows it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    findings: Vec<Finding>,
    /// How many findings are not shown; mend those that are first.
    #[serde(skip_serializing_if = "Option::is_none")]
    not_shown: Option<usize>,
    /// How the tried sets of parameters came out, where the source was not admitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    tally: Option<Tally>,
    /// The same by stages; one that fails is the last that is tried.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    stages: Vec<Stage>,
    /// What to do where the limit on time was reached.
    #[serde(skip_serializing_if = "Option::is_none")]
    next: Option<String>,
    /// On what the factory was admitted.
    #[serde(skip_serializing_if = "Option::is_none")]
    evidence: Option<Evidence>,
    /// Ranges that are narrower than declared: smallest and largest value.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    narrowed: BTreeMap<String, [f64; 2]>,
    /// What is needed to write the source.
    #[serde(skip_serializing_if = "Option::is_none")]
    to_write: Option<ToWrite>,
}

/// What is needed to write a source.
#[derive(Debug, Serialize, JsonSchema)]
struct ToWrite {
    /// The language, on one page.
    language: String,
    /// What the solid will have to show for each expected port.
    ports: Vec<PortWanted>,
    /// The factories most like the request.
    examples: Vec<Example>,
    /// What to do next.
    next: String,
}

/// An expected port and its evidence.
#[derive(Debug, Serialize, JsonSchema)]
struct PortWanted {
    /// Name.
    name: String,
    /// What a port of the type is, and where its frame sits.
    meaning: String,
    /// What is looked for in the solid, at the defaults.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    shown_by: Vec<String>,
}

/// A factory as an example.
#[derive(Debug, Serialize, JsonSchema)]
struct Example {
    /// Name.
    factory: String,
    /// Source.
    source: String,
}

impl Tool for SynthesizeFactory {
    type Arguments = Arguments;
    type Answer = Answer;
    const NAME: &'static str = "synthesize_factory";
    const TITLE: &'static str = "Synthesize a factory";
    const DESCRIPTION: &'static str = "Makes a factory for a part that no factory makes. Without 'source' it \
        returns the factory admitted for the same request before, or all you need to write one (language, \
        examples, what each port must show). With 'source' it runs it, builds the solid and probes every \
        port at the defaults, then at ends, corners and samples of the ranges; it is admitted on that \
        evidence, or refused with findings to mend; a few refused rounds under one name and request end it. \
        Look at list_factories first.";
    const EFFECT: Effect = Effect::Adds;

    async fn run(workshop: &Workshop, a: Arguments) -> Result<Answer, Faults> {
        Self::run_with(workshop, a, &Caller::default()).await
    }

    async fn run_with(
        workshop: &Workshop,
        a: Arguments,
        caller: &Caller<'_>,
    ) -> Result<Answer, Faults> {
        let source = match (a.source, a.file) {
            (Some(_), Some(_)) => {
                let message =
                    "give either 'source' (the text) or 'file' (a path below the root folder)";
                return Err(vec![Diagnostic::error(
                    Code::ArgumentInvalid,
                    "source",
                    message,
                )]);
            }
            (None, Some(file)) => Some(workshop.store.read_text(&file).map_err(|d| vec![d])?),
            (source, None) => source,
        };
        let request = Request {
            description: a.description,
            expected_ports: a.expected_ports,
            params: a.params,
        };
        let mut asked = Asked {
            name: a.name,
            request,
            source,
            narrowed: a.ranges == Ranges::AsShown,
            extent: a.sets,
        };
        let mut answer = round(workshop, &asked, caller).await?;
        let Some(writer) = caller.writer.filter(|_| a.write) else {
            return Ok(answer);
        };
        // A writer that gives the same source again does not use up the request's own rounds.
        for _ in 0..workshop.synthesis_rounds {
            let prompt = match &answer.status {
                Status::Known | Status::Admitted | Status::Unfinished => break,
                Status::Wanted => to_write(workshop, &asked).await?,
                Status::Refused => to_mend(workshop, &asked, &answer).await?,
            };
            let written = writer.write(prompt).await.map_err(|why| {
                let message = format!("the client's model wrote nothing: {why}");
                let d = Diagnostic::error(Code::SynthesisFailed, "write", message);
                vec![d.hint("leave 'write' out and give the source yourself")]
            })?;
            asked.source = Some(code_in(&written).to_owned());
            answer = round(workshop, &asked, caller).await?;
        }
        Ok(answer)
    }
}

/// One round: what is asked, held against what is known and against the gate.
async fn round(workshop: &Workshop, asked: &Asked, caller: &Caller<'_>) -> Result<Answer, Faults> {
    let mut answer = Answer::of(&asked.request, workshop.synthesis_rounds);
    let watch = |progress: Progress| caller.tell(&progress.to_string());
    match workshop.synthesize(asked, &watch).await? {
        Synthesis::Unfinished(report) => answer.unfinished(*report, workshop.synthesis_limit),
        Synthesis::Known(known) => answer.admitted(Status::Known, &known),
        Synthesis::Admitted(admitted) => answer.admitted(Status::Admitted, &admitted),
        Synthesis::Refused(refusal) => answer.refused(*refusal),
        Synthesis::Wanted => answer.to_write = Some(ToWrite::of(workshop, &asked.request).await),
    }
    Ok(answer)
}

/// The prompt for a first source.
async fn to_write(workshop: &Workshop, asked: &Asked) -> Result<String, Faults> {
    let request = serde_json::to_string_pretty(&asked.request).unwrap_or_default();
    let description = format!(
        "Answer with the source alone, in one code block. The name is `{}`, the request:\n{request}",
        asked.name
    );
    filled(workshop, "synthesize", &[("description", description)]).await
}

/// The prompt for a source that mends a refused one.
async fn to_mend(workshop: &Workshop, asked: &Asked, refused: &Answer) -> Result<String, Faults> {
    let findings = serde_json::to_string_pretty(&refused.findings).unwrap_or_default();
    let findings = format!("Answer with the mended source alone, in one code block.\n{findings}");
    let source = asked.source.clone().unwrap_or_default();
    filled(
        workshop,
        "repair",
        &[("source", source), ("findings", findings)],
    )
    .await
}

async fn filled(
    workshop: &Workshop,
    name: &str,
    given: &[(&str, String)],
) -> Result<String, Faults> {
    let given = given
        .iter()
        .map(|(k, v)| ((*k).to_owned(), v.as_str().into()));
    let Some(prompt) = prompts::ALL.iter().find(|p| p.name == name) else {
        return Err(vec![Diagnostic::error(
            Code::Internal,
            name,
            "there is no such prompt",
        )]);
    };
    let text = prompt.text(workshop, &given.collect()).await;
    text.map_err(|d| vec![d])
}

/// The last code block of an answer, or all of it where it has none.
fn code_in(text: &str) -> &str {
    const FENCE: &str = "```";
    let Some((before, _)) = text.trim_end().rsplit_once(FENCE) else {
        return text;
    };
    let Some((_, block)) = before.rsplit_once(FENCE) else {
        return text;
    };
    // Behind the fence the language may be named.
    block.split_once('\n').map_or(block, |(_, code)| code)
}

impl Answer {
    fn of(request: &Request, rounds: usize) -> Self {
        Self {
            status: Status::Wanted,
            factory: None,
            request_sha256: request.hash(),
            round: None,
            rounds,
            layers: Vec::new(),
            findings: Vec::new(),
            not_shown: None,
            tally: None,
            stages: Vec::new(),
            next: None,
            evidence: None,
            narrowed: BTreeMap::new(),
            to_write: None,
        }
    }

    fn admitted(&mut self, status: Status, admitted: &Admitted) {
        self.status = status;
        self.factory = Some(admitted.factory.name().to_owned());
        self.evidence = Some(admitted.record.evidence.clone());
        self.narrowed.clone_from(&admitted.record.ranges);
    }

    fn refused(&mut self, refusal: Refusal) {
        let Refusal { round, report } = refusal;
        self.status = Status::Refused;
        self.round = Some(round);
        self.layers = report.layers;
        self.tally = Some(report.tally);
        self.stages = report.stages;
        self.findings = report.findings;
        let more = self.findings.len().saturating_sub(MOST_FINDINGS);
        self.not_shown = (more > 0).then_some(more);
        self.findings.truncate(MOST_FINDINGS);
    }
}

impl Answer {
    fn unfinished(&mut self, report: Report, limit: Duration) {
        self.status = Status::Unfinished;
        self.next = Some(format!(
            "{} of {} sets of parameters are left after the limit of {} s: call again, the solids made so far \
             are kept; or have it admitted on less evidence ('sets'), make the geometry simpler, start the \
             server with a larger --synthesis-s",
            report.tally.not_tried,
            report.tally.sets,
            limit.as_secs()
        ));
        self.layers = report.layers;
        self.tally = Some(report.tally);
        self.stages = report.stages;
    }
}

impl ToWrite {
    async fn of(workshop: &Workshop, request: &Request) -> Self {
        let defaults = request.defaults();
        let mut ports = Vec::new();
        for wanted in &request.expected_ports {
            ports.push(PortWanted {
                name: wanted.name.clone(),
                meaning: wanted.port_type.kind().doc.to_owned(),
                shown_by: evidence(&workshop.evaluator, wanted, &defaults).await,
            });
        }
        let all = workshop.registry.all();
        let near = nearest(request, all.iter().map(AsRef::as_ref)).into_iter();
        let short = near.filter(|f| f.source().len() <= MOST_EXAMPLE);
        let examples = short.take(EXAMPLES).map(|factory| Example {
            factory: factory.name().to_owned(),
            source: factory.source().to_owned(),
        });
        Self {
            language: assemcad_script::reference(),
            ports,
            examples: examples.collect(),
            next: "call synthesize_factory again with the same arguments and 'source'".to_owned(),
        }
    }
}
