//! Many clients against many servers over a few folders, with servers and workers killed at random, from a fixed
//! seed: `make soak`. What it holds: no answered change is lost, no verdict gets better than it was for the same
//! specification, memory and descriptors of a server that lives through it stay level, what is on disk is bounded,
//! and short questions are answered soon. The figures go to standard output as Markdown.

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::panic,
    clippy::indexing_slicing
)]

#[allow(dead_code)]
mod harness;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};

use harness::Session;

/// So many calls has a session.
const CALLS: usize = 20;

/// So many folders there are.
const ROOTS: usize = 4;

/// Assemblies in a folder: few, so that sessions meet.
const ASSEMBLIES: usize = 24;

fn setting(name: &str, otherwise: u64) -> u64 {
    let value = std::env::var(name).ok();
    value.and_then(|v| v.parse().ok()).unwrap_or(otherwise)
}

/// Numbers that are the same for the same seed (Marsaglia's xorshift).
struct Numbers(u64);

impl Numbers {
    fn of(seed: u64) -> Self {
        let mut numbers = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..8 {
            numbers.below(2);
        }
        numbers
    }

    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most.max(1) as u64) as usize
    }
}

/// What all clients have in common.
struct Soak {
    program: PathBuf,
    roots: Vec<PathBuf>,
    /// Changes that were answered, by root and assembly: parts, and whether one of them was being added when its server
    /// was killed. An assembly has one client at a time that changes it.
    known: Vec<Vec<Mutex<Known>>>,
    /// The verdicts by specification.
    verdicts: Mutex<BTreeMap<String, BTreeSet<String>>>,
    servers_killed: AtomicUsize,
    workers_killed: AtomicUsize,
    calls: AtomicUsize,
    changes: AtomicUsize,
    refused: AtomicUsize,
}

#[derive(Default)]
struct Known {
    there: bool,
    parts: BTreeSet<String>,
    /// A change whose answer never came: it may be there or not.
    open: BTreeSet<String>,
}

impl Soak {
    fn start(&self, root: usize) -> Session {
        Session::start(&self.program, &self.roots[root], &["--workers", "1"]).unwrap()
    }

    /// A session of some calls.
    fn session(&self, number: usize, seed: u64) {
        let mut numbers = Numbers::of(seed ^ number as u64);
        let (root, which) = (number % ROOTS, numbers.below(ASSEMBLIES));
        let name = format!("a{which}");
        // One client at a time changes an assembly, so that what it knows is what is there.
        let mut known = self.known[root][which].lock().unwrap();
        let mut session = self.start(root);
        for _ in 0..CALLS {
            self.calls.fetch_add(1, Ordering::Relaxed);
            let (tool, arguments) = self.choose(&name, &known, &mut numbers);
            let Ok(id) = session.begin_call(tool, arguments.clone()) else {
                panic!("{tool}: the server is gone");
            };
            match numbers.below(40) {
                0 => {
                    std::thread::sleep(Duration::from_millis(numbers.below(400) as u64));
                    session.kill().unwrap();
                    self.servers_killed.fetch_add(1, Ordering::Relaxed);
                    note(&mut known, tool, &arguments, None);
                    session = self.start(root);
                    held(&mut session, &name, &mut known);
                    continue;
                }
                1 | 2 => {
                    std::thread::sleep(Duration::from_millis(numbers.below(100) as u64));
                    for worker in children(session.pid()) {
                        let _ = kill_process(Pid::from_raw(worker).unwrap(), Signal::KILL);
                        self.workers_killed.fetch_add(1, Ordering::Relaxed);
                    }
                }
                _ => {}
            }
            let answer = session
                .wait_call(id)
                .unwrap_or_else(|e| panic!("{tool}: {e}"));
            if answer.is_error {
                self.refused.fetch_add(1, Ordering::Relaxed);
            }
            if note(&mut known, tool, &arguments, Some(!answer.is_error)) {
                self.changes.fetch_add(1, Ordering::Relaxed);
            }
            if tool == "verify" && !answer.is_error {
                let of = |key: &str| answer.content[key].as_str().unwrap_or_default().to_owned();
                let mut verdicts = self.verdicts.lock().unwrap();
                let seen = verdicts.entry(of("specification_sha256")).or_default();
                seen.insert(of("verdict"));
                assert!(
                    !(seen.contains("fail") && seen.contains("pass")),
                    "{name}: {seen:?} for one specification"
                );
            }
        }
        held(&mut session, &name, &mut known);
        session.close().unwrap();
    }

    /// The next call.
    fn choose(&self, name: &str, known: &Known, numbers: &mut Numbers) -> (&'static str, Value) {
        if !known.there {
            return ("new_assembly", json!({"assembly": name}));
        }
        let part = format!("p{}", numbers.below(8));
        match numbers.below(16) {
            0..=3 => {
                let (factory, params) = match part.as_bytes().get(1).map_or(0, |b| b % 3) {
                    0 => (
                        "base_frame.rect_plate",
                        json!({"length": 40 + 10 * numbers.below(3)}),
                    ),
                    1 => ("bearing.ball", json!({})),
                    _ => ("fastener.washer", json!({})),
                };
                (
                    "add_part",
                    json!({"assembly": name, "part": part, "factory": factory, "params": params}),
                )
            }
            4 => (
                "remove",
                json!({"assembly": name, "kind": "part", "name": part}),
            ),
            5..=6 => ("verify", json!({"assembly": name})),
            7..=8 => ("get_assembly", json!({"assembly": name})),
            9 => ("measure", json!({"assembly": name, "what": "box"})),
            10 => (
                "render",
                json!({"assembly": name, "width_px": 320, "height_px": 240}),
            ),
            11 => ("export_step", json!({"assembly": name})),
            12 => (
                "validate_draft",
                json!({"draft": "assembly: {id: x, parts: [{id: a, factory: bearing.bal}]}"}),
            ),
            13 => (
                "realize",
                json!({"draft": format!(
                    "assembly: {{id: r{name}, parts: [{{id: a, factory: base_frame.rect_plate, params: {{length: {}}}}}]}}",
                    40 + numbers.below(20)
                )}),
            ),
            14 => ("find_axioms", json!({"mate_type": "coaxial"})),
            _ => ("list_factories", json!({})),
        }
    }
}

/// Takes down what a call changed; `done` is none where its answer never came. Whether it was an answered change.
fn note(known: &mut Known, tool: &str, arguments: &Value, done: Option<bool>) -> bool {
    let part = |key: &str| arguments[key].as_str().unwrap_or_default().to_owned();
    match (tool, done) {
        ("new_assembly", Some(true)) => known.there = true,
        ("add_part", Some(true)) => drop(known.parts.insert(part("part"))),
        ("remove", Some(true)) => drop(known.parts.remove(&part("name"))),
        ("new_assembly", None) => {}
        ("add_part", None) => drop(known.open.insert(part("part"))),
        ("remove", None) => drop(known.open.insert(part("name"))),
        _ => return false,
    }
    done == Some(true)
}

/// All that was answered is there, and nothing else.
fn held(session: &mut Session, name: &str, known: &mut Known) {
    if !known.there {
        let list = session.call("list_assemblies", json!({})).unwrap();
        let all = list.content["assemblies"].as_array().unwrap();
        known.there = all.contains(&json!(name));
        return;
    }
    let state = session
        .call("get_assembly", json!({"assembly": name}))
        .unwrap();
    assert!(!state.is_error, "{name}: {}", state.content);
    let parts = state.content["state"]["parts"].as_array().unwrap();
    let there: BTreeSet<String> = parts
        .iter()
        .map(|p| p["part"].as_str().unwrap().to_owned())
        .collect();
    for part in known.parts.symmetric_difference(&there) {
        assert!(
            known.open.contains(part),
            "{name}: '{part}' is not as it was answered"
        );
    }
    known.parts = there;
    known.open.clear();
}

/// The worker processes of a server.
fn children(server: u32) -> Vec<i32> {
    let mut found = Vec::new();
    for task in std::fs::read_dir(format!("/proc/{server}/task"))
        .into_iter()
        .flatten()
        .flatten()
    {
        let text = std::fs::read_to_string(task.path().join("children")).unwrap_or_default();
        found.extend(
            text.split_whitespace()
                .filter_map(|p| p.parse::<i32>().ok()),
        );
    }
    found
}

/// Memory in use in MiB and open descriptors of a process.
fn uses(pid: u32) -> (u64, usize) {
    let text = std::fs::read_to_string(format!("/proc/{pid}/statm")).unwrap_or_default();
    let pages: u64 = text
        .split_whitespace()
        .nth(1)
        .and_then(|n| n.parse().ok())
        .unwrap_or(0);
    let descriptors = std::fs::read_dir(format!("/proc/{pid}/fd")).map_or(0, Iterator::count);
    ((pages * 4096) >> 20, descriptors)
}

/// What a server that lives through all of it shows.
struct Witness {
    took: Vec<Duration>,
    uses: Vec<(u64, usize)>,
}

/// Asks short questions of a server over one of the folders until all is done, and works a little meanwhile.
fn witness(soak: &Soak, root: usize, done: &AtomicBool) -> Witness {
    let mut session = soak.start(root);
    let mut seen = Witness {
        took: Vec::new(),
        uses: Vec::new(),
    };
    let mut round = 0;
    while !done.load(Ordering::Relaxed) {
        for short in ["ping", "list_factories"] {
            let began = Instant::now();
            match short {
                "ping" => drop(session.request("ping", json!({})).unwrap()),
                tool => drop(session.call(tool, json!({})).unwrap()),
            }
            seen.took.push(began.elapsed());
        }
        let name = format!("a{}", round % ASSEMBLIES);
        let _ = session.call("verify", json!({"assembly": name}));
        seen.uses.push(uses(session.pid()));
        round += 1;
        std::thread::sleep(Duration::from_millis(100));
    }
    session.close().unwrap();
    seen
}

/// Whether specification, report and STEP file of every realisation are of one piece; how many there are.
fn whole(session: &mut Session, root: &Path) -> usize {
    let list = session.call("list_assemblies", json!({})).unwrap();
    let names = list.content["assemblies"].as_array().unwrap();
    let realized = names
        .iter()
        .filter_map(Value::as_str)
        .filter(|n| n.starts_with('r'));
    let mut count = 0;
    for name in realized {
        let folder = root.join("assemblies").join(name);
        let state = session
            .call("get_assembly", json!({"assembly": name}))
            .unwrap();
        let sha = state.content["state"]["specification_sha256"]
            .as_str()
            .unwrap()
            .to_owned();
        let report = std::fs::read_to_string(folder.join("report.json")).unwrap();
        let report: Value = serde_json::from_str(&report).unwrap();
        assert_eq!(
            report["specification_sha256"], sha,
            "{name}: the report is of another"
        );
        let step = std::fs::read_to_string(folder.join(format!("{name}.step"))).unwrap();
        let flat: String = step.split_whitespace().collect();
        assert!(flat.contains(&sha), "{name}: the STEP file is of another");
        count += 1;
    }
    count
}

fn disk(folder: &Path) -> (u64, usize) {
    let mut total = (0, 0);
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        let (bytes, begun) = if path.is_dir() {
            disk(&path)
        } else {
            let name = entry.file_name().to_string_lossy().into_owned();
            let begun = name.starts_with('.') && name.contains('-');
            (entry.metadata().map_or(0, |m| m.len()), usize::from(begun))
        };
        total = (total.0 + bytes, total.1 + begun);
    }
    total
}

fn percentile(sorted: &[Duration], share: f64) -> Duration {
    let at = (sorted.len() as f64 * share) as usize;
    sorted
        .get(at.min(sorted.len().saturating_sub(1)))
        .copied()
        .unwrap_or_default()
}

fn main() {
    let program = std::env::current_exe().unwrap();
    let program = program
        .parent()
        .and_then(Path::parent)
        .unwrap()
        .join("assemcad");
    let (clients, sessions) = (setting("SOAK_CLIENTS", 32), setting("SOAK_SESSIONS", 1000));
    let seed = setting("SOAK_SEED", 1);
    let there = tempfile::tempdir().unwrap();
    let assemblies = || (0..ASSEMBLIES).map(|_| Mutex::default()).collect();
    let soak = Soak {
        program,
        roots: (0..ROOTS)
            .map(|i| there.path().join(format!("root{i}")))
            .collect(),
        known: (0..ROOTS).map(|_| assemblies()).collect(),
        verdicts: Mutex::default(),
        servers_killed: AtomicUsize::new(0),
        workers_killed: AtomicUsize::new(0),
        calls: AtomicUsize::new(0),
        changes: AtomicUsize::new(0),
        refused: AtomicUsize::new(0),
    };
    let (next, done) = (AtomicUsize::new(0), AtomicBool::new(false));
    let began = Instant::now();
    let witnesses: Vec<Witness> = std::thread::scope(|scope| {
        let witnesses: Vec<_> = (0..ROOTS)
            .map(|root| {
                scope.spawn({
                    let (soak, done) = (&soak, &done);
                    move || witness(soak, root, done)
                })
            })
            .collect();
        let clients: Vec<_> = (0..clients)
            .map(|_| {
                scope.spawn(|| {
                    loop {
                        let number = next.fetch_add(1, Ordering::Relaxed);
                        if number as u64 >= sessions {
                            return;
                        }
                        soak.session(number, seed);
                    }
                })
            })
            .collect();
        let ended: Vec<_> = clients.into_iter().map(|c| c.join()).collect();
        done.store(true, Ordering::Relaxed);
        let witnesses = witnesses.into_iter().map(|w| w.join().unwrap()).collect();
        assert!(
            ended.iter().all(Result::is_ok),
            "a client found something wrong"
        );
        witnesses
    });
    let took = began.elapsed();
    // What killed servers left behind goes at the next start.
    let (mut kept, mut realized) = (0, 0);
    for root in 0..ROOTS {
        let mut session = soak.start(root);
        realized += whole(&mut session, &soak.roots[root]);
        session.close().unwrap();
        let (bytes, begun) = disk(&soak.roots[root]);
        assert_eq!(begun, 0, "files that were begun are left");
        kept += bytes;
    }
    let mut all: Vec<Duration> = witnesses.iter().flat_map(|w| w.took.clone()).collect();
    all.sort();
    let mut rows = vec![
        format!("| clients, folders, sessions, seed | {clients}, {ROOTS}, {sessions}, {seed} |"),
        format!("| elapsed | {:.0} s |", took.as_secs_f64()),
        format!(
            "| calls; refused with diagnostics | {}; {} |",
            soak.calls.into_inner(),
            soak.refused.into_inner()
        ),
        format!(
            "| answered changes; lost | {}; 0 |",
            soak.changes.into_inner()
        ),
        format!(
            "| servers, workers killed | {}, {} |",
            soak.servers_killed.into_inner(),
            soak.workers_killed.into_inner()
        ),
        format!(
            "| specifications verified; with a verdict that got better | {}; 0 |",
            soak.verdicts.into_inner().unwrap().len()
        ),
        format!(
            "| ping and list_factories: median, 95th percentile, longest ({} asked) | {:.0} ms, {:.0} ms, {:.0} ms |",
            all.len(),
            percentile(&all, 0.5).as_secs_f64() * 1e3,
            percentile(&all, 0.95).as_secs_f64() * 1e3,
            all.last().copied().unwrap_or_default().as_secs_f64() * 1e3
        ),
    ];
    for (root, w) in witnesses.iter().enumerate() {
        let at = |share: f64| {
            w.uses
                .get((w.uses.len() as f64 * share) as usize)
                .copied()
                .unwrap_or_default()
        };
        let (quarter, end) = (at(0.25), w.uses.last().copied().unwrap_or_default());
        rows.push(format!(
            "| server that lived, folder {root}: memory and descriptors after a quarter, at the end | {} MiB, {}; {} MiB, {} |",
            quarter.0, quarter.1, end.0, end.1
        ));
    }
    rows.push(format!(
        "| realisations, replaced again and again; not of one piece | {realized}; 0 |"
    ));
    rows.push(format!(
        "| on disk at the end; begun files left | {} MiB; 0 |",
        kept >> 20
    ));
    println!("| | |\n|---|---|\n{}", rows.join("\n"));
}
