//! The language held against CadQuery: every script of `tests/cadquery` gives what CadQuery gave.
//!
//! `golden.json` holds CadQuery's results, so that this runs without CadQuery; `make peers-cadquery`
//! computes them anew.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::print_stdout,
    reason = "helpers of tests, outside of #[test] functions"
)]

use std::collections::BTreeMap;
use std::path::PathBuf;

use assemcad_kernel::brep::Topology;
use assemcad_kernel::replay::make;
use serde::Deserialize;

/// Relative to the value, or to the diagonal of the box.
const TOLERANCE: f64 = 1e-6;

#[derive(Debug, Deserialize)]
struct Golden {
    scripts: BTreeMap<String, Facts>,
}

#[derive(Debug, Deserialize)]
struct Facts {
    solids: usize,
    faces: usize,
    volume: f64,
    area: f64,
    center: [f64; 3],
    min: [f64; 3],
    max: [f64; 3],
}

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/cadquery")
}

fn read<T: serde::de::DeserializeOwned>(name: &str) -> T {
    serde_json::from_str(&std::fs::read_to_string(folder().join(name)).unwrap()).unwrap()
}

/// What a script makes here, or the first thing that went wrong.
fn facts(name: &str) -> Result<Facts, String> {
    let path = folder().join(format!("scripts/{name}.py"));
    let source = std::fs::read_to_string(path).map_err(|e| e.to_string())?;
    let made = assemcad_script::script(name, &source)
        .map_err(|faults| format!("script: {} ({})", faults[0].message, faults[0].place))?;
    let result = make(&made.recipe, &mut |_, _| {}).map_err(|e| {
        let line = made.lines.get(e.step).copied().unwrap_or(0);
        format!("line {line}, {}: {}", e.call, e.error)
    })?;
    let shape = result.shape;
    let text = |e: assemcad_kernel::KernelError| e.to_string();
    if !shape.is_valid().map_err(text)? {
        return Err("the result is not valid".to_owned());
    }
    let (mass, bounds) = (shape.mass().map_err(text)?, shape.bounds().map_err(text)?);
    Ok(Facts {
        solids: result.solids,
        faces: shape.parts(Topology::Face).map_err(text)?.len(),
        volume: mass.volume,
        area: mass.area,
        center: mass.center,
        min: bounds.min,
        max: bounds.max,
    })
}

/// What differs between what is here and what CadQuery gave.
fn difference(here: &Facts, there: &Facts) -> Option<String> {
    let mut found = Vec::new();
    if here.solids != there.solids {
        found.push(format!("solids {} for {}", here.solids, there.solids));
    }
    if here.faces != there.faces {
        found.push(format!("faces {} for {}", here.faces, there.faces));
    }
    for (what, a, b) in [
        ("volume", here.volume, there.volume),
        ("area", here.area, there.area),
    ] {
        if (a - b).abs() > TOLERANCE * b.abs() {
            found.push(format!("{what} {a} for {b}"));
        }
    }
    let size: f64 = there
        .max
        .iter()
        .zip(there.min)
        .map(|(a, b)| (a - b) * (a - b))
        .sum();
    for (what, a, b) in [
        ("centre", here.center, there.center),
        ("low corner", here.min, there.min),
        ("high corner", here.max, there.max),
    ] {
        if a.iter()
            .zip(b)
            .any(|(x, y)| (x - y).abs() > TOLERANCE * size.sqrt())
        {
            found.push(format!("{what} {a:?} for {b:?}"));
        }
    }
    (!found.is_empty()).then(|| found.join("; "))
}

#[test]
fn scripts_give_what_cadquery_gives() {
    let golden: Golden = read("golden.json");
    // Script by script why the result is another one, or none.
    let known: BTreeMap<String, String> = read("deviations.json");
    let only = std::env::var("ASSEMCAD_ONLY").unwrap_or_default();
    let (mut agree, mut wrong) = (0, Vec::new());
    for (name, there) in &golden.scripts {
        if !name.contains(&only) {
            continue;
        }
        println!("{name}");
        let found = match facts(name) {
            Ok(here) => difference(&here, there),
            Err(why) => Some(why),
        };
        match (found, known.get(name)) {
            (None, None) => agree += 1,
            (Some(_), Some(_)) => {}
            (None, Some(_)) => wrong.push(format!("{name}: agrees, but is listed as a deviation")),
            (Some(why), None) => wrong.push(format!("{name}: {why}")),
        }
    }
    println!(
        "{agree} of {} agree, {} deviate as listed",
        golden.scripts.len(),
        known.len()
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(only.is_empty() || agree > 0);
}
