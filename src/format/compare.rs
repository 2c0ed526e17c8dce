//! Whether two scenes say the same, whatever they look like.

use crate::syntax::lexer::Token;
use crate::syntax::{Document, Item};

/// Whether two scenes have the same records with the same values to the bit, the same comments, and
/// the same text where they could not be read.
pub fn same_content(a: (&str, &Document), b: (&str, &Document)) -> bool {
    comments(a).eq(comments(b))
        && a.1.items.len() == b.1.items.len()
        && a.1
            .items
            .iter()
            .zip(&b.1.items)
            .all(|(x, y)| same_item((a.0, a.1, x), (b.0, b.1, y)))
}

fn comments<'a>((text, document): (&'a str, &'a Document)) -> impl Iterator<Item = &'a str> {
    document.comments().map(move |t| t.text(text))
}

fn same_item(a: (&str, &Document, &Item), b: (&str, &Document, &Item)) -> bool {
    let text = |(text, document, item): (&str, &Document, &Item)| {
        text[document.item_span(item).range()].to_owned()
    };
    match (a.2, b.2) {
        (Item::Void { .. }, Item::Void { .. }) => true,
        (Item::Record(x), Item::Record(y)) => {
            x.id == y.id
                && x.ty.code == y.ty.code
                && x.params == y.params
                && a.1
                    .params(x)
                    .zip(b.1.params(y))
                    .all(|(s, t)| same_value((a.0, s), (b.0, t)))
        }
        (Item::Broken(x), Item::Broken(y)) => {
            x.id == y.id && x.ty.map(|t| t.code) == y.ty.map(|t| t.code) && text(a) == text(b)
        }
        _ => false,
    }
}

fn same_value(a: (&str, &Token), b: (&str, &Token)) -> bool {
    let (x, y) = (a.1.text(a.0), b.1.text(b.0));
    x == y
        || match (a.1.number(a.0), b.1.number(b.0)) {
            (Some(x), Some(y)) => x.to_bits() == y.to_bits(),
            _ => false,
        }
}
