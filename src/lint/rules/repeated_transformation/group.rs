//! A transformation of an earlier object among the records of a later one. If the later object has none of that type,
//! the later one is meant.

use std::cell::LazyCell;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::lint::rules::{TRANSFORMATIONS, duplicate_operand};
use crate::scene::NodeId;
use crate::syntax::table::{Effect, Kind, RecordKind};
use crate::syntax::{Record, quote};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let is_move = |r: &&Record| TRANSFORMATIONS.contains(&r.kind);
    let mut counts: FxHashMap<(u32, RecordKind), usize> = FxHashMap::default();
    for record in context.records().filter(is_move) {
        *counts.entry((record.id, record.kind)).or_default() += 1;
    }
    if context.has_broken() || counts.values().all(|&count| count < 2) {
        return;
    }
    let nodes = LazyCell::new(|| -> FxHashMap<u32, NodeId> {
        let entities = context.scene.entities.iter();
        entities.filter_map(|e| Some((e.id, e.node()?))).collect()
    });
    // W333 reports equal shapes in one place.
    let are_equal = |a: u32, b: u32| match (nodes.get(&a), nodes.get(&b)) {
        (Some(&a), Some(&b)) => duplicate_operand::are_equal(context.scene, a, b),
        _ => false,
    };
    // The transformations of all objects above the last one, and the IDs that records above use.
    let mut above: FxHashSet<(u32, RecordKind)> = FxHashSet::default();
    let mut used: FxHashSet<u32> = FxHashSet::default();
    // The last object, as long as all records below are about it, and its transformations.
    let mut last: Option<&Record> = None;
    let mut own: Vec<(u32, RecordKind)> = Vec::new();
    let mut objects: FxHashSet<u32> = FxHashSet::default();
    for record in context.records() {
        used.extend(context.references(record));
        if matches!(record.ty().effect, Effect::Defines(Kind::Object)) {
            above.extend(own.drain(..));
            objects.insert(record.id);
            last = Some(record);
            continue;
        }
        let given = (record.id, record.kind);
        if last.is_some_and(|last| last.id == record.id) {
            own.extend(is_move(&record).then_some(given));
            continue;
        }
        if let Some(later) = last
            && is_move(&record)
            && objects.contains(&record.id)
            && above.contains(&given)
            && !used.contains(&record.id)
            && !counts.contains_key(&(later.id, record.kind))
        {
            if !are_equal(record.id, later.id) {
                out.push(finding(context, record, later));
            }
            continue;
        }
        last = None;
        above.extend(own.drain(..));
        above.insert(given);
    }
}

/// The finding about the transformation `record` of an earlier object that is rather meant for the object `later`.
fn finding(context: &Context, record: &Record, later: &Record) -> Diagnostic {
    let p = context.record_params(record);
    let id = later.id.to_string();
    let fix = Fix::replace("fix-write", Applicability::Choice, p.id_span(), id.clone());
    Diagnostic::new(Code::W336, p.span())
        .case("group")
        .with("change", Value::Term(p.ty.title))
        .with("type", Value::Term(later.ty().title))
        .with("id", p.id.to_string())
        .with("other", id.clone())
        .label(context.record_params(later).span(), "first")
        .fix(fix.with("number", quote(&id)))
}
