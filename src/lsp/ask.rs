//! What a request may look at, and how it is refused.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use gen_lsp_types::{TextDocumentIdentifier, TextDocumentPositionParams, Uri};
use lsp_server::{ErrorCode, ResponseError};

use super::client::{Client, Preferences};
use super::convert::Convert;
use super::documents::{Changes, Snapshot, Snapshots};
use super::outgoing::Outgoing;
use super::tokens_sent::TokensSent;
use crate::diagnostics::Complaint;

/// What a request may look at: all open files as they were when it came.
pub struct Ask {
    pub files: Snapshots,
    pub client: Arc<Client>,
    pub preferences: Preferences,
    pub folders: Vec<Uri>,
    pub outgoing: Outgoing,
    pub tokens_sent: Arc<TokensSent>,
    pub changes: Changes,
    /// Set when the client does not want the answer any more.
    pub cancelled: Arc<AtomicBool>,
}

/// Why a request is not met.
pub type Refusal = ResponseError;

pub fn refusal(code: ErrorCode, message: impl Into<String>) -> Refusal {
    ResponseError {
        code: code as i32,
        message: message.into(),
        data: None,
    }
}

impl Ask {
    pub fn file(&self, document: &TextDocumentIdentifier) -> Result<&Snapshot, Refusal> {
        let file = self.files.get(&document.uri).map(Arc::as_ref);
        file.ok_or_else(|| {
            let values = [("path", document.uri.0.clone().into())];
            let message = self.client.language.say("lsp-not-open", &values);
            refusal(ErrorCode::InvalidParams, message)
        })
    }

    pub fn convert<'a>(&'a self, file: &'a Snapshot) -> Convert<'a> {
        Convert::new(file, &self.client)
    }

    /// Something cannot be done, in the client's language.
    pub fn refuse(&self, why: &Complaint) -> Refusal {
        refusal(ErrorCode::RequestFailed, why.wording(self.client.language))
    }

    /// A file and the offset of a place in it.
    pub fn place(&self, at: &TextDocumentPositionParams) -> Result<(Convert<'_>, u32), Refusal> {
        let convert = self.convert(self.file(&at.text_document)?);
        let offset = convert.places.offset(at.position);
        Ok((convert, offset))
    }

    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}
