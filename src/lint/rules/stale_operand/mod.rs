//! W309: a change that comes too late for the operation it was meant for.
//!
//! An operation takes its operands as they are at that point. A change that comes later is plainly
//! of no use if nothing takes the operand after it: neither another operation nor the render record. If
//! something does, then the one ID stands for several states of one thing, each used where it was
//! ready; that is a way to model, and nothing is said. Nor is anything said of an original that changes after it
//! was copied: that is what copies are for. What holds for operands holds for properties, too, which an
//! assignment takes as they are, and for the colours of a texture.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Code, Diagnostic, Value};
use crate::lint::Context;
use crate::syntax::Record;
use crate::syntax::table::{Effect, Family, RecordKind};

pub fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.has_broken() {
        return;
    }
    let late = late(context);
    if late.is_empty() {
        return;
    }
    let titles = context.titles();
    for Late {
        change,
        taker,
        more,
    } in late
    {
        let title = |id| Value::Term(titles.get(&id).copied().unwrap_or("object"));
        let document = context.document;
        let case = match taker.ty.family {
            Family::Operation => "",
            _ => "property",
        };
        out.push(
            Diagnostic::new(Code::W309, document.span(change.first, change.last))
                .case(case)
                .with("change", Value::Term(change.ty.title))
                .with("id", change.id.to_string())
                .with("type", title(change.id))
                .with("taker", title(taker.id))
                .with("taker-id", taker.id.to_string())
                .with("more", Value::Count(more))
                .label(document.span(taker.first, taker.last), "taken"),
        );
    }
}

/// A change that reaches nothing.
struct Late<'a> {
    change: &'a Record,
    /// The last record that took what is changed.
    taker: &'a Record,
    /// Further changes of the same thing.
    more: u64,
}

#[derive(Default)]
struct Entry<'a> {
    taker: Option<&'a Record>,
    change: Option<&'a Record>,
    more: u64,
}

fn late<'a>(context: &Context<'a>) -> Vec<Late<'a>> {
    let mut entries: FxHashMap<u32, Entry> = FxHashMap::default();
    // What is not there yet is not taken, and the record that defines it changes nothing.
    let mut defined: FxHashSet<u32> = FxHashSet::default();
    // What these name is taken at the end of the file.
    let mut at_the_end: FxHashSet<u32> = FxHashSet::default();
    for record in context.records() {
        let kind = record.ty.kind;
        if matches!(
            kind,
            RecordKind::Render | RecordKind::MonoCamera | RecordKind::StereoCamera
        ) {
            at_the_end.extend(context.references(record));
            continue;
        }
        for id in context.references(record).filter(|id| defined.contains(id)) {
            entries.insert(
                id,
                Entry {
                    taker: Some(record).filter(|_| kind != RecordKind::Copy),
                    ..Entry::default()
                },
            );
        }
        // A promise changes nothing.
        let changes =
            !matches!(record.ty.effect, Effect::Defines(_)) && record.ty.family != Family::Bound;
        if changes
            && let Some(entry) = entries.get_mut(&record.id)
            && entry.taker.is_some()
        {
            match entry.change {
                None => entry.change = Some(record),
                Some(_) => entry.more += 1,
            }
        }
        if kind != RecordKind::Undefined {
            defined.insert(record.id);
        }
    }
    let mut late: Vec<Late> = (entries.into_iter())
        .filter(|(id, _)| !at_the_end.contains(id))
        .filter_map(|(_, e)| {
            Some(Late {
                change: e.change?,
                taker: e.taker?,
                more: e.more,
            })
        })
        .collect();
    late.sort_by_key(|l| l.change.first);
    late
}
