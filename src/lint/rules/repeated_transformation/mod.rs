//! W336: a transformation that occurs twice, one right behind the other; a second move of a lamp right behind another
//! lamp that nothing moves; a note on a move of a shape that has a place, right behind a shape that nothing moves; a
//! transformation of an earlier object among the records of a later one.

mod group;
mod other_shape;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::syntax::table::RecordKind;
use crate::syntax::{Item, Record, quote};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for pair in context.document.items.windows(2) {
        let [Item::Record(first), Item::Record(second)] = pair else {
            continue;
        };
        if !super::TRANSFORMATIONS.contains(&first.kind) || !is_repeated(context, first, second) {
            continue;
        }
        let p = context.record_params(second);
        let d = Diagnostic::new(Code::W336, p.span())
            .with("type", Value::Term(p.ty.title))
            .with("id", p.id.to_string())
            .label(context.record_params(first).span(), "first");
        out.push(
            match context.take_out(second, "fix", Applicability::Unsafe) {
                Some(fix) => d.fix(fix),
                None => d,
            },
        );
    }
    group::check(context, out);
    other_lamps(context, out);
    other_shape::check(context, out);
}

/// Reports each second move of a lamp that stands right behind another lamp, which nothing moves.
fn other_lamps(context: &Context, out: &mut Vec<Diagnostic>) {
    let lamps = context
        .records()
        .filter(|r| r.kind == RecordKind::PointLight);
    let lamps: FxHashMap<u32, &Record> = lamps.map(|r| (r.id, r)).collect();
    if lamps.len() < 2 {
        return;
    }
    let is_move = |r: &&Record| super::TRANSFORMATIONS.contains(&r.kind);
    let changed: FxHashSet<u32> = context.records().filter(is_move).map(|r| r.id).collect();
    // The lamps that a translation above has moved.
    let mut placed: FxHashSet<u32> = FxHashSet::default();
    let mut above: Option<&Record> = None;
    for record in context.records() {
        let is_place = record.kind == RecordKind::Translation && lamps.contains_key(&record.id);
        if is_place
            && !placed.insert(record.id)
            && let Some(other) = above.and_then(|r| lamps.get(&r.id))
            && !changed.contains(&other.id)
        {
            out.push(other_lamp(context, record, other));
        }
        above = Some(record);
    }
}

/// The finding about the move `place` of one lamp that is rather meant for the lamp `other`.
fn other_lamp(context: &Context, place: &Record, other: &Record) -> Diagnostic {
    let p = context.record_params(place);
    let id = other.id.to_string();
    let fix = Fix::replace("fix-write", Applicability::Unsafe, p.id_span(), id.clone());
    Diagnostic::new(Code::W336, p.span())
        .case("lamp")
        .with("type", Value::Term(other.ty().title))
        .with("id", p.id.to_string())
        .with("other", id.clone())
        .label(context.record_params(other).span(), "first")
        .fix(fix.with("number", quote(&id)))
}

/// Whether two records are the same word for word, without a comment in between, which would say that both are meant.
fn is_repeated(context: &Context, first: &Record, second: &Record) -> bool {
    let words = |r: &Record| {
        let tokens = context.document.significant(r.first, r.last);
        tokens.map(|t| t.text(context.text))
    };
    let between = &context.document.tokens[first.last as usize..second.first as usize];
    first.kind == second.kind
        && first.id == second.id
        && !between.iter().any(|t| t.kind().is_comment())
        && words(first).eq(words(second))
}
