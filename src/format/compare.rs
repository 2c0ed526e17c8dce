//! Whether two scenes have the same content, in whatever layout.

use crate::syntax::lexer::Token;
use crate::syntax::parser;
use crate::syntax::{Document, Item, Record};

/// Whether two scenes have the same records with the same values to the bit, the same comments, and
/// the same text where they could not be read. A lone `0` says nothing.
pub fn same_content(a: (&str, &Document), b: (&str, &Document)) -> bool {
    comments(a).eq(comments(b)) && differences(a, b).is_empty()
}

/// A quick version of [`same_content`] for a new text that is not parsed yet. `false` says nothing: the text may need
/// recovery. Values are compared as the parser read them, not as they are spelled.
pub(super) fn are_plainly_same(old: &str, document: &Document, new: &str) -> bool {
    let Some(other) = parser::parse_plain(new) else {
        return false;
    };
    let says = |item: &&Item| !matches!(item, Item::Void { .. });
    let mut others = other.items.iter().filter(says);
    let mut items = document.items.iter().filter(says);
    let same = |(x, y): (&Item, &Item)| match (x, y) {
        (Item::Record(x), Item::Record(y)) => same_record((old, document, x), (new, &other, y)),
        _ => false,
    };
    let all = loop {
        match (items.next(), others.next()) {
            (Some(x), Some(y)) if same((x, y)) => {}
            (None, None) => break true,
            _ => break false,
        }
    };
    all && comments((old, document)).eq(comments((new, &other)))
}

/// Whether two records have the same values to the bit.
fn same_record(a: (&str, &Document, &Record), b: (&str, &Document, &Record)) -> bool {
    let (x, y) = (a.1.values(a.2), b.1.values(b.2));
    // Where a value is a large integer or no number, the spelling is compared: two integers may be one double.
    let told = |x: &f64, y: &f64| x.to_bits() == y.to_bits() && x.abs() < INTEGERS;
    same_head(a.2, b.2)
        && (x.iter().zip(y).all(|(x, y)| told(x, y))
            || (a.1.params(a.2).zip(b.1.params(b.2))).all(|(s, t)| same_value((a.0, s), (b.0, t))))
}

/// 2⁵³: all smaller integers are exact as doubles.
const INTEGERS: f64 = 9_007_199_254_740_992.0;

/// The indices of the items of scene `a` that scene `b` does not have in the same place. The place of an item is how
/// many numbers stand before it.
pub(super) fn differences(a: (&str, &Document), b: (&str, &Document)) -> Vec<usize> {
    let same = |x: &Item, y: &Item| same_item((a.0, a.1, x), (b.0, b.1, y));
    let (mut items, mut others): (Vec<_>, Vec<_>) = (places(a.1).collect(), places(b.1).collect());
    // Items that are the same up to the end are no differences, even if more or fewer numbers are read before them.
    let ends = items.iter().rev().zip(others.iter().rev());
    let ends = ends.take_while(|(x, y)| same(x.2, y.2)).count();
    items.truncate(items.len() - ends);
    others.truncate(others.len() - ends);
    let mut found = Vec::new();
    let mut others = others.into_iter().peekable();
    let mut last = 0;
    for (i, start, item) in items {
        // This item of the other scene begins inside of the item before.
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

/// The items that are no VOIDs, each with its index and the number of significant tokens before it.
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

pub(super) fn comments<'a>(
    (text, document): (&'a str, &'a Document),
) -> impl Iterator<Item = &'a str> {
    document.comments().map(move |t| t.text(text))
}

fn same_item(a: (&str, &Document, &Item), b: (&str, &Document, &Item)) -> bool {
    let text = |(text, document, item): (&str, &Document, &Item)| {
        text[document.item_span(item).range()].to_owned()
    };
    match (a.2, b.2) {
        (Item::Record(x), Item::Record(y)) => same_record((a.0, a.1, x), (b.0, b.1, y)),
        (Item::Broken(x), Item::Broken(y)) => {
            x.id == y.id && x.kind == y.kind && text(a) == text(b)
        }
        _ => false,
    }
}

fn same_head(x: &Record, y: &Record) -> bool {
    x.id == y.id && x.kind == y.kind && x.params == y.params
}

fn same_value(a: (&str, &Token), b: (&str, &Token)) -> bool {
    let (x, y) = (a.1.text(a.0), b.1.text(b.0));
    x == y
        || match (a.1.number(a.0), b.1.number(b.0)) {
            (Some(x), Some(y)) => x.to_bits() == y.to_bits(),
            _ => false,
        }
}
