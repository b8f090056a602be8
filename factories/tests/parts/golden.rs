//! Golden data: for each factory a folder with cases, and the ports and properties that they give.
//!
//! `ASSEMCAD_ACCEPT=1 cargo test -p assemcad-factories golden` accepts what is made now. Volume, centre and
//! box are held against formulas all the same, and every port against its evidence.

use std::path::PathBuf;

use assemcad_factories::Registry;
use assemcad_kernel::replay::Part;
use serde_json::{Value, json};

use super::closed::closed;
use super::kit::sound;

fn folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden"))
}

#[test]
fn every_factory_has_its_folder() {
    let mut found: Vec<String> = std::fs::read_dir(folder())
        .unwrap()
        .map(|f| f.unwrap().file_name().into_string().unwrap())
        .collect();
    found.sort();
    assert_eq!(found, Registry::builtin().names());
}

#[test]
fn parts_are_as_accepted_and_as_computed() {
    for name in &Registry::builtin().names() {
        let folder = folder().join(name);
        let text = std::fs::read_to_string(folder.join("cases.json")).unwrap();
        let cases: Vec<Value> = serde_json::from_str(&text).unwrap();
        assert_eq!(
            cases[0],
            json!({"case": "defaults", "params": {}}),
            "{name}"
        );
        let factory = Registry::builtin().get(name).unwrap();
        let doc = factory.doc();
        let mut made = Vec::new();
        for case in &cases {
            let part = sound(name, &case["params"]);
            for port in &part.ports {
                // Of numbered ports the first one is named.
                let base = port.name.trim_end_matches(|c: char| c.is_ascii_digit());
                let first = if base == port.name {
                    base.to_owned()
                } else {
                    format!("{base}1")
                };
                assert!(doc.contains(&first), "{name}: {first} is not documented");
            }
            as_computed(name, &case["params"], &part);
            made.push(json!({
                "case": case["case"],
                "properties": properties(&part),
                "ports": part.ports,
            }));
        }
        let path = folder.join("expected.json");
        if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
            let text = serde_json::to_string_pretty(&made).unwrap();
            std::fs::write(&path, format!("{text}\n")).unwrap();
        }
        let expected: Value =
            serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
        same(name, &json!(made), &expected);
    }
}

/// Twelve digits: the last ones of a double are the kernel's and not the part's.
fn digits(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap()
}

fn properties(part: &Part) -> Value {
    let (mass, bounds) = (part.solid.mass().unwrap(), part.solid.bounds().unwrap());
    // What is nothing but rounding is 0.
    let places = |v: [f64; 3]| v.map(|x| (x * 1e9).round() / 1e9 + 0.0);
    json!({
        "volume_mm3": digits(mass.volume),
        "area_mm2": digits(mass.area),
        "centre_mm": places(mass.center),
        "min_mm": places(bounds.min),
        "max_mm": places(bounds.max),
    })
}

/// Equal texts, numbers to 1e-9 of their size.
fn same(at: &str, a: &Value, b: &Value) {
    match (a, b) {
        (Value::Object(x), Value::Object(y)) => {
            let keys = |m: &serde_json::Map<String, Value>| m.keys().cloned().collect::<Vec<_>>();
            assert_eq!(keys(x), keys(y), "{at}");
            for (key, value) in x {
                same(&format!("{at}.{key}"), value, &y[key]);
            }
        }
        (Value::Array(x), Value::Array(y)) => {
            assert_eq!(x.len(), y.len(), "{at}");
            for (i, (p, q)) in x.iter().zip(y).enumerate() {
                same(&format!("{at}[{i}]"), p, q);
            }
        }
        (Value::Number(x), Value::Number(y)) => {
            let (x, y) = (x.as_f64().unwrap(), y.as_f64().unwrap());
            assert!(
                (x - y).abs() <= 1e-8 + 1e-9 * y.abs(),
                "{at}: {x}, accepted was {y}"
            );
        }
        _ => assert_eq!(a, b, "{at}"),
    }
}

/// Volume, centre and box are those of the formulas.
pub fn as_computed(name: &str, params: &Value, part: &Part) {
    let factory = Registry::builtin().get(name).unwrap();
    let params = Value::Object(factory.check(params.as_object().unwrap()).unwrap());
    let wanted = closed(name, &params);
    let (mass, bounds) = (part.solid.mass().unwrap(), part.solid.bounds().unwrap());
    let volume = wanted.volume();
    let (least, most) = (volume - wanted.less, volume);
    let slack = 1e-8 * volume + wanted.slack;
    assert!(
        mass.volume >= least - slack && mass.volume <= most + slack,
        "{name} {params}: volume {}, computed {volume}",
        mass.volume
    );
    let size = bounds.size().iter().sum::<f64>();
    for (found, computed) in mass.center.iter().zip(wanted.centre()) {
        assert!(
            (found - computed).abs() < 1e-7 * size,
            "{name} {params}: centre {:?}, computed {:?}",
            mass.center,
            wanted.centre()
        );
    }
    let sides = bounds
        .min
        .iter()
        .zip(wanted.min)
        .chain(bounds.max.iter().zip(wanted.max));
    for (found, computed) in sides {
        if computed.is_nan() {
            continue;
        }
        assert!(
            (found - computed).abs() < 1e-5 + 1e-7 * size,
            "{name} {params}: {bounds}, computed {:?} to {:?}",
            wanted.min,
            wanted.max
        );
    }
}

/// From source to solid at the defaults: `cargo test -p assemcad-factories timings -- --ignored --nocapture`.
#[test]
#[ignore = "prints timings"]
fn timings() {
    use std::time::Instant;
    for name in &Registry::builtin().names() {
        let factory = Registry::builtin().get(name).unwrap();
        let source = factory.source();
        let mut best = [f64::INFINITY; 2];
        for _ in 0..5 {
            let began = Instant::now();
            let factory = assemcad_factories::Factory::parse(name, source).unwrap();
            let built = factory.build(&serde_json::Map::new()).unwrap();
            let script = began.elapsed().as_secs_f64();
            assemcad_kernel::replay(&built.recipe, &mut |_, _| {}).unwrap();
            let all = began.elapsed().as_secs_f64();
            best = [best[0].min(script), best[1].min(all - script)];
        }
        println!(
            "{name}: script {:.1} ms, kernel {:.1} ms",
            1e3 * best[0],
            1e3 * best[1]
        );
    }
}
