//! Sources made worse at random: a value or diagnostics, never a fault of this program, and the same
//! answer twice.
//!
//! A bounded run with fixed seeds is part of the tests; `make fuzz` goes on for longer. Set by the
//! environment: `ASSEMCAD_FUZZ_SECONDS` (run for so long instead of for a number of cases) and
//! `ASSEMCAD_FUZZ_SEED` (the first seed). A failure names its seed; that seed alone repeats it.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::print_stdout,
    reason = "helpers of tests, outside of #[test] functions"
)]

mod mutate;

use core::time::Duration;
use std::path::{Path, PathBuf};
use std::time::Instant;

use assemcad_model::diagnostic::Diagnostic;
use assemcad_script::{Evaluated, Factory, Limits, expressions, script_within};
use mutate::{Dice, expression, mutated};
use serde_json::{Map, Value, json};

/// Cases of the bounded run.
const CASES: u64 = 500;

/// Much less than a factory may use, so that many cases fit; time is no limit that decides.
fn limits() -> Limits {
    Limits {
        statements: 3_000,
        ticks: 10_000,
        operations: 500,
        pieces: 5_000,
        heap_bytes: 4 << 20,
        time: Duration::from_secs(10),
        ..Limits::default()
    }
}

fn files(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, ending, found);
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
}

/// The built-in factories and the scripts of the comparison with CadQuery, in a fixed order. The
/// factories, which are longer and fewer, stand there several times.
fn corpus() -> Vec<String> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let read = |folder: &str, ending: &str| -> Vec<String> {
        let mut paths = Vec::new();
        files(&top.join(folder), ending, &mut paths);
        paths.sort();
        assert!(paths.len() > 10, "{folder}: {}", paths.len());
        let texts = paths.iter().map(|p| std::fs::read_to_string(p).unwrap());
        texts.collect()
    };
    let mut all = read("tests/cadquery/scripts", "py");
    let factories = read("factories/builtin", "star");
    all.extend(factories.iter().cycle().take(10 * factories.len()).cloned());
    all
}

type Answer = Result<Evaluated, Vec<Diagnostic>>;

fn evaluate(source: &str) -> Answer {
    if source.contains("factory(") {
        Factory::parse_within("user.fuzz", source, limits())?.build(&Map::new())
    } else {
        script_within("user.fuzz", source, limits())
    }
}

/// What can be wrong with a source as a whole, and so at no line.
const OF_THE_WHOLE: [&str; 8] = [
    "the source has ",
    "the source does not call factory(",
    "the source does not define the function build(p)",
    "build(p) returned",
    "a plain script does not call factory(",
    "the script leaves no `result`",
    "`result` is",
    "the evaluation took longer",
];

fn check_faults(source: &str, faults: &[Diagnostic]) -> Result<(), String> {
    if faults.is_empty() || faults.len() > 40 {
        return Err(format!("{} diagnostics", faults.len()));
    }
    let lines = source.lines().count() + 1;
    for d in faults {
        let wrong = |what: &str| Err(format!("{what}: {d:?}"));
        if d.message.contains("fault of its own") {
            return wrong("a fault of the interpreter");
        }
        if d.message.is_empty() || d.message.len() > 2000 {
            return wrong("the message's length");
        }
        let line = d.place.strip_prefix("factory user.fuzz, line ");
        match line.map(str::parse::<usize>) {
            Some(Ok(line)) if (1..=lines).contains(&line) => {}
            Some(_) => return wrong("a line that is not there"),
            None if d.place.starts_with("params") => {}
            None if OF_THE_WHOLE.iter().any(|w| d.message.starts_with(w)) => {}
            None => return wrong("no line"),
        }
    }
    Ok(())
}

/// Whether a source has a value, or what is wrong with the answer to it.
fn check(source: &str) -> Result<bool, String> {
    let start = Instant::now();
    let first = evaluate(source);
    let second = evaluate(source);
    if start.elapsed() > limits().time {
        return Err(format!("it took {:?}", start.elapsed()));
    }
    if first != second {
        return Err(format!("two answers: {first:?} and {second:?}"));
    }
    // As it goes over the socket of a worker.
    let sent = serde_json::to_string(&first).map_err(|e| e.to_string())?;
    if serde_json::from_str::<Answer>(&sent).map_err(|e| e.to_string())? != first {
        return Err("the answer does not survive being sent".to_owned());
    }
    match first {
        Ok(made) if made.lines.len() != made.recipe.calls.len() => Err("lines".to_owned()),
        Ok(made) => made.recipe.hash().map(|_| true).map_err(|e| e.to_string()),
        Err(faults) => check_faults(source, &faults).map(|()| false),
    }
}

/// Runs one case after another; so many, or for so long as the environment says. A case tells whether
/// there was a value.
fn run(cases: u64, case: impl Fn(u64) -> Result<bool, String>) {
    let number = |name: &str| std::env::var(name).ok().map(|v| v.parse::<u64>().unwrap());
    let seconds = number("ASSEMCAD_FUZZ_SECONDS").map(Duration::from_secs);
    let first = number("ASSEMCAD_FUZZ_SEED").unwrap_or(0);
    let (start, mut done, mut values, mut wrong) = (Instant::now(), 0, 0, Vec::new());
    while seconds.map_or(done < cases, |s| start.elapsed() < s) {
        let seed = first + done;
        match case(seed) {
            Ok(value) => values += u64::from(value),
            Err(why) => {
                println!("seed {seed}: {why}");
                wrong.push(seed);
            }
        }
        done += 1;
    }
    let time = start.elapsed();
    println!("{done} cases, {values} of them with a value, in {time:?}; seeds from {first}");
    assert!(
        wrong.is_empty(),
        "wrong at the seeds {wrong:?} of {done} cases"
    );
}

#[test]
fn sources_made_worse() {
    let corpus = corpus();
    run(CASES, |seed| {
        let source = mutated(&corpus, &mut Dice::new(seed));
        check(&source).map_err(|why| format!("{why}\n{source}"))
    });
}

#[test]
fn expressions_of_any_words() {
    let params = json!({"a": 2, "b": -1.5, "rows": [{"d": 1.0}], "kind": "left", "on": true});
    let params = params.as_object().unwrap().clone();
    let names = [
        "a",
        "b",
        "rows",
        "kind",
        "on",
        "math.sqrt(",
        "min(",
        " + ",
        " * ",
        "2",
        ")",
        ",",
    ];
    run(CASES, |seed| {
        let text = expression(&names, &mut Dice::new(seed));
        let ask = || expressions(&params, std::slice::from_ref(&text));
        let (first, second) = (ask(), ask());
        let same = first == second;
        match first.as_slice() {
            _ if !same => Err(format!("{text:?}: two answers")),
            [Ok(value)] if value.is_finite() => Ok(true),
            [Err(d)]
                if d.place == "expressions[0]" && d.hint.is_some() && !d.message.is_empty() =>
            {
                if d.message.contains("fault of its own") {
                    return Err(format!("{text:?}: {d}"));
                }
                Ok(false)
            }
            other => Err(format!("{text:?}: {other:?}")),
        }
    });
}

/// The corpus itself is sound, so that most mutations begin at something that works.
#[test]
fn the_corpus_before_it_is_made_worse() {
    let works = |source: &&String| {
        let found = if source.contains("factory(") {
            Factory::parse("user.fuzz", source).and_then(|f| f.build(&Map::<String, Value>::new()))
        } else {
            assemcad_script::script("user.fuzz", source)
        };
        found.is_ok()
    };
    let mut corpus = corpus();
    corpus.sort();
    corpus.dedup();
    let sound = corpus.iter().filter(works).count();
    assert_eq!(sound, corpus.len());
}
