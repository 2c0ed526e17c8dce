//! A property of a whole object that overrides different properties of several parts: none of these has an effect.

use rustc_hash::{FxHashMap, FxHashSet};

use super::{MAX_PROPOSED, neighbours};
use crate::diagnostics::{Code, Diagnostic, Span, Value};
use crate::lint::Context;
use crate::lint::properties::{ASPECTS, sets};
use crate::scene::{Node, NodeId, Paint, Scene, Texture};
use crate::syntax::Item;

/// The cases of the message, by aspect.
const CASES: [&str; ASPECTS] = ["whole", "whole-optics", "whole-index"];

/// Least number of parts whose property is overridden, with different values: a single one may be a default of the
/// part.
const MIN_VALUES: usize = 2;

/// Most records that get a label.
const MAX_LABELS: usize = 8;

/// Adds the findings, one for each record that gives a property to a whole object.
pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    if context.has_broken() || scene.paints.len() <= MIN_VALUES {
        return;
    }
    let Some(render) = scene.render else { return };
    let above = Above::new(scene, render.root);
    let given = given(scene);
    let mut told: FxHashSet<Span> = FxHashSet::default();
    for (aspect, case) in CASES.into_iter().enumerate() {
        for (cover, parts) in above.taken_away(scene, aspect) {
            let span = given[&cover][aspect];
            // An assignment that gives several aspects is reported once.
            if told.contains(&span) {
                continue;
            }
            let mut spans: Vec<Span> = parts.iter().map(|node| given[node][aspect]).collect();
            spans.sort_unstable_by_key(|span| span.start);
            spans.dedup();
            let Some(d) = finding(context, span, &spans, told.len() < MAX_PROPOSED) else {
                continue;
            };
            told.insert(span);
            out.push(d.case(case));
        }
    }
}

fn finding(context: &Context, span: Span, parts: &[Span], is_proposed: bool) -> Option<Diagnostic> {
    let at = context.document.item_at(span.start)?;
    let Item::Record(record) = &context.document.items[at] else {
        return None;
    };
    let mut d = Diagnostic::new(Code::W334, span)
        .with("change", Value::Term(record.ty().title))
        .with("id", record.id.to_string())
        .with("count", Value::Count(parts.len() as u64));
    for &part in parts.iter().take(MAX_LABELS) {
        d = d.label(part, "part");
    }
    if is_proposed {
        d.fixes = neighbours(context, record);
    }
    Some(d)
}

/// For each node that paints the spans of the records that give its aspects. Properties given to an object one after
/// the other are one paint.
fn given(scene: &Scene) -> FxHashMap<NodeId, [Span; ASPECTS]> {
    let mut given: FxHashMap<NodeId, [Span; ASPECTS]> = FxHashMap::default();
    let mut last: FxHashMap<NodeId, NodeId> = FxHashMap::default();
    for (node, child, paint) in paints(scene) {
        let mut spans = [scene.origins[node as usize].span; ASPECTS];
        if let Some(before) = last.insert(child, node)
            && let Node::Paint { paint: old, .. } = scene.nodes[before as usize]
            && let old = &scene.paints[old as usize]
            && old.owner == paint.owner
        {
            for aspect in 0..ASPECTS {
                if is_same(aspect, old, paint) {
                    spans[aspect] = given[&before][aspect];
                }
            }
        }
        given.insert(node, spans);
    }
    given
}

/// The nodes that paint, each with its child and its paint.
fn paints(scene: &Scene) -> impl Iterator<Item = (NodeId, NodeId, &Paint)> {
    let nodes = (0..).zip(&scene.nodes);
    nodes.filter_map(|(node, n)| match *n {
        Node::Paint { child, paint } => Some((node, child, &scene.paints[paint as usize])),
        _ => None,
    })
}

fn is_same(aspect: usize, one: &Paint, other: &Paint) -> bool {
    match aspect {
        0 => one.texture == other.texture,
        1 => one.optics == other.optics,
        _ => one.index == other.index,
    }
}

/// The paints above each node that is drawn, aspect by aspect. A node that is only taken away from another object
/// counts as not drawn: another rule reports it.
struct Above {
    /// Whether the node has a way up on which nothing gives the aspect.
    free: Vec<[bool; ASPECTS]>,
    /// The nearest paint that gives the aspect on one of the ways up.
    cover: Vec<[Option<NodeId>; ASPECTS]>,
}

impl Above {
    fn new(scene: &Scene, root: NodeId) -> Above {
        let mut free = vec![[false; ASPECTS]; scene.nodes.len()];
        let mut cover = vec![[None; ASPECTS]; scene.nodes.len()];
        free[root as usize] = [true; ASPECTS];
        // Children stand before their parents.
        for at in (0..=root as usize).rev() {
            let node = scene.nodes[at];
            let given = match node {
                Node::Paint { paint, .. } => sets(&scene.paints[paint as usize]),
                _ => [false; ASPECTS],
            };
            let tool = match node {
                Node::Difference(_, tool) => Some(tool),
                _ => None,
            };
            for child in node.children().filter(|&child| tool != Some(child)) {
                let child = child as usize;
                for aspect in 0..ASPECTS {
                    let own = given[aspect].then_some(at as NodeId);
                    free[child][aspect] |= free[at][aspect] && !given[aspect];
                    cover[child][aspect] = cover[child][aspect].or(own).or(cover[at][aspect]);
                }
            }
        }
        Above { free, cover }
    }

    /// The nodes of whole objects whose paints override different values of an aspect, each with the nodes of the
    /// paints below that give these values. A whole object is left out if one of the values is seen elsewhere: the
    /// whole then has a look of its own on purpose.
    fn taken_away(&self, scene: &Scene, aspect: usize) -> Vec<(NodeId, Vec<NodeId>)> {
        let mut of: FxHashMap<NodeId, Vec<NodeId>> = FxHashMap::default();
        let mut kept: Vec<NodeId> = Vec::new();
        for (node, _, paint) in paints(scene).filter(|(_, _, paint)| sets(paint)[aspect]) {
            let Some(cover) = self.cover[node as usize][aspect] else {
                continue;
            };
            if self.free[node as usize][aspect] {
                kept.push(cover);
            // W331 reports textures.
            } else if aspect != 0 || matches!(paint.texture, Some(Texture::Colour(_))) {
                of.entry(cover).or_default().push(node);
            }
        }
        for cover in kept {
            of.remove(&cover);
        }
        let paint = |node: NodeId| match scene.nodes[node as usize] {
            Node::Paint { paint, .. } => Some(&scene.paints[paint as usize]),
            _ => None,
        };
        let differ = |nodes: &[NodeId]| {
            let mut paints = nodes.iter().filter_map(|&node| paint(node));
            let first = paints.next();
            first.is_some_and(|first| paints.any(|other| !is_same(aspect, first, other)))
        };
        of.retain(|_, nodes| nodes.len() >= MIN_VALUES && differ(nodes));
        let mut all: Vec<(NodeId, Vec<NodeId>)> = of.into_iter().collect();
        all.sort_unstable_by_key(|(cover, _)| *cover);
        all
    }
}
