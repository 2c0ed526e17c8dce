//! Proposals for an assignment that takes back a texture or a colour.

use crate::diagnostics::{Applicability, Edit, Fix, Span};
use crate::lint::Context;
use crate::syntax::table::RecordKind;
use crate::syntax::{Record, quote};

/// Adds the fix that keeps the texture: the record that gave it moves behind the assignment, or two assignments become
/// one. The fix is a choice if there are other fixes, for which the assignment is meant for another object.
pub(super) fn propose(context: &Context, first: &Record, second: &Record, fixes: &mut Vec<Fix>) {
    let applicability = match fixes.is_empty() {
        true => Applicability::Unsafe,
        false => Applicability::Choice,
    };
    fixes.extend(match first.kind {
        RecordKind::Assignment => joined(context, first, second, applicability),
        _ => behind(context, first, second, applicability),
    });
}

fn joined(
    context: &Context,
    first: &Record,
    second: &Record,
    applicability: Applicability,
) -> Option<Fix> {
    let mut fix = context.take_out(first, "fix-join", applicability)?;
    let text = context.record_params(first).text_of(0).to_owned();
    let number = quote(&text);
    let span = context.record_params(second).span_of(0, 1);
    fix.edits.push(Edit { span, text });
    Some(fix.with("number", number))
}

/// The fix that moves the first record behind the assignment. `None` if the record is a texture and a transformation
/// stands in between: a texture moves with its object.
fn behind(
    context: &Context,
    first: &Record,
    second: &Record,
    applicability: Applicability,
) -> Option<Fix> {
    let mut between = (context.records())
        .skip_while(|r| r.first <= first.first)
        .take_while(|r| r.first < second.first);
    let text = text_of(context, first)?;
    if first.kind != RecordKind::Colour
        && between.any(|r| r.id == first.id && super::super::TRANSFORMATIONS.contains(&r.kind))
    {
        return None;
    }
    let mut fix = context.take_out(first, "fix-behind", applicability)?;
    let span = context.document.span(second.first, second.last);
    let behind = context.add_behind(span, "fix-behind", applicability, &[text]);
    fix.edits.extend(behind.edits);
    Some(fix)
}

/// The text of a record on one line; `None` if the record has several.
fn text_of(context: &Context, record: &Record) -> Option<String> {
    let Span { start, end } = context.document.span(record.first, record.last);
    let text = &context.text[start as usize..end as usize];
    (!text.contains(['\r', '\n'])).then(|| text.to_owned())
}
