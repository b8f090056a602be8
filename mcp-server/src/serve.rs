//! The tools over MCP. The only place that knows the protocol's library.

use std::sync::Arc;

use assemcad_assembly::Workshop;
use assemcad_model::diagnostic::{Code, Diagnostic};
use assemcad_model::name::nearest;
use assemcad_model::param::clip;
use assemcad_tools::{Effect, Offer, Output, prompts};
use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, ClientNotification, ClientRequest,
    ContentBlock, CustomRequest, CustomResult, ErrorCode, GetPromptRequestParams,
    GetPromptResponse, GetPromptResult, Implementation, ListPromptsResult, ListToolsResult,
    PaginatedRequestParams, Prompt, PromptArgument, PromptMessage, Role, ServerCapabilities,
    ServerConfig, ServerResult, Tool, ToolAnnotations,
};
use rmcp::service::{NotificationContext, RequestContext, Service};
use rmcp::transport::stdio as streams;
use rmcp::{ErrorData, RoleServer, ServerHandler, ServiceExt};
use serde_json::json;

use crate::calls::Calls;
use crate::lines;
use crate::running::Running;

/// What a model reads before it sees any tool; clients cut it at 2 KiB.
const INSTRUCTIONS: &str = "assemcad builds mechanical assemblies that are checked: typed parts with \
real dimensions, joined port to port by mates, verified, exported as STEP (AP242).\n\
The main road is one text and one call: write the whole assembly as YAML (assembly: {id, parts: [{id, \
factory, params}], mates: [{id, mate_type, base: {ref, port}, incoming: {ref, port}, options, axioms}]}), \
have it checked by validate_draft, which tells every error at once with its line, mend it, and call \
realize, which builds, places, verifies and exports it, all or nothing. A machine of 17 parts is one \
text, not forty calls. The prompt 'decompose' holds the format, the factories and the mates; \
list_factories and describe_factory tell parameters and ports, find_axioms the engineering rules that \
each mate cites and verify checks. For a part that no factory makes, synthesize_factory admits a \
source that you write, on evidence (prompts 'synthesize' and 'repair').\n\
The fine-grained tools (new_assembly, add_part, mate, remove, verify, export_step) are for changes to \
what is there. Every change is on disk when it is answered; assemblies of earlier sessions are there \
(list_assemblies, get_assembly). Look at what was built: render draws it, measure tells distances, \
angles, boxes, masses.\n\
Units: millimetres and degrees. A port's z points out of the material: a face's outward normal, a \
hole's way out of its mouth, a shaft's way out of its end. Tools write ports as part:port.\n\
A call that cannot be done answers with diagnostics, each with the place, the value found, the values \
possible and often the next call to make; nothing is changed then. A verdict is pass, fail or \
indeterminate; a report also says what was not checked.";

/// Serves a workshop on standard input and output until the input ends.
///
/// # Errors
/// When the protocol cannot be spoken.
pub(crate) async fn stdio(workshop: Workshop) -> Result<(), String> {
    // A picture of 2000 pixels takes some hundred megabytes, and one long trial is not to hold up all else.
    let running = Running::new(workshop.door.asker().processes().clamp(2, 8));
    let (input, output) = streams();
    let (stream, writing) = lines::around(input, output, running.clone(), lines::is_read);
    let service = Worded(Server::new(workshop, running))
        .serve(stream)
        .await
        .map_err(|e| format!("the session did not start: {e}"))?;
    service
        .waiting()
        .await
        .map_err(|e| format!("the session broke off: {e}"))?;
    match writing.await {
        Ok(written) => written.map_err(|e| format!("the output broke off: {e}")),
        Err(e) => Err(format!("the output broke off: {e}")),
    }
}

struct Server {
    calls: Calls,
    tools: Vec<Tool>,
}

impl Server {
    fn new(workshop: Workshop, running: Running) -> Self {
        let offers = assemcad_tools::all();
        let tools = offers.iter().map(tool).collect();
        let offers = offers.into_iter().map(|o| (o.name, o)).collect();
        Self {
            calls: Calls {
                workshop: Arc::new(workshop),
                offers: Arc::new(offers),
                running,
            },
            tools,
        }
    }
}

fn tool(offer: &Offer) -> Tool {
    let annotations = ToolAnnotations::from_raw(
        Some(offer.title.to_owned()),
        Some(offer.effect == Effect::Reads),
        Some(offer.effect == Effect::Removes),
        Some(true),
        Some(false),
    );
    let tool = Tool::new(
        offer.name,
        offer.description,
        Arc::new(offer.input_schema.clone()),
    )
    .with_title(offer.title)
    .with_annotations(annotations);
    match &offer.output_schema {
        Some(schema) => tool.with_raw_output_schema(Arc::new(schema.clone())),
        None => tool,
    }
}

fn answered(output: Output) -> CallToolResult {
    match output {
        Output::Object(answer) => CallToolResult::structured(answer),
        // Without structured content: clients that find some show nothing else to the model.
        Output::Picture(picture) => CallToolResult::success(vec![
            ContentBlock::text(picture.caption),
            ContentBlock::image(BASE64.encode(picture.png), "image/png"),
        ]),
    }
}

impl ServerHandler for Server {
    fn get_info(&self) -> ServerConfig {
        let capabilities = ServerCapabilities::builder()
            .enable_tools()
            .enable_prompts()
            .build();
        ServerConfig::new(capabilities)
            .with_server_info(
                Implementation::new("assemcad", env!("CARGO_PKG_VERSION")).with_title("assemcad"),
            )
            .with_instructions(INSTRUCTIONS)
    }

    async fn list_tools(
        &self,
        _request: Option<PaginatedRequestParams>,
        _context: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        Ok(ListToolsResult::with_all_items(self.tools.clone()))
    }

    fn get_tool(&self, name: &str) -> Option<Tool> {
        self.tools.iter().find(|t| t.name == name).cloned()
    }

    /// What the library could not read as any request that it knows.
    async fn on_custom_request(
        &self,
        request: CustomRequest,
        _context: RequestContext<RoleServer>,
    ) -> Result<CustomResult, ErrorData> {
        let method = clip(&request.method);
        Err(match method.as_str() {
            "tools/call" => ErrorData::invalid_params(
                "the parameters of tools/call are {\"name\": a tool's name, \"arguments\": an object}",
                Some(json!({"tools": self.calls.offers.keys().collect::<Vec<_>>()})),
            ),
            "tools/list" | "prompts/list" | "prompts/get" | "initialize" | "ping" => {
                ErrorData::invalid_params(
                    format!("the parameters of {method} could not be read"),
                    None,
                )
            }
            _ => no_method(&method),
        })
    }

    async fn list_prompts(
        &self,
        _request: Option<PaginatedRequestParams>,
        _context: RequestContext<RoleServer>,
    ) -> Result<ListPromptsResult, ErrorData> {
        let prompt = |p: &prompts::Prompt| {
            let arguments = p.arguments.iter().map(|a| {
                PromptArgument::new(a.name)
                    .with_description(a.description)
                    .with_required(true)
            });
            Prompt::new(p.name, Some(p.description), Some(arguments.collect())).with_title(p.title)
        };
        let all = prompts::ALL.iter().map(prompt).collect();
        Ok(ListPromptsResult::with_all_items(all))
    }

    async fn get_prompt(
        &self,
        request: GetPromptRequestParams,
        _context: RequestContext<RoleServer>,
    ) -> Result<GetPromptResponse, ErrorData> {
        let Some(prompt) = prompts::ALL.iter().find(|p| p.name == request.name) else {
            let names: Vec<&str> = prompts::ALL.iter().map(|p| p.name).collect();
            return Err(ErrorData::invalid_params(
                format!("there is no prompt '{}'", clip(&request.name)),
                Some(json!({"expected": names})),
            ));
        };
        let given = request.arguments.unwrap_or_default();
        let text = prompt
            .text(&self.calls.workshop, &given)
            .await
            .map_err(|d| ErrorData::invalid_params(d.to_string(), Some(json!(d))))?;
        let message = PromptMessage::new_text(Role::User, text);
        let result = GetPromptResult::new(vec![message]).with_description(prompt.description);
        Ok(result.into())
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        let Some((name, _)) = self.calls.offers.get_key_value(request.name.as_ref()) else {
            return Err(self.unknown(&request.name));
        };
        let given = request.arguments.unwrap_or_default();
        Ok(match self.calls.run(name, given, &context).await {
            Ok(output) => answered(output),
            Err(faults) => CallToolResult::structured_error(json!({"diagnostics": faults})),
        }
        .into())
    }
}

impl Server {
    /// The protocol has an error for this; the diagnostic goes with it.
    fn unknown(&self, name: &str) -> ErrorData {
        let names: Vec<&str> = self.calls.offers.keys().copied().collect();
        let near = nearest(name, names.iter().copied(), 1).first().copied();
        let message = format!("there is no tool '{}'", clip(name));
        let d = Diagnostic::error(Code::ToolUnknown, "name", message.as_str())
            .found(name)
            .expected(json!(names));
        let d = match near {
            Some(near) => d.hint(format!("did you mean '{near}'?")),
            None => d,
        };
        let message = match &d.hint {
            Some(hint) => format!("{message}; {hint}"),
            None => message,
        };
        ErrorData::invalid_params(message, Some(json!(d)))
    }
}

/// The server as the library calls it. Where the library itself says that there is no such method, it says no more
/// than the method's name; here it is told in words.
struct Worded(Server);

impl Service<RoleServer> for Worded {
    async fn handle_request(
        &self,
        request: ClientRequest,
        context: RequestContext<RoleServer>,
    ) -> Result<ServerResult, ErrorData> {
        let answer = self.0.handle_request(request, context).await;
        answer.map_err(|e| {
            let bare = !e.message.contains(' ');
            if e.code == ErrorCode::METHOD_NOT_FOUND && bare {
                no_method(&e.message)
            } else {
                e
            }
        })
    }

    async fn handle_notification(
        &self,
        notification: ClientNotification,
        context: NotificationContext<RoleServer>,
    ) -> Result<(), ErrorData> {
        self.0.handle_notification(notification, context).await
    }

    fn get_info(&self) -> ServerConfig {
        ServerHandler::get_info(&self.0)
    }
}

fn no_method(method: &str) -> ErrorData {
    ErrorData::new(
        ErrorCode::METHOD_NOT_FOUND,
        format!(
            "this server does not support the method '{}' in this revision of the protocol: it has tools and prompts",
            clip(method)
        ),
        Some(
            json!({"methods": ["tools/list", "tools/call", "prompts/list", "prompts/get", "ping"]}),
        ),
    )
}
