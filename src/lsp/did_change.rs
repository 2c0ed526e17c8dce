//! Edits of open files, as clients send them.

use gen_lsp_types::{Range, VersionedTextDocumentIdentifier};
use serde::Deserialize;

/// The parameters of `textDocument/didChange`. The library's own type would read a change with an unreadable range as a
/// change of the whole file.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct DidChange {
    pub text_document: VersionedTextDocumentIdentifier,
    pub content_changes: Vec<Change>,
}

/// A change: a new text for a range.
#[derive(Deserialize)]
pub(super) struct Change {
    /// The range that the text replaces; `None` for the whole file.
    pub range: Option<Range>,
    pub text: String,
}
