//! Every factory at the corners of its ranges and at random parameters: each set is either refused with a
//! reason that names a parameter, or gives one valid closed solid of the computed volume that shows all
//! its ports.

use assemcad_factories::Registry;
use assemcad_model::diagnostic::Code;
use assemcad_model::param::{ParamKind, ParamSpec};
use serde_json::{Map, Value, json};

use super::golden::as_computed;
use super::kit::{faults, made};
use super::sample::{Rng, sample};

/// Whether the factory makes it. Panics where it is neither sound nor refused with a reason.
fn tried(name: &str, params: &Value) -> bool {
    match made(name, params) {
        Ok(part) => {
            let found = faults(&part);
            assert!(found.is_empty(), "{name} {params}: {found:#?}");
            as_computed(name, params, &part);
            true
        }
        Err(found) => {
            let factory = Registry::builtin().get(name).unwrap();
            for d in found {
                let of_params = (d.code, d.place.as_str()) == (Code::ParamInvalid, "params");
                let named = factory.params().iter().any(|s| d.message.contains(&s.name));
                assert!(of_params && named, "{name} {params}: {d}");
            }
            false
        }
    }
}

/// Smallest and largest value of a parameter.
fn ends(spec: &ParamSpec) -> Vec<Value> {
    match &spec.kind {
        ParamKind::Number { min, max, .. } => vec![json!(min), json!(max)],
        ParamKind::Integer { min, max, .. } => vec![json!(min), json!(max)],
        ParamKind::Choice { choices, .. } => choices.iter().map(|c| json!(c)).collect(),
        ParamKind::Flag { .. } => vec![json!(false), json!(true)],
        ParamKind::Records {
            fields,
            min_items,
            max_items,
            ..
        } => {
            let mut lists = Vec::new();
            for record in combinations(fields) {
                for n in [*min_items, *max_items] {
                    lists.push(Value::Array(vec![Value::Object(record.clone()); n]));
                }
            }
            lists
        }
    }
}

/// Every combination of smallest and largest values.
fn combinations(specs: &[ParamSpec]) -> Vec<Map<String, Value>> {
    specs.iter().fold(vec![Map::new()], |all, spec| {
        let values = ends(spec);
        all.iter()
            .flat_map(|given| {
                values.iter().map(|value| {
                    let mut given = given.clone();
                    given.insert(spec.name.clone(), value.clone());
                    given
                })
            })
            .collect()
    })
}

fn corners(name: &str) {
    let factory = Registry::builtin().get(name).unwrap();
    let specs = factory.params();
    let all = combinations(specs).into_iter().map(Value::Object);
    try_all(name, "corners", all.collect());
}

/// Every end of every range on its own.
fn ends_alone(name: &str) {
    let factory = Registry::builtin().get(name).unwrap();
    let specs = factory.params();
    let alone = |spec: &ParamSpec| {
        let name = spec.name.clone();
        ends(spec)
            .into_iter()
            .map(move |value| json!({ name.as_str(): value }))
    };
    let made = try_all(name, "ends", specs.iter().flat_map(alone).collect());
    assert!(made >= 2, "{name}: only {made} are made");
}

fn try_all(name: &str, what: &str, sets: Vec<Value>) -> usize {
    let (began, tries) = (std::time::Instant::now(), sets.len());
    let made = sets.iter().filter(|params| tried(name, params)).count();
    println!(
        "{name}: {made} made of {tries} {what} in {:?}",
        began.elapsed()
    );
    made
}

fn random(name: &str, count: usize) {
    let mut rng = Rng::of(name);
    let sets = (0..count).map(|_| sample(name, &mut rng)).collect();
    let made = try_all(name, "random sets", sets);
    assert!(
        2 * made >= count,
        "{name}: only {made} of {count} sets are made"
    );
}

macro_rules! of_each {
    ($($module:ident $name:literal $(#[$slow:meta])?,)*) => {
        #[test]
        fn every_factory_is_tried() {
            let mut names = vec![$($name),*];
            names.sort_unstable();
            assert_eq!(names, Registry::builtin().names());
        }
        $(mod $module {
            #[test]
            fn ends() {
                super::ends_alone($name);
            }
            #[test]
            $(#[$slow])?
            fn corners() {
                super::corners($name);
            }
            #[test]
            fn twenty_random_sets() {
                super::random($name, 20);
            }
            #[test]
            #[ignore = "make test-factories"]
            fn two_hundred_random_sets() {
                super::random($name, 200);
            }
        })*
    };
}

of_each! {
    ball "bearing.ball",
    bolt "fastener.bolt",
    bolt_circle_flange "base_frame.bolt_circle_flange",
    boss "base_frame.boss",
    coupling_hub "base_frame.coupling_hub",
    housing_block "base_frame.housing_block",
    l_bracket "base_frame.l_bracket",
    nut "fastener.nut",
    rect_plate "base_frame.rect_plate",
    // Gears of 400 teeth by the dozen take minutes.
    spur "gear.spur" #[ignore = "make test-factories"],
    stepped_shaft "base_frame.stepped_shaft",
    u_channel "base_frame.u_channel",
    washer "fastener.washer",
}
