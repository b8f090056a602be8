//! Sources evaluated in processes of their own: the same answers as here, and what kills such a
//! process costs one diagnostic.

use std::time::{Duration, Instant};

use assemcad_factories::Registry;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_script::worker::{Config, Evaluator, LIMITS};
use assemcad_workers::Limits;
use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Map, json};

use crate::kit::program;

fn processes(limits: Limits) -> Evaluator {
    Evaluator::processes(Config {
        program: program().to_owned(),
        workers: 1,
        limits,
    })
}

/// A factory whose `build(p)` begins with these lines.
fn building(lines: &str) -> String {
    let body: String = lines.lines().map(|l| format!("    {l}\n")).collect();
    format!(
        "factory(doc = \"\", params = {{}})\ndef build(p):\n{body}    return cq.Workplane().box(1, 1, 1)\n"
    )
}

/// One list that is a member of the next, twice, as often as asked for: nothing to hold, and 2^n
/// values to walk through.
fn net(name: &str, n: usize) -> String {
    format!(
        "{name} = []\n{}",
        format!("{name} = [{name}, {name}]\n").repeat(n)
    )
}

/// The worker process that this thread has started.
fn worker() -> i32 {
    let list = std::fs::read_to_string("/proc/thread-self/children").unwrap();
    let all: Vec<i32> = list
        .split_whitespace()
        .map(|p| p.parse().unwrap())
        .collect();
    assert_eq!(all.len(), 1, "{all:?}");
    all[0]
}

fn kill(signal: Signal) {
    kill_process(Pid::from_raw(worker()).unwrap(), signal).unwrap();
}

async fn refused(evaluator: &Evaluator, source: &str) -> Diagnostic {
    let factory = evaluator.parse("user.hostile", source).await.unwrap();
    let mut found = evaluator.build(&factory, &Map::new()).await.unwrap_err();
    assert_eq!(found.len(), 1, "{found:?}");
    found.remove(0)
}

/// After a fault the next source is evaluated as if nothing had been.
async fn goes_on(evaluator: &Evaluator) {
    let factory = evaluator
        .parse("user.box", &building("pass"))
        .await
        .unwrap();
    let made = evaluator.build(&factory, &Map::new()).await.unwrap();
    assert_eq!(made.recipe.calls.len(), 2);
}

#[tokio::test]
async fn the_same_answers_as_in_this_process() {
    let (there, here) = (processes(LIMITS), Evaluator::here());
    for factory in Registry::builtin().all() {
        let (name, source) = (factory.name(), factory.source());
        let read = there.parse(name, source).await.unwrap();
        assert_eq!(read.doc(), factory.doc());
        assert_eq!(read.params(), factory.params(), "{name}");
        let made = there.build(&read, &Map::new()).await;
        assert_eq!(made, here.build(&factory, &Map::new()).await, "{name}");
        let wrong = json!({"no_such_parameter": 1, "length": "x"});
        let wrong = wrong.as_object().unwrap();
        let found = there.build(&read, wrong).await.unwrap_err();
        assert_eq!(found, here.build(&factory, wrong).await.unwrap_err());
    }
    let plain = "result = cq.Workplane().box(1, 2, 3)\n";
    assert_eq!(
        there.script("a", plain).await.unwrap(),
        here.script("a", plain).await.unwrap()
    );
    for wrong in ["x = ", "factory()", "import os\nwhile True: pass\n"] {
        assert_eq!(
            there.parse("user.a", wrong).await.unwrap_err(),
            here.parse("user.a", wrong).await.unwrap_err()
        );
    }
    let texts = ["a / 3", "b", "nothing"].map(str::to_owned);
    let params = json!({"a": 0.1, "b": 7}).as_object().unwrap().clone();
    let found = there.expressions(&params, &texts).await.unwrap();
    assert_eq!(found[0], Ok(0.1 / 3.0));
    assert_eq!(found, here.expressions(&params, &texts).await.unwrap());
}

#[tokio::test]
async fn numbers_keep_their_last_digit() {
    let evaluator = processes(LIMITS);
    let source = "factory(doc = \"\", params = {\n\
        \"x\": number(0.30000000000000004, -1e300, 1e300), \"n\": integer(-9007199254740993, -9223372036854775808, 9223372036854775807),\n\
        \"r\": records(fields = {\"y\": number(5e-324, 0, 1e22)}, default = [{\"y\": 1e22}], min_items = 0, max_items = 3)})\n\
        def build(p):\n    return cq.Workplane().box(p.x, 1e-7 / 3, 123456789.123456789)\n";
    let there = evaluator.parse("user.numbers", source).await.unwrap();
    let here = Evaluator::here()
        .parse("user.numbers", source)
        .await
        .unwrap();
    assert_eq!(there.params(), here.params());
    assert_eq!(there.schema(), here.schema());
    for params in [
        json!({}),
        json!({"x": 1e300}),
        json!({"x": 0.1, "r": [{"y": 0.1}]}),
    ] {
        let params = params.as_object().unwrap();
        let (a, b) = (evaluator.build(&there, params).await, here.build(params));
        assert_eq!(a, b);
        assert_eq!(
            a.unwrap().recipe.hash().unwrap(),
            b.unwrap().recipe.hash().unwrap()
        );
    }
}

#[tokio::test]
async fn memory_without_end() {
    // What is left beside the evaluation's stack and the program itself is used up soon.
    let evaluator = processes(Limits {
        memory_mb: 850,
        ..LIMITS
    });
    let text = "t = \"x\" * 60000\n";
    let lists = net("s", 20).replacen("[]", "[t]", 1);
    for then in ["int(s)", "s()", "[1].index(s)"] {
        let source = building(&format!("{text}{lists}x = {then}"));
        let d = refused(&evaluator, &source).await;
        assert_eq!(d.code, Code::WorkerMemoryLimit, "{d:?}");
        assert_eq!(d.place, "factory user.hostile");
        assert_eq!(d.expected, Some(json!({"memory_mb": 850})));
        assert!(d.message.contains("limit of 850 MiB"), "{d}");
        assert!(d.hint.is_some());
        goes_on(&evaluator).await;
    }
}

#[tokio::test]
async fn time_without_end() {
    let source = building(&format!("{}{}x = s == t", net("s", 40), net("t", 40)));
    let wall = Limits {
        wall_s: 2,
        ..LIMITS
    };
    let cpu = Limits { cpu_s: 1, ..LIMITS };
    for (limits, code, part) in [
        (wall, Code::WorkerTimeout, "limit of 2 s"),
        (cpu, Code::WorkerCpuLimit, "limit of 1 s"),
    ] {
        let evaluator = processes(limits);
        let start = Instant::now();
        let d = refused(&evaluator, &source).await;
        assert_eq!((d.code, d.place.as_str()), (code, "factory user.hostile"));
        assert!(
            d.message.contains(part) && d.message.contains("build(p)"),
            "{d}"
        );
        assert!(start.elapsed() < Duration::from_secs(15));
        goes_on(&evaluator).await;
    }
}

#[tokio::test]
async fn an_evaluation_that_is_left_behind_takes_its_process_with_it() {
    let evaluator = processes(LIMITS);
    let source = building(&format!("{}{}x = s == t", net("s", 40), net("t", 40)));
    let d = refused(&evaluator, &source).await;
    assert_eq!(d.code, Code::FactoryFailed);
    assert!(d.message.contains("limit time"), "{d}");
    goes_on(&evaluator).await;
}

#[tokio::test]
async fn a_worker_that_is_killed() {
    let evaluator = std::sync::Arc::new(processes(LIMITS));
    goes_on(&evaluator).await;
    let source = building(&format!("{}{}x = s == t", net("s", 40), net("t", 40)));
    let slow = std::sync::Arc::clone(&evaluator);
    let task = tokio::spawn(async move { refused(&slow, &source).await });
    tokio::time::sleep(Duration::from_secs(1)).await;
    kill(Signal::ABORT);
    let d = task.await.unwrap();
    assert_eq!(
        (d.code, d.place.as_str()),
        (Code::WorkerCrashed, "factory user.hostile")
    );
    assert!(d.message.contains("signal 6"), "{d}");
    goes_on(&evaluator).await;
    // One that dies while nothing is asked of it costs nothing.
    kill(Signal::KILL);
    goes_on(&evaluator).await;
}

#[tokio::test]
async fn what_a_worker_has_is_its_socket_and_little_else() {
    let evaluator = processes(LIMITS);
    goes_on(&evaluator).await;
    let proc = format!("/proc/{}", worker());
    let limits = std::fs::read_to_string(format!("{proc}/limits")).unwrap();
    for (what, most) in [
        ("Max open files", "1"),
        ("Max file size", "0"),
        ("Max core file size", "0"),
        ("Max address space", "1073741824"),
    ] {
        let line = limits.lines().find(|l| l.starts_with(what)).unwrap();
        let values: Vec<&str> = line[what.len()..].split_whitespace().take(2).collect();
        assert_eq!(values, [most, most], "{what}");
    }
    let status = std::fs::read_to_string(format!("{proc}/status")).unwrap();
    if assemcad_workers::missing_seclusion().is_empty() {
        for line in ["NoNewPrivs:\t1", "Seccomp:\t2"] {
            assert!(status.contains(line), "{line}");
        }
    }
    // PATH, HOME and whatever else stands there are set in this process.
    assert!(std::env::var_os("PATH").is_some());
    let environment = std::fs::read(format!("{proc}/environ")).unwrap();
    for variable in environment.split(|b| *b == 0).filter(|v| !v.is_empty()) {
        let variable = String::from_utf8_lossy(variable);
        let name = variable.split('=').next().unwrap_or_default();
        let linker =
            name.starts_with("DYLD_") || ["LD_LIBRARY_PATH", "ASSEMCAD_LOG"].contains(&name);
        assert!(linker, "{name}");
    }
    let ours = |n: u32| std::fs::read_link(format!("/proc/self/fd/{n}"));
    for entry in std::fs::read_dir(format!("{proc}/fd")).unwrap() {
        let path = entry.unwrap().path();
        let number: u32 = path.file_name().unwrap().to_str().unwrap().parse().unwrap();
        let what = std::fs::read_link(&path).unwrap();
        let handed_down = ours(number).is_ok_and(|o| o == what);
        let text = what.to_string_lossy();
        let expected = match number {
            0 => text.starts_with("socket:"),
            1 => text == "/dev/null",
            2 => text.starts_with("pipe:"),
            // The socket again; and what whoever started this process has let it inherit.
            _ => handed_down || std::fs::read_link(format!("{proc}/fd/0")).unwrap() == what,
        };
        assert!(expected, "{number}: {text}");
    }
}
