//! W309: a change that comes too late for the operation it was meant for.
//!
//! An operation takes its operands as they are at that point. A later change is useless if nothing takes the operand
//! after the change: neither another operation nor the render record. If something does take it, the ID stands for
//! several states of one object, each used when it was ready: that is a way to model, and the rule is silent. The rule
//! is also silent about an original that changes after it was copied: that is what copies are for. The same holds for
//! properties, which an assignment takes as they are, and for the colours of a texture.

use super::overridden_property::{MAX_PROPOSED, neighbours};
use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::lint::Context;
use crate::syntax::Record;
use crate::syntax::table::{Effect, Family, Kind, RecordKind, RecordType};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.has_broken() || !context.document.contents.any(changes) {
        return;
    }
    let late = late(context);
    if late.is_empty() {
        return;
    }
    let titles = context.titles();
    for (i, late) in late.into_iter().enumerate() {
        let Late {
            change,
            taker,
            more,
        } = late;
        let title = |id| Value::Term(titles.get(&id).copied().unwrap_or("object"));
        let document = context.document;
        let case = match taker.ty().family {
            Family::Operation => "",
            _ => "property",
        };
        let mut finding = Diagnostic::new(Code::W309, document.span(change.first, change.last))
            .case(case)
            .with("change", Value::Term(change.ty().title))
            .with("id", change.id.to_string())
            .with("type", title(change.id))
            .with("taker", title(taker.id))
            .with("taker-id", taker.id.to_string())
            .with("more", Value::Count(more))
            .label(document.span(taker.first, taker.last), "taken");
        if i < MAX_PROPOSED {
            finding.fixes = match case {
                "property" => neighbours(context, change),
                _ => right_above(context, change, taker),
            };
        }
        out.push(finding);
    }
}

/// A change that comes after the last use of its ID, so that nothing uses the changed state.
struct Late<'a> {
    change: &'a Record,
    /// The last record that took the changed ID as an operand or a property.
    taker: &'a Record,
    /// The number of further changes of the same ID.
    more: u64,
}

/// The fixes that give a change to the object of the record right above, if that object has no change of its kind. They
/// are guesses where the record right below belongs to that object, too; else they are choices.
fn right_above(context: &Context, change: &Record, taker: &Record) -> Vec<Fix> {
    let records = || context.records();
    let Some(above) = records().take_while(|r| r.first < change.first).last() else {
        return Vec::new();
    };
    if above.id == change.id || above.id == taker.id {
        return Vec::new();
    }
    let below = records().find(|r| r.first > change.first);
    let is_within = below.is_some_and(|r| r.id == above.id);
    let above_id = above.id.to_string();
    let is_above = |fix: &Fix| fix.edits.iter().all(|edit| edit.text == above_id);
    let mut fixes = neighbours(context, change);
    fixes.retain(is_above);
    if is_within {
        let guess = |fix: &mut Fix| fix.applicability = Applicability::Unsafe;
        fixes.iter_mut().for_each(guess);
    }
    fixes
}

/// The state of an ID while the records are gone over in file order.
#[derive(Clone, Default)]
struct IdState<'a> {
    /// Whether the ID is defined already. An ID that is not defined yet is not taken, and the record that defines it
    /// changes nothing.
    defined: bool,
    /// Whether the render record or a choice of cameras takes the ID, in its state at the end of the file.
    at_the_end: bool,
    /// The last record that took the ID as an operand or a property.
    taker: Option<&'a Record>,
    /// The first change since then. `more` is the number of further ones.
    change: Option<&'a Record>,
    more: u64,
}

fn late<'a>(context: &Context<'a>) -> Vec<Late<'a>> {
    // An ID that nothing defines has no entry, since nothing can take it.
    let ids = &context.scene.ids;
    let number = |id| ids.get(id).map(|number| number as usize);
    let mut entries = vec![IdState::default(); context.scene.entities.len()];
    for record in context.records() {
        let kind = record.kind;
        if matches!(
            kind,
            RecordKind::Render | RecordKind::MonoCamera | RecordKind::StereoCamera
        ) {
            for number in context.references(record).filter_map(number) {
                entries[number].at_the_end = true;
            }
            continue;
        }
        for number in context.references(record).filter_map(number) {
            let taken = &mut entries[number];
            if taken.defined {
                taken.taker = Some(record).filter(|_| kind != RecordKind::Copy);
                (taken.change, taken.more) = (None, 0);
            }
        }
        let Some(number) = number(record.id) else {
            continue;
        };
        let own = &mut entries[number];
        let of = context.scene.entities[number].kind;
        if changes_kind(record.ty(), of) && own.taker.is_some() {
            match own.change {
                None => own.change = Some(record),
                Some(_) => own.more += 1,
            }
        }
        own.defined |= kind != RecordKind::Undefined;
    }
    let mut late: Vec<Late> = (entries.into_iter())
        .filter(|e| !e.at_the_end)
        .filter_map(|e| {
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

/// Whether records of a type change an entity of a kind. A promise changes nothing.
fn changes_kind(ty: &RecordType, of: Option<Kind>) -> bool {
    let is_right = of.is_none_or(|of| match ty.effect {
        Effect::Defines(_) => false,
        Effect::Changes(kinds) => kinds.contains(&of),
        Effect::DefinesOrChanges(own, kinds) => own == of || kinds.contains(&of),
    });
    changes(ty) && is_right
}

/// Whether records of a type change an entity of any kind. A promise changes nothing.
fn changes(ty: &RecordType) -> bool {
    !matches!(ty.effect, Effect::Defines(_)) && ty.family != Family::Bound
}
