//! Whether two scenes say the same, whatever they look like.

use std::cell::Cell;

use crate::syntax::lexer::{Token, Tokens};
use crate::syntax::plain::{Doubt, Reader};
use crate::syntax::{Document, Item, Record};

/// Whether two scenes have the same records with the same values to the bit, the same comments, and
/// the same text where they could not be read. A lone `0` says nothing.
pub fn same_content(a: (&str, &Document), b: (&str, &Document)) -> bool {
    comments(a).eq(comments(b)) && differences(a, b).is_empty()
}

/// Whether a text plainly says the same as a scene: `true` means what [`same_content`] says of the two, `false`
/// nothing.
///
/// The text is not parsed, but read by the reader that the parser asks first (`syntax::plain`), token by token.
/// What that reads without a doubt is what the parser makes of the text, to the token; so its records
/// are compared as they come, and nothing is kept of them.
pub fn are_plainly_same(old: &str, document: &Document, new: &str) -> bool {
    let mut comments = document.comments();
    let same_comments = Cell::new(true);
    let tokens = Tokens::new(new, &[]).inspect(|t| {
        if t.kind.is_comment() {
            let same = (comments.next()).is_some_and(|other| other.text(old) == t.text(new));
            same_comments.set(same_comments.get() && same);
        }
    });
    let Ok(mut reader) = Reader::new(new, tokens) else {
        return false;
    };
    let mut items = document
        .items
        .iter()
        .filter(|i| !matches!(i, Item::Void { .. }));
    loop {
        let item = items.next();
        let record = match item {
            Some(Item::Record(record)) => Some(record),
            None => None,
            Some(Item::Void { .. } | Item::Broken(_)) => return false,
        };
        let mut values = record
            .into_iter()
            .flat_map(|r| document.significant(r.first, r.last));
        let mut same = true;
        let mut each = |t: &Token| {
            let value = values.next();
            same &= value.is_some_and(|v| same_value((old, v), (new, t)));
        };
        let other = loop {
            match reader.item(&mut each) {
                Ok(Some(Item::Void { .. })) => {}
                Ok(other) => break other,
                Err(Doubt) => return false,
            }
        };
        match (record, other) {
            (Some(x), Some(Item::Record(y))) if same && same_head(x, &y) => {}
            (None, None) => break,
            _ => return false,
        }
    }
    drop(reader);
    same_comments.get() && comments.next().is_none()
}

/// The items of the first scene that are not the same in the second, or not in the same place among
/// its numbers.
pub fn differences(a: (&str, &Document), b: (&str, &Document)) -> Vec<usize> {
    let same = |x: &Item, y: &Item| same_item((a.0, a.1, x), (b.0, b.1, y));
    let (mut items, mut others): (Vec<_>, Vec<_>) = (places(a.1).collect(), places(b.1).collect());
    // What is the same up to the end is no difference, however much else is read before it.
    let ends = items.iter().rev().zip(others.iter().rev());
    let ends = ends.take_while(|(x, y)| same(x.2, y.2)).count();
    items.truncate(items.len() - ends);
    others.truncate(others.len() - ends);
    let mut found = Vec::new();
    let mut others = others.into_iter().peekable();
    let mut last = 0;
    for (i, start, item) in items {
        // What begins within the item before.
        while others.next_if(|other| other.1 < start).is_some() {
            found.push(last);
        }
        let other = others.next_if(|other| other.1 == start);
        if !other.is_some_and(|(.., other)| same(item, other)) {
            found.push(i);
        }
        last = i;
    }
    if others.next().is_some() {
        found.push(last);
    }
    found
}

/// The items that say something, each with its index and how many numbers stand before it.
fn places(document: &Document) -> impl Iterator<Item = (usize, usize, &Item)> {
    let mut end = 0;
    document
        .items
        .iter()
        .enumerate()
        .filter_map(move |(i, item)| {
            let start = end;
            end += match item {
                Item::Void { .. } => return None,
                Item::Record(record) => 2 + record.params as usize,
                Item::Broken(broken) => document.significant(broken.first, broken.last).count(),
            };
            Some((i, start, item))
        })
}

pub fn comments<'a>((text, document): (&'a str, &'a Document)) -> impl Iterator<Item = &'a str> {
    document.comments().map(move |t| t.text(text))
}

fn same_item(a: (&str, &Document, &Item), b: (&str, &Document, &Item)) -> bool {
    let text = |(text, document, item): (&str, &Document, &Item)| {
        text[document.item_span(item).range()].to_owned()
    };
    match (a.2, b.2) {
        (Item::Record(x), Item::Record(y)) => {
            same_head(x, y)
                && a.1
                    .params(x)
                    .zip(b.1.params(y))
                    .all(|(s, t)| same_value((a.0, s), (b.0, t)))
        }
        (Item::Broken(x), Item::Broken(y)) => {
            x.id == y.id && x.ty.map(|t| t.kind) == y.ty.map(|t| t.kind) && text(a) == text(b)
        }
        _ => false,
    }
}

fn same_head(x: &Record, y: &Record) -> bool {
    x.id == y.id && x.ty.kind == y.ty.kind && x.params == y.params
}

fn same_value(a: (&str, &Token), b: (&str, &Token)) -> bool {
    let (x, y) = (a.1.text(a.0), b.1.text(b.0));
    x == y
        || match (a.1.number(a.0), b.1.number(b.0)) {
            (Some(x), Some(y)) => x.to_bits() == y.to_bits(),
            _ => false,
        }
}
