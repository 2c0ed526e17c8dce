//! Edits of open files, as clients send them.

use gen_lsp_types::{Range, VersionedTextDocumentIdentifier};
use serde::Deserialize;

/// The parameters of `textDocument/didChange`. The library's own type takes a change whose range cannot be read for one of
/// the whole file.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct DidChange {
    pub text_document: VersionedTextDocumentIdentifier,
    pub content_changes: Vec<Change>,
}

/// A new text.
#[derive(Deserialize)]
pub(super) struct Change {
    /// The range that the text takes the place of; without one it takes that of the whole file.
    pub range: Option<Range>,
    pub text: String,
}
