//! An unused operation whose operand another operation names in the place of the unused one.

use crate::diagnostics::{Applicability, Fix};
use crate::lint::Context;
use crate::scene::Entity;
use crate::scene::names::references;
use crate::syntax::table::{Family, RecordType};
use crate::syntax::{Record, quote};

/// The fix that makes an operation below name the unused one in place of an operand of the unused one. `None` unless
/// that is the only other use of these operands.
pub(super) fn in_its_place(context: &Context, unused: &Entity) -> Option<Fix> {
    let own = context.params(unused.span)?;
    if !joins(own.ty) {
        return None;
    }
    let is_own = |r: &&Record| context.document.span(r.first, r.last).start == unused.span.start;
    let record = context.records().find(is_own)?;
    let parts: Vec<u32> = references(context.document, record).collect();
    let others = context.records().filter(|r| r.first != record.first);
    let uses = others.flat_map(|r| {
        let named = references(context.document, r).enumerate();
        named.map(move |(at, id)| (r, at, id))
    });
    let mut uses = uses.filter(|(_, _, id)| parts.contains(id));
    let (Some((user, at, part)), None) = (uses.next(), uses.next()) else {
        return None;
    };
    if !joins(user.ty()) || user.first < record.first {
        return None;
    }
    let user = context.params(context.document.span(user.first, user.last))?;
    let place = user.span_of(at, 1);
    let own = unused.id.to_string();
    let mut words = vec![user.id.to_string(), user.ty.code.to_string()];
    let operands = 0..user.ty.params.len();
    words.extend(operands.map(|i| match i == at {
        true => own.clone(),
        false => user.text_of(i).to_owned(),
    }));
    let fix = Fix::replace("fix", Applicability::Choice, place, own);
    let fix = fix.with("part", part.to_string());
    Some(fix.with("text", quote(&words.join(" "))))
}

/// Whether records of a type make an object of two others: no copy, no complement.
fn joins(ty: &RecordType) -> bool {
    ty.family == Family::Operation && ty.params.len() == 2
}
