//! The language server: messages of the [protocol](https://microsoft.github.io/language-server-protocol/) come
//! in, answers of [`features`](crate::features) go out.
//!
//! One thread handles messages and keeps the open files ([`documents`]). It takes all messages that have arrived before
//! it sends diagnostics, so that several edits count as one. Requests are answered from the files as they are at that
//! moment by two other threads ([`requests`]), in their order; slow requests have a thread each. Diagnostics have a
//! thread ([`publish`]), pictures have theirs ([`drawing`]), and longer commands run as programs ([`programs`]). Thus
//! nothing waits for a picture. A request that fails gets an error as its answer.
//!
//! Most protocol types are made in [`convert`], all positions in [`position`].

mod ask;
mod capabilities;
mod client;
mod commenting;
mod convert;
mod did_change;
mod documents;
mod drawing;
mod outgoing;
mod parent;
mod position;
mod programs;
mod publish;
mod pull;
mod refusal;
mod requests;
mod stdio;
mod tokens_sent;
mod told;
mod uri;
mod whole_file;
mod workspace;

use std::collections::HashMap;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crossbeam_channel::{Receiver, Sender, unbounded};
use gen_lsp_types::{
    DidChangeConfigurationParams, DidChangeWatchedFilesParams, DidChangeWorkspaceFoldersParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, InitializeResult, ServerInfo, Uri,
};
use lsp_server::{ErrorCode, Message, Notification, Request, RequestId};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use ask::Ask;
use client::{Client, Preferences};
use did_change::DidChange;
use documents::Documents;
use outgoing::Outgoing;
use publish::News;
use refusal::{Refusal, refusal};
use requests::Lane;
use tokens_sent::TokensSent;
use told::Told;

use crate::allocator;
use crate::diagnostics::Language;

/// The way in which a session ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The client asked for the end, with `shutdown` and `exit`.
    Clean,
    /// The client vanished, or said `exit` without `shutdown`.
    Early,
}

/// Serves one client on standard input and output.
///
/// # Errors
///
/// The output cannot be written to.
pub fn run(language: Language) -> io::Result<Ending> {
    allocator::keep(KEPT_BYTES);
    let (incoming, sender, writer) = stdio::connect();
    let ending = serve(&incoming, sender, language);
    programs::remove_pages();
    // The last answers have some time to be written. After that, nobody reads them any more.
    let end = Instant::now() + LAST_WORDS;
    while !writer.is_finished() && Instant::now() < end {
        thread::sleep(Duration::from_millis(1));
    }
    match writer.is_finished() {
        true => writer.join().unwrap_or(Ok(())).map(|()| ending),
        false => Ok(ending),
    }
}

/// The size up to which freed blocks of memory are kept for the next edit, which needs as much again.
pub const KEPT_BYTES: usize = 31 << 20;

/// The time that writing the last answers may take.
const LAST_WORDS: Duration = Duration::from_secs(1);

/// Serves one client until it is gone. `sender` gets the messages to the client, as JSON.
pub fn serve(incoming: &Receiver<Message>, sender: Sender<String>, language: Language) -> Ending {
    let Some(mut server) = Server::begin(incoming, sender, language) else {
        return Ending::Early;
    };
    let ending = server.serve(incoming);
    // Programs that are still running end, too.
    server.pending.stop_all();
    ending
}

/// The requests that are not answered yet. The thread that takes a request out has to answer it.
#[derive(Clone, Default)]
struct Pending(Arc<Mutex<HashMap<RequestId, Waiting>>>);

struct Waiting {
    cancelled: Arc<AtomicBool>,
    /// For a picture, the file that it shows: an edit of the file makes the picture pointless.
    drawn: Option<Uri>,
}

impl Pending {
    fn take(&self, id: &RequestId) -> Option<Waiting> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.remove(id)
    }

    fn add(&self, id: RequestId, waiting: Waiting) {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.insert(id, waiting);
    }

    /// Stops all work: nobody waits for an answer any more.
    fn stop_all(&self) {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        for waiting in all.values() {
            waiting.cancelled.store(true, Ordering::Relaxed);
        }
    }

    /// The IDs of the requests for pictures of a file.
    fn drawing(&self, uri: &Uri) -> Vec<RequestId> {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let of = all.iter().filter(|(_, w)| w.drawn.as_ref() == Some(uri));
        of.map(|(id, _)| id.clone()).collect()
    }
}

type Job = Box<dyn FnOnce() + Send>;

/// The number of threads that answer quick requests.
const ANSWERING: usize = 2;

struct Server {
    client: Arc<Client>,
    preferences: Preferences,
    folders: Vec<Uri>,
    documents: Documents,
    /// Files whose diagnostics are to be sent.
    changed: Vec<Uri>,
    outgoing: Outgoing,
    news: Sender<News>,
    jobs: Sender<Job>,
    pending: Pending,
    tokens_sent: Arc<TokensSent>,
    told: Arc<Told>,
    is_shut_down: bool,
}

impl Server {
    /// Exchanges capabilities with the client. `None` if the client is gone before that.
    fn begin(
        incoming: &Receiver<Message>,
        sender: Sender<String>,
        language: Language,
    ) -> Option<Server> {
        let (id, sent) = first_request(incoming, &sender)?;
        let client = Arc::new(Client::of(&sent, language));
        let result = InitializeResult {
            capabilities: capabilities::capabilities(&client),
            server_info: Some(ServerInfo {
                name: "zpg".to_owned(),
                version: Some(env!("CARGO_PKG_VERSION").to_owned()),
            }),
        };
        let outgoing = Outgoing::new(sender, client.shows_documents);
        outgoing.send(outgoing::answer(&id, result).ok()?);
        let pending = Pending::default();
        if let Some(process) = client.process {
            let pending = pending.clone();
            parent::end_with(process, move || {
                pending.stop_all();
                thread::sleep(LAST_WORDS);
                programs::remove_pages();
            });
        }
        let mut preferences = Preferences::default();
        if let Some(options) = sent.get("initializationOptions") {
            preferences.read(options);
        }
        Some(Server {
            news: publish::start(client.clone(), outgoing.clone()),
            jobs: start_answering(),
            client,
            preferences,
            folders: client::folders(&sent),
            documents: Documents::default(),
            changed: Vec::new(),
            outgoing,
            pending,
            tokens_sent: Arc::default(),
            told: Arc::default(),
            is_shut_down: false,
        })
    }

    /// Takes messages until the session is over.
    fn serve(&mut self, incoming: &Receiver<Message>) -> Ending {
        while let Ok(first) = incoming.recv() {
            // All waiting messages come first, so that diagnostics are sent for the latest texts only.
            for message in std::iter::once(first).chain(incoming.try_iter()) {
                if let Some(ending) = self.take(message) {
                    return ending;
                }
            }
            self.publish();
        }
        Ending::Early
    }

    /// Handles a message. Returns the ending if the session is over.
    fn take(&mut self, message: Message) -> Option<Ending> {
        match message {
            Message::Request(request) if self.is_shut_down => {
                let error = refusal(ErrorCode::InvalidRequest, "the server is shut down");
                self.refuse(&request.id, &error);
            }
            Message::Request(request) if request.method == "shutdown" => {
                self.is_shut_down = true;
                if let Ok(answer) = outgoing::answer(&request.id, Value::Null) {
                    self.outgoing.send(answer);
                }
            }
            Message::Request(request) if request.method == INITIALIZE => {
                let error = refusal(ErrorCode::InvalidRequest, "the server is initialized");
                self.refuse(&request.id, &error);
            }
            Message::Request(request) => self.answer(request),
            Message::Notification(notification) if notification.method == "exit" => {
                return Some(match self.is_shut_down {
                    true => Ending::Clean,
                    false => Ending::Early,
                });
            }
            Message::Notification(notification) => self.note(notification),
            // The server does not depend on the client's answers.
            Message::Response(_) => {}
        }
        None
    }

    fn refuse(&self, id: &RequestId, error: &Refusal) {
        self.outgoing.send(outgoing::refused(id, error));
    }

    /// Has a request answered: quick requests by the threads for these, slow requests by a new thread.
    fn answer(&mut self, Request { id, method, params }: Request) {
        let Some((lane, handler)) = requests::handler(&method) else {
            let error = refusal(ErrorCode::MethodNotFound, format!("there is no {method}"));
            self.refuse(&id, &error);
            return;
        };
        let cancelled = Arc::new(AtomicBool::new(false));
        let drawn = (method == "zpg/preview")
            .then(|| params.pointer("/textDocument/uri")?.as_str().map(Uri::from));
        let waiting = Waiting {
            cancelled: cancelled.clone(),
            drawn: drawn.flatten(),
        };
        self.pending.add(id.clone(), waiting);
        let ask = Ask {
            files: self.documents.snapshots(),
            not_open: OnceLock::new(),
            client: self.client.clone(),
            preferences: self.preferences.clone(),
            folders: self.folders.clone(),
            outgoing: self.outgoing.clone(),
            tokens_sent: self.tokens_sent.clone(),
            told: self.told.clone(),
            changes: self.documents.changes,
            cancelled,
        };
        let pending = self.pending.clone();
        let job = move || {
            if ask.is_cancelled() {
                return;
            }
            let answered = catch_unwind(AssertUnwindSafe(|| handler(&ask, &id, params)));
            let answer = answered.unwrap_or_else(|_| {
                let message = format!("zpg has made a mistake in {method}");
                Err(refusal(ErrorCode::InternalError, message))
            });
            if pending.take(&id).is_some() {
                let refused = |why| outgoing::refused(&id, &why);
                ask.outgoing.send(answer.unwrap_or_else(refused));
            }
        };
        match lane {
            Lane::Quick => drop(self.jobs.send(Box::new(job))),
            Lane::Slow => drop(thread::spawn(job)),
        }
    }

    /// Refuses a request that is not answered yet, and stops the work on it.
    fn cancel(&self, id: RequestId, code: ErrorCode) {
        if let Some(waiting) = self.pending.take(&id) {
            waiting.cancelled.store(true, Ordering::Relaxed);
            self.refuse(&id, &refusal(code, "cancelled"));
        }
    }

    /// Handles a notification. One that cannot be understood is ignored.
    fn note(&mut self, notification: Notification) {
        let Notification { method, params } = notification;
        match method.as_str() {
            "initialized" if self.client.watches_files => {
                let watched = watched_files();
                self.outgoing.request("client/registerCapability", watched);
            }
            "textDocument/didOpen" => {
                if let Some(p) = self.read::<DidOpenTextDocumentParams>(&method, params) {
                    let file = p.text_document;
                    self.changed.push(file.uri.clone());
                    self.tokens_sent.open(&file.uri);
                    self.documents.open(file.uri, file.version, file.text);
                }
            }
            "textDocument/didChange" => {
                if let Some(p) = self.read::<DidChange>(&method, params) {
                    let file = p.text_document;
                    let uri = file.text_document_identifier.uri;
                    let (version, units) = (file.version, self.client.units);
                    if self
                        .documents
                        .change(&uri, version, &p.content_changes, units)
                    {
                        for id in self.pending.drawing(&uri) {
                            self.cancel(id, ErrorCode::ContentModified);
                        }
                        self.changed.push(uri);
                    }
                }
            }
            "textDocument/didClose" => {
                if let Some(p) = self.read::<DidCloseTextDocumentParams>(&method, params) {
                    let uri = p.text_document.uri;
                    self.documents.close(&uri);
                    self.tokens_sent.forget(&uri);
                    self.changed.retain(|other| *other != uri);
                    if !self.client.pulls {
                        let _ = self.news.send(News::Closed(uri));
                    }
                }
            }
            "workspace/didChangeConfiguration" => {
                if let Some(p) = self.read::<DidChangeConfigurationParams>(&method, params) {
                    self.preferences.read(&p.settings);
                    if self.client.refreshes_hints {
                        self.outgoing
                            .request("workspace/inlayHint/refresh", Value::Null);
                    }
                }
            }
            "workspace/didChangeWatchedFiles" => {
                if let Some(p) = self.read::<DidChangeWatchedFilesParams>(&method, params) {
                    p.changes.iter().for_each(|c| self.file_has_changed(&c.uri));
                }
                if self.client.pulls && self.client.refreshes_diagnostics {
                    self.outgoing
                        .request("workspace/diagnostic/refresh", Value::Null);
                }
            }
            "workspace/didChangeWorkspaceFolders" => {
                if let Some(p) = self.read::<DidChangeWorkspaceFoldersParams>(&method, params) {
                    let gone = |uri: &Uri| p.event.removed.iter().any(|f| f.uri == *uri);
                    self.folders.retain(|uri| !gone(uri));
                    self.folders
                        .extend(p.event.added.into_iter().map(|f| f.uri));
                }
            }
            "$/cancelRequest" => {
                let id = params.get("id").cloned();
                if let Some(id) = id.and_then(|id| serde_json::from_value(id).ok()) {
                    self.cancel(id, ErrorCode::RequestCanceled);
                }
            }
            _ => {}
        }
    }

    /// The parameters of a notification. If they cannot be understood, the client gets a warning: nobody waits for an
    /// answer that could be an error.
    fn read<P: DeserializeOwned>(&self, method: &str, params: Value) -> Option<P> {
        let why = match serde_json::from_value(params) {
            Ok(params) => return Some(params),
            Err(why) => why.to_string(),
        };
        let values = [("method", method.to_owned().into()), ("reason", why.into())];
        let message = self.client.language.say("lsp-unreadable", &values);
        self.outgoing.log_warning(&message);
        None
    }

    /// Handles a change on disk: a file that is not open, settings or a picture, was written or deleted.
    fn file_has_changed(&mut self, uri: &Uri) {
        let path = uri::path_of(uri).unwrap_or_default();
        let is_picture = workspace::PICTURES
            .iter()
            .any(|&e| path.extension().is_some_and(|own| own == e));
        match path.file_name().and_then(|name| name.to_str()) {
            Some(name) if is_picture => self.changed.extend(self.documents.forget_picture(name)),
            _ => {
                self.documents.forget_configs();
                self.changed = self.documents.uris();
            }
        }
    }

    /// Has the diagnostics of the changed files sent, unless the client asks for diagnostics itself.
    fn publish(&mut self) {
        let mut changed = std::mem::take(&mut self.changed);
        if self.client.pulls {
            return;
        }
        changed.sort_by(|a, b| a.0.cmp(&b.0));
        changed.dedup();
        for uri in changed {
            if let Some(file) = self.documents.snapshot(&uri) {
                let _ = self.news.send(News::Changed(file));
            }
        }
    }
}

const INITIALIZE: &str = "initialize";

/// The request that a session begins with: its ID and its parameters. `None` if the client is gone before it.
fn first_request(
    incoming: &Receiver<Message>,
    sender: &Sender<String>,
) -> Option<(RequestId, Value)> {
    loop {
        match incoming.recv().ok()? {
            Message::Request(r) if r.method == INITIALIZE => return Some((r.id, r.params)),
            Message::Request(r) => {
                let why = refusal(
                    ErrorCode::ServerNotInitialized,
                    "the server is not initialized",
                );
                let _ = sender.send(outgoing::refused(&r.id, &why));
            }
            Message::Notification(n) if n.method == "exit" => return None,
            Message::Notification(_) | Message::Response(_) => {}
        }
    }
}

/// The parameters with which the server asks to be told of changes to settings and pictures.
fn watched_files() -> Value {
    let pictures = format!("**/*.{{{}}}", workspace::PICTURES.join(","));
    let watchers = [
        json!({ "globPattern": "**/zpg.toml" }),
        json!({ "globPattern": pictures }),
    ];
    json!({ "registrations": [{
        "id": "files",
        "method": "workspace/didChangeWatchedFiles",
        "registerOptions": { "watchers": watchers },
    }] })
}

/// Starts the threads that answer quick requests. They end once the returned sender is dropped.
fn start_answering() -> Sender<Job> {
    let (sender, jobs) = unbounded::<Job>();
    for _ in 0..ANSWERING {
        let jobs = jobs.clone();
        thread::spawn(move || jobs.iter().for_each(|job| job()));
    }
    sender
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A request that we make a mistake in is answered with an error, and the next one as ever.
    #[test]
    fn it_outlives_a_panic() {
        let (to_server, incoming) = unbounded();
        let (sender, said) = unbounded();
        let serving = thread::spawn(move || serve(&incoming, sender, Language::English));
        let ask = |id: i32, method: &str, params: Value| {
            let (id, method) = (RequestId::from(id), method.to_owned());
            let request = Request { id, method, params };
            to_server.send(request.into()).unwrap();
            loop {
                let message = serde_json::from_str(&said.recv().unwrap()).unwrap();
                if let Message::Response(response) = message {
                    return response.response_result;
                }
            }
        };
        let tell = |method: &str| {
            let (method, params) = (method.to_owned(), json!({}));
            to_server
                .send(Notification { method, params }.into())
                .unwrap();
        };
        let start = json!({ "processId": null, "rootUri": null, "capabilities": {} });
        ask(1, "initialize", start).unwrap();
        tell("initialized");
        // More often than there are threads to lose.
        for id in 2..2 + 2 * ANSWERING as i32 {
            let error = ask(id, "test/panic", json!({})).unwrap_err();
            assert_eq!(error.code, ErrorCode::InternalError as i32);
        }
        let error = ask(99, "textDocument/codeLens", json!({})).unwrap_err();
        assert_eq!(error.code, ErrorCode::InvalidParams as i32);
        ask(100, "shutdown", Value::Null).unwrap();
        tell("exit");
        assert_eq!(serving.join().unwrap(), Ending::Clean);
    }
}
