//! W335: a part of what is drawn that lies wholly inside of an opaque solid, or behind an opaque plane.

pub(super) mod mended;
mod on_top;

use rustc_hash::{FxHashMap, FxHashSet};

use super::unseen_texture;
use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::scene::NodeId;
use crate::solids::{Named, named};
use crate::syntax::table::{RecordKind, ShapeKind};
use crate::trace::plan::unseen::{Unseen, Why, find_but_for_points, screened};

/// Number of nodes above which hidden parts are not looked for: that takes too long for an editor.
const MAX_NODES: usize = 5000;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if scene.nodes.len() > MAX_NODES {
        return;
    }
    let Some(render) = scene.render else { return };
    let hidden = find_but_for_points(scene, render.root).unseen;
    let buried = hidden.iter().filter_map(|part: &Unseen| match part.why {
        Why::Inside(solid) => Some((part.node, part.span, solid)),
        Why::Outside => None,
    });
    let known: FxHashSet<NodeId> = hidden.iter().map(|part| part.node).collect();
    let behind = screened(scene, context.bounds(), render.root);
    let behind = behind.iter().filter(|part| !known.contains(&part.node));
    let all = buried.chain(behind.map(|part| (part.node, part.span, part.plane)));
    let with_place = |(node, definition, solid): (NodeId, Span, Named)| {
        let named = named(scene, node)?;
        let is_own = context.params(named.span).is_some_and(|p| p.id == named.id);
        // A copy is reported at its own record, not at that of its original.
        let span = if is_own { named.span } else { definition };
        Some((Named { span, ..named }, solid, node))
    };
    let parts: Vec<(Named, Named, NodeId)> = all.filter_map(with_place).collect();
    if parts.is_empty() {
        return;
    }
    let told = told(context);
    // The parts in each solid and behind each plane, in the order of the file.
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

/// The solids and planes that hide a part of what is drawn.
pub(super) fn hiders(context: &Context) -> FxHashSet<Span> {
    let scene = context.scene;
    let Some(render) = scene.render.filter(|_| scene.nodes.len() <= MAX_NODES) else {
        return FxHashSet::default();
    };
    let buried = find_but_for_points(scene, render.root).unseen;
    let buried = buried.iter().filter_map(|part| match part.why {
        Why::Inside(solid) => Some(solid.span),
        Why::Outside => None,
    });
    let behind = screened(scene, context.bounds(), render.root);
    let behind = behind.iter().map(|part| part.plane.span);
    buried.chain(behind).collect()
}

/// The finding about all that lies in one solid, or behind one plane.
fn finding(context: &Context, solid: Named, all: &[(Named, NodeId)]) -> Diagnostic {
    let (first, _) = all[0];
    let record = context.params(solid.span);
    let kind = match record.as_ref().map(|p| p.ty.kind) {
        Some(RecordKind::Shape(kind)) => Some(kind),
        _ => None,
    };
    let own = record.filter(|p| p.id == solid.id);
    let (better, fixes) = match (&own, kind) {
        (Some(p), Some(ShapeKind::HalfSpace)) => mended::mended(context, (solid, p), all),
        (Some(p), Some(ShapeKind::Plane)) => (None, mended::plane(context, (solid, p))),
        _ => match *all {
            [(_, node)] => {
                let fix = on_top::on_top(context, node, solid);
                (fix.is_some().then_some("on-top"), Vec::from_iter(fix))
            }
            _ => Default::default(),
        },
    };
    let case = better.unwrap_or(match (kind, all.len()) {
        (Some(ShapeKind::Plane), 1) => "plane",
        (Some(ShapeKind::Plane), _) => "plane-several",
        (Some(ShapeKind::HalfSpace), 1) => "half-space",
        (Some(ShapeKind::HalfSpace), _) => "half-space-several",
        (_, 1) => "",
        (..) => "several",
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

/// The nodes of objects whose texture W331 reports as hidden: W335 does not report these objects again.
fn told(context: &Context) -> FxHashSet<NodeId> {
    let scene = context.scene;
    let mut told: FxHashSet<NodeId> = unseen_texture::hidden(context).into_iter().collect();
    if told.is_empty() {
        return told;
    }
    // The texture may be given to the part itself, or to an object within it.
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
