//! Lines behind a `#` that ends a comment although it was meant to begin one: see [`hidden::lone_signs`].

use rustc_hash::FxHashMap;

use crate::diagnostics::{Code, Diagnostic, SourceFile, Value};
use crate::syntax::Document;
use crate::syntax::hidden;

/// The note of a finding about a line behind such a `#`.
const NOTE: &str = "behind-sign";

/// Adds to findings about such lines, and to errors about IDs on them, where the comment ends. Their own fixes go,
/// since the fix of the comment is meant.
pub(super) fn retell(source: &SourceFile, document: &Document, findings: &mut [Diagnostic]) {
    let comments = hidden::records(&source.text, document);
    let all = hidden::lone_signs(&source.text, &comments);
    if all.is_empty() {
        return;
    }
    let mut of_id: FxHashMap<u32, usize> = FxHashMap::default();
    for (i, signs) in all.iter().enumerate() {
        of_id.extend(signs.ids.iter().map(|&id| (id, i)));
    }
    let follows = |d: &&mut Diagnostic| !d.code.is_about_notation() && d.code != Code::W315;
    for d in findings.iter_mut().filter(follows) {
        let before = all.partition_point(|s| s.lines[1].start <= d.span.start);
        let at = before
            .checked_sub(1)
            .filter(|&i| d.span.start < all[i].lines[1].end)
            .or_else(|| of_id.get(&id(d)?).copied());
        let Some(at) = at else { continue };
        d.fixes.clear();
        if !d.notes.contains(&NOTE) {
            let line = source.position(all[at].lines[1].start).line;
            d.notes.push(NOTE);
            d.values.push(("behind", line.to_string().into()));
        }
    }
}

/// The ID that an error speaks of.
fn id(d: &Diagnostic) -> Option<u32> {
    let id = d.values.iter().find(|v| v.0 == "id" && d.is_error());
    match id?.1 {
        Value::Text(ref text) => text.parse().ok(),
        _ => None,
    }
}
