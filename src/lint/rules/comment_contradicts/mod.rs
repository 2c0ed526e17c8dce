//! W344: a record whose comment names another light, axis, colour or height than its numbers.

pub(crate) mod axes;
mod colours;
mod heights;
mod lights;

use crate::diagnostics::Diagnostic;
use crate::lint::Context;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::syntax::words::plain;

/// Words by which a comment speaks of something beside its record, or of what is not so, without accents.
const BESIDE: [&str; 44] = [
    "in", "on", "under", "behind", "for", "of", "with", "without", "and", "or", "not", "no",
    "than", "then", "instead", "was", "old", "like", "plus", "next", "before", "after", "if", "v",
    "ve", "na", "pod", "za", "u", "pro", "bez", "s", "se", "a", "i", "nebo", "ne", "neni", "misto",
    "byla", "bylo", "pak", "potom", "jako",
];

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.comments {
        return;
    }
    let mut lamps = Vec::new();
    let mut planes = Vec::new();
    for record in context.records() {
        let p = || context.record_params(record);
        match record.kind {
            RecordKind::Rotation => out.extend(axes::check(context, &p())),
            RecordKind::Colour => out.extend(colours::check(&p())),
            RecordKind::PointLight if p().own_comments().any(lights::is_ambient) => {
                lamps.push(record);
            }
            RecordKind::Shape(ShapeKind::Plane | ShapeKind::HalfSpace) => {
                planes.extend(heights::said(&p()).map(|said| (record, said)));
            }
            _ => {}
        }
    }
    // What cannot be read may move anything.
    if !context.has_broken() {
        lights::check(context, &lamps, out);
        heights::check(context, &planes, out);
    }
}

/// The words of a comment without accents and in lower case; numbers are words, too.
fn words(comment: &str) -> Vec<String> {
    let words = comment.split(|c: char| !c.is_alphanumeric());
    words.filter(|w| !w.is_empty()).map(plain).collect()
}

fn is_beside(word: &str) -> bool {
    BESIDE.contains(&word)
}
