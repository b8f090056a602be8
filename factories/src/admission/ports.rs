//! The third layer: the expected ports, and the evidence of all that are declared.

use assemcad_geometry::Asker;
use assemcad_kernel::protocol::{Built, Named};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::frame::Frame;
use assemcad_model::name::nearest;
use assemcad_model::ports::Port;
use assemcad_model::recipe::Recipe;
use assemcad_model::report::rounded;
use serde_json::json;

use super::gate::Gate;
use super::hints;
use super::report::{Finding, Layer};
use super::request::{ExpectedPort, Request};
use super::sets::Set;
use crate::evidence::{self, Unasked};
use crate::failure;

/// How far a port's parameter may be from the expected value: what is measured of a solid is good to
/// this (mm, degrees), or to the same share of a larger value.
const EQUAL: f64 = 1e-4;

/// Of so many ports without evidence it is tried out what may have been meant: what holds for them mostly holds for
/// the rest.
const MOST_HINTED: usize = 6;

/// How near, in mm, origins are that are one.
const ONE_PLACE_MM: f64 = 1e-4;

/// What is wrong with the ports of a solid, whatever is expected of them.
pub(super) async fn shown(
    door: Asker<'_>,
    name: &str,
    (solid, recipe): (&Named, &Recipe),
    built: &Built,
) -> Vec<Finding> {
    let whose = format!("factory {name}");
    let mut found = coincident(&whose, &built.ports);
    let mut hinted = 0;
    match evidence::ask(door, solid, &built.ports).await {
        Ok(asked) => {
            for (port, answers) in asked {
                if let Some((d, _)) = evidence::missing(port, &answers, &whose) {
                    // Each hint asks the solid some dozens of questions.
                    let hint = if hinted < MOST_HINTED {
                        hints::of_port(door, solid, recipe, port, built).await
                    } else {
                        hints::plain(recipe, port, built)
                    };
                    hinted += 1;
                    found.push(Finding::of_port(&port.name, d.hint(hint)));
                }
            }
        }
        Err(Unasked::Port(port, faults)) => {
            let place = format!("{whose}, port '{port}'");
            let d = Diagnostic::error(Code::PortEvidence, place, faults.join("; "));
            found.push(Finding::of_port(&port, d));
        }
        Err(Unasked::Kernel(failure)) => {
            found.push(Finding::of(
                Layer::Ports,
                failure::diagnostic(&failure, &whose),
            ));
        }
    }
    found
}

/// Expected ports that are not there, or not as expected.
pub(super) async fn expected(
    gate: &Gate<'_>,
    name: &str,
    request: &Request,
    set: &Set,
    ports: &[Port],
) -> Vec<Finding> {
    let mut found = Vec::new();
    for wanted in &request.expected_ports {
        let place = format!("factory {name}, port '{}'", wanted.name);
        match ports.iter().find(|p| p.name == wanted.name) {
            None => found.push(Finding::of_port(
                &wanted.name,
                absent(&place, wanted, ports),
            )),
            Some(port) if port.port_type != wanted.port_type => {
                let d = Diagnostic::error(
                    Code::PortUnknown,
                    place,
                    format!(
                        "the port '{}' is a {}, and a {} is expected",
                        wanted.name, port.port_type, wanted.port_type
                    ),
                )
                .found(json!(port.port_type))
                .expected(json!(wanted.port_type))
                .hint(format!(
                    "a {} port is {}; make that geometry, or ask for what the part has",
                    wanted.port_type,
                    wanted.port_type.kind().summary()
                ));
                found.push(Finding::of_port(&wanted.name, d));
            }
            Some(port) => found.extend(differing(gate, &place, wanted, set, port).await),
        }
    }
    found
}

fn absent(place: &str, wanted: &ExpectedPort, ports: &[Port]) -> Diagnostic {
    let names: Vec<&str> = ports.iter().map(|p| p.name.as_str()).collect();
    let d = Diagnostic::error(
        Code::PortUnknown,
        place,
        format!("the part has no port '{}'", wanted.name),
    )
    .expected(json!(names));
    let alike = ports.iter().filter(|p| p.port_type == wanted.port_type);
    let alike: Vec<&str> = alike.map(|p| p.name.as_str()).collect();
    let near = nearest(&wanted.name, alike.iter().copied(), 1);
    match near.first().or(alike.first()) {
        Some(near) => d.hint(format!(
            "there is the {} port '{near}': call it '{}'",
            wanted.port_type, wanted.name
        )),
        None => d.hint(format!(
            "declare a {} port of this name: {}",
            wanted.port_type,
            wanted.port_type.kind().summary()
        )),
    }
}

/// Parameters of a port that are not what the request says at this set.
async fn differing(
    gate: &Gate<'_>,
    place: &str,
    wanted: &ExpectedPort,
    set: &Set,
    port: &Port,
) -> Vec<Finding> {
    let expressions = wanted.expressions();
    let texts: Vec<String> = expressions.iter().map(|(_, text)| text.clone()).collect();
    let values = match gate.evaluator.expressions(set, &texts).await {
        Ok(values) => values,
        Err(faults) => {
            let of = |d: Diagnostic| Finding::of_port(&wanted.name, d);
            return faults.into_iter().map(of).collect();
        }
    };
    let mut found = Vec::new();
    for ((name, text), value) in expressions.iter().zip(values) {
        let at = format!("{place}, {name}");
        let d = match value {
            Err(why) => Diagnostic::error(
                Code::ArgumentInvalid,
                at,
                format!(
                    "the expected value '{text}' cannot be computed: {}",
                    why.message
                ),
            )
            .hint("write a number, or an expression over the parameters that the request names"),
            Ok(expected) => {
                let value = port.value(name);
                if (value - expected).abs() <= EQUAL * expected.abs().max(1.0) {
                    continue;
                }
                let d = Diagnostic::error(
                    Code::PortEvidence,
                    at,
                    format!(
                        "'{name}' of the port '{}' is {} here, and {} is expected",
                        wanted.name,
                        rounded(value),
                        rounded(expected)
                    ),
                )
                .found(json!(rounded(value)))
                .expected(json!({"expression": text, "value": rounded(expected)}));
                let constant = text.parse::<f64>().is_ok();
                d.hint(if constant {
                    "the value is the same at every set of parameters: where it follows a parameter, the \
                     request says which, as an expression such as \"pin_d\""
                } else {
                    "the port's geometry does not follow the parameters as the request has it: look which \
                     number in the source is fixed"
                })
            }
        };
        found.push(Finding::of_port(&wanted.name, d));
    }
    found
}

/// Ports of one type in one place, looking one way: parts on both would be in one place.
fn coincident(whose: &str, ports: &[Port]) -> Vec<Finding> {
    let mut found = Vec::new();
    for (i, port) in ports.iter().enumerate() {
        let twin = ports.iter().take(i).find(|other| {
            other.port_type == port.port_type && one_place(&other.frame, &port.frame)
        });
        let Some(twin) = twin else { continue };
        let d = Diagnostic::error(
            Code::Coincident,
            format!("{whose}, port '{}'", port.name),
            format!(
                "the ports '{}' and '{}' are in one place, {:?}, and look one way: parts mated to them \
                 would be in one place",
                twin.name,
                port.name,
                port.frame.origin.map(rounded)
            ),
        )
        .hint("move the points apart (rarray, polarArray, pushPoints), or leave one of the ports out");
        found.push(Finding::of_port(&port.name, d));
    }
    found
}

fn one_place(a: &Frame, b: &Frame) -> bool {
    let near =
        |p: [f64; 3], q: [f64; 3], by: f64| p.iter().zip(q).all(|(x, y)| (x - y).abs() <= by);
    near(a.origin, b.origin, ONE_PLACE_MM) && near(a.z, b.z, 1e-6)
}
