//! Each check on an assembly that obeys its axiom and on one that breaks exactly it.
//!
//! A case is a file in `cases/`, one per axiom, that reads like documentation: `what` it shows, the facts of
//! an assembly that `obeys`, and under `breaks` the one `change` that breaks the axiom. What is left out of
//! a case takes its plain value: a part stands in the world as it is, a port's frame has the world's axes.
//! Values in the checks are confirmed by `values` (after the change: `breaks.values`).

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests, outside of #[test] functions"
)]

use std::collections::BTreeSet;

use assemcad_axioms::axiom::{Checking, Need};
use assemcad_axioms::knowledge::axiom;
use assemcad_axioms::{Facts, Status, checks};
use assemcad_model::frame::Placement;
use assemcad_model::mates::MateType;
use assemcad_model::yaml;
use serde_json::{Map, Value, json};

fn cases() -> Vec<(String, Value)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/cases");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|f| f.unwrap().path())
        .collect();
    files.sort();
    let read = |path: std::path::PathBuf| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let read = yaml::read(&std::fs::read_to_string(&path).unwrap());
        let errors: Vec<_> = read
            .faults
            .iter()
            .filter(|f| f.severity == assemcad_model::diagnostic::Severity::Error)
            .collect();
        assert!(errors.is_empty(), "{name}: {errors:?}");
        (name, read.node.unwrap().value(None))
    };
    files.into_iter().map(read).collect()
}

/// Fills in what a case leaves out.
fn full(mut facts: Value) -> Value {
    let identity = json!([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]);
    for part in facts["parts"].as_array_mut().unwrap() {
        let part = part.as_object_mut().unwrap();
        part.entry("placement").or_insert(identity.clone());
        let Some(ports) = part.get_mut("ports").and_then(Value::as_array_mut) else {
            continue;
        };
        for port in ports {
            let port = port.as_object_mut().unwrap();
            port.entry("params").or_insert(json!({}));
            let at = port.remove("at").unwrap_or(json!([0, 0, 0]));
            let z = port.remove("z").unwrap_or(json!([0, 0, 1]));
            let across = if z[0].as_f64() == Some(0.0) {
                json!([1, 0, 0])
            } else {
                json!([0, 1, 0])
            };
            let x = port.remove("x").unwrap_or(across);
            port.insert("frame".to_owned(), json!({"origin": at, "x": x, "z": z}));
        }
    }
    let none = &mut Vec::new();
    for mate in facts
        .get_mut("mates")
        .and_then(Value::as_array_mut)
        .unwrap_or(none)
    {
        for end in ["base", "incoming"] {
            let (part, port) = mate[end].as_str().unwrap().split_once(':').unwrap();
            mate[end] = json!({"ref": part, "port": port});
        }
    }
    facts
}

/// Sets the value at a path such as `parts/wheel/ports/teeth/params/module`; `null` takes it away.
fn change(facts: &mut Value, path: &str, to: &Value) {
    let (into, last) = path.rsplit_once('/').unwrap_or(("", path));
    let mut at = facts;
    for step in into.split('/').filter(|s| !s.is_empty()) {
        at = match at {
            Value::Array(items) => items
                .iter_mut()
                .find(|i| i["id"] == step || i["name"] == step)
                .unwrap_or_else(|| panic!("{path}: no {step}")),
            Value::Object(map) => map.entry(step).or_insert(Value::Object(Map::new())),
            _ => panic!("{path}: {step} leads nowhere"),
        };
    }
    match at {
        Value::Array(items) => {
            let named = |i: &Value| i["id"] == last || i["name"] == last;
            match items.iter().position(named) {
                Some(i) if to.is_null() => {
                    items.remove(i);
                }
                Some(i) => items[i] = to.clone(),
                None if named(to) => items.push(to.clone()),
                None => panic!("{path}: no {last}"),
            }
        }
        Value::Object(map) if to.is_null() => {
            map.shift_remove(last)
                .unwrap_or_else(|| panic!("{path}: no {last}"));
        }
        Value::Object(map) => {
            map.insert(last.to_owned(), to.clone());
        }
        _ => panic!("{path}: nothing to set"),
    }
}

fn facts(name: &str, value: &Value) -> Facts {
    let facts: Facts =
        serde_json::from_value(full(value.clone())).unwrap_or_else(|e| panic!("{name}: {e}"));
    for part in &facts.parts {
        for port in &part.ports {
            let faults = port.faults();
            assert!(
                faults.is_empty(),
                "{name}: {}:{}: {faults:?}",
                part.id,
                port.name
            );
        }
    }
    facts
}

fn failing(facts: &Facts) -> BTreeSet<String> {
    checks::run_all(facts)
        .into_iter()
        .filter(|v| v.status == Status::Fail)
        .map(|v| v.axiom)
        .collect()
}

/// Values that a case confirms, computed by hand: of the verdicts of its axiom one has them.
fn confirm(name: &str, facts: &Facts, status: Status, values: Option<&Value>) {
    let verdicts: Vec<_> = checks::run_all(facts)
        .into_iter()
        .filter(|v| v.axiom == name)
        .collect();
    let with = verdicts.iter().filter(|v| v.status == status);
    let close = |a: &Value, b: &Value| (a.as_f64().unwrap() - b.as_f64().unwrap()).abs() <= 2e-3;
    let all = |v: &&assemcad_axioms::Ruling| {
        let Some(wanted) = values.and_then(Value::as_object) else {
            return true;
        };
        wanted
            .iter()
            .all(|(k, w)| v.values.get(k).is_some_and(|found| close(found, w)))
    };
    assert!(
        with.clone().any(|v| all(&v)),
        "{name}: none {status:?} with {values:?} in {verdicts:#?}"
    );
}

#[test]
fn each_axiom_is_obeyed_and_broken_alone() {
    for (name, case) in cases() {
        assert_eq!(axiom(&name).map(|a| a.id.clone()), Some(name.clone()));
        assert!(
            case["what"].as_str().unwrap().len() > 10 && case["breaks"]["what"].is_string(),
            "{name}"
        );
        let obeys = facts(&name, &case["obeys"]);
        let before = failing(&obeys);
        assert!(
            !before.contains(&name),
            "{name} fails: {:#?}",
            checks::run_all(&obeys)
        );
        confirm(&name, &obeys, Status::Pass, case.get("values"));

        let mut broken = case["obeys"].clone();
        for (path, to) in case["breaks"]["change"].as_object().unwrap() {
            change(&mut broken, path, to);
        }
        let broken = facts(&name, &broken);
        confirm(&name, &broken, Status::Fail, case["breaks"].get("values"));
        let more: Vec<String> = failing(&broken).difference(&before).cloned().collect();
        assert_eq!(more, [name.as_str()], "{name} is to be broken alone");
        // A case is clean but for what is no part of it: fragments have no ground.
        let fragment = ["F-02", "P-03", "S-03"].map(str::to_owned);
        let rest: Vec<_> = before.iter().filter(|a| !fragment.contains(a)).collect();
        assert!(
            rest.is_empty(),
            "{name}: {rest:?} fail too: {:#?}",
            checks::run_all(&obeys)
        );
    }
}

#[test]
fn every_check_has_its_case() {
    let cases: BTreeSet<String> = cases().into_iter().map(|c| c.0).collect();
    let checks: BTreeSet<String> = checks::ALL.iter().map(|c| c.axiom().to_owned()).collect();
    let lacking: Vec<_> = checks.difference(&cases).collect();
    assert!(lacking.is_empty(), "{lacking:?}");
}

#[test]
fn what_is_not_there_is_said_to_be() {
    let verdicts = checks::run_all(&Facts::default());
    assert!(
        verdicts
            .iter()
            .all(|v| v.status != Status::Pass && v.status != Status::Fail),
        "{verdicts:#?}"
    );
    let ids: BTreeSet<&str> = verdicts.iter().map(|v| v.axiom.as_str()).collect();
    assert_eq!(ids.len(), checks::ALL.len());
    assert!(checks::not_written().all(|a| !ids.contains(a.id.as_str())));
}

fn both(case: &Value) -> [Value; 2] {
    let mut broken = case["obeys"].clone();
    for (path, to) in case["breaks"]["change"].as_object().unwrap() {
        change(&mut broken, path, to);
    }
    [case["obeys"].clone(), broken]
}

fn statuses(facts: &Facts) -> Vec<(String, Status)> {
    let all = checks::run_all(facts).into_iter();
    let mut all: Vec<_> = all.map(|v| (v.axiom, v.status)).collect();
    all.sort();
    all
}

/// An assembly is as good in another place and attitude.
#[test]
fn a_rigid_motion_of_everything_changes_nothing() {
    let turn = Placement::rotation_about([3.0, -20.0, 7.0], [1.0, 2.0, -0.5], 73.0).unwrap();
    for (name, case) in cases() {
        for value in both(&case) {
            let here = facts(&name, &value);
            let mut there = here.clone();
            for part in &mut there.parts {
                part.placement = part.placement.map(|p| turn * p);
            }
            assert_eq!(statuses(&here), statuses(&there), "{name}");
        }
    }
}

/// Which of the two ends stays says nothing about how they go together.
#[test]
fn base_and_incoming_are_alike() {
    for (name, case) in cases() {
        for value in both(&case) {
            let here = facts(&name, &value);
            let mut there = here.clone();
            for m in &mut there.mates {
                // The place on a face is given in the base face's extents.
                if m.mate_type != MateType::SnapToFace {
                    std::mem::swap(&mut m.base, &mut m.incoming);
                }
            }
            assert_eq!(statuses(&here), statuses(&there), "{name}");
        }
    }
}

/// Where nothing has a place, a check of places neither passes nor fails; those that pass look at ports
/// in their parts' own frames, or at what mates state.
#[test]
fn without_places_nothing_is_said_of_places() {
    let by_ports = [
        "B-04", "G-06", "K-04", "N-03", "N-04", "N-06", "P-02", "P-03", "T-02", "T-03", "T-04",
        "T-05", "T-06", "T-07",
    ];
    for (name, case) in cases() {
        let mut unplaced = facts(&name, &case["obeys"]);
        for part in &mut unplaced.parts {
            part.placement = None;
        }
        let known = ["F-02", "P-03", "S-03"];
        let failing = failing(&unplaced);
        let more: Vec<_> = failing
            .iter()
            .filter(|a| !known.contains(&a.as_str()))
            .collect();
        assert!(
            more.is_empty(),
            "{name}: {more:?} {:#?}",
            checks::run_all(&unplaced)
        );
        let Checking::Checked { needs, .. } = &axiom(&name).unwrap().check else {
            continue;
        };
        let placed = needs.contains(&Need::PlacedPorts) && !needs.contains(&Need::Geometry);
        if placed && !by_ports.contains(&name.as_str()) && name != "G-09" {
            let of = |v: &&assemcad_axioms::Ruling| v.axiom == name;
            let verdicts = checks::run_all(&unplaced);
            assert!(
                verdicts
                    .iter()
                    .filter(of)
                    .all(|v| v.status == Status::Indeterminate),
                "{name}: {verdicts:#?}"
            );
        }
    }
}

/// Two runs over the same facts give the same text.
#[test]
fn the_same_facts_give_the_same_verdicts() {
    for (name, case) in cases() {
        let facts = facts(&name, &case["obeys"]);
        let text = |f: &Facts| serde_json::to_string(&checks::run_all(f)).unwrap();
        assert_eq!(text(&facts), text(&facts.clone()));
    }
}
