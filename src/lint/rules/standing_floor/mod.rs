//! W343: a rectangle that a comment calls a floor, and that stands upright.

use crate::diagnostics::{Applicability, Code, Diagnostic};
use crate::lint::Context;
use crate::lint::records::chosen_cameras;
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::syntax::words::{self, FLOOR, denies};

/// Words that show that a comment speaks of something beside the floor, without accents.
const BESIDE: [&str; 20] = [
    "on", "under", "above", "over", "from", "below", "plan", "lamp", "wall", "walls", "na", "nad",
    "pod", "od", "z", "s", "stena", "steny", "zed", "zdi",
];
/// Comments of more words are about something else.
const MAX_COMMENT_WORDS: usize = 6;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.document.contents.comments {
        return;
    }
    // In the picture, up must be along y.
    let cameras = chosen_cameras(context);
    let is_along_y = |up: &[f64; 3]| up[1].abs() > up[0].abs().max(up[2].abs());
    if cameras.is_empty() || !cameras.iter().all(|(c, _)| is_along_y(&c.up)) {
        return;
    }
    let is_rectangle = RecordKind::Shape(ShapeKind::Rectangle);
    let called = context
        .records()
        .filter(|r| r.kind == is_rectangle && context.record_params(r).comments().any(is_floor));
    let called: Vec<_> = called.collect();
    if called.is_empty() {
        return;
    }
    let turns = [RecordKind::Rotation, RecordKind::RotationMatrix];
    let turned = context.with_parts(|r| turns.contains(&r.kind));
    for record in called.into_iter().filter(|r| !turned.contains(&r.id)) {
        let span = context.document.span(record.first, record.last);
        // This rotation turns the side with the normal along z upwards.
        let line = format!("{} -2 -90 1", record.id);
        let lines = [line.clone()];
        let fix = context.add_behind(span, "fix", Applicability::Unsafe, &lines);
        out.push(
            Diagnostic::new(Code::W343, span)
                .with("id", record.id.to_string())
                .fix(fix.with("line", line)),
        );
    }
}

fn is_floor(comment: &str) -> bool {
    let words: Vec<String> = words::of_text(comment)
        .take(MAX_COMMENT_WORDS + 1)
        .collect();
    let has = |any: &[&str]| words.iter().any(|w| any.contains(&w.as_str()));
    words.len() <= MAX_COMMENT_WORDS
        && words::has(comment, &FLOOR)
        && !has(&BESIDE)
        && !denies(comment)
}
