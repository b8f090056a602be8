//! What a worker process cannot do, tried from inside one.
//!
//! This program is both sides: called as a worker, it tries what it is told to; called as a test, it starts such
//! workers. So it has no harness of the usual kind.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    clippy::indexing_slicing
)]

use std::ffi::OsString;
use std::io::Read;
use std::net::{TcpListener, UdpSocket};
use std::os::unix::net::{UnixListener, UnixStream};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use assemcad_workers::{
    Config, FailureKind, Handler, Keeps, Limits, Pool, Refusal, Tell, Work, missing_seclusion,
    serve,
};
use serde::{Deserialize, Serialize};

struct Trying;

/// What is tried.
#[derive(Debug, Clone, Serialize, Deserialize)]
enum Attempt {
    Read(PathBuf),
    Write(PathBuf),
    List(PathBuf),
    Remove(PathBuf),
    Connect(PathBuf),
    Tcp,
    Udp,
    Process,
    Fork,
    Signal(u32),
    Environment,
    Thread,
    Memory,
    Claim(u32),
    Sleep,
}

impl Work for Trying {
    type Job = Attempt;
    type Reply = Result<String, String>;
    const SUBCOMMAND: &'static str = "try";
    fn name(_: &Attempt) -> &'static str {
        "an attempt"
    }
}

struct Worker;

impl Handler<Trying> for Worker {
    fn work(
        &mut self,
        job: &Attempt,
        _tell: Tell<'_>,
    ) -> Result<(Result<String, String>, Vec<u8>), Refusal> {
        let done = attempt(job).map_err(|e| e.to_string());
        Ok((done, Vec::new()))
    }
}

fn attempt(what: &Attempt) -> std::io::Result<String> {
    let done = |()| "done".to_owned();
    match what {
        Attempt::Read(path) => std::fs::read_to_string(path),
        Attempt::Write(path) => std::fs::write(path, "x").map(done),
        Attempt::List(path) => std::fs::read_dir(path).map(|all| all.count().to_string()),
        Attempt::Remove(path) => std::fs::remove_file(path).map(done),
        Attempt::Connect(path) => UnixStream::connect(path).map(|_| done(())),
        Attempt::Tcp => TcpListener::bind("127.0.0.1:0").map(|_| done(())),
        Attempt::Udp => UdpSocket::bind("127.0.0.1:0").map(|_| done(())),
        Attempt::Process => Command::new("/bin/true").status().map(|s| s.to_string()),
        Attempt::Fork => {
            // With a user of its own the library forks, where it has quicker ways otherwise.
            let user = rustix::process::getuid().as_raw();
            let child = Command::new("/bin/true").uid(user).spawn();
            child.map(|c| c.id().to_string())
        }
        Attempt::Signal(pid) => {
            let pid = i32::try_from(*pid)
                .ok()
                .and_then(rustix::process::Pid::from_raw);
            rustix::process::test_kill_process(pid.unwrap())?;
            Ok(done(()))
        }
        Attempt::Environment => {
            let names = std::env::vars_os().map(|(name, _)| name);
            Ok(format!("{:?}", names.collect::<Vec<OsString>>()))
        }
        Attempt::Thread => {
            let thread = std::thread::Builder::new().spawn(|| 6 * 7)?;
            Ok(thread.join().unwrap().to_string())
        }
        Attempt::Memory => {
            let mut text = String::new();
            std::fs::File::open("/proc/self/statm")?.read_to_string(&mut text)?;
            Ok(text)
        }
        Attempt::Claim(length) => {
            // A message that says it is long, and is not.
            let mut head = length.to_le_bytes().to_vec();
            head.extend(length.to_le_bytes());
            rustix::io::write(rustix::stdio::stdin(), &head)?;
            std::thread::sleep(Duration::from_secs(60));
            Ok(done(()))
        }
        Attempt::Sleep => {
            std::thread::sleep(Duration::from_secs(60));
            Ok(done(()))
        }
    }
}

fn pool(folder: &str, wall_s: u64) -> Pool<Trying> {
    Pool::new(Config {
        program: std::env::current_exe().unwrap(),
        arguments: vec![folder.into()],
        workers: 1,
        limits: Limits {
            memory_mb: 512,
            cpu_s: 20,
            wall_s,
        },
    })
}

async fn tried(pool: &Pool<Trying>, what: Attempt) -> Result<String, String> {
    pool.run(&what).await.unwrap().0
}

async fn nothing_of_the_users() {
    let there = tempfile::tempdir().unwrap();
    let (own, other) = (there.path().join("own"), there.path().join("other"));
    for folder in [&own, &other] {
        std::fs::create_dir(folder).unwrap();
        std::fs::write(folder.join("file"), "secret").unwrap();
    }
    std::os::unix::fs::symlink(other.join("file"), own.join("link")).unwrap();
    let _listener = UnixListener::bind(other.join("socket")).unwrap();
    for keeps in ["", own.to_str().unwrap()] {
        let pool = pool(keeps, 30);
        let home = Path::new("/etc/passwd").to_owned();
        for refused in [
            Attempt::Read(home),
            Attempt::Read(other.join("file")),
            Attempt::Read(own.join("link")),
            Attempt::Read("/proc/1/status".into()),
            Attempt::Write(other.join("new")),
            Attempt::List(other.clone()),
            Attempt::Remove(other.join("file")),
            Attempt::Connect(other.join("socket")),
            Attempt::Tcp,
            Attempt::Udp,
            Attempt::Process,
            Attempt::Fork,
            Attempt::Signal(std::process::id()),
        ] {
            let answer = tried(&pool, refused.clone()).await;
            assert!(answer.is_err(), "{refused:?}: {answer:?}");
        }
        assert_eq!(tried(&pool, Attempt::Thread).await, Ok("42".to_owned()));
        let names = tried(&pool, Attempt::Environment).await.unwrap();
        assert!(
            !names.contains("HOME") && !names.contains("\"PATH\""),
            "{names}"
        );
        let own_files = [
            tried(&pool, Attempt::Read(own.join("file"))).await,
            tried(&pool, Attempt::Write(own.join("new"))).await,
            tried(&pool, Attempt::Memory).await,
        ];
        for answer in own_files {
            assert_eq!(answer.is_ok(), !keeps.is_empty(), "{answer:?}");
        }
    }
    assert_eq!(
        std::fs::read_to_string(other.join("file")).unwrap(),
        "secret"
    );
}

async fn what_a_worker_claims_is_not_believed() {
    let pool = pool("", 3);
    for (length, kind) in [
        (u32::MAX, FailureKind::Worker),
        (1 << 29, FailureKind::Worker),
    ] {
        let failure = pool.run(&Attempt::Claim(length)).await.unwrap_err();
        assert_eq!(failure.kind, kind, "{failure:?}");
    }
    // One that may be true is waited for, and costs no memory before it comes.
    let before = resident();
    let failure = pool.run(&Attempt::Claim(1 << 25)).await.unwrap_err();
    assert_eq!(failure.kind, FailureKind::Wall, "{failure:?}");
    assert!(
        resident() < before + (8 << 20),
        "{} and {before}",
        resident()
    );
}

fn resident() -> u64 {
    let text = std::fs::read_to_string("/proc/self/statm").unwrap();
    text.split_whitespace()
        .nth(1)
        .unwrap()
        .parse::<u64>()
        .unwrap()
        * 4096
}

async fn a_worker_ends_with_its_server() {
    // A server of its own, which is killed in the middle of a job.
    let mut server = Command::new(std::env::current_exe().unwrap())
        .arg("server")
        .spawn()
        .unwrap();
    let children = format!("/proc/{0}/task/{0}/children", server.id());
    let until = Instant::now() + Duration::from_secs(20);
    let worker = loop {
        let list = std::fs::read_to_string(&children).unwrap();
        if let Some(pid) = list.split_whitespace().next() {
            break pid.to_owned();
        }
        assert!(Instant::now() < until, "no worker came");
        std::thread::sleep(Duration::from_millis(20));
    };
    std::thread::sleep(Duration::from_millis(500));
    server.kill().unwrap();
    server.wait().unwrap();
    let until = Instant::now() + Duration::from_secs(5);
    let lives = || {
        let stat = std::fs::read_to_string(format!("/proc/{worker}/stat")).unwrap_or_default();
        !stat.is_empty() && !stat.contains(") Z ")
    };
    while lives() {
        assert!(Instant::now() < until, "the worker outlived its server");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let runtime = || {
        let mut builder = tokio::runtime::Builder::new_current_thread();
        builder.enable_all().build().unwrap()
    };
    match arguments.get(1).map(String::as_str) {
        Some("try") => {
            let folder = arguments.get(6).filter(|f| !f.is_empty());
            let keeps = Keeps {
                folders: folder
                    .iter()
                    .map(|f| std::fs::File::open(f).unwrap().into())
                    .collect(),
                read: folder.iter().map(|_| "/proc/self".into()).collect(),
            };
            let limits = Limits {
                memory_mb: 512,
                cpu_s: 20,
                wall_s: 30,
            };
            let _ = serve::<Trying>(limits, &keeps, Worker);
        }
        Some("server") => {
            let _ = runtime().block_on(pool("", 60).run(&Attempt::Sleep));
        }
        _ => {
            let missing = missing_seclusion();
            if !missing.is_empty() {
                println!("this system lacks {missing:?}: nothing to be tried");
                return;
            }
            runtime().block_on(async {
                nothing_of_the_users().await;
                what_a_worker_claims_is_not_believed().await;
                a_worker_ends_with_its_server().await;
            });
            println!("test result: ok. workers reach nothing of the user's");
        }
    }
}
