//! Admission: a factory that somebody wrote becomes one of the registry's, on evidence.
//!
//! The paper's algorithm 2 with the writing left to the caller: a [`Request`] says what is wanted, a
//! source is held against it by the [`Gate`], and what passes is kept with its [`Record`].

mod agree;
mod examples;
mod gate;
mod hints;
mod narrow;
mod ports;
mod record;
mod report;
mod request;
mod sets;

pub use examples::{evidence, nearest};
pub use gate::{Admission, Gate};
pub use record::{NAMESPACE, Record, file_name, is_valid_user_name, split_version, versioned};
pub use report::{Evidence, Finding, Layer, LayerVerdict, PortEvidence, Report, Tally};
pub use request::{AskedKind, AskedParam, ExpectedPort, Request};

pub(crate) fn expressions(
    set: &serde_json::Map<String, serde_json::Value>,
    texts: &[String],
) -> Vec<Result<f64, assemcad_model::diagnostic::Diagnostic>> {
    texts
        .iter()
        .map(|t| {
            t.parse()
                .ok()
                .or_else(|| set.get(t)?.as_f64())
                .ok_or_else(|| {
                    assemcad_model::diagnostic::Diagnostic::error(
                        assemcad_model::diagnostic::Code::ArgumentInvalid,
                        "",
                        "temporary",
                    )
                })
        })
        .collect()
}
