//! The context of a request: the files and the client that it may look at.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

use gen_lsp_types::{TextDocumentIdentifier, TextDocumentPositionParams, Uri};
use lsp_server::ErrorCode;

use super::client::{Client, Preferences};
use super::convert::Convert;
use super::documents::{Changes, Snapshot, Snapshots};
use super::outgoing::Outgoing;
use super::refusal::{Refusal, refusal};
use super::tokens_sent::TokensSent;
use super::told::Told;
use super::uri;
use crate::analysis::config::Configs;
use crate::diagnostics::Complaint;

/// The state that a request may look at: all open files as they were when it came.
pub(super) struct Ask {
    pub files: Snapshots,
    /// The file that the request is about, if it is not open. It is read from disk when it is first needed.
    pub not_open: OnceLock<Snapshot>,
    pub client: Arc<Client>,
    pub preferences: Preferences,
    pub folders: Vec<Uri>,
    pub outgoing: Outgoing,
    pub tokens_sent: Arc<TokensSent>,
    pub told: Arc<Told>,
    pub changes: Changes,
    /// Whether the client does not want the answer any more.
    pub cancelled: Arc<AtomicBool>,
}

impl Ask {
    /// Finds the file that the request is about. Clients also ask about files that they have just closed, renamed or
    /// deleted: a file that is not open is read from disk. A text that is no URI is refused.
    pub(super) fn file(&self, document: &TextDocumentIdentifier) -> Result<&Snapshot, Refusal> {
        let uri = &document.uri;
        match self.files.get(uri) {
            Some(file) => Ok(file),
            None if uri::is_uri(uri) => Ok(self
                .not_open
                .get_or_init(|| Snapshot::on_disk(uri.clone(), &Configs::default()))),
            None => {
                let values = [("text", uri.0.clone().into())];
                let message = self.client.language.say("lsp-no-uri", &values);
                Err(refusal(ErrorCode::InvalidParams, message))
            }
        }
    }

    pub(super) fn convert<'a>(&'a self, file: &'a Snapshot) -> Convert<'a> {
        Convert::new(file, &self.client)
    }

    /// Refuses a request, with the reason in the client's language.
    pub(super) fn refuse(&self, why: &Complaint) -> Refusal {
        refusal(ErrorCode::RequestFailed, why.wording(self.client.language))
    }

    /// The file of a position, with the means to convert answers about it, and the offset of the position.
    pub(super) fn place(
        &self,
        at: &TextDocumentPositionParams,
    ) -> Result<(Convert<'_>, u32), Refusal> {
        let convert = self.convert(self.file(&at.text_document)?);
        let offset = convert.places.offset(at.position);
        Ok((convert, offset))
    }

    pub(super) fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}
