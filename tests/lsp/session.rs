//! A client for tests: it sends what a test says, and holds every message that comes against the protocol's model.

use std::collections::HashMap;
use std::io::BufReader;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

use crossbeam_channel::{Receiver, Sender, unbounded};
use lsp_server::{Message, Notification, Request, Response};
use serde_json::{Value, json};
use zpg::internals::diagnostics::Language;

use super::model::Model;

/// How long anything may take.
const TIMEOUT: Duration = Duration::from_secs(60);

pub struct Session {
    to: Sender<Message>,
    from: Receiver<Message>,
    model: Model,
    /// The methods of the requests that are not answered.
    asked: HashMap<i32, String>,
    next: i32,
    /// Notifications, and requests of the server's, that nobody has waited for yet.
    pub said: Vec<(String, Value)>,
    answers: HashMap<i32, Result<Value, Value>>,
    /// The program, where it is one of its own.
    pub child: Option<Child>,
}

/// What an editor can that can everything.
pub fn rich() -> Value {
    json!({
        "general": { "positionEncodings": ["utf-16"] },
        "textDocument": {
            "completion": { "completionItem": { "snippetSupport": true } },
            "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
            "hover": { "contentFormat": ["markdown"] },
            "codeAction": { "resolveSupport": { "properties": ["edit"] }, "dataSupport": true },
        },
        "workspace": {
            "applyEdit": true,
            "workspaceEdit": { "documentChanges": true },
            "didChangeWatchedFiles": { "dynamicRegistration": true },
            "inlayHint": { "refreshSupport": true },
            "diagnostics": { "refreshSupport": true },
        },
        "window": { "showDocument": { "support": true } },
    })
}

impl Session {
    /// A server in this program.
    pub fn start(capabilities: Value, options: Value) -> Session {
        let (to, incoming) = unbounded();
        let (sender, said) = unbounded::<String>();
        thread::spawn(move || zpg::internals::lsp::serve(&incoming, sender, Language::English));
        let (received, from) = unbounded();
        thread::spawn(move || {
            for text in said {
                let message = serde_json::from_str(&text).expect("a message");
                let _ = received.send(message);
            }
        });
        Session::begin((to, from), None, capabilities, options)
    }

    /// The server as it is installed.
    pub fn program(capabilities: Value) -> Session {
        Session::started(crate::support::program::command(), capabilities)
    }

    /// The same, as it is called.
    pub fn started(mut command: Command, capabilities: Value) -> Session {
        let mut child = command
            .arg("lsp")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (mut input, output) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
        let (to, outgoing) = unbounded::<Message>();
        let (received, from) = unbounded();
        thread::spawn(move || outgoing.iter().try_for_each(|m| m.write(&mut input)));
        thread::spawn(move || {
            let mut output = BufReader::new(output);
            while let Ok(Some(message)) = Message::read(&mut output) {
                let _ = received.send(message);
            }
        });
        Session::begin((to, from), Some(child), capabilities, Value::Null)
    }

    fn begin(
        (to, from): (Sender<Message>, Receiver<Message>),
        child: Option<Child>,
        capabilities: Value,
        options: Value,
    ) -> Session {
        let mut session = Session {
            to,
            from,
            model: Model::read(),
            asked: HashMap::new(),
            next: 0,
            said: Vec::new(),
            answers: HashMap::new(),
            child,
        };
        let params = json!({
            "processId": std::process::id(), "rootUri": null, "capabilities": capabilities,
            "initializationOptions": options,
        });
        session.ask("initialize", params);
        session.tell("initialized", json!({}));
        session
    }

    pub fn tell(&mut self, method: &str, params: Value) {
        let method = method.to_owned();
        let _ = self.to.send(Notification { method, params }.into());
    }

    /// Sends a request and does not wait.
    pub fn send(&mut self, method: &str, params: Value) -> i32 {
        self.next += 1;
        let (id, method) = (self.next, method.to_owned());
        self.asked.insert(id, method.clone());
        let request = Request {
            id: id.into(),
            method,
            params,
        };
        self.to.send(request.into()).unwrap();
        id
    }

    /// What a request is answered, or how it is refused.
    pub fn answer(&mut self, id: i32) -> Result<Value, Value> {
        loop {
            if let Some(answer) = self.answers.remove(&id) {
                return answer;
            }
            self.next_message();
        }
    }

    pub fn has_answer(&self, id: i32) -> bool {
        self.answers.contains_key(&id)
    }

    pub fn try_ask(&mut self, method: &str, params: Value) -> Result<Value, Value> {
        let id = self.send(method, params);
        self.answer(id)
    }

    pub fn ask(&mut self, method: &str, params: Value) -> Value {
        self.model
            .check_asked(method, &params)
            .unwrap_or_else(|e| panic!("the test's own: {e}"));
        (self.try_ask(method, params)).unwrap_or_else(|e| panic!("{method} is refused: {e}"))
    }

    /// The parameters of the next notification, or request of the server's, of this method.
    pub fn heard(&mut self, method: &str) -> Value {
        loop {
            if let Some(at) = self.said.iter().position(|(m, _)| m == method) {
                return self.said.remove(at).1;
            }
            self.next_message();
        }
    }

    /// The diagnostics of the version of a file.
    pub fn diagnostics(&mut self, version: i32) -> Vec<Value> {
        loop {
            let params = self.heard("textDocument/publishDiagnostics");
            if params["version"] == version {
                return params["diagnostics"].as_array().unwrap().clone();
            }
        }
    }

    fn next_message(&mut self) {
        let message = self.from.recv_timeout(TIMEOUT).expect("a message");
        let right = match message {
            Message::Response(response) => self.take(response),
            Message::Notification(n) => {
                let right = match n.method.as_str() {
                    // The value of a progress is anything.
                    "$/progress" => Ok(()),
                    method => self.model.check_call(method, &n.params, false),
                };
                self.said.push((n.method, n.params));
                right
            }
            Message::Request(r) => {
                let right = self.model.check_call(&r.method, &r.params, true);
                let response = Response {
                    id: r.id,
                    response_result: Ok(Value::Null),
                };
                let _ = self.to.send(response.into());
                self.said.push((r.method, r.params));
                right
            }
        };
        right.unwrap_or_else(|e| panic!("against the protocol: {e}"));
    }

    fn take(&mut self, response: Response) -> Result<(), String> {
        let id: i32 = response.id.to_string().parse().unwrap();
        let method = self.asked.remove(&id).expect("one answer for each request");
        let answer = response.response_result;
        let right = match &answer {
            Ok(result) if !method.starts_with("zpg/") => self.model.check_result(&method, result),
            _ => Ok(()),
        };
        let answer = answer.map_err(|e| serde_json::to_value(e).unwrap());
        self.answers.insert(id, answer);
        right
    }

    /// Opens a file, as version 1.
    pub fn open(&mut self, uri: &str, text: &str) {
        let file = json!({ "uri": uri, "languageId": "zpg", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": file }));
    }

    /// Replaces the text of a file.
    pub fn replace(&mut self, uri: &str, version: i32, text: &str) {
        let file = json!({ "uri": uri, "version": version });
        let changes = json!([{ "text": text }]);
        self.tell(
            "textDocument/didChange",
            json!({ "textDocument": file, "contentChanges": changes }),
        );
    }

    pub fn end(mut self) -> Option<i32> {
        self.ask("shutdown", Value::Null);
        self.tell("exit", Value::Null);
        let mut child = self.child.take()?;
        child.wait().unwrap().code()
    }
}
