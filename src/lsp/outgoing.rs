//! The way to the client: messages are JSON from here on.
//!
//! `lsp-server` builds messages as trees of [`Value`]s, and the tree of a long answer takes many times the memory of
//! its text.

use std::cell::Cell;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicI32, Ordering};

use crossbeam_channel::Sender;
use lsp_server::{ErrorCode, RequestId};
use serde::{Serialize, Serializer};
use serde_json::{Value, json};

use super::refusal::{Refusal, refusal};
use super::uri;

/// Sends messages, from any thread.
#[derive(Clone)]
pub(super) struct Outgoing {
    sender: Sender<String>,
    /// The number of the next request.
    next: Arc<AtomicI32>,
    shows_documents: bool,
}

impl Outgoing {
    pub(super) fn new(sender: Sender<String>, shows_documents: bool) -> Outgoing {
        Outgoing {
            sender,
            next: Arc::new(AtomicI32::new(1)),
            shows_documents,
        }
    }

    /// Sends a notification.
    pub(super) fn notify(&self, method: &str, params: impl Serialize) {
        self.call(None, method, params);
    }

    /// Sends a request whose answer does not matter.
    pub(super) fn request(&self, method: &str, params: impl Serialize) {
        let id = self.next.fetch_add(1, Ordering::Relaxed);
        self.call(Some(id), method, params);
    }

    fn call(&self, id: Option<i32>, method: &str, params: impl Serialize) {
        #[derive(Serialize)]
        struct Call<'a, P> {
            jsonrpc: &'a str,
            #[serde(skip_serializing_if = "Option::is_none")]
            id: Option<i32>,
            method: &'a str,
            params: P,
        }
        let call = Call {
            jsonrpc: VERSION,
            id,
            method,
            params,
        };
        // The parameters of this server's messages can always be written as JSON.
        if let Ok(message) = serde_json::to_string(&call) {
            self.send(message);
        }
    }

    /// Sends a message that [`answer`] or [`refused`] has made.
    pub(super) fn send(&self, message: String) {
        // If this fails, the client is gone.
        let _ = self.sender.send(message);
    }

    /// Has the client show a file, if it can.
    pub(super) fn show_document(&self, path: &Path) {
        self.show(path, json!({ "takeFocus": true }));
    }

    /// Has the client open a page in the browser, if it can.
    pub(super) fn show_in_browser(&self, path: &Path) {
        self.show(path, json!({ "external": true }));
    }

    fn show(&self, path: &Path, mut how: Value) {
        if let (true, Some(uri)) = (self.shows_documents, uri::uri_of(path)) {
            how["uri"] = json!(uri);
            self.request("window/showDocument", how);
        }
    }

    pub(super) fn show_message(&self, message: &str) {
        // 3: information.
        let params = json!({ "type": 3, "message": message });
        self.notify("window/showMessage", params);
    }

    /// Sends a warning to the client's log.
    pub(super) fn log_warning(&self, message: &str) {
        // 2: a warning.
        let params = json!({ "type": 2, "message": message });
        self.notify("window/logMessage", params);
    }
}

const VERSION: &str = "2.0";

/// The answer to a request.
///
/// # Errors
///
/// The result cannot be written as JSON.
pub(super) fn answer(id: &RequestId, result: impl Serialize) -> Result<String, Refusal> {
    #[derive(Serialize)]
    struct Answer<'a, R> {
        jsonrpc: &'a str,
        id: &'a RequestId,
        result: R,
    }
    let answer = Answer {
        jsonrpc: VERSION,
        id,
        result,
    };
    serde_json::to_string(&answer).map_err(|e| refusal(ErrorCode::InternalError, e.to_string()))
}

/// The answer to a request for a list. Only one item of the list is in memory at a time.
///
/// # Errors
///
/// An item cannot be written as JSON.
pub(super) fn answer_list(
    id: &RequestId,
    all: impl Iterator<Item = impl Serialize>,
) -> Result<String, Refusal> {
    struct List<I>(Cell<Option<I>>);
    impl<T: Serialize, I: Iterator<Item = T>> Serialize for List<I> {
        fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
            to.collect_seq(self.0.take().into_iter().flatten())
        }
    }
    answer(id, List(Cell::new(Some(all))))
}

/// The error answer to a request. `id` is null if the request's ID cannot be read.
pub(super) fn refused(id: impl Serialize, why: &Refusal) -> String {
    json!({ "jsonrpc": VERSION, "id": json!(id), "error": why }).to_string()
}
