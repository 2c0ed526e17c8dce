//! A point light that a comment calls ambient, and that nothing moves.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix};
use crate::lint::Context;
use crate::scene::axes::{is_beside, words};
use crate::syntax::table::{Family, RecordKind, RecordType};
use crate::syntax::{Record, quote};

/// Beginnings of words for ambient light, without accents.
const AMBIENT: [&str; 2] = ["ambient", "okoln"];
/// The same for other lights.
const OTHERS: [&str; 9] = [
    "lamp", "bodov", "point", "spot", "bulb", "zarovk", "sun", "slunc", "slunec",
];
/// Comments of more words are about something else.
const MAX_COMMENT_WORDS: usize = 5;

pub(super) fn is_ambient(comment: &str) -> bool {
    let words = words(comment);
    let has = |any: &[&str]| words.iter().any(|w| any.iter().any(|b| w.starts_with(b)));
    words.len() <= MAX_COMMENT_WORDS
        && has(&AMBIENT)
        && !has(&OTHERS)
        && !words.iter().any(|w| is_beside(w))
}

pub(super) fn check(context: &Context, lamps: &[&Record], out: &mut Vec<Diagnostic>) {
    if lamps.is_empty() {
        return;
    }
    let moves = |r: &&Record| r.ty().family == Family::Transformation;
    let moved: FxHashSet<u32> = context.records().filter(moves).map(|r| r.id).collect();
    for record in lamps.iter().filter(|r| !moved.contains(&r.id)) {
        let p = context.record_params(record);
        let code = RecordType::of(RecordKind::AmbientLight).code.to_string();
        let span = p.type_span();
        let fix = Fix::replace("fix", Applicability::Unsafe, span, code.clone());
        out.push(
            Diagnostic::new(Code::W344, span)
                .case("ambient")
                .with("id", p.id.to_string())
                .fix(fix.with("number", quote(&code))),
        );
    }
}
