//! The client's own model, where the client offers to run it (`sampling/createMessage`).
//!
//! Newer revisions of the protocol do not let a server ask; there, and where the client does not offer
//! it, there is no such model and the agent does the writing. The request is made by its name: the
//! protocol's library has marked its types for it as things of the past.

use assemcad_tools::Writer;
use futures::future::BoxFuture;
use rmcp::RoleServer;
use rmcp::model::{CustomRequest, ServerRequest};
use rmcp::service::{Peer, RequestContext};
use serde_json::{Value, json};

/// The most that the model may write, in its tokens.
const MOST_TOKENS: u32 = 16_000;

/// The model of the client at the other end.
#[derive(Debug)]
pub(crate) struct ClientsModel {
    peer: Peer<RoleServer>,
}

impl ClientsModel {
    /// The model, where the client said when the session began that it can be asked.
    pub(crate) fn of(context: &RequestContext<RoleServer>) -> Option<Self> {
        let client = serde_json::to_value(context.peer.peer_info()?.as_ref()).ok()?;
        let offered = client.pointer("/capabilities/sampling")?.is_object();
        offered.then(|| Self {
            peer: context.peer.clone(),
        })
    }
}

impl Writer for ClientsModel {
    fn write(&self, prompt: String) -> BoxFuture<'_, Result<String, String>> {
        Box::pin(async move {
            let params = json!({
                "messages": [{"role": "user", "content": {"type": "text", "text": prompt}}],
                "maxTokens": MOST_TOKENS,
            });
            let request = CustomRequest::new("sampling/createMessage", Some(params));
            let answer = self
                .peer
                .send_request(ServerRequest::CustomRequest(request))
                .await;
            let answer = answer.map_err(|_| "the client refused the request".to_owned())?;
            let answer = serde_json::to_value(answer).unwrap_or_default();
            text_of(&answer).ok_or_else(|| "its answer holds no text".to_owned())
        })
    }
}

/// The text of an answer: of its one block, or of the first that is a text.
fn text_of(answer: &Value) -> Option<String> {
    let content = answer.get("content")?;
    let text = |block: &Value| block.get("text").and_then(Value::as_str).map(str::to_owned);
    match content {
        Value::Array(blocks) => blocks.iter().find_map(text),
        block => text(block),
    }
}
