//! Parts of a scene that are printed one without the other.

use std::ops::Range;

use crate::syntax::lexer::TokenKind;
use crate::syntax::{Document, Item};

/// Items and tokens of a scene that follow one another, from the start of a line to the end of one.
pub struct Part {
    pub items: Range<usize>,
    pub tokens: Range<usize>,
}

impl Part {
    pub fn whole(document: &Document) -> Part {
        Part {
            items: 0..document.items.len(),
            tokens: 0..document.tokens.len(),
        }
    }

    /// At most so many parts, about as long as each other. One ends and the next one begins with a record.
    pub fn cut(document: &Document, count: usize) -> Vec<Part> {
        let mut rest = Part::whole(document);
        let mut parts = Vec::new();
        for i in 1..count {
            let near = (document.items.len() / count * i).max(rest.items.start + 1);
            let Some(item) = (near..document.items.len().min(near + LOOKS))
                .find(|&item| may_begin(document, item))
            else {
                continue;
            };
            let token = document.items[item].ends().0 as usize;
            parts.push(Part {
                items: rest.items.start..item,
                tokens: rest.tokens.start..token,
            });
            (rest.items.start, rest.tokens.start) = (item, token);
        }
        parts.push(rest);
        parts
    }

    pub fn is_first(&self) -> bool {
        self.tokens.start == 0
    }

    /// How long it is in the text.
    pub fn length(&self, document: &Document) -> usize {
        let tokens = &document.tokens[self.tokens.clone()];
        match (tokens.first(), tokens.last()) {
            (Some(first), Some(last)) => first.span().to(last.span()).range().len(),
            _ => 0,
        }
    }
}

/// So many items are looked at in search of an end.
const LOOKS: usize = 1000;

/// Whether a part may begin with an item: a record of another type than the one before it, on the next line. Nothing of
/// how that one is printed depends on this one, nor the other way round, but for the column of their comments.
fn may_begin(document: &Document, item: usize) -> bool {
    let (Item::Record(before), Item::Record(record)) =
        (&document.items[item - 1], &document.items[item])
    else {
        return false;
    };
    let between = &document.tokens[before.last as usize + 1..record.first as usize];
    let Some((last, comments)) = between.split_last() else {
        return false;
    };
    before.kind != record.kind
        && last.kind() == TokenKind::Newline
        && comments.iter().all(|t| t.kind() == TokenKind::Comment)
}
