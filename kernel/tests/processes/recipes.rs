//! Recipes, written as calls with what differs from the defaults.

use assemcad_model::language::{Default, method};
use assemcad_model::recipe::{Call, FORMAT, Recipe};
use assemcad_model::selector::Selector;
use serde_json::{Value, json};

/// A chain of calls, each on the one before it.
fn chain(calls: &[(&str, Value)]) -> Recipe {
    let calls: Vec<Call> = calls
        .iter()
        .enumerate()
        .map(|(i, (name, given))| {
            let Value::Object(given) = given else {
                panic!("{name}: no object");
            };
            let mut args: std::collections::BTreeMap<String, Value> =
                given.clone().into_iter().collect();
            for p in method(name).unwrap().params {
                let default = match p.default {
                    Default::Required | Default::None => continue,
                    Default::Flag(x) => json!(x),
                    Default::Real(x) => json!(x),
                    Default::Count(x) => json!(x),
                    Default::Text(x) => json!(x),
                    Default::Vector(x) => json!(x),
                };
                args.entry(p.name.to_owned()).or_insert(default);
            }
            Call {
                call: (*name).to_owned(),
                on: i.checked_sub(1).map(|i| u32::try_from(i).unwrap()),
                args,
            }
        })
        .collect();
    Recipe {
        format: FORMAT,
        result: u32::try_from(calls.len() - 1).unwrap(),
        calls,
    }
}

fn selected(text: &str) -> Value {
    json!({ "selector": Selector::parse(text).unwrap() })
}

fn plate() -> Vec<(&'static str, Value)> {
    vec![
        ("Workplane", json!({})),
        (
            "Workplane.box",
            json!({"length": 60, "width": 50, "height": 10, "combine": "add"}),
        ),
    ]
}

fn and(mut start: Vec<(&str, Value)>, more: Vec<(&'static str, Value)>) -> Recipe {
    start.extend(more);
    chain(&start)
}

/// Names and recipes.
pub fn recipes() -> Vec<(&'static str, Recipe)> {
    let top = || ("Workplane.faces", selected(">Z"));
    let plane = || ("Workplane.workplane", json!({}));
    let upright = || ("Workplane.edges", selected("|Z"));
    let rect = || ("Workplane.rect", json!({"xLen": 20, "yLen": 15}));
    vec![
        (
            "recipe drilled and rounded",
            and(
                plate(),
                vec![
                    top(),
                    plane(),
                    (
                        "Workplane.rarray",
                        json!({"xSpacing": 11, "ySpacing": 11, "xCount": 5, "yCount": 4}),
                    ),
                    ("Workplane.hole", json!({"diameter": 5})),
                    ("Workplane.edges", json!({})),
                    ("Workplane.chamfer", json!({"length": 0.5})),
                ],
            ),
        ),
        (
            "recipe rounded and hollow",
            and(
                plate(),
                vec![
                    upright(),
                    ("Workplane.fillet", json!({"radius": 4})),
                    top(),
                    ("Workplane.shell", json!({"thickness": -1.5})),
                ],
            ),
        ),
        (
            "recipe hollow outwards",
            and(
                plate(),
                vec![top(), ("Workplane.shell", json!({"thickness": 2}))],
            ),
        ),
        (
            "recipe tapered boss",
            and(
                plate(),
                vec![
                    top(),
                    plane(),
                    rect(),
                    (
                        "Workplane.extrude",
                        json!({"until": 12, "combine": "add", "taper": 8}),
                    ),
                ],
            ),
        ),
        (
            "recipe tapered cut",
            and(
                plate(),
                vec![
                    top(),
                    plane(),
                    rect(),
                    ("Workplane.cutThruAll", json!({"taper": 5})),
                ],
            ),
        ),
        (
            "recipe tapered cut outwards",
            and(
                plate(),
                vec![
                    top(),
                    plane(),
                    rect(),
                    ("Workplane.cutThruAll", json!({"taper": -5})),
                ],
            ),
        ),
    ]
}
