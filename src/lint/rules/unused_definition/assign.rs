//! The assignment that may be missing.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Fix, Span};
use crate::lint::Context;
use crate::scene::Entity;
use crate::syntax::Record;
use crate::syntax::lexer::TokenKind;
use crate::syntax::quote;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType};

/// The name of the fix's phrase.
pub(super) const TITLE: &str = "fix";

/// Whether a record gives an object a refractive index that goes with a property: the property stands above, lets light
/// through and has no index.
pub(super) fn goes_with(context: &Context, property: &Entity) -> impl Fn(&Record) -> bool {
    let is_index = |r: &Record| r.kind == RecordKind::RefractiveIndex;
    let own = || context.records().filter(|r| r.id == property.id);
    let lets_through = |r: &Record| {
        let p = context.record_params(r);
        r.ty().transmitted().any(|i| p.number(i) > 0.0)
    };
    let is_clear = property.kind == Some(Kind::Optics) && own().any(lets_through);
    let lacks_index = is_clear && !own().any(is_index);
    move |r| {
        let start = context.document.id_token(r).start;
        lacks_index && is_index(r) && start > property.span.start
    }
}

/// The fix that assigns a property to the only shape without one of its kind, or to the only one of these with a
/// refractive index. `None` if there are several, or if an operation has one.
pub(super) fn to_the_only_one(context: &Context, property: &Entity) -> Option<Fix> {
    let kind = property.kind?;
    let goes_with = goes_with(context, property);
    let gives = |r: &Record| match r.ty().effect {
        Effect::DefinesOrChanges(own, _) => own == kind && !goes_with(r),
        _ => r.kind == RecordKind::Assignment,
    };
    let given = context.records().filter(|r| gives(r)).map(|r| r.id);
    let given: FxHashSet<u32> = given.collect();
    let indices = context.records().filter(|r| goes_with(r)).map(|r| r.id);
    let indices: FxHashSet<u32> = indices.collect();
    // The properties of an operation are those of its operands, too.
    let is_given = |r: &Record| given.contains(&r.id) || indices.contains(&r.id);
    let of = |family| context.records().filter(move |r| r.ty().family == family);
    if of(Family::Operation).any(is_given) {
        return None;
    }
    let objects = of(Family::Shape).filter(|r| !given.contains(&r.id));
    let mut objects: Vec<&Record> = objects.collect();
    if objects.iter().any(|r| indices.contains(&r.id)) {
        objects.retain(|r| indices.contains(&r.id));
    }
    let &[object] = &objects[..] else {
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
    let fix = Fix::replace(TITLE, Applicability::Unsafe, at, format!("\n{record}"));
    Some(fix.with("text", quote(&record)))
}
