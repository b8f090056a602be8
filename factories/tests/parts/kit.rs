//! Making parts and asking for the evidence of their ports.

use assemcad_factories::Registry;
use assemcad_kernel::replay::Part;
use assemcad_model::diagnostic::Diagnostic;
use assemcad_model::ports::{Port, PortType};
use serde_json::Value;

pub const FLAT: PortType = PortType::FlatFace;
pub const X: [f64; 3] = [1.0, 0.0, 0.0];
pub const Y: [f64; 3] = [0.0, 1.0, 0.0];
pub const Z: [f64; 3] = [0.0, 0.0, 1.0];
pub const NX: [f64; 3] = [-1.0, 0.0, 0.0];
pub const NY: [f64; 3] = [0.0, -1.0, 0.0];
pub const NZ: [f64; 3] = [0.0, 0.0, -1.0];

/// The part, or why the script refuses it. What the kernel refuses fails the test: a factory refuses
/// by `require`.
pub fn made(name: &str, params: &Value) -> Result<Part, Vec<Diagnostic>> {
    let built = Registry::builtin()
        .get(name)
        .unwrap()
        .build(params.as_object().unwrap())?;
    assert_eq!(built.recipe.calls.len(), built.lines.len());
    assert!(built.lines.iter().all(|l| *l > 0), "{:?}", built.lines);
    let part = assemcad_kernel::replay(&built.recipe, &mut |_, _| {});
    Ok(part.unwrap_or_else(|e| {
        let line = built.lines.get(e.step);
        panic!("{name} {params}: line {line:?}: {e}")
    }))
}

/// What is wrong with a part: its solid, or a port that it does not show.
pub fn faults(part: &Part) -> Vec<String> {
    let mut found = Vec::new();
    let validity = part.solid.validity().unwrap();
    if !validity.is_valid() {
        found.push(format!("{validity:?}"));
    }
    let mut probes = Vec::new();
    for port in &part.ports {
        match port.evidence() {
            Ok(own) => probes.extend(own.into_iter().map(|p| (&port.name, p))),
            Err(faults) => found.push(format!("port '{}': {}", port.name, faults.join("; "))),
        }
    }
    let asked: Vec<_> = probes.iter().map(|(_, p)| p.clone()).collect();
    let answers = part.solid.probe(&asked).unwrap();
    assert_eq!(answers.len(), asked.len());
    for ((name, probe), answer) in probes.iter().zip(answers) {
        if !answer.held {
            let shows = &probe.shows;
            found.push(format!(
                "port '{name}': {shows} at {:?}: {}",
                answer.at, answer.found
            ));
        }
    }
    found
}

/// A part that is made, valid, and shows all its ports.
#[track_caller]
pub fn sound(name: &str, params: &Value) -> Part {
    let part = made(name, params).unwrap_or_else(|f| panic!("{name} {params}: {f:?}"));
    let found = faults(&part);
    assert!(found.is_empty(), "{name} {params}: {found:#?}");
    part
}

/// Why the script refuses these parameters.
#[track_caller]
pub fn refused(name: &str, params: &Value) -> Vec<Diagnostic> {
    match made(name, params) {
        Ok(_) => panic!("{name} {params} was made"),
        Err(faults) => faults,
    }
}

pub fn port<'a>(ports: &'a [Port], name: &str) -> &'a Port {
    ports.iter().find(|p| p.name == name).unwrap_or_else(|| {
        let names: Vec<&str> = ports.iter().map(|p| p.name.as_str()).collect();
        panic!("no port {name}, only {names:?}")
    })
}

/// A port is of this type, there, with exactly these parameters.
#[track_caller]
pub fn is(
    ports: &[Port],
    name: &str,
    port_type: PortType,
    origin: [f64; 3],
    z: [f64; 3],
    x: [f64; 3],
    params: &[(&str, f64)],
) {
    let p = port(ports, name);
    assert_eq!(p.port_type, port_type, "{name}");
    for (a, b) in p.frame.origin.iter().zip(origin) {
        assert!((a - b).abs() < 1e-9, "{name} origin {:?}", p.frame.origin);
    }
    assert_eq!((p.frame.z, p.frame.x), (z, x), "{name}");
    assert_eq!(p.params.len(), params.len(), "{name} {:?}", p.params);
    for (key, value) in params {
        assert!(
            (p.params[*key] - value).abs() < 1e-6,
            "{name} {key} {}",
            p.params[*key]
        );
    }
}

pub fn face(x: f64, y: f64) -> [(&'static str, f64); 2] {
    [("extent_x", x), ("extent_y", y)]
}

pub fn ring(d: f64, hole: f64) -> [(&'static str, f64); 3] {
    [("extent_x", d), ("extent_y", d), ("hole_diameter", hole)]
}

/// The ports of a sound part, of which there are so many.
#[track_caller]
pub fn ports(name: &str, params: Value, count: usize) -> Vec<Port> {
    let ports = sound(name, &params).ports;
    assert_eq!(ports.len(), count, "{ports:?}");
    ports
}
