//! Commenting out and in: a request of its own for the keys of editors, and a code action for editors without such
//! keys.

use gen_lsp_types::{
    CodeAction, LspRequestMethod, MessageDirection, Range, Request, TextDocumentIdentifier,
    TextEdit,
};
use serde::{Deserialize, Serialize};

use super::ask::Ask;
use super::capabilities::COMMENT;
use super::convert::Convert;
use super::refusal::Refusal;
use crate::diagnostics::Span;
use crate::features::commenting::{self, Mode};

/// `zpg/comment`: the edits that comment out or in the lines of some selections.
pub(super) enum CommentRequest {}

impl Request for CommentRequest {
    const METHOD: LspRequestMethod<'static> = LspRequestMethod::new("zpg/comment");
    const MESSAGE_DIRECTION: MessageDirection = MessageDirection::ClientToServer;
    type Params = CommentParams;
    type Result = Vec<TextEdit>;
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct CommentParams {
    pub text_document: TextDocumentIdentifier,
    pub ranges: Vec<Range>,
    #[serde(default)]
    pub mode: Wanted,
}

#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) enum Wanted {
    #[default]
    Toggle,
    Out,
    In,
}

pub(super) fn comment(ask: &Ask, p: CommentParams) -> Result<Vec<TextEdit>, Refusal> {
    let file = ask.file(&p.text_document)?;
    let convert = ask.convert(file);
    let spans: Vec<Span> = p.ranges.iter().map(|r| convert.places.span(*r)).collect();
    let mode = match p.mode {
        Wanted::Toggle => Mode::Toggle,
        Wanted::Out => Mode::Out,
        Wanted::In => Mode::In,
    };
    let edits = commenting::edits(file.analysis(), &spans, mode);
    Ok(convert.text_edits(&edits))
}

/// The action that comments out or in the lines of a selection; `None` if the lines are blank.
pub(super) fn action(ask: &Ask, convert: &Convert, range: Range) -> Option<CodeAction> {
    let analysis = convert.file.analysis();
    let span = convert.places.span(range);
    let mode = commenting::direction(analysis, span)?;
    let title = match mode {
        Mode::In => "lsp-comment-in",
        Mode::Out | Mode::Toggle => "lsp-comment-out",
    };
    let edits = commenting::edits(analysis, &[span], mode);
    Some(CodeAction {
        title: ask.client.language.say(title, &[]),
        kind: Some(COMMENT.to_owned().into()),
        edit: Some(convert.workspace_edit(&edits)),
        ..CodeAction::default()
    })
}
