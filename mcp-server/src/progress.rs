//! Signs of progress for clients that ask for them.

use std::time::Duration;

use rmcp::RoleServer;
use rmcp::model::ProgressNotificationParam;
use rmcp::service::RequestContext;
use tokio::sync::mpsc::{UnboundedSender, unbounded_channel};
use tokio::task::JoinHandle;

/// How long a call may be silent: clients drop calls that are silent for a minute.
const BETWEEN_SIGNS: Duration = Duration::from_secs(5);

/// Tells the client of a call how far it has come, in the words that the call sends, and every few seconds that
/// it is being worked on. Ends when the sender is dropped and all is told; at once where the client asked
/// for no signs.
pub(crate) fn signs(
    context: &RequestContext<RoleServer>,
) -> (UnboundedSender<String>, JoinHandle<()>) {
    let (say, mut said) = unbounded_channel();
    let (peer, token) = (context.peer.clone(), context.meta.get_progress_token());
    let telling = tokio::spawn(async move {
        let Some(token) = token else {
            return;
        };
        let mut told = 0.0;
        loop {
            let words = match tokio::time::timeout(BETWEEN_SIGNS, said.recv()).await {
                Ok(Some(words)) => words,
                Ok(None) => return,
                Err(_) => "at work".to_owned(),
            };
            told += 1.0;
            let sign = ProgressNotificationParam::new(token.clone(), told).with_message(words);
            // A client that does not listen any more is told by its connection.
            let _ = peer.notify_progress(sign).await;
        }
    });
    (say, telling)
}
