//! Glass without an index in a scene in which other glass has one: the index is rather forgotten.

use rustc_hash::FxHashSet;

use super::{Member, PAIRS, Test, finding, is_clear, is_glass, members};
use crate::diagnostics::{Diagnostic, Value};
use crate::lint::Context;
use crate::lint::parts::Parts;
use crate::lint::spelling::spelled;
use crate::scene::NodeId;
use crate::solids::named;

/// The finding about solids that let half of the light through and have no index, if another solid that lets light
/// through has one. A solid within the box of a solid with an index is left out: it may be a bubble of air.
pub(super) fn others(context: &Context, root: NodeId, kinds: &[Parts]) -> Option<Diagnostic> {
    let scene = context.scene;
    let is_like: Test = |o| is_glass(o) && !is_clear(o);
    let lets_light: Test = |o| o.kt.iter().any(|&x| x > 0.0);
    let bending = members(context, root, lets_light)?.into_iter();
    let bending: Vec<Member> = bending
        .filter(|m| m.meets && m.is_solid(kinds))
        .filter(|m| m.index.is_some())
        .collect();
    let first = bending.first()?;
    let other = named(scene, first.node)?;
    let mut left = PAIRS;
    let mut told = FxHashSet::default();
    let mut forgotten = Vec::new();
    let plain = members(context, root, is_like)?.into_iter();
    for part in plain.filter(|m| m.is_plain() && m.is_solid(kinds)) {
        match left.checked_sub(bending.len()) {
            Some(rest) => left = rest,
            None => break,
        }
        if bending.iter().any(|m| m.bounds.holds(&part.bounds)) {
            continue;
        }
        if let (Some(object), Some(paint)) = (named(scene, part.node), part.paint)
            && told.insert(paint)
        {
            forgotten.push((object, scene.origins[paint as usize]));
        }
    }
    let index = first.index?.map(spelled).join(" ");
    let d = finding(context, &forgotten, ["unlike", "unlike-several"], &index)?;
    let d = d.label(other.span, "other");
    let d = d.with("other", Value::Term(other.title));
    Some(d.with("other-id", other.id.to_string()))
}
