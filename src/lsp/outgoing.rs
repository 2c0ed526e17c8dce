//! The way to the client.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicI32, Ordering};

use crossbeam_channel::Sender;
use lsp_server::{Message, Notification, Request, RequestId, Response};
use serde::Serialize;
use serde_json::{Value, json};

use super::uri;

/// Sends messages, from any thread.
#[derive(Clone)]
pub struct Outgoing {
    sender: Sender<Message>,
    /// The number of the next request.
    next: Arc<AtomicI32>,
    shows_documents: bool,
}

impl Outgoing {
    pub fn new(sender: Sender<Message>, shows_documents: bool) -> Outgoing {
        Outgoing {
            sender,
            next: Arc::new(AtomicI32::new(1)),
            shows_documents,
        }
    }

    /// Says something.
    pub fn notify(&self, method: &str, params: impl Serialize) {
        let params = serde_json::to_value(params).unwrap_or(Value::Null);
        let method = method.to_owned();
        // Nobody is left to be told when this fails.
        let _ = self.sender.send(Notification { method, params }.into());
    }

    /// Asks for something whose answer does not matter.
    pub fn request(&self, method: &str, params: Value) {
        let id = RequestId::from(self.next.fetch_add(1, Ordering::Relaxed));
        let method = method.to_owned();
        let _ = self.sender.send(Request { id, method, params }.into());
    }

    pub fn respond(&self, response: Response) {
        let _ = self.sender.send(response.into());
    }

    /// Has the client show a file, if it can.
    pub fn show_document(&self, path: &Path) {
        self.show(path, json!({ "takeFocus": true }));
    }

    /// Has the client open a page in the browser, if it can.
    pub fn show_in_browser(&self, path: &Path) {
        self.show(path, json!({ "external": true }));
    }

    fn show(&self, path: &Path, mut how: Value) {
        if let (true, Some(uri)) = (self.shows_documents, uri::uri_of(path)) {
            how["uri"] = json!(uri);
            self.request("window/showDocument", how);
        }
    }

    pub fn show_message(&self, message: &str) {
        // 3: information.
        let params = json!({ "type": 3, "message": message });
        self.notify("window/showMessage", params);
    }
}
