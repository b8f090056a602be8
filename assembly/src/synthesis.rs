//! Factories that users write: asked for, held against the gate, kept, and loaded again.
//!
//! A version never changes by itself: a newer source under the same name is a new version, and an
//! assembly names the version that it was built with.

use std::sync::Arc;

use assemcad_factories::Admitted;
use assemcad_factories::admission::{
    Admission, Extent, Gate, Manner, NAMESPACE, Progress, Record, Report, Request,
    is_valid_user_name,
};
use assemcad_model::canonical::sha256;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name;
use assemcad_model::param::clip;
use assemcad_store::{Round, history};
use serde_json::json;

use crate::{Faults, Workshop};

/// Where the rounds of requests are counted.
const ROUNDS: &str = ".assemcad/syntheses";

/// What a caller brings.
#[derive(Debug)]
pub struct Asked {
    /// `user.NAME`.
    pub name: String,
    /// What is wanted.
    pub request: Request,
    /// The source, where there is one already.
    pub source: Option<String>,
    /// Whether a factory that works in a part of its ranges only is admitted for that part.
    pub narrowed: bool,
    /// At which sets of parameters the source is tried.
    pub extent: Extent,
}

/// What became of a request.
#[derive(Debug)]
pub enum Synthesis {
    /// A factory was admitted for this very request before.
    Known(Box<Admitted>),
    /// There is none: one has to be written.
    Wanted,
    /// The source was admitted.
    Admitted(Box<Admitted>),
    /// The limit on time was reached, and nothing was wrong so far: no round is used up.
    Unfinished(Box<Report>),
    /// The source is at fault.
    Refused(Box<Refusal>),
}

/// Why a source was refused.
#[derive(Debug)]
pub struct Refusal {
    /// Which round of the request this was, from 1.
    pub round: usize,
    /// What was found.
    pub report: Report,
}

impl Workshop {
    /// Answers a request for a factory: with one that is known, with the news that one has to be
    /// written, or with the gate's judgement of the source; `watch` is told how far that has come. What is
    /// admitted is on disk when this returns.
    ///
    /// # Errors
    /// Everything that is wrong with the name and the request; the history, where the rounds are used up.
    pub async fn synthesize(
        &self,
        asked: &Asked,
        watch: &(dyn Fn(Progress) + Sync),
    ) -> Result<Synthesis, Faults> {
        let mut faults: Faults = name_fault(self, &asked.name).into_iter().collect();
        faults.extend(asked.request.faults());
        if !faults.is_empty() {
            return Err(faults);
        }
        let hash = asked.request.hash();
        let Some(source) = &asked.source else {
            let known = self.registry.admitted_for(&hash);
            return Ok(known.map_or(Synthesis::Wanted, |a| Synthesis::Known(Box::new(a))));
        };
        let same = self.same(&asked.name, &hash, source);
        if let Some(same) = &same
            && same.record.evidence.sets >= asked.extent
        {
            let same = same.clone();
            return Ok(Synthesis::Known(Box::new(same)));
        }
        // Not the request's own hash alone: a new name begins anew.
        let row = sha256(format!("{}\n{hash}", asked.name).as_bytes());
        let text = sha256(source.as_bytes());
        let before = self.store.rounds(ROUNDS, &row);
        let again = before.last().is_some_and(|r| r.text_sha256 == text);
        if before.len() >= self.synthesis_rounds && !again {
            return Err(vec![failed(&asked.name, &before)]);
        }
        let manner = Manner {
            extent: asked.extent,
            narrowed: asked.narrowed,
            watch,
        };
        let gate = self.gate();
        let judged = gate
            .judge(&asked.name, source, &asked.request, manner)
            .await;
        let judged = match judged {
            Err(report) if report.findings.is_empty() => {
                return Ok(Synthesis::Unfinished(report));
            }
            judged => judged,
        };
        let faults: Faults = match &judged {
            Ok(_) => Vec::new(),
            Err(report) => report
                .findings
                .iter()
                .map(|f| f.diagnostic.clone())
                .collect(),
        };
        let history = self
            .store
            .count_round(ROUNDS, Some(&row), Round::of(&faults, text), judged.is_ok())
            .await
            .map_err(one)?;
        match judged {
            Ok(admission) => {
                let kept = match same {
                    // The same source on more evidence is no other version.
                    Some(same) => {
                        self.on_more_evidence(&same.record, source, admission)
                            .await?
                    }
                    None => self.keep_factory(asked, &hash, source, admission).await?,
                };
                Ok(Synthesis::Admitted(Box::new(kept)))
            }
            Err(_) if history.len() >= self.synthesis_rounds => {
                let mut all = vec![failed(&asked.name, &history)];
                all.extend(faults);
                Err(all)
            }
            Err(report) => Ok(Synthesis::Refused(Box::new(Refusal {
                round: history.len(),
                report: *report,
            }))),
        }
    }

    pub(crate) fn gate(&self) -> Gate<'_> {
        Gate {
            door: self.door.asker(),
            evaluator: &self.evaluator,
            limit: self.synthesis_limit,
        }
    }

    /// A record and its source as the registry takes them.
    pub(crate) async fn parsed(&self, record: Record, source: &str) -> Result<Admitted, Faults> {
        let factory = self.evaluator.parse(&record.name(), source).await?;
        Ok(Admitted {
            factory: Arc::new(record.within(factory)),
            edited: record.source_sha256 != sha256(source.as_bytes()),
            record: Arc::new(record),
        })
    }

    /// The version of this name that has this very source and was admitted for this very request.
    fn same(&self, name: &str, request_sha256: &str, source: &str) -> Option<Admitted> {
        let text = sha256(source.as_bytes());
        self.registry.admitted(name).filter(|a| {
            !a.edited && a.record.source_sha256 == text && a.record.request_sha256 == request_sha256
        })
    }

    /// Keeps an admitted factory as the next version of its name: on disk, then in the registry.
    async fn keep_factory(
        &self,
        asked: &Asked,
        request_sha256: &str,
        source: &str,
        admission: Admission,
    ) -> Result<Admitted, Faults> {
        let _lock = self.store.lock_factories().await.map_err(one)?;
        let newest = self.registry.admitted(&asked.name);
        let newest = newest.map_or(0, |a| a.record.version);
        // Another server over the same folder may have admitted one that this one does not know.
        let newest = self
            .store
            .newest_version(&asked.name)
            .map_err(one)?
            .max(newest);
        let record = Record {
            format: Record::FORMAT,
            factory: asked.name.clone(),
            version: newest + 1,
            source_sha256: sha256(source.as_bytes()),
            request_sha256: request_sha256.to_owned(),
            request: asked.request.clone(),
            ranges: admission.ranges,
            evidence: admission.evidence,
        };
        self.store
            .write_factory(&record, Some(source))
            .map_err(one)?;
        let admitted = self.parsed(record, source).await?;
        self.registry.admit(admitted.clone());
        Ok(admitted)
    }

    /// Writes down on what a version stands now.
    async fn on_more_evidence(
        &self,
        record: &Record,
        source: &str,
        admission: Admission,
    ) -> Result<Admitted, Faults> {
        let _lock = self.store.lock_factories().await.map_err(one)?;
        self.renewed(record, source, admission).await
    }

    /// A version with another source or other evidence: on disk, then in the registry. The factories are held.
    pub(crate) async fn renewed(
        &self,
        record: &Record,
        source: &str,
        admission: Admission,
    ) -> Result<Admitted, Faults> {
        let record = Record {
            source_sha256: sha256(source.as_bytes()),
            ranges: admission.ranges,
            evidence: admission.evidence,
            ..Record::clone(record)
        };
        self.store.write_factory(&record, None).map_err(one)?;
        let admitted = self.parsed(record, source).await?;
        self.registry.admit(admitted.clone());
        Ok(admitted)
    }
}

fn one(d: Diagnostic) -> Faults {
    vec![d]
}

fn name_fault(workshop: &Workshop, name: &str) -> Option<Diagnostic> {
    if !is_valid_user_name(name) {
        let d = Diagnostic::error(
            Code::NameInvalid,
            "name",
            "this is no name of a factory of yours",
        );
        return Some(
            d.found(clip(name))
                .expected(format!("{NAMESPACE}.NAME; NAME is {}", name::RULE)),
        );
    }
    workshop.registry.is_given(name).then(|| {
        Diagnostic::error(
            Code::NameTaken,
            "name",
            format!("there is a factory '{name}' in the server's own folder of factories"),
        )
        .hint("choose another name")
    })
}

/// The rounds are used up: what was tried.
fn failed(name: &str, tried: &[Round]) -> Diagnostic {
    let mut d = Diagnostic::error(
        Code::SynthesisFailed,
        format!("factory {name}"),
        format!(
            "no source for this request passed the gate in {} rounds",
            tried.len()
        ),
    );
    // Set whole: it is bounded by itself, and a cut text would be no history.
    d.found = Some(history(tried));
    d.expected = Some(json!("another name, or another request"));
    d.hint(
        "stop and think again about the part: a simpler shape, narrower ranges, fewer expected ports; another \
         name or a changed request begins anew",
    )
}
