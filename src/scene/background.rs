//! The colour that was meant as the background, where the render record names none.

use rustc_hash::FxHashSet;

use super::model::Entity;
use super::names::references;
use crate::syntax::lexer::TokenKind;
use crate::syntax::table::Kind;
use crate::syntax::words;
use crate::syntax::{Document, Item};

/// Beginnings of words for a background, without accents.
const WORDS: [&str; 7] = [
    "backdrop",
    "background",
    "sky",
    "nebe",
    "obloh",
    "obloz",
    "pozadi",
];

/// A colour that no record names, so that it may be meant as the background.
pub struct Background {
    pub id: u32,
    /// Whether a comment on the line of the colour calls it a background.
    pub is_called_so: bool,
}

/// The only colour that no record names. If there are several, the only one of them that a comment calls a background.
pub fn meant(document: &Document, text: &str, entities: &[Entity]) -> Option<Background> {
    let colours = || entities.iter().filter(|e| e.kind == Some(Kind::Colour));
    colours().next()?;
    let mut named: FxHashSet<u32> = FxHashSet::default();
    for item in &document.items {
        match item {
            Item::Void { .. } => {}
            Item::Record(record) => named.extend(references(document, record)),
            // Any whole number of a record that cannot be read may be a reference to a colour.
            Item::Broken(broken) => {
                let tokens = document.significant(broken.first, broken.last).skip(2);
                named.extend(tokens.filter_map(|t| u32::try_from(t.integer(text)?).ok()));
            }
        }
    }
    let free: Vec<Background> = colours()
        .filter(|e| !named.contains(&e.id))
        .map(|e| Background {
            id: e.id,
            is_called_so: is_called_so(document, text, e),
        })
        .collect();
    let is_one = free.len() == 1;
    let mut meant = free.into_iter().filter(|b| is_one || b.is_called_so);
    meant.next().filter(|_| meant.next().is_none())
}

/// Whether a comment behind a colour, on its line, has a word for a background.
fn is_called_so(document: &Document, text: &str, colour: &Entity) -> bool {
    let tokens = &document.tokens;
    let first = tokens.partition_point(|t| t.start < colour.span.start);
    let on_line = tokens[first..]
        .iter()
        .take_while(|t| t.kind() != TokenKind::Newline);
    let mut comments = on_line.filter(|t| t.kind().is_comment());
    comments.any(|t| words::has(t.text(text), &WORDS))
}
