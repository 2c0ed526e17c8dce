//! W333: a thing that occurs twice in one place: a union or an intersection of an object with itself, a union of an
//! object with a copy that has not been moved or with an equal shape, a checkerboard of one colour, two equal lamps.

mod checkerboard;
mod equal;
mod lamps;

use std::cell::LazyCell;

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Span, Value};
use crate::lint::{Context, live_nodes};
use crate::scene::record::Params;
use crate::scene::{Entity, Node, NodeId, Scene};
use crate::solids::named_core;
use crate::syntax::quote;
use crate::syntax::table::Kind;

pub(super) use checkerboard::of_one_colour;
pub(super) use equal::are as are_equal;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    out.extend(checkerboard::check(context));
    lamps::check(context, out);
    let scene = context.scene;
    let live = live_nodes(scene);
    let originals = originals(scene);
    let mut is_part = vec![false; scene.nodes.len()];
    let unused = LazyCell::new(|| unused(context));
    // Operations stand behind their operands: from the end, the outermost union comes first.
    for (i, node) in scene.nodes.iter().enumerate().rev() {
        if live[i]
            && let Node::Union(a, b) | Node::Intersection(a, b) = node
            && a == b
        {
            out.extend(same(context, i as NodeId, &unused));
            continue;
        }
        if live[i] && !is_part[i] && matches!(node, Node::Union(..)) {
            twice(context, i as NodeId, (&originals, &mut is_part), out);
        }
    }
}

/// Reports operands of a union, and of the unions within it, that are another operand once more: as a copy that has not
/// been moved, or as an equal shape. Marks the unions that it visits in `is_part`.
fn twice(
    context: &Context,
    union: NodeId,
    (originals, is_part): (&[NodeId], &mut [bool]),
    out: &mut Vec<Diagnostic>,
) {
    let scene = context.scene;
    let mut seen: FxHashMap<NodeId, NodeId> = FxHashMap::default();
    let mut shapes: FxHashMap<equal::Key, NodeId> = FxHashMap::default();
    let mut todo = vec![union];
    while let Some(node) = todo.pop() {
        if let Node::Union(a, b) = scene.nodes[node as usize] {
            if !std::mem::replace(&mut is_part[node as usize], true) {
                todo.extend([b, a]);
            }
            continue;
        }
        let original = originals[node as usize];
        let first = *seen.entry(original).or_insert(node);
        if first != node {
            out.extend(finding(scene, union, first, node));
            continue;
        }
        if let Some(key) = equal::Key::new(scene, node) {
            let first = *shapes.entry(key).or_insert(node);
            if first != node && equal::are(scene, first, node) {
                out.extend(equal::finding(context, union, first, node));
            }
        }
    }
}

/// The objects that no record names.
pub(super) fn unused<'a>(context: &Context<'a>) -> Vec<&'a Entity> {
    let named: FxHashSet<u32> = (context.records())
        .flat_map(|r| context.references(r))
        .collect();
    let entities = context.scene.entities.iter();
    let objects = entities.filter(|e| e.kind == Some(Kind::Object));
    objects.filter(|e| !named.contains(&e.id)).collect()
}

/// The finding about an operation that names an object twice. If exactly one object above the operation is unused, the
/// fix names that one.
fn same(context: &Context, operation: NodeId, unused: &[&Entity]) -> Option<Diagnostic> {
    let record = context.scene.origins[operation as usize];
    let p = context.params(record.span)?;
    let id = p.integer(SECOND);
    let place = p.span_of(SECOND, 1);
    let d = Diagnostic::new(Code::W333, place)
        .case("same")
        .with("type", Value::Term(p.ty.title))
        .with("id", record.id.to_string())
        .with("one-id", id.to_string());
    Some(match instead(&p, record.span, unused) {
        Some(fix) => d.fix(fix),
        None => d,
    })
}

/// The fix that makes the only unused object above an operation its second operand. `None` unless there is exactly one.
pub(super) fn instead(p: &Params, operation: Span, unused: &[&Entity]) -> Option<Fix> {
    let mut above = unused.iter().filter(|e| e.span.start < operation.start);
    let (Some(one), None) = (above.next(), above.next()) else {
        return None;
    };
    let text = one.id.to_string();
    let place = p.span_of(SECOND, 1);
    let fix = Fix::replace("fix-write", Applicability::Unsafe, place, text.clone());
    Some(fix.with("number", quote(&text)))
}

/// The index of the second operand among the parameters.
const SECOND: usize = 1;

/// For each node the object below all of its copies and paints, or the node itself. Copies stand behind their
/// originals.
fn originals(scene: &Scene) -> Vec<NodeId> {
    let mut originals: Vec<NodeId> = Vec::with_capacity(scene.nodes.len());
    for (i, node) in scene.nodes.iter().enumerate() {
        originals.push(match node {
            Node::Copy { child, .. } | Node::Paint { child, .. } => originals[*child as usize],
            _ => i as NodeId,
        });
    }
    originals
}

/// The copy below the paints of a node, and the ID of the copy; `None` if the node is no copy.
fn copied(scene: &Scene, mut node: NodeId) -> Option<(NodeId, u32)> {
    while let Node::Paint { child, .. } = scene.nodes[node as usize] {
        node = child;
    }
    match scene.nodes[node as usize] {
        Node::Copy { id, .. } => Some((node, id)),
        _ => None,
    }
}

fn finding(scene: &Scene, union: NodeId, a: NodeId, b: NodeId) -> Option<Diagnostic> {
    let (one, (copy, id)) = match copied(scene, b) {
        Some(copy) => (a, copy),
        None => (b, copied(scene, a)?),
    };
    let same = |mut node: NodeId| {
        while let Node::Copy { child, .. } = scene.nodes[node as usize] {
            node = child;
        }
        node
    };
    let (named, _) = named_core(scene, one)?;
    let record = scene.origins[copy as usize];
    let taken = scene.origins[union as usize];
    let d = Diagnostic::new(Code::W333, record.span)
        .case(if same(a) == same(b) { "" } else { "painted" })
        .with("id", taken.id.to_string())
        .with("one", Value::Term(named.title))
        .with("one-id", named.id.to_string())
        .with("two-id", id.to_string());
    Some(d.label(named.span, "one"))
}
