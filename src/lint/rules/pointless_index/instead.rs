//! The object that an index was meant for.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Fix};
use crate::lint::Context;
use crate::scene::record::Params;
use crate::scene::{Entity, Node, Paint, fold_up};
use crate::syntax::table::{Kind, RecordKind};
use crate::syntax::{Record, quote};

/// For an index under the ID of some optics: the ID of the only other optics that let light through and have no index,
/// and the fix that gives the index that ID. Optics that are used above the index do not count, since they would not
/// change, nor do unused ones.
pub(super) fn of_clear_optics(context: &Context, index: &Params) -> Option<(u32, Fix)> {
    let is_optics = |e: &&Entity| e.kind == Some(Kind::Optics);
    let start = index.id_span().start;
    let mut entities = context.scene.entities.iter().filter(is_optics);
    entities.find(|e| e.id == index.id)?;
    let mut clear: FxHashSet<u32> = FxHashSet::default();
    let mut without: FxHashSet<u32> = FxHashSet::default();
    let mut used: FxHashSet<u32> = FxHashSet::default();
    for record in context.records() {
        let is_above = context.document.span(record.first, record.last).start < start;
        if record.kind == RecordKind::RefractiveIndex {
            without.insert(record.id);
        }
        match is_above {
            true => without.extend(context.references(record)),
            false => used.extend(context.references(record)),
        }
        let p = context.record_params(record);
        if is_above && record.ty().transmitted().any(|i| p.number(i) > 0.0) {
            clear.insert(record.id);
        }
    }
    let entities = context.scene.entities.iter().filter(is_optics);
    let mut meant = entities
        .filter(|e| clear.contains(&e.id) && !without.contains(&e.id) && used.contains(&e.id));
    let (only, None) = (meant.next()?, meant.next()) else {
        return None;
    };
    Some((only.id, written(index, only.id)))
}

/// The fix that writes another ID in the record of an index.
fn written(index: &Params, id: u32) -> Fix {
    let text = id.to_string();
    let number = quote(&text);
    let fix = Fix::replace("fix-write", Applicability::Unsafe, index.id_span(), text);
    fix.with("number", number)
}

/// The fix that gives the index to an object that lets light through and has none: the only one, or the one whose
/// optics stand right above. `None` for an object of `without`: its optics may be meant for another object.
pub(super) fn of_glass(context: &Context, index: &Params, without: &FxHashSet<u32>) -> Option<Fix> {
    let scene = context.scene;
    let start = index.id_span().start;
    let own = |paint: u32| -> &Paint { &scene.paints[paint as usize] };
    // For each node whether any part has an index, and whether its outermost optics let light through.
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
    // An object that is used above the index would not change.
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
    Some(written(index, id))
}
