//! Calls of tools, each on a thread of its own.
//!
//! The threads that speak the protocol do nothing else: a call may read a long text, follow a mechanism or shoot
//! rays for seconds without coming up for air, and a ping is answered meanwhile.

use std::collections::BTreeMap;
use std::sync::Arc;

use assemcad_assembly::{Faults, Workshop};
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_tools::{Caller, Offer, Output, Writer};
use rmcp::RoleServer;
use rmcp::service::RequestContext;
use serde_json::{Map, Value};

use crate::clients_model::ClientsModel;
use crate::progress::signs;
use crate::running::Running;

/// What calls work with.
#[derive(Debug, Clone)]
pub(crate) struct Calls {
    pub(crate) workshop: Arc<Workshop>,
    pub(crate) offers: Arc<BTreeMap<&'static str, Offer>>,
    pub(crate) running: Running,
}

impl Calls {
    /// Runs a tool that there is: when its turn has come, until it is done, taken back, or nobody reads any more.
    ///
    /// # Errors
    /// What is wrong with the arguments or with what they ask for.
    pub(crate) async fn run(
        &self,
        name: &'static str,
        given: Map<String, Value>,
        context: &RequestContext<RoleServer>,
    ) -> Result<Output, Faults> {
        let Some(_call) = self.running.start() else {
            return Err(vec![busy(name)]);
        };
        let writer = ClientsModel::of(context);
        let (words, telling) = signs(context);
        let (calls, taken_back) = (self.clone(), context.ct.clone());
        let work = async move {
            // A client that asked for no progress has nobody who listens.
            let progress = |text: &str| drop(words.send(text.to_owned()));
            let caller = Caller {
                writer: writer.as_ref().map(|w| w as &dyn Writer),
                progress: Some(&progress),
            };
            match calls.offers.get(name) {
                Some(offer) => {
                    let _turn = calls.running.turn(offer.weight).await;
                    offer.call(&calls.workshop, given, caller).await
                }
                None => Err(Faults::new()),
            }
        };
        let running = self.running.clone();
        // Dropping the work drops its workers, which ends the kernel's computation.
        let work = async move {
            tokio::select! {
                done = work => done,
                () = taken_back.cancelled() => Err(vec![ended(name, "the client cancelled the call")]),
                () = running.stopped() => Err(vec![ended(name, "nobody reads the answer")]),
            }
        };
        let runtime = tokio::runtime::Handle::current();
        let task = tokio::task::spawn_blocking(move || runtime.block_on(work));
        let done = task.await.unwrap_or_else(|e| Err(vec![broken(name, &e)]));
        // The work is gone, and so is who sends words: what it said is told first.
        let _ = telling.await;
        done
    }
}

fn ended(tool: &str, why: &str) -> Diagnostic {
    Diagnostic::error(Code::Cancelled, tool, why)
}

fn busy(tool: &str) -> Diagnostic {
    Diagnostic::error(
        Code::Busy,
        tool,
        "too many calls are waiting for their turn",
    )
    .hint("wait for some of their answers, then call again")
}

fn broken(tool: &str, e: &tokio::task::JoinError) -> Diagnostic {
    tracing::error!("{tool}: {e}");
    Diagnostic::error(
        Code::Internal,
        tool,
        "a fault of the server itself; it is in the server's log",
    )
    .hint("the assemblies on disk are as they were before this call; other calls are not affected")
}
