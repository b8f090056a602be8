//! `assemcad`: the command line.
//!
//! Standard output belongs to the protocol; logs go to standard error.

mod calls;
mod clients_model;
mod lines;
mod message;
mod progress;
mod running;
mod serve;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

use assemcad_assembly::{DEFAULT_CACHE_MB, DEFAULT_LIMIT_S, DEFAULT_ROUNDS, Workshop};
use assemcad_factories::Registry;
use assemcad_kernel::pool::{Config, Limits, Pool};
use assemcad_kernel::worker;
use assemcad_script::worker::{self as script_worker, Evaluator};
use assemcad_workers::missing_seclusion;
use clap::{Args, Parser, Subcommand};

#[derive(Debug, Parser)]
#[command(version, about)]
struct Command {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Speaks MCP on standard input and output.
    ///
    /// Kernel and scripts run in processes that may open no file but the cache of solids, no network and no other
    /// process. That takes Linux with Landlock and seccomp; where the system lacks them, the first line of the log
    /// (standard error) says so.
    Serve(Serve),
    /// Runs the geometry kernel for a server. Started by the server; not for people.
    #[command(hide = true)]
    Worker(Worker),
    /// Evaluates factories' sources for a server. Started by the server; not for people.
    #[command(hide = true)]
    ScriptWorker(ScriptWorker),
}

#[derive(Debug, Args)]
struct Serve {
    /// Folder that holds the assemblies. Nothing outside it is written.
    #[arg(long, default_value = ".")]
    root: PathBuf,
    /// Folder with further factories, files named NAMESPACE.NAME.star.
    #[arg(long)]
    factories: Option<PathBuf>,
    /// Number of kernel processes; as many as processor cores where it is left out.
    #[arg(long)]
    workers: Option<usize>,
    /// Address space of a kernel process, in MiB.
    #[arg(long, default_value_t = Limits::default().memory_mb)]
    worker_memory_mb: u64,
    /// Processor time of one kernel request, in seconds.
    #[arg(long, default_value_t = Limits::default().cpu_s)]
    worker_cpu_s: u64,
    /// Elapsed time of one kernel request, in seconds, counted from its start.
    #[arg(long, default_value_t = Limits::default().wall_s)]
    worker_wall_s: u64,
    /// How much solids and answers about them may take on disk (ROOT/.assemcad/cache), in MiB. The longest unused go
    /// first; all of it can be made again.
    #[arg(long, default_value_t = DEFAULT_CACHE_MB)]
    cache_mb: u64,
    /// How many wrong rounds a draft has before its decomposition counts as failed.
    #[arg(long, default_value_t = DEFAULT_ROUNDS)]
    draft_rounds: usize,
    /// How many wrong sources a request for a factory has before its synthesis counts as failed.
    #[arg(long, default_value_t = DEFAULT_ROUNDS)]
    synthesis_rounds: usize,
    /// After how many seconds the trial of a factory's source begins no further set of parameters.
    #[arg(long, default_value_t = DEFAULT_LIMIT_S)]
    synthesis_s: u64,
}

#[derive(Debug, Args)]
struct Worker {
    #[arg(long)]
    memory_mb: u64,
    #[arg(long)]
    cpu_s: u64,
    #[arg(long)]
    root: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct ScriptWorker {
    #[arg(long)]
    memory_mb: u64,
    #[arg(long)]
    cpu_s: u64,
}

fn main() -> ExitCode {
    let filter = tracing_subscriber::EnvFilter::try_from_env("ASSEMCAD_LOG")
        .unwrap_or_else(|_| tracing_subscriber::EnvFilter::new("warn"));
    tracing_subscriber::fmt()
        .with_writer(std::io::stderr)
        .with_env_filter(filter)
        .init();
    let done = match Command::parse().action {
        Action::Serve(options) => serve(options),
        Action::Worker(options) => {
            let settings = worker::Settings {
                memory_mb: options.memory_mb,
                cpu_s: options.cpu_s,
                root: options.root,
            };
            worker::run(settings).map_err(|e| e.to_string())
        }
        Action::ScriptWorker(options) => {
            let limits = Limits {
                memory_mb: options.memory_mb,
                cpu_s: options.cpu_s,
                ..script_worker::LIMITS
            };
            script_worker::run(limits).map_err(|e| e.to_string())
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            tracing::error!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn serve(options: Serve) -> Result<(), String> {
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        // A verification is one future of many; unoptimised, polling it takes more than the usual 2 MB.
        .thread_stack_size(8 << 20)
        .build()
        .map_err(|e| format!("the runtime: {e}"))?;
    let served = runtime.block_on(async {
        let workshop = workshop(options).await?;
        serve::stdio(workshop).await
    });
    // A call that was left behind may be in the middle of something long: nobody waits for it any more, and its
    // workers end by themselves.
    runtime.shutdown_background();
    served
}

/// This very program, for its workers: not what somebody has put in its place since it was started, which may speak
/// another language.
fn this_program() -> std::io::Result<PathBuf> {
    // Linux has a name for it that holds even where the file is gone.
    let itself = PathBuf::from("/proc/self/exe");
    if itself.exists() {
        Ok(itself)
    } else {
        std::env::current_exe()
    }
}

/// The workshop that the options describe, with what was admitted to it before.
async fn workshop(options: Serve) -> Result<Workshop, String> {
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let workers = options.workers.unwrap_or(cores);
    let missing = missing_seclusion();
    if !missing.is_empty() {
        let missing = missing.join(" and ");
        tracing::warn!(
            "this system lacks {missing}: kernel and scripts run in processes of their own, but could reach your files \
             and network if a fault in them were abused"
        );
    }
    let program = this_program().map_err(|e| format!("where this program is: {e}"))?;
    let evaluator = Evaluator::processes(script_worker::Config {
        program: program.clone(),
        workers,
        limits: script_worker::LIMITS,
    });
    let (registry, mut faults) = Registry::load(options.factories.as_deref(), &evaluator).await;
    std::fs::create_dir_all(&options.root).map_err(|e| format!("--root: {e}"))?;
    let root = options
        .root
        .canonicalize()
        .map_err(|e| format!("--root: {e}"))?;
    let pool = Pool::new(Config {
        program,
        root: Some(root.clone()),
        workers,
        limits: Limits {
            memory_mb: options.worker_memory_mb,
            cpu_s: options.worker_cpu_s,
            wall_s: options.worker_wall_s,
        },
    });
    let mut workshop = Workshop::open(
        &root,
        registry,
        pool,
        evaluator,
        options.cache_mb.saturating_mul(1 << 20),
    )
    .map_err(|d| d.to_string())?;
    workshop.draft_rounds = options.draft_rounds;
    workshop.synthesis_rounds = options.synthesis_rounds;
    workshop.synthesis_limit = Duration::from_secs(options.synthesis_s);
    faults.extend(workshop.load_admitted().await);
    for fault in faults {
        tracing::warn!("{fault}");
    }
    Ok(workshop)
}
