//! An unused operation whose operand another operation names in the place of the unused one.

use crate::diagnostics::{Applicability, Fix};
use crate::lint::Context;
use crate::lint::rules::duplicate_operand;
use crate::scene::names::references;
use crate::scene::{Entity, Node, NodeId, Scene};
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

/// The fix that makes a union below the unused object name it in place of an operand that the union's other operand
/// holds already. `None` unless there is exactly one such union.
pub(super) fn for_one_named_twice(context: &Context, unused: &Entity) -> Option<Fix> {
    let scene = context.scene;
    let below = |i: &usize| scene.origins[*i].span.start > unused.span.start;
    let places = (0..scene.nodes.len()).filter(below).filter_map(|i| {
        let Node::Union(a, b) = scene.nodes[i] else {
            return None;
        };
        let at = [(b, a), (a, b)].map(|(part, whole)| part != whole && holds(scene, whole, part));
        let held = at.iter().position(|held| *held)?;
        Some((i, held, [b, a][held]))
    });
    let mut places = places.take(2);
    let (Some((union, held, part)), None) = (places.next(), places.next()) else {
        return None;
    };
    // In place of an equal object it would be there twice, too.
    if duplicate_operand::are_equal(scene, unused.node()?, part) {
        return None;
    }
    let p = context.params(scene.origins[union].span)?;
    let (at, kept) = match held {
        0 => (1, 0),
        _ => (0, 1),
    };
    let own = unused.id.to_string();
    let mut operands = [own.clone(), own.clone()];
    operands[kept] = p.text_of(kept).to_owned();
    let text = format!("{} {} {}", p.id, p.ty.code, operands.join(" "));
    let fix = Fix::replace("fix-twice", Applicability::Unsafe, p.span_of(at, 1), own);
    let fix = fix.with("part", p.text_of(at).to_owned());
    Some(fix.with("text", quote(&text)))
}

/// Whether a node is one of those that a union joins, at any depth. The union's parts are looked at up to a limit.
fn holds(scene: &Scene, union: NodeId, part: NodeId) -> bool {
    let mut open = vec![union];
    let mut left = MAX_PARTS;
    while let Some(node) = open.pop() {
        if node == part {
            return true;
        }
        left -= 1;
        if left == 0 {
            return false;
        }
        if let Node::Union(a, b) = scene.nodes[node as usize] {
            open.extend([a, b]);
        }
    }
    false
}

/// Most parts of a union that are compared with an operand.
const MAX_PARTS: usize = 20;

/// Whether records of a type make an object of two others: no copy, no complement.
fn joins(ty: &RecordType) -> bool {
    ty.family == Family::Operation && ty.params.len() == 2
}
