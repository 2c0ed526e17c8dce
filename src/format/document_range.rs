//! Parts of a scene, each of which is printed without the others.

use std::ops::Range;

use crate::syntax::Document;
use crate::syntax::lexer::TokenKind;

/// A range of a scene's items, and of their tokens. A part that is not the first begins with a line break: the record
/// before the line break, and the comments behind that record on its line, belong to the part before.
pub(super) struct DocumentRange {
    pub items: Range<usize>,
    pub tokens: Range<usize>,
}

impl DocumentRange {
    pub(super) fn whole(document: &Document) -> DocumentRange {
        DocumentRange {
            items: 0..document.items.len(),
            tokens: 0..document.tokens.len(),
        }
    }

    /// At most `count` parts, with about as many tokens each. A part that is not the first one follows a record.
    pub(super) fn cut(document: &Document, count: usize) -> Vec<DocumentRange> {
        let Document { items, tokens, .. } = document;
        let mut rest = DocumentRange::whole(document);
        let mut parts = Vec::new();
        for i in 1..count {
            let near = tokens.len() / count * i;
            let near = items.partition_point(|item| (item.ends().0 as usize) < near);
            let near = near.max(rest.items.start + 1);
            let mut tried = near..items.len().min(near + MAX_ITEMS_TRIED);
            let Some((item, token)) = tried.find_map(|i| Some((i, cut_before(document, i)?)))
            else {
                continue;
            };
            parts.push(DocumentRange {
                items: rest.items.start..item,
                tokens: rest.tokens.start..token,
            });
            (rest.items.start, rest.tokens.start) = (item, token);
        }
        parts.push(rest);
        parts
    }

    pub(super) fn is_first(&self) -> bool {
        self.tokens.start == 0
    }

    /// The length of the range in the text, in bytes.
    pub(super) fn length(&self, document: &Document) -> usize {
        let tokens = &document.tokens[self.tokens.clone()];
        match (tokens.first(), tokens.last()) {
            (Some(first), Some(last)) => first.span().to(last.span()).range().len(),
            _ => 0,
        }
    }
}

/// The most items that are tried before a cut is given up.
const MAX_ITEMS_TRIED: usize = 1000;

/// The index of the token with which a part may begin whose first item is `item`: the line break behind the record
/// before. `None` if no part may begin there.
///
/// A cut must not change what is printed, except for the column of the comments, which
/// [`page::join`](super::page::join) decides. So there must be a blank line at the cut, or two records of different
/// types on neighbouring lines.
fn cut_before(document: &Document, item: usize) -> Option<usize> {
    let before = document.items[item - 1].record()?;
    let start = before.last as usize + 1;
    let between = &document.tokens[start..document.items[item].ends().0 as usize];
    let on_line = between
        .iter()
        .take_while(|t| t.kind() == TokenKind::Comment)
        .count();
    let breaks = &between[on_line..];
    let only_breaks = breaks.iter().all(|t| t.kind() == TokenKind::Newline);
    let record = document.items[item].record();
    let apart = match breaks.len() {
        0 => false,
        1 => record.is_some_and(|record| record.kind != before.kind),
        _ => true,
    };
    (only_breaks && apart).then_some(start + on_line)
}
