//! The token at an offset of the text.

use crate::analysis::Analysis;
use crate::diagnostics::Span;
use crate::syntax::lexer::{Token, TokenKind};
use crate::syntax::table::{Param, ParamKind, RecordType};
use crate::syntax::{Document, Item, Record};

/// A token of a record that can be read, and its role.
#[derive(Debug, Clone, Copy)]
pub struct TokenAtOffset<'a> {
    pub record: &'a Record,
    pub token: Token,
    pub role: Role,
}

/// The role of a token in a record.
#[derive(Debug, Clone, Copy)]
pub enum Role {
    Id,
    Type,
    /// The parameter with this number, from 0.
    Param(usize, &'static Param),
}

impl TokenAtOffset<'_> {
    /// The ID that the token names: its own record's, or the one that it refers to.
    pub fn id(&self, text: &str) -> Option<u32> {
        match self.role {
            Role::Id => Some(self.record.id),
            Role::Param(_, param) => reference(param, &self.token, text),
            Role::Type => None,
        }
    }
}

/// The ID that a parameter refers to; `None` for other parameters, and for 0, which names no entity.
pub fn reference(param: &Param, token: &Token, text: &str) -> Option<u32> {
    let ParamKind::Reference { .. } = param.kind else {
        return None;
    };
    let id = token.integer(text)?;
    u32::try_from(id).ok().filter(|&id| id > 0)
}

/// The index of the last item that begins at an offset or before it.
pub fn item_before(document: &Document, offset: u32) -> Option<usize> {
    let start = |item: &Item| document.tokens[item.ends().0 as usize].start;
    (document.items)
        .partition_point(|item| start(item) <= offset)
        .checked_sub(1)
}

/// The indices of the items that have a part in a span.
pub fn items_in(document: &Document, span: Span) -> std::ops::Range<usize> {
    let items = &document.items;
    let end = items.partition_point(|i| document.tokens[i.ends().0 as usize].start < span.end);
    let start = items.partition_point(|i| document.tokens[i.ends().1 as usize].end() <= span.start);
    start..end.max(start)
}

/// A record whose type is known, so that its tokens are parameters in the type's order.
pub struct Readable {
    pub ty: &'static RecordType,
    /// The index of the first token, the ID; the type and the parameters follow, up to `last`.
    pub first: u32,
    pub last: u32,
    /// The value of the count parameter; 0 if the type has none.
    pub count: usize,
}

/// The item as a record of a known type, if it can be read, or if at least its ID and type can. `None` for other
/// items.
pub fn readable(analysis: &Analysis, item: &Item) -> Option<Readable> {
    let broken = match item {
        Item::Record(record) => {
            return Some(Readable {
                ty: record.ty(),
                first: record.first,
                last: record.last,
                count: record.count(),
            });
        }
        Item::Broken(broken) => broken,
        Item::Void { .. } => return None,
    };
    let (document, text) = (&analysis.document, &analysis.source.text);
    let ty = broken.ty()?;
    let mut tokens = document.significant(broken.first, broken.last);
    let id = tokens.next()?.integer(text)?;
    if u32::try_from(id).is_err() || tokens.next()?.integer(text)? != i64::from(ty.code) {
        return None;
    }
    let values: Vec<&Token> = tokens.collect();
    let count_at = ty.params.iter().position(|p| p.kind == ParamKind::Count);
    let count = count_at.and_then(|i| usize::try_from(values.get(i)?.integer(text)?).ok());
    Some(Readable {
        ty,
        first: broken.first,
        last: broken.last,
        // A profile has no more points than there are numbers.
        count: count.unwrap_or(0).min(values.len()),
    })
}

/// The record around an offset, its end included.
pub fn record_at(analysis: &Analysis, offset: u32) -> Option<&Record> {
    let document = &analysis.document;
    let at = item_before(document, offset)?;
    match &document.items[at] {
        Item::Record(record) if offset <= document.tokens[record.last as usize].end() => {
            Some(record)
        }
        _ => None,
    }
}

/// The token at an offset, or one that ends there; of two that touch, the second one. Comments and spaces do not
/// count.
pub fn token_at(analysis: &Analysis, offset: u32) -> Option<Token> {
    let tokens = &analysis.document.tokens;
    let end = tokens.partition_point(|t| t.start <= offset);
    let mut near = tokens[..end].iter().rev().take(2);
    near.find(|t| offset <= t.end() && !t.kind().is_trivia())
        .copied()
}

/// The token of a readable record at an offset, or one that ends there.
pub fn place_at(analysis: &Analysis, offset: u32) -> Option<TokenAtOffset<'_>> {
    let record = record_at(analysis, offset)?;
    let document = &analysis.document;
    let holds = |t: &Token| t.start <= offset && offset <= t.end();
    // The last match counts: of two tokens that touch, the second one is meant.
    let mut tokens = document.significant(record.first, record.last).enumerate();
    let mut found = None;
    for (i, token) in tokens.by_ref() {
        if token.start > offset {
            break;
        }
        if holds(token) {
            found = Some((i, *token));
        }
    }
    let (i, token) = found?;
    let role = match i {
        0 => Role::Id,
        1 => Role::Type,
        _ => Role::Param(i - 2, record.ty().param(i - 2, record.count())?),
    };
    Some(TokenAtOffset {
        record,
        token,
        role,
    })
}

/// The record that a person is typing, up to the place of the cursor. It may not be complete.
#[derive(Debug, Clone, Copy)]
pub struct Typing {
    /// The number of the record's significant tokens before the token at the place.
    pub index: usize,
    /// The part of the token at the place that has been typed; empty behind white space.
    pub word: Span,
    /// The record's ID, once it has been typed.
    pub id: Option<u32>,
    /// The record's type, once it has been typed and is known.
    pub ty: Option<&'static RecordType>,
    /// The value of the count parameter; 0 while there is none.
    pub count: usize,
    /// Whether a record that is complete ends before the place, so that another one may begin.
    pub complete: bool,
}

/// The record that is being typed at an offset. `None` within comments.
///
/// A record that cannot be read is taken to begin at the start of its line: that is how people write.
pub fn typing(analysis: &Analysis, offset: u32) -> Option<Typing> {
    let (document, text) = (&analysis.document, analysis.source.text.as_str());
    let tokens = &document.tokens;
    let next = tokens.partition_point(|t| t.start < offset);
    let word = (next.checked_sub(1).map(|i| tokens[i])).filter(|t| t.end() >= offset);
    let in_comment = |t: &Token| match t.kind() {
        TokenKind::Comment => t.end() > offset,
        TokenKind::UnterminatedComment => true,
        _ => false,
    };
    if word.as_ref().is_some_and(in_comment) {
        return None;
    }
    let word = word.filter(|t| !t.kind().is_trivia());
    let first = first_token(analysis, offset);
    let before: Vec<&Token> = tokens[first..next]
        .iter()
        .filter(|t| !t.kind().is_trivia() && word.is_none_or(|w| w.start != t.start))
        .collect();
    let id = before.first().and_then(|t| t.integer(text));
    let ty = (before.get(1).and_then(|t| t.integer(text))).and_then(RecordType::by_code);
    let count_at = ty.and_then(|ty| ty.params.iter().position(|p| p.kind == ParamKind::Count));
    let count = count_at
        .and_then(|i| before.get(2 + i)?.integer(text))
        .and_then(|n| usize::try_from(n).ok())
        .unwrap_or(0);
    let index = before.len();
    let complete = ty.is_some_and(|ty| {
        // A profile is not complete before its number of points is known.
        let arity = ty.arity(count as u64) + ty.optional.len() as u64;
        index as u64 >= arity.saturating_add(2) && (count > 0 || count_at.is_none())
    });
    Some(Typing {
        index,
        word: word.map_or(Span::new(offset, offset), |t| Span::new(t.start, offset)),
        id: id.and_then(|id| u32::try_from(id).ok()),
        ty,
        count,
        complete,
    })
}

/// The index of the first token of the record at an offset: the record around the offset, or the record before it, if
/// that one ends on the same line or lacks its last numbers. Otherwise the first token of the line.
fn first_token(analysis: &Analysis, offset: u32) -> usize {
    let document = &analysis.document;
    let tokens = &document.tokens;
    let line = analysis.source.line_index(offset);
    let line_start = analysis.source.line_span(line).start;
    let on_line = tokens.partition_point(|t| t.start < line_start);
    match item_before(document, offset).map(|i| document.items[i]) {
        Some(Item::Record(record)) => {
            let end = tokens[record.last as usize].end();
            match end >= offset || end > line_start {
                true => record.first as usize,
                false => on_line,
            }
        }
        Some(Item::Broken(broken)) => {
            let start = tokens[broken.first as usize].start;
            // Profiles are long. Another broken record on several lines may be one that somebody has only begun, with
            // more records behind it.
            let is_long = broken.ty().is_some_and(RecordType::is_counted);
            let goes_on = is_long && tokens[broken.last as usize].end() >= offset;
            match start >= line_start || goes_on {
                true => broken.first as usize,
                false => on_line,
            }
        }
        _ => on_line,
    }
}
