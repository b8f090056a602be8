//! What a part's solid shows of its ports.

use assemcad_geometry::Asker;
use assemcad_kernel::protocol::{Failure, Named};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::ports::Port;
use assemcad_model::probe::{Answer, Probe};
use assemcad_model::report::rounded;
use serde_json::{Map, Value, json};

/// How many probes are told of; all are counted.
const MOST_TOLD: usize = 3;

/// A port and the answers to its probes.
pub type Asked<'a> = (&'a Port, Vec<(Probe, Answer)>);

/// Why there are no answers.
#[derive(Debug)]
pub enum Unasked {
    /// A port is not well formed: its name and its faults.
    Port(String, Vec<String>),
    /// The kernel did not answer.
    Kernel(Box<Failure>),
}

/// The probes of ports and the solid's answers.
///
/// # Errors
/// When a port is not well formed, or the kernel does not answer.
pub async fn ask<'a>(
    door: Asker<'_>,
    solid: &Named,
    ports: impl IntoIterator<Item = &'a Port>,
) -> Result<Vec<Asked<'a>>, Unasked> {
    let mut asked = Vec::new();
    let mut probes = Vec::new();
    for port in ports {
        let own = port
            .evidence()
            .map_err(|faults| Unasked::Port(port.name.clone(), faults))?;
        asked.push((port, own.len()));
        probes.extend(own);
    }
    if asked.is_empty() {
        return Ok(Vec::new());
    }
    let answers = door.probe(solid, &probes).await;
    let answers = answers.map_err(|failure| Unasked::Kernel(Box::new(failure)))?;
    let mut pairs = probes.into_iter().zip(answers);
    Ok(asked
        .into_iter()
        .map(|(port, n)| (port, pairs.by_ref().take(n).collect()))
        .collect())
}

/// What is wrong where the solid does not show a port, and the values that show it; none where it does.
/// `whose` leads the place.
#[must_use]
pub fn missing(
    port: &Port,
    answers: &[(Probe, Answer)],
    whose: &str,
) -> Option<(Diagnostic, Map<String, Value>)> {
    let failed: Vec<_> = answers.iter().filter(|(_, a)| !a.held).collect();
    let (probe, answer) = failed.first()?;
    let kind = port.port_type.kind();
    let told: Vec<_> = failed
        .iter()
        .take(MOST_TOLD)
        .map(|(p, a)| json!({"shows": p.shows, "at_mm": a.at.map(rounded), "found": a.found}))
        .collect();
    let mut values = Map::new();
    values.insert("port".to_owned(), json!(port.name));
    values.insert("probes".to_owned(), json!(answers.len()));
    values.insert("failed".to_owned(), json!(failed.len()));
    values.insert("first_failed".to_owned(), json!(told));
    let at = answer.at.map(rounded);
    let d = Diagnostic::error(
        Code::PortEvidence,
        format!("{whose}, port '{}'", port.name),
        format!(
            "the solid does not show this {} port: {} is missing at {at:?} in the part's frame ({} of {} \
             probes fail): {}",
            kind.name,
            probe.shows,
            failed.len(),
            answers.len(),
            answer.found
        ),
    )
    .found(json!({"frame": port.frame, "params": port.params}))
    .expected(kind.doc);
    Some((d, values))
}
