//! Recipes written call by call, and what is asked of the parts that they make.

use std::collections::BTreeMap;

use assemcad_kernel::replay::Part;
use assemcad_kernel::{Kind, ReplayError, Shape, replay};
use assemcad_model::frame::Frame;
use assemcad_model::language::{Default, Kind as Takes, method};
use assemcad_model::ports::{Port, PortType};
use assemcad_model::recipe::{Call, FORMAT, Recipe};
use assemcad_model::selector::Selector;
use serde_json::{Value, json};

/// A recipe that is being written. Defaults are those of the language's table, and selectors may be
/// texts, as in a script.
#[derive(std::default::Default)]
pub struct Script {
    calls: Vec<Call>,
}

impl Script {
    pub fn new() -> Self {
        Self { calls: Vec::new() }
    }

    /// A call as it stands; its index.
    pub fn raw(&mut self, call: &str, on: Option<u32>, args: Value) -> u32 {
        let args: BTreeMap<String, Value> = serde_json::from_value(args).unwrap();
        self.calls.push(Call {
            call: call.to_owned(),
            on,
            args,
        });
        u32::try_from(self.calls.len() - 1).unwrap()
    }

    /// A call with the defaults filled in.
    pub fn call(&mut self, name: &str, on: Option<u32>, given: Value) -> u32 {
        let method = method(name).unwrap_or_else(|| panic!("no {name}"));
        let Value::Object(mut given) = given else {
            panic!("{given}")
        };
        let mut args = serde_json::Map::new();
        for param in method.params {
            let value = given.remove(param.name).or_else(|| match param.default {
                Default::Required => panic!("{name} needs {}", param.name),
                Default::None => None,
                Default::Flag(yes) if param.kind == Takes::Combine => {
                    Some(json!(if yes { "add" } else { "none" }))
                }
                Default::Flag(yes) => Some(json!(yes)),
                Default::Real(number) => Some(json!(number)),
                Default::Count(number) => Some(json!(number)),
                Default::Text(text) => Some(json!(text)),
                Default::Vector(vector) => Some(json!(vector)),
            });
            let value = match value {
                Some(Value::String(text)) if param.kind == Takes::Selector => {
                    Some(serde_json::to_value(Selector::parse(&text).unwrap()).unwrap())
                }
                other => other,
            };
            if let Some(value) = value {
                args.insert(param.name.to_owned(), value);
            }
        }
        // What stands for the argument of a function is no parameter of the table.
        args.extend(given.remove_entry("variable"));
        assert!(given.is_empty(), "{name} has no {given:?}");
        self.raw(name, on, Value::Object(args))
    }

    /// Methods of a workplane, one on the other.
    pub fn on(&mut self, at: u32, calls: &[(&str, Value)]) -> u32 {
        calls.iter().fold(at, |at, (name, given)| {
            self.call(&format!("Workplane.{name}"), Some(at), given.clone())
        })
    }

    /// A new chain on the plane XY and its methods.
    pub fn chain(&mut self, calls: &[(&str, Value)]) -> u32 {
        let at = self.call("Workplane", None, json!({}));
        self.on(at, calls)
    }

    /// A box from its corner, in a chain of its own.
    pub fn cuboid(&mut self, corner: [f64; 3], size: [f64; 3]) -> u32 {
        let at = self.call("Workplane", None, json!({ "origin": corner }));
        self.on(at, &[("box", sized(size, [false; 3]))])
    }

    pub fn recipe(&self, result: u32) -> Recipe {
        let recipe = Recipe {
            format: FORMAT,
            calls: self.calls.clone(),
            result,
        };
        // As it would come over the wire.
        serde_json::from_str(&serde_json::to_string(&recipe).unwrap()).unwrap()
    }

    #[track_caller]
    pub fn part(&self, result: u32) -> Part {
        match replay(&self.recipe(result), &mut |_, _| {}) {
            Ok(part) => part,
            Err(error) => panic!("{error}"),
        }
    }

    /// That the recipe is refused at this call, in these words.
    #[track_caller]
    pub fn refused(&self, result: u32, call: &str, words: &[&str]) -> ReplayError {
        let Err(error) = replay(&self.recipe(result), &mut |_, _| {}) else {
            panic!("it went well");
        };
        assert_eq!(error.call, call, "{error}");
        assert_ne!(error.error.kind, Kind::Internal, "{error}");
        let named = self.calls.get(error.step).map(|call| call.call.as_str());
        assert_eq!(named.unwrap_or("recipe"), call);
        for word in words {
            assert!(
                error.error.message.contains(word),
                "{:?} does not say {word:?}",
                error.error.message
            );
        }
        error
    }
}

pub fn to(index: u32) -> Value {
    json!({ "ref": index })
}

/// The arguments of a box.
pub fn sized([x, y, z]: [f64; 3], centered: [bool; 3]) -> Value {
    json!({ "length": x, "width": y, "height": z, "centered": centered })
}

pub fn volume(solid: &Shape) -> f64 {
    solid.mass().unwrap().volume
}

/// Within a relative difference.
#[track_caller]
pub fn near(found: f64, expected: f64, relative: f64) {
    let slack = relative * expected.abs().max(1e-3);
    assert!(
        (found - expected).abs() <= slack,
        "found {found}, expected {expected}, off by {:e}",
        found - expected
    );
}

#[track_caller]
pub fn near3(found: [f64; 3], expected: [f64; 3], distance: f64) {
    for (f, e) in found.iter().zip(expected) {
        assert!(
            (f - e).abs() <= distance,
            "found {found:?}, expected {expected:?}"
        );
    }
}

#[track_caller]
pub fn near_frame(found: &Frame, expected: &Frame) {
    near3(found.origin, expected.origin, 1e-7);
    near3(found.x, expected.x, 1e-9);
    near3(found.z, expected.z, 1e-9);
}

#[track_caller]
pub fn named<'a>(part: &'a Part, name: &str) -> &'a Port {
    let names: Vec<&str> = part.ports.iter().map(|p| p.name.as_str()).collect();
    part.ports
        .iter()
        .find(|port| port.name == name)
        .unwrap_or_else(|| panic!("no {name} among {names:?}"))
}

/// That the part has this port, with these parameters and no others.
#[track_caller]
pub fn has(part: &Part, name: &str, port_type: PortType, at: &Frame, params: &[(&str, f64)]) {
    let port = named(part, name);
    assert_eq!(port.port_type, port_type);
    near_frame(&port.frame, at);
    let names: Vec<&str> = port.params.keys().map(String::as_str).collect();
    let mut expected: Vec<&str> = params.iter().map(|(name, _)| *name).collect();
    expected.sort_unstable();
    assert_eq!(names, expected);
    for (name, value) in params {
        near(port.params[*name], *value, 1e-8);
    }
}

/// That every port of the part has its evidence on the solid.
#[track_caller]
pub fn evident(part: &Part) {
    for port in &part.ports {
        let probes = port.evidence().unwrap();
        assert!(!probes.is_empty());
        for (probe, answer) in probes.iter().zip(part.solid.probe(&probes).unwrap()) {
            let Port { name, params, .. } = port;
            assert!(
                answer.held,
                "{name} {params:?}: {}: {}",
                probe.shows, answer.found
            );
        }
    }
}

/// The faces on which ports are tried: level, upright, and slanted along no axis. Each with the x that
/// a workplane on it has: level, by the cross product of the world's z and the normal.
pub fn seats() -> [Frame; 4] {
    let root = 13.0_f64.sqrt();
    [
        Frame {
            origin: [5.0, -3.0, 7.0],
            x: [1.0, 0.0, 0.0],
            z: [0.0, 0.0, 1.0],
        },
        Frame {
            origin: [5.0, -3.0, 7.0],
            x: [0.0, 1.0, 0.0],
            z: [1.0, 0.0, 0.0],
        },
        Frame {
            origin: [-2.0, 1.0, 4.0],
            x: [0.0, 1.0, 0.0],
            z: [0.6, 0.0, 0.8],
        },
        Frame {
            origin: [1.0, 2.0, -3.0],
            x: [-3.0 / root, 2.0 / root, 0.0],
            z: [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0],
        },
    ]
}

/// A point of a frame: its origin and so much along x, y and z.
pub fn point(at: &Frame, local: [f64; 3]) -> [f64; 3] {
    let Frame { origin, x, z } = *at;
    let y = [
        z[1] * x[2] - z[2] * x[1],
        z[2] * x[0] - z[0] * x[2],
        z[0] * x[1] - z[1] * x[0],
    ];
    [0, 1, 2].map(|i| origin[i] + local[0] * x[i] + local[1] * y[i] + local[2] * z[i])
}

/// The frame with its origin moved along its own axes.
pub fn shifted(at: &Frame, local: [f64; 3]) -> Frame {
    Frame {
        origin: point(at, local),
        ..*at
    }
}

/// The frame turned over about its x.
pub fn over(at: &Frame) -> Frame {
    Frame {
        z: at.z.map(|n| -n),
        ..*at
    }
}

/// A block of 40 x 40 x 20 under a seat, and the workplane on its face there.
pub fn block(script: &mut Script, at: &Frame) -> u32 {
    let low = shifted(at, [0.0, 0.0, -20.0]);
    let chain = script.call("Workplane", None, json!({ "inPlane": low }));
    let body = script.on(
        chain,
        &[("box", sized([40.0, 40.0, 20.0], [true, true, false]))],
    );
    face_of(script, body, at.z)
}

/// The workplane at the centre of the face furthest along a direction.
pub fn face_of(script: &mut Script, body: u32, along: [f64; 3]) -> u32 {
    let selector =
        json!({ "nth": { "key": { "parallel_center": along }, "index": -1, "ascending": true } });
    script.on(
        body,
        &[
            ("faces", json!({ "selector": selector })),
            ("workplane", json!({ "centerOption": "CenterOfMass" })),
        ],
    )
}

pub const BLOCK: f64 = 40.0 * 40.0 * 20.0;
