//! Workers that die, hang or run out: each costs one diagnostic and nothing else.

use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};

use crate::kit::Kit;

/// The worker processes of a server.
fn workers(server: u32) -> Vec<u32> {
    let children = format!("/proc/{server}/task");
    let mut found = Vec::new();
    for task in std::fs::read_dir(children).unwrap() {
        let list = task.unwrap().path().join("children");
        let text = std::fs::read_to_string(list).unwrap_or_default();
        found.extend(text.split_whitespace().map(|p| p.parse::<u32>().unwrap()));
    }
    found
}

fn add(part: &str, factory: &str) -> Value {
    json!({"assembly": "a", "part": part, "factory": factory})
}

/// A kit with an assembly of one part.
fn kit(options: &[&str]) -> Kit {
    let mut kit = Kit::with(options);
    kit.new_assembly("a");
    kit.part("a", "first", "test.block", json!({}));
    kit
}

/// After a fault: the failed part is not there, the rest is, and work goes on.
fn goes_on(kit: &mut Kit) {
    let state = kit.ok("get_assembly", json!({"assembly": "a"}))["state"].clone();
    let names: Vec<&Value> = state["parts"]
        .as_array()
        .unwrap()
        .iter()
        .map(|p| &p["part"])
        .collect();
    assert_eq!(names, ["first"]);
    kit.part("a", "next", "base_frame.stepped_shaft", json!({}));
    kit.ok(
        "remove",
        json!({"assembly": "a", "kind": "part", "name": "next"}),
    );
    assert_eq!(
        kit.ok("verify", json!({"assembly": "a"}))["verdict"],
        "pass"
    );
}

#[test]
fn what_was_answered_needs_no_kernel() {
    let mut kit = kit(&["--workers", "2"]);
    kit.part("a", "plate", "base_frame.rect_plate", json!({}));
    kit.mate(json!({
        "assembly": "a", "id": "on", "mate_type": "face_to_face",
        "base": "plate:top_face", "incoming": "first:bottom",
    }));
    let ask = |kit: &mut Kit, tau: f64| {
        let arguments = json!({"assembly": "a", "tau_mm3": tau, "detail": "full"});
        let mut report = kit.ok("verify", arguments);
        let fields = report.as_object_mut().unwrap();
        fields.retain(|name, _| ["verdict", "parts", "pairs", "mates"].contains(&name.as_str()));
        report
    };
    let before = ask(&mut kit, 0.001);
    let server = kit.session.pid();
    assert!(!workers(server).is_empty());
    for pid in workers(server) {
        kill_process(Pid::from_raw(pid as i32).unwrap(), Signal::KILL).unwrap();
    }
    let until = Instant::now() + Duration::from_secs(20);
    while !workers(server).is_empty() && Instant::now() < until {
        std::thread::sleep(Duration::from_millis(20));
    }
    // The same again, and folded anew under other terms: nobody has to be asked.
    for tau in [0.001, 0.002] {
        assert_eq!(ask(&mut kit, tau), before);
    }
    let alive = |pid: &u32| {
        let stat = std::fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
        !stat.contains(") Z ") && !stat.is_empty()
    };
    assert_eq!(workers(server).iter().filter(|p| alive(p)).count(), 0);
    // A changed part is a new question.
    kit.part("a", "other", "base_frame.rect_plate", json!({"length": 77}));
    assert!(workers(server).iter().any(alive));
}

#[test]
fn a_worker_killed_in_the_middle_of_a_request() {
    for signal in [Signal::KILL, Signal::ABORT] {
        let mut kit = kit(&["--workers", "2"]);
        let slow = kit
            .session
            .begin_call("add_part", add("slow", "test.endless"))
            .unwrap();
        // Another request is under way at the same time, on another worker.
        let busy = |pid: &u32| {
            let stat = std::fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
            let ticks = stat
                .split_whitespace()
                .nth(13)
                .and_then(|t| t.parse::<u64>().ok());
            ticks.is_some_and(|t| t > 50)
        };
        let victim = |pid: u32, not: Option<u32>| {
            let until = Instant::now() + Duration::from_secs(60);
            loop {
                let mut all = workers(pid).into_iter();
                if let Some(pid) = all.find(|p| busy(p) && Some(*p) != not) {
                    return pid;
                }
                assert!(Instant::now() < until, "no worker is busy");
                std::thread::sleep(Duration::from_millis(20));
            }
        };
        let kill = |pid: u32| kill_process(Pid::from_raw(pid as i32).unwrap(), signal).unwrap();
        let first = victim(kit.session.pid(), None);
        kit.ok("new_assembly", json!({"assembly": "b"}));
        kit.ok(
            "add_part",
            json!({"assembly": "b", "part": "p", "factory": "bearing.ball"}),
        );
        kill(first);
        // What was lost with a worker is tried once more by another; that one is killed too.
        kill(victim(kit.session.pid(), Some(first)));
        let answer = kit.session.wait_call(slow).unwrap();
        assert!(answer.is_error);
        let d = &answer.content["diagnostics"][0];
        assert_eq!(d["code"], "worker_crashed");
        let message = d["message"].as_str().unwrap();
        assert!(
            message.contains("(Workplane.union)") && message.contains("signal"),
            "{message}"
        );
        assert!(
            d["where"]
                .as_str()
                .unwrap()
                .contains("part 'slow', factory test.endless, line 9")
        );
        goes_on(&mut kit);
    }
}

#[test]
fn a_worker_killed_while_idle_costs_nothing() {
    let mut kit = kit(&["--workers", "1"]);
    for pid in workers(kit.session.pid()) {
        kill_process(Pid::from_raw(pid as i32).unwrap(), Signal::KILL).unwrap();
    }
    goes_on(&mut kit);
}

#[test]
fn a_request_that_never_ends() {
    let mut kit = kit(&["--worker-wall-s", "2", "--workers", "1"]);
    // Two at once on one worker: the second one's time starts when its work does.
    let calls = ["slow_1", "slow_2"].map(|p| {
        kit.session
            .begin_call("add_part", add(p, "test.endless"))
            .unwrap()
    });
    for call in calls {
        let answer = kit.session.wait_call(call).unwrap();
        let d = &answer.content["diagnostics"][0];
        assert_eq!(d["code"], "worker_timeout");
        let message = d["message"].as_str().unwrap();
        assert!(
            message.contains("Workplane.union") && message.contains("limit of 2 s"),
            "{message}"
        );
    }
    goes_on(&mut kit);
}

#[test]
fn a_request_that_uses_too_much_processor_time() {
    let mut kit = kit(&["--worker-cpu-s", "1"]);
    let d = kit.refusal("add_part", add("slow", "test.endless"));
    assert_eq!(d["code"], "worker_cpu_limit");
    assert!(
        d["message"].as_str().unwrap().contains("limit of 1 s"),
        "{d}"
    );
    goes_on(&mut kit);
}

#[test]
fn a_request_that_allocates_without_end() {
    let mut kit = kit(&["--worker-memory-mb", "250"]);
    let d = kit.refusal("add_part", add("big", "test.glutton"));
    assert_eq!(d["code"], "worker_memory_limit");
    assert!(
        d["message"].as_str().unwrap().contains("limit of 250 MiB"),
        "{d}"
    );
    goes_on(&mut kit);
}

#[test]
fn recipes_of_a_size_that_nobody_needs() {
    let options = [
        "--worker-wall-s",
        "4",
        "--worker-cpu-s",
        "4",
        "--worker-memory-mb",
        "1024",
    ];
    let mut kit = kit(&options);
    let limits = ["worker_timeout", "worker_cpu_limit", "worker_memory_limit"];
    let d = kit.refusal("add_part", add("helix", "test.long_helix"));
    assert_eq!(d["code"], "kernel_failed");
    assert!(
        d["message"].as_str().unwrap().contains("10000 turns"),
        "{d}"
    );
    let arguments = |part: &str, factory: &str, params: Value| json!({"assembly": "a", "part": part, "factory": factory, "params": params});
    for heavy in [
        arguments("helix", "test.long_helix", json!({"turns": 1000})),
        arguments("bar", "test.many_fillets", json!({})),
    ] {
        let start = Instant::now();
        let d = kit.refusal("add_part", heavy);
        assert!(limits.contains(&d["code"].as_str().unwrap()), "{d}");
        assert!(start.elapsed() < Duration::from_secs(30), "{d}");
    }
    // What is wrong with them is their size alone.
    kit.ok(
        "add_part",
        arguments("helix", "test.long_helix", json!({"turns": 2})),
    );
    kit.ok(
        "add_part",
        arguments("bar", "test.many_fillets", json!({"corners": 6})),
    );
}

#[test]
fn workers_are_of_the_same_build_as_their_server() {
    let there = tempfile::tempdir().unwrap();
    let program = there.path().join("assemcad");
    std::fs::copy(crate::kit::program(), &program).unwrap();
    let root = there.path().join("root");
    let mut session = crate::harness::Session::start(&program, &root, &[]).unwrap();
    // Built anew meanwhile: something else stands in its place.
    std::fs::remove_file(&program).unwrap();
    std::fs::write(&program, "#!/bin/false").unwrap();
    session
        .call("new_assembly", json!({"assembly": "a"}))
        .unwrap();
    let part = json!({"assembly": "a", "part": "p", "factory": "base_frame.rect_plate"});
    let added = session.call("add_part", part).unwrap();
    assert!(!added.is_error, "{}", added.content);
}

#[test]
fn an_operation_that_the_kernel_cannot_do() {
    let mut kit = kit(&[]);
    for radius in [5.0, 6.0] {
        let d = kit.refusal(
            "add_part",
            json!({
                "assembly": "a", "part": "f", "factory": "test.impossible_fillet",
                "params": {"radius": radius},
            }),
        );
        assert_eq!(d["code"], "kernel_failed");
        assert_eq!(
            d["where"],
            "part 'f', factory test.impossible_fillet, line 8"
        );
        assert!(
            d["message"]
                .as_str()
                .unwrap()
                .contains(&format!("fillet of {radius} mm")),
            "{d}"
        );
    }
    goes_on(&mut kit);
}

#[test]
fn a_slow_call_tells_signs_of_life_where_they_are_asked_for() {
    let mut kit = kit(&["--workers", "1"]);
    let slow = kit
        .session
        .begin(
            "tools/call",
            json!({
                "name": "add_part", "arguments": add("slow", "test.endless"),
                "_meta": {"progressToken": "mine"},
            }),
        )
        .unwrap();
    let sign = kit.session.message(Duration::from_secs(20)).unwrap();
    assert_eq!(sign["method"], "notifications/progress", "{sign}");
    assert_eq!(sign["params"]["progressToken"], "mine");
    assert_eq!(sign["params"]["progress"].as_f64(), Some(1.0));
    let cancel = json!({
        "jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": slow},
    });
    kit.session.send(&cancel.to_string()).unwrap();
    goes_on(&mut kit);
}

#[test]
fn a_cancelled_call_frees_its_worker() {
    let mut kit = kit(&["--workers", "1"]);
    let slow = kit
        .session
        .begin_call("add_part", add("slow", "test.endless"))
        .unwrap();
    std::thread::sleep(Duration::from_millis(500));
    let cancel = json!({
        "jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": slow},
    });
    kit.session.send(&cancel.to_string()).unwrap();
    let start = Instant::now();
    goes_on(&mut kit);
    assert!(
        start.elapsed() < Duration::from_secs(30),
        "the only worker was not free"
    );
}
