//! The list of calls that a script records.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use assemcad_model::recipe::{Call, FORMAT, Recipe, Ref};
use serde_json::Value as Json;

use crate::fault::Fault;
use crate::limits::Limits;

/// Calls in the order of their recording, each with its line.
#[derive(Debug)]
pub(crate) struct Recorder {
    calls: Vec<Call>,
    lines: Vec<u32>,
    pieces: usize,
    most_calls: usize,
    most_pieces: usize,
    /// Where in the source the statement begins that is carried out, and its operators with it.
    pub(crate) statement: Option<u32>,
    /// Where in the source lines end.
    ends: Vec<u32>,
}

/// A recorder that values refer to: operators record too, and see nothing but their operands.
#[derive(Debug, Clone)]
pub(crate) struct Shared(Arc<Mutex<Recorder>>);

impl Shared {
    pub(crate) fn new(limits: &Limits, source: &str) -> Self {
        let ends = source.match_indices('\n');
        Self(Arc::new(Mutex::new(Recorder {
            calls: Vec::new(),
            lines: Vec::new(),
            pieces: 0,
            most_calls: limits.operations,
            most_pieces: limits.pieces,
            statement: None,
            ends: ends.filter_map(|(at, _)| u32::try_from(at).ok()).collect(),
        })))
    }

    /// The recorder; evaluations run in one thread, so that nobody waits for it.
    pub(crate) fn get(&self) -> MutexGuard<'_, Recorder> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Recorder {
    /// Records a call and gives its index.
    pub(crate) fn record(
        &mut self,
        call: &str,
        on: Option<Ref>,
        args: BTreeMap<String, Json>,
        line: u32,
    ) -> Result<Ref, Fault> {
        let index = self.calls.len();
        if index >= self.most_calls {
            return Err(Fault::new(format!(
                "more than {} calls are recorded (limit operations)",
                self.most_calls
            ))
            .hint("make solids once and use them again; use fewer of them"));
        }
        self.charge(args.values().map(pieces).sum())?;
        self.calls.push(Call {
            call: call.to_owned(),
            on,
            args,
        });
        self.lines.push(line);
        Ref::try_from(index).map_err(|_| Fault::new("too many calls"))
    }

    /// Counts pieces that values outside the interpreter's heap hold.
    pub(crate) fn charge(&mut self, pieces: usize) -> Result<(), Fault> {
        self.pieces = self.pieces.saturating_add(pieces);
        if self.pieces > self.most_pieces {
            return Err(Fault::new(format!(
                "lists of points and texts hold more than {} pieces (limit pieces)",
                self.most_pieces
            ))
            .hint("draw outlines once and use their solids again"));
        }
        Ok(())
    }

    /// The 1-based line of the statement that is carried out; none before the first.
    pub(crate) fn line(&self) -> Option<u32> {
        let statement = self.statement?;
        let before = self.ends.partition_point(|end| *end < statement);
        u32::try_from(before + 1).ok()
    }

    /// The call of an index.
    pub(crate) fn call(&self, index: Ref) -> Option<&Call> {
        self.calls.get(index as usize)
    }

    /// The recipe whose result is that of the call `result`, with the line of each call.
    ///
    /// All calls stay: those on one chain share what is drawn and not yet used, so that what does not
    /// lead to the result may change it all the same.
    pub(crate) fn recipe(&self, result: Ref) -> (Recipe, Vec<u32>) {
        let recipe = Recipe {
            format: FORMAT,
            calls: self.calls.clone(),
            result,
        };
        (recipe, self.lines.clone())
    }
}

/// How many pieces an argument holds: members of long lists, parts of selectors and outlines, and
/// stretches of long texts.
fn pieces(value: &Json) -> usize {
    match value {
        Json::String(text) => text.len() / 64,
        Json::Array(items) if items.iter().any(Json::is_object) => {
            items.iter().map(|item| 1 + pieces(item)).sum()
        }
        Json::Array(items) if items.len() > 3 || items.iter().any(Json::is_array) => items.len(),
        Json::Object(fields) => fields.values().map(pieces).sum(),
        _ => 0,
    }
}
