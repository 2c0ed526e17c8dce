//! The object that an index was meant for.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Fix};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Entity, Node, Paint, fold_up};
use crate::syntax::table::{Kind, RecordKind};
use crate::syntax::{Record, quote};

/// The index with the ID of the object that lets light through and has no index: the one whose record stands right
/// above, or the only one. None of those `without` it: their optics may be meant for another object themselves.
pub(super) fn of_glass(context: &Context, index: &Params, without: &FxHashSet<u32>) -> Option<Fix> {
    let scene = context.scene;
    let start = index.id_span().start;
    let own = |paint: u32| -> &Paint { &scene.paints[paint as usize] };
    // Whether any part has an index of its own, and whether what is outermost lets light through.
    let known = fold_up(&scene.nodes, |_, node, known: &[(bool, bool)]| {
        let has_index = node.children().any(|n| known[n as usize].0);
        match node {
            Node::Paint { child, paint } => {
                let paint = own(paint);
                let is_clear = paint.optics.map(|o| o.kt.iter().any(|&k| k > 0.0));
                let is_clear = is_clear.unwrap_or(known[child as usize].1);
                (has_index || paint.index.is_some(), is_clear)
            }
            Node::Transform { child, .. } | Node::Copy { child, .. } => known[child as usize],
            _ => (has_index, false),
        }
    });
    let above = context.records();
    let above = above.take_while(|r| context.document.span(r.first, r.last).start < start);
    let above: Vec<&Record> = above.collect();
    // What is used above the index would not change.
    let taken: FxHashSet<u32> = (above.iter().flat_map(|r| context.references(r))).collect();
    let is_meant = |e: &&Entity| {
        let is_other = e.kind == Some(Kind::Object) && e.id != index.id && e.span.start < start;
        let is_glass = |node: u32| known[node as usize] == (false, true);
        is_other && !taken.contains(&e.id) && e.node().is_some_and(is_glass)
    };
    let mut meant = scene.entities.iter().filter(is_meant).map(|e| e.id);
    let (first, second) = (meant.next()?, meant.next());
    let id = match second {
        None => first,
        Some(second) => {
            let last = above.last().filter(|r| r.kind == RecordKind::Optics)?;
            let mut all = [first, second].into_iter().chain(meant);
            all.find(|id| *id == last.id)?
        }
    };
    if without.contains(&id) {
        return None;
    }
    let text = id.to_string();
    let fix = Fix::replace(
        "fix-write",
        Applicability::Unsafe,
        index.id_span(),
        text.clone(),
    );
    Some(fix.with("number", quote(&text)))
}
