//! The fix of an object inside of a solid, where a comment on its translation says that the object lies on something.

use crate::diagnostics::{Applicability, Fix};
use crate::lint::Context;
use crate::lint::spelling::opposite;
use crate::scene::{Node, NodeId};
use crate::solids::{Named, named};
use crate::syntax::table::RecordKind;
use crate::syntax::{quote, words};
use crate::trace::plan::unseen::sides::box_of;

/// Words that say that an object lies on another one, and words that say that it lies elsewhere.
const ON: [&str; 5] = ["on", "onto", "above", "na", "nad"];
const ELSEWHERE: [&str; 9] = [
    "in", "into", "inside", "under", "below", "not", "v", "ve", "pod",
];
/// The largest share of its height by which an object on top of a solid reaches into it.
const MAX_SUNK_SHARE: f64 = 0.25;

/// The fix that gives the height of a translation the other sign, if that puts the object on top of the solid.
pub(super) fn on_top(context: &Context, node: NodeId, solid: Named) -> Option<Fix> {
    let scene = context.scene;
    let root = scene.render?.root;
    // Below another transformation, a translation is not along the axes of the scene.
    let moved = scene.states(node).find_map(|(id, node)| match node {
        Node::Transform { .. } => Some(scene.origins[id as usize]),
        _ => None,
    })?;
    let p = context.params(moved.span)?;
    if p.ty.kind != RecordKind::Translation || !p.own_comments().any(says_on) {
        return None;
    }
    let bounds = |is_it: &dyn Fn(NodeId) -> bool| box_of(scene, context.bounds(), root, is_it);
    let own = bounds(&|n| n == node)?;
    let is_solid = |n: NodeId| named(scene, n).is_some_and(|named| named.span == solid.span);
    let top = bounds(&is_solid)?.max[1];
    let bottom = own.min[1] - 2.0 * p.number(1);
    let text = opposite(&p, 1);
    let all = quote(&[p.text_of(0), &text, p.text_of(2)].join(" "));
    let fix = Fix::replace("fix-on-top", Applicability::Choice, p.span_of(1, 1), text);
    (bottom >= top - MAX_SUNK_SHARE * own.extent()[1]).then(|| fix.with("number", all))
}

fn says_on(comment: &str) -> bool {
    let all: Vec<String> = words::of_text(comment).collect();
    let has = |any: &[&str]| all.iter().any(|w| any.contains(&w.as_str()));
    has(&ON) && !has(&ELSEWHERE)
}
