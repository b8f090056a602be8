//! `make faults`: every sound assembly and every defect before a server, and the page on what it said.

// A program of its own: its standard output is for people.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic
)]

// Other sessions use more of it.
#[allow(dead_code)]
mod harness;
#[path = "defects/suite.rs"]
mod suite;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::process::ExitCode;

use harness::Session;
use suite::{Told, cases};

/// How many of a kind were found, missed, told elsewhere, left open.
#[derive(Debug, Default, Clone, Copy)]
struct Count {
    all: usize,
    found: usize,
    missed: usize,
    elsewhere: usize,
    open: usize,
}

fn main() -> ExitCode {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let here = std::env::current_exe().unwrap();
    let program = here.ancestors().nth(2).unwrap().join("assemcad");
    let root = tempfile::tempdir().unwrap();
    let factories = top.join("tests/factories");
    let options = ["--factories", factories.to_str().unwrap()];
    let mut session = Session::start(&program, root.path(), &options).unwrap();
    let mut kinds: BTreeMap<(String, String), Count> = BTreeMap::new();
    let (mut sound, mut alarms, mut wrong) = (0, 0, Vec::new());
    for case in cases(&top.join("tests/defects")) {
        let told = case.put(&mut session);
        let Some(kind) = &case.mechanism else {
            sound += 1;
            if told != Told::Pass {
                alarms += 1;
                wrong.push(format!("false alarm: {} ({}): {told:?}", case.id, case.why));
            }
            continue;
        };
        let count = kinds.entry((kind.clone(), case.form.clone())).or_default();
        count.all += 1;
        *match &told {
            Told::Found => &mut count.found,
            Told::Pass => &mut count.missed,
            Told::Elsewhere(_) => &mut count.elsewhere,
            Told::Open(_) => &mut count.open,
        } += 1;
        if told != Told::Found {
            wrong.push(format!("{}: {}: {told:?}", case.id, case.why));
        }
    }
    session.close().unwrap();
    let page = page(&kinds, sound, alarms, &wrong);
    println!("{page}");
    std::fs::write(top.join("docs/faults.md"), page).unwrap();
    match wrong.is_empty() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}

fn page(
    kinds: &BTreeMap<(String, String), Count>,
    sound: usize,
    alarms: usize,
    wrong: &[String],
) -> String {
    let mut out = String::from(
        "# What the verifier finds\n\nSound assemblies (`tests/defects/`), each broken in one physical point: honestly, \
         or in a form whose text hides it. Made by `make faults`.\n\n\
         | kind of defect | form | cases | found at the place | missed | told elsewhere | left open |\n\
         |---|---|---|---|---|---|---|\n",
    );
    let mut sum = Count::default();
    for ((kind, form), c) in kinds {
        let _ = writeln!(
            out,
            "| {kind} | {form} | {} | {} | {} | {} | {} |",
            c.all, c.found, c.missed, c.elsewhere, c.open
        );
        sum.all += c.all;
        sum.found += c.found;
        sum.missed += c.missed;
        sum.elsewhere += c.elsewhere;
        sum.open += c.open;
    }
    let _ = writeln!(
        out,
        "| all | | {} | {} | {} | {} | {} |\n\nOf {sound} sound assemblies {alarms} were not passed.",
        sum.all, sum.found, sum.missed, sum.elsewhere, sum.open
    );
    if !wrong.is_empty() {
        out.push_str("\n## What went wrong\n\n");
        for line in wrong {
            let _ = writeln!(out, "- {line}");
        }
    }
    out
}
