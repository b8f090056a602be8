//! A client that speaks the real protocol to a real child process, line by line.
//!
//! Everything that the server writes on its standard output must be JSON-RPC: a line that is not ends
//! the session with an error.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// How long a client waits for an answer.
const PATIENCE: Duration = Duration::from_secs(300);

/// A session with a server of its own.
pub struct Session {
    child: Child,
    input: Option<ChildStdin>,
    lines: Receiver<Result<Value, String>>,
    waiting: BTreeMap<u64, Value>,
    next: u64,
}

/// A tool's answer.
#[derive(Debug, Clone)]
pub struct Answer {
    /// Whether it is an error.
    pub is_error: bool,
    /// The structured content.
    pub content: Value,
    /// The blocks of content: texts and pictures.
    pub blocks: Value,
}

impl Session {
    /// Starts a server over a root folder and opens the session.
    pub fn start(program: &Path, root: &Path, options: &[&str]) -> Result<Self, String> {
        Self::spawn(program, root, options)?.open()
    }

    /// Opens the session.
    pub fn open(mut self) -> Result<Self, String> {
        let hello = self.request(
            "initialize",
            json!({
                "protocolVersion": "2025-11-25", "capabilities": {},
                "clientInfo": {"name": "harness", "version": "1"},
            }),
        )?;
        if hello.pointer("/result/serverInfo/name") != Some(&json!("assemcad")) {
            return Err(format!("not our server: {hello}"));
        }
        self.send(&json!({"jsonrpc": "2.0", "method": "notifications/initialized"}).to_string())?;
        Ok(self)
    }

    /// Starts a server without opening the session.
    pub fn spawn(program: &Path, root: &Path, options: &[&str]) -> Result<Self, String> {
        Self::of(
            Command::new(program)
                .arg("serve")
                .arg("--root")
                .arg(root)
                .args(options),
        )
    }

    /// The session of a server that is not yet started, and what it logs.
    pub fn of(command: &mut Command) -> Result<Self, String> {
        let program = PathBuf::from(command.get_program());
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|e| format!("{}: {e}", program.display()))?;
        let input = child.stdin.take();
        let output = child.stdout.take().ok_or("no standard output")?;
        let (sender, lines) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(output).lines() {
                let line = line.map_err(|e| e.to_string()).and_then(|l| rpc(&l));
                if sender.send(line).is_err() {
                    return;
                }
            }
        });
        Ok(Self {
            child,
            input,
            lines,
            waiting: BTreeMap::new(),
            next: 1,
        })
    }

    /// The server's process.
    pub fn pid(&self) -> u32 {
        self.child.id()
    }

    /// Sends a line as it is.
    pub fn send(&mut self, line: &str) -> Result<(), String> {
        self.send_bytes(line.as_bytes())
    }

    /// Sends bytes that need not be a text as a line.
    pub fn send_bytes(&mut self, line: &[u8]) -> Result<(), String> {
        let input = self.input.as_mut().ok_or("the input is closed")?;
        input.write_all(line).map_err(|e| e.to_string())?;
        input.write_all(b"\n").map_err(|e| e.to_string())?;
        input.flush().map_err(|e| e.to_string())
    }

    /// Sends a request and gives its id.
    pub fn begin(&mut self, method: &str, params: Value) -> Result<u64, String> {
        let id = self.next;
        self.next += 1;
        let request = json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params});
        self.send(&request.to_string())?;
        Ok(id)
    }

    /// Waits for the answer to a request.
    pub fn wait(&mut self, id: u64) -> Result<Value, String> {
        let until = Instant::now() + PATIENCE;
        loop {
            if let Some(answer) = self.waiting.remove(&id) {
                return Ok(answer);
            }
            let message = self.message(until.saturating_duration_since(Instant::now()))?;
            if let Some(id) = message.get("id").and_then(Value::as_u64) {
                self.waiting.insert(id, message);
            }
        }
    }

    /// The answer to a request, where it has come.
    pub fn answered(&mut self, id: u64) -> Option<Value> {
        while let Ok(Ok(message)) = self.lines.try_recv() {
            if let Some(id) = message.get("id").and_then(Value::as_u64) {
                self.waiting.insert(id, message);
            }
        }
        self.waiting.remove(&id)
    }

    /// The next message of any kind.
    pub fn message(&mut self, patience: Duration) -> Result<Value, String> {
        match self.lines.recv_timeout(patience) {
            Ok(line) => line,
            Err(RecvTimeoutError::Timeout) => Err("no answer in time".to_owned()),
            Err(RecvTimeoutError::Disconnected) => Err("the server's output has ended".to_owned()),
        }
    }

    /// Sends a request and waits for its answer.
    pub fn request(&mut self, method: &str, params: Value) -> Result<Value, String> {
        let id = self.begin(method, params)?;
        self.wait(id)
    }

    /// Begins a tool call and gives its id.
    pub fn begin_call(&mut self, tool: &str, arguments: Value) -> Result<u64, String> {
        self.begin("tools/call", json!({"name": tool, "arguments": arguments}))
    }

    /// Waits for a tool's answer.
    pub fn wait_call(&mut self, id: u64) -> Result<Answer, String> {
        let answer = self.wait(id)?;
        let result = answer
            .get("result")
            .ok_or_else(|| format!("no result: {answer}"))?;
        Ok(Answer {
            is_error: result
                .get("isError")
                .and_then(Value::as_bool)
                .unwrap_or(false),
            content: result
                .get("structuredContent")
                .cloned()
                .unwrap_or(Value::Null),
            blocks: result.get("content").cloned().unwrap_or(Value::Null),
        })
    }

    /// Calls a tool and waits for its answer.
    pub fn call(&mut self, tool: &str, arguments: Value) -> Result<Answer, String> {
        let id = self.begin_call(tool, arguments)?;
        self.wait_call(id)
    }

    /// Closes the input and waits for the server to end by itself.
    pub fn close(mut self) -> Result<(), String> {
        self.input = None;
        let until = Instant::now() + PATIENCE;
        loop {
            match self.child.try_wait().map_err(|e| e.to_string())? {
                Some(status) if status.success() => return Ok(()),
                Some(status) => return Err(format!("the server ended with {status}")),
                None if Instant::now() > until => return Err("the server goes on".to_owned()),
                None => std::thread::sleep(Duration::from_millis(10)),
            }
        }
    }

    /// Ends the server without warning, as a crash of the machine would.
    pub fn kill(mut self) -> Result<(), String> {
        self.child.kill().map_err(|e| e.to_string())?;
        self.child.wait().map(|_| ()).map_err(|e| e.to_string())
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A line as a JSON-RPC message.
fn rpc(line: &str) -> Result<Value, String> {
    let message: Value = serde_json::from_str(line)
        .map_err(|e| format!("not JSON on standard output: {line:?}: {e}"))?;
    let is_rpc = message.get("jsonrpc") == Some(&json!("2.0"))
        && ["method", "result", "error"]
            .iter()
            .any(|k| message.get(k).is_some());
    if is_rpc {
        Ok(message)
    } else {
        Err(format!("not JSON-RPC on standard output: {line:?}"))
    }
}
