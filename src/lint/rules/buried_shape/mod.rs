//! W335: a part of what is drawn that lies wholly inside of an opaque solid.

mod mended;

use rustc_hash::{FxHashMap, FxHashSet};

use super::unseen_texture;
use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::scene::NodeId;
use crate::solids::{Named, named};
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::trace::plan::unseen::{Unseen, Why, find_but_for_points};

/// Number of nodes above which hidden parts are not looked for: that takes too long for an editor.
const MAX_NODES: usize = 5000;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if scene.nodes.len() > MAX_NODES {
        return;
    }
    let Some(render) = scene.render else { return };
    let hidden = find_but_for_points(scene, render.root).unseen;
    let inside = |part: &Unseen| match part.why {
        Why::Inside(solid) => {
            let named = named(scene, part.node)?;
            let is_own = context.params(named.span).is_some_and(|p| p.id == named.id);
            // The place of a copy, not of its original.
            let span = if is_own { named.span } else { part.span };
            Some((Named { span, ..named }, solid, part.node))
        }
        Why::Outside => None,
    };
    let parts: Vec<(Named, Named, NodeId)> = hidden.iter().filter_map(inside).collect();
    if parts.is_empty() {
        return;
    }
    let told = told(context);
    // Of each solid what is in it, in the order of the file.
    let mut order: Vec<Named> = Vec::new();
    let mut held: FxHashMap<(u32, Span), Vec<(Named, NodeId)>> = FxHashMap::default();
    let mut seen = FxHashSet::default();
    for (part, solid, node) in parts {
        if told.contains(&node) || !seen.insert((part.id, part.span, solid.id)) {
            continue;
        }
        let all = held.entry((solid.id, solid.span)).or_default();
        if all.is_empty() {
            order.push(solid);
        }
        all.push((part, node));
    }
    for solid in order {
        let all = &held[&(solid.id, solid.span)];
        out.push(finding(context, solid, all));
    }
}

/// The finding about all that lies in one solid.
fn finding(context: &Context, solid: Named, all: &[(Named, NodeId)]) -> Diagnostic {
    let (first, _) = all[0];
    let half_space = context
        .params(solid.span)
        .filter(|p| p.ty.kind == RecordKind::Shape(ShapeKind::HalfSpace));
    let is_half_space = half_space.is_some();
    let own = half_space.filter(|p| p.id == solid.id);
    let (better, fixes) = match &own {
        Some(p) => mended::mended(context, (solid, p), all),
        None => Default::default(),
    };
    let case = better.unwrap_or(match (is_half_space, all.len()) {
        (false, 1) => "",
        (false, _) => "several",
        (true, 1) => "half-space",
        (true, _) => "half-space-several",
    });
    let finding = Diagnostic::new(Code::W335, first.span)
        .case(case)
        .with("object", Value::Term(first.title))
        .with("object-id", first.id.to_string())
        .with("count", Value::Count(all.len() as u64))
        .with("solid", Value::Term(solid.title))
        .with("solid-id", solid.id.to_string())
        .label(solid.span, "solid");
    fixes.into_iter().fold(finding, Diagnostic::fix)
}

/// The nodes that belong to something whose texture is hidden for several reasons: of that W331 speaks.
fn told(context: &Context) -> FxHashSet<NodeId> {
    let scene = context.scene;
    let mut told: FxHashSet<NodeId> = unseen_texture::hidden(context).into_iter().collect();
    if told.is_empty() {
        return told;
    }
    // A texture is given to a part, or to something within it.
    for (id, node) in (0..scene.nodes.len() as NodeId).zip(&scene.nodes).rev() {
        if told.contains(&id) {
            told.extend(node.children());
        }
    }
    for (id, node) in (0..).zip(&scene.nodes) {
        if node.is_change() && node.children().any(|n| told.contains(&n)) {
            told.insert(id);
        }
    }
    told
}
