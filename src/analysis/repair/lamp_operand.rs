//! A light as an operand of a union: the light shines by itself, so the other operand can replace the union.

use rustc_hash::{FxHashMap, FxHashSet};

use super::switched_off::instead;
use super::whole::{records, references};
use super::{Engine, judge};
use crate::analysis::Analysis;
use crate::diagnostics::{Applicability, Diagnostic, Edit, Fix, Span};
use crate::syntax::table::{Kind, RecordKind};
use crate::syntax::{Record, quote};

/// The most unions for which guesses are tried.
const MAX_TRIED: usize = 4;

impl Engine<'_> {
    /// Proposes to do without unions that have a light as an operand. If there is an unused object, it may be meant in
    /// place of the light, so the proposal is a choice.
    pub(super) fn lamp_operands(&mut self) {
        let is_one = |d: &Diagnostic| d.notes.contains(&"no-part") && d.fixes.is_empty();
        let all = (0..self.findings.len()).filter(|&at| is_one(&self.findings[at]));
        let all: Vec<usize> = all.take(MAX_TRIED).collect();
        if all.is_empty() {
            return;
        }
        let analysis = self.analysis;
        let mut unions: FxHashMap<Span, &Record> = FxHashMap::default();
        let mut named: FxHashSet<i64> = FxHashSet::default();
        for record in records(analysis) {
            for (token, id) in references(analysis, record) {
                named.insert(id);
                if record.kind == RecordKind::Union {
                    unions.insert(token.span(), record);
                }
            }
        }
        let mut objects = (analysis.scene.entities.iter()).filter(|e| e.kind == Some(Kind::Object));
        let applicability = match objects.any(|e| !named.contains(&i64::from(e.id))) {
            true => Applicability::Choice,
            false => Applicability::Unsafe,
        };
        for at in all {
            let place = self.findings[at].span;
            let union = unions.get(&place);
            let fix = union.and_then(|union| without(analysis, union, place, applicability));
            let scene = fix.as_ref().and_then(|fix| self.attempt(Some(fix), &[]));
            if scene.is_some_and(|s| judge::errors(&s) < judge::errors(analysis)) {
                self.findings[at].fixes.extend(fix);
            }
        }
    }
}

/// The fix that deletes a union on a line of its own, and writes its other operand wherever the union is used or
/// changed. `None` if something else stands on the line.
fn without(
    analysis: &Analysis,
    union: &Record,
    light: Span,
    applicability: Applicability,
) -> Option<Fix> {
    let mut others = references(analysis, union).filter(|(token, _)| token.span() != light);
    let (_, other) = others.next()?;
    let other = u32::try_from(other).ok().filter(|&id| id != union.id)?;
    let document = &analysis.document;
    let span = document.span(union.first, union.last);
    let source = &analysis.source;
    let number = source.line_index(span.start);
    let line = source.line_span(number);
    let behind = source.text.get(span.end as usize..line.end as usize)?;
    let before = source.text.get(line.start as usize..span.start as usize)?;
    let is_comment = behind.trim().is_empty() || behind.trim_start().starts_with('#');
    let starts = |r: &Record| document.id_token(r).start;
    let is_alone = !records(analysis).any(|r| (span.end..line.end).contains(&starts(r)));
    if !before.trim().is_empty() || !is_comment || !is_alone {
        return None;
    }
    let end = match number + 1 < source.line_count() {
        true => source.line_span(number + 1).start,
        false => line.end,
    };
    let mut edits = vec![Edit {
        span: Span::new(line.start, end),
        text: String::new(),
    }];
    edits.extend(instead(analysis, union.id, other, end));
    edits.sort_by_key(|edit| edit.span.start);
    let fix = Fix {
        applicability,
        ..Fix::guess("fix-without-light", edits)
    };
    let text = other.to_string();
    Some(
        fix.with("other", union.id.to_string())
            .with("number", quote(&text)),
    )
}
