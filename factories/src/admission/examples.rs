//! What a writer of a factory needs: the factories most like the request, and the evidence that its
//! ports will have to show.

use std::collections::BTreeSet;

use assemcad_model::frame::Frame;
use assemcad_model::ports::Port;
use assemcad_script::{Evaluator, Factory};

use super::request::{ExpectedPort, Request};
use super::sets::Set;

/// How many shared words a shared type of port is worth: what is hard to write is the ports.
const WEIGHT_OF_PORTS: usize = 4;

/// The factories, those most like a request first: by the words of the description, and by the types of
/// the expected ports as their documentation names them.
#[must_use]
pub fn nearest<'a>(
    request: &Request,
    factories: impl IntoIterator<Item = &'a Factory>,
) -> Vec<&'a Factory> {
    let mut wanted = words(&request.description);
    wanted.extend(request.params.iter().flat_map(|p| words(&p.name)));
    let types: BTreeSet<&str> = request
        .expected_ports
        .iter()
        .map(|p| p.port_type.kind().name)
        .collect();
    let score = |f: &Factory| {
        let own = words(&format!("{} {}", f.name(), f.doc()));
        let shared = wanted.intersection(&own).count();
        let ports = types.iter().filter(|t| f.doc().contains(**t)).count();
        shared + WEIGHT_OF_PORTS * ports
    };
    let mut scored: Vec<(usize, &Factory)> = factories.into_iter().map(|f| (score(f), f)).collect();
    // Stable: among equals, the order of the names.
    scored.sort_by_key(|(score, _)| core::cmp::Reverse(*score));
    scored.into_iter().map(|(_, f)| f).collect()
}

/// The words of a text that tell something.
fn words(text: &str) -> BTreeSet<String> {
    text.split(|c: char| !c.is_alphanumeric())
        .filter(|w| w.len() > 4)
        .map(str::to_lowercase)
        .collect()
}

/// What the solid will have to show for a port, in plain words, each once: at the defaults, where the
/// request says enough of the port's parameters; else none.
pub async fn evidence(evaluator: &Evaluator, wanted: &ExpectedPort, defaults: &Set) -> Vec<String> {
    let expressions = wanted.expressions();
    let texts: Vec<String> = expressions.iter().map(|(_, text)| text.clone()).collect();
    let values = evaluator
        .expressions(defaults, &texts)
        .await
        .unwrap_or_default();
    let params = expressions
        .iter()
        .zip(values)
        .filter_map(|((name, _), value)| Some(((*name).to_owned(), value.ok()?)));
    let port = Port {
        name: wanted.name.clone(),
        port_type: wanted.port_type,
        frame: Frame::WORLD,
        params: params.collect(),
    };
    let mut told: Vec<String> = Vec::new();
    for probe in port.evidence().unwrap_or_default() {
        if !told.contains(&probe.shows) {
            told.push(probe.shows);
        }
    }
    told
}
