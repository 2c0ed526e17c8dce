//! The assignment that may be missing.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Fix, Span};
use crate::lint::Context;
use crate::scene::Entity;
use crate::syntax::Record;
use crate::syntax::lexer::TokenKind;
use crate::syntax::quote;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType};

/// The fix that assigns a property to the only shape without one of its kind. `None` if there are several, or if an
/// operation has one.
pub(super) fn to_the_only_one(context: &Context, property: &Entity) -> Option<Fix> {
    let kind = property.kind?;
    let gives = |ty: &RecordType| match ty.effect {
        Effect::DefinesOrChanges(own, _) => own == kind,
        _ => ty.kind == RecordKind::Assignment,
    };
    let given = context.records().filter(|r| gives(r.ty())).map(|r| r.id);
    let given: FxHashSet<u32> = given.collect();
    // The properties of an operation are those of its operands, too.
    let is_given = |r: &Record| given.contains(&r.id);
    let of = |family| context.records().filter(move |r| r.ty().family == family);
    if of(Family::Operation).any(is_given) {
        return None;
    }
    let mut objects = of(Family::Shape).filter(|r| !is_given(r));
    let (object, None) = (objects.next()?, objects.next()) else {
        return None;
    };
    let own = context.records().find(|r| {
        let span = context.document.span(r.first, r.last);
        span.start == property.span.start
    })?;
    let last = object.last.max(own.last);
    let tokens = &context.document.tokens;
    let behind = tokens[last as usize + 1..].iter();
    let on_line = behind
        .clone()
        .take_while(|t| t.kind() != TokenKind::Newline);
    // The line may have closed comments behind the record, and nothing else.
    let end = on_line
        .clone()
        .last()
        .map_or(tokens[last as usize].end(), |t| t.end());
    if !on_line.clone().all(|t| t.kind() == TokenKind::Comment) {
        return None;
    }
    let code = RecordType::of(RecordKind::Assignment).code;
    let record = match kind {
        Kind::Optics => format!("{} {code} 0 {}", object.id, property.id),
        Kind::Texture | Kind::Colour => format!("{} {code} {} 0", object.id, property.id),
        _ => return None,
    };
    let at = Span::new(end, end);
    let fix = Fix::replace("fix", Applicability::Unsafe, at, format!("\n{record}"));
    Some(fix.with("text", quote(&record)))
}
