//! Factories that agents write: a folder for each request, with a source that is to be admitted or refused.
//!
//! `request.yaml` holds the arguments, `source.star` the source, `expect.yaml` what must become of it: the
//! volume by a closed form and the box where it is admitted; the layer and words of the finding where it is
//! refused, and `mended.star`, which must be admitted, is what a reader of the finding would make of it.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::kit::Kit;

fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/synthesis");
    let mut cases: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .filter(|p| p.is_dir())
        .collect();
    cases.sort();
    cases
}

fn yaml(path: &Path) -> Value {
    let text = std::fs::read_to_string(path).unwrap();
    assemcad_model::yaml::read(&text).node.unwrap().value(None)
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The arguments of a case, with a source.
fn arguments(case: &Path, source: &str) -> Value {
    let mut arguments = yaml(&case.join("request.yaml"));
    arguments["source"] = json!(text(&case.join(source)));
    arguments
}

fn near(found: &Value, expected: &Value, within: f64) -> bool {
    (found.as_f64().unwrap() - expected.as_f64().unwrap()).abs() <= within
}

/// What is wrong with the outcome of a case; empty where it is as expected.
fn examined(kit: &mut Kit, case: &Path) -> Vec<String> {
    let expect = yaml(&case.join("expect.yaml"));
    let answer = kit.ok("synthesize_factory", arguments(case, "source.star"));
    if expect["outcome"] == "admitted" {
        return admitted(&answer, &expect);
    }
    let mut wrong = refused(&answer, &expect);
    let mended = kit.ok("synthesize_factory", arguments(case, "mended.star"));
    if mended["status"] != "admitted" {
        wrong.push(format!("mended.star is not admitted: {}", brief(&mended)));
    }
    wrong
}

fn brief(answer: &Value) -> String {
    let findings = answer["findings"].as_array().cloned().unwrap_or_default();
    let told = findings.iter().map(|f| {
        format!(
            "\n    {} line {} port {} at {} ({} sets): {} | hint: {}",
            f["layer"],
            f["line"],
            f["port"],
            f["at"],
            f["sets"],
            f["diagnostic"]["message"],
            f["diagnostic"]["hint"]
        )
    });
    format!(
        "{} {}{}",
        answer["status"],
        answer["tally"],
        told.collect::<String>()
    )
}

fn admitted(answer: &Value, expect: &Value) -> Vec<String> {
    if answer["status"] != "admitted" {
        return vec![brief(answer)];
    }
    let mut wrong = Vec::new();
    let evidence = &answer["evidence"];
    if !expect["volume_mm3"].is_null() {
        let within = expect["tolerance_mm3"].as_f64().unwrap();
        if !near(&evidence["volume_mm3"], &expect["volume_mm3"], within) {
            wrong.push(format!(
                "volume {}, not {}",
                evidence["volume_mm3"], expect["volume_mm3"]
            ));
        }
    }
    for (i, key) in ["box_min_mm", "box_max_mm"].into_iter().enumerate() {
        for axis in 0..3 {
            if !near(&evidence[key][axis], &expect["box_mm"][i][axis], 1e-3) {
                wrong.push(format!(
                    "{key} {}, not {}",
                    evidence[key], expect["box_mm"][i]
                ));
                break;
            }
        }
    }
    wrong
}

fn refused(answer: &Value, expect: &Value) -> Vec<String> {
    if answer["status"] != "refused" {
        return vec![format!("{} and not refused", answer["status"])];
    }
    let mut wrong = Vec::new();
    let layer = expect["layer"].as_str().unwrap();
    let layers = answer["layers"].as_array().unwrap();
    let failed: Vec<&str> = layers
        .iter()
        .filter(|l| l["verdict"] == "fail")
        .map(|l| l["layer"].as_str().unwrap())
        .collect();
    if failed != [layer] {
        wrong.push(format!("layers {failed:?}, not {layer}: {}", brief(answer)));
    }
    let findings = answer["findings"].to_string();
    for word in expect["says"].as_array().unwrap() {
        let word = word.as_str().unwrap();
        if !findings.contains(word) {
            wrong.push(format!("nothing says '{word}': {}", brief(answer)));
        }
    }
    for key in ["port", "line"] {
        let has = |f: &Value| f[key] == expect[key];
        if !expect[key].is_null() && !answer["findings"].as_array().unwrap().iter().any(has) {
            wrong.push(format!(
                "{key} {} is not named: {}",
                expect[key],
                brief(answer)
            ));
        }
    }
    wrong
}

#[test]
fn a_source_gives_the_same_recipe_on_every_day() {
    let mut found = String::new();
    for case in cases() {
        if yaml(&case.join("expect.yaml"))["outcome"] == "admitted" {
            let name = case.file_name().unwrap().to_str().unwrap();
            let source = text(&case.join("source.star"));
            let factory = assemcad_script::Factory::parse(name, &source).unwrap();
            let recipe = factory.build(&serde_json::Map::new()).unwrap().recipe;
            found.push_str(&format!("{} {name}\n", recipe.hash().unwrap()));
        }
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/synthesis/recipes.txt");
    if std::env::var_os("ASSEMCAD_ACCEPT").is_some() {
        std::fs::write(&path, &found).unwrap();
    }
    assert_eq!(text(&path), found, "accept with ASSEMCAD_ACCEPT=1");
}

/// Holds cases to what is expected of them; `slow` ones are those that say so.
fn run(share: usize, of: usize, slow: bool) {
    // On a busy machine unoptimised code takes its time.
    let mut kit = Kit::with(&["--synthesis-s", "3000"]);
    let mut wrong = String::new();
    let all = cases();
    let all = all.iter().filter(|case| {
        let is_slow = yaml(&case.join("expect.yaml"))["slow"] == true;
        is_slow == slow
    });
    for case in all.skip(share).step_by(of) {
        let began = std::time::Instant::now();
        for fault in examined(&mut kit, case) {
            wrong.push_str(&format!(
                "{}: {fault}\n",
                case.file_name().unwrap().display()
            ));
        }
        println!(
            "{}: {:?}",
            case.file_name().unwrap().display(),
            began.elapsed()
        );
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn every_case_is_admitted_or_refused_for_its_reason_1() {
    assert!(cases().len() >= 40, "{}", cases().len());
    run(0, 2, false);
}

#[test]
fn every_case_is_admitted_or_refused_for_its_reason_2() {
    run(1, 2, false);
}

#[test]
#[ignore = "make test-factories"]
fn the_slow_cases() {
    run(0, 1, true);
}
