//! W337: an object that lets all light through, and has no refractive index: a picture shows nothing of it.
//!
//! In a union the first part owns a point, so what is clear may cut a hole into what comes behind it. Such a part has an
//! effect.

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::parts::{Parts, parts};
use crate::scene::{DEFAULT_INDEX, Node, NodeId, Optics, Paint, Scene, fold_up};
use crate::solids::named;
use crate::solids::shapes::facts::Facts;
use crate::solids::within::CLEARANCE_REL;
use crate::syntax::Record;
use crate::syntax::table::RecordKind;

/// Nodes gone through, and pairs of parts compared: some hundredths of a second.
const NODES: usize = 200_000;
const PAIRS: usize = 1_000_000;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    if !scene
        .paints
        .iter()
        .any(|p| p.optics.is_some_and(|o| is_clear(&o)))
    {
        return;
    }
    // Somebody who writes the index of a vacuum means it.
    let is_vacuum = |r: &Record| {
        let p = context.record_params(r);
        r.kind == RecordKind::RefractiveIndex && p.numbers(0) == DEFAULT_INDEX
    };
    if context.records().any(is_vacuum) {
        return;
    }
    let kinds = parts(scene);
    let Some(all) = members(context, render.root) else {
        return;
    };
    let mut left = PAIRS;
    let mut told = FxHashSet::default();
    let mut unseen = Vec::new();
    for (i, part) in all.iter().enumerate().filter(|(_, part)| part.is_clear) {
        match left.checked_sub(all.len() - i) {
            Some(rest) => left = rest,
            None => break,
        }
        let cuts = |other: &Member| !other.is_clear && !is_apart(&part.bounds, &other.bounds);
        let Parts { surface, solid } = kinds[part.node as usize];
        if !solid || surface.is_some() || all[i + 1..].iter().any(cuts) {
            continue;
        }
        if let (Some(object), Some(paint)) = (named(scene, part.node), part.paint)
            && told.insert(paint)
        {
            unseen.push((object, scene.origins[paint as usize]));
        }
    }
    let Some(&(object, record)) = unseen.first() else {
        return;
    };
    let line = |id: u32| format!("{id} -203 1.5 1.5 1.5");
    let edits = unseen.iter().flat_map(|(_, record)| {
        let lines = [line(record.id)];
        let fix = context.add_behind(record.span, "fix", Applicability::Unsafe, &lines);
        fix.edits
    });
    let mut edits: Vec<_> = edits.collect();
    edits.sort_by_key(|e| e.span.start);
    let d = Diagnostic::new(Code::W337, record.span)
        .case(if unseen.len() == 1 { "" } else { "several" })
        .with("count", Value::Count(unseen.len() as u64))
        .with("object", Value::Term(object.title))
        .with("object-id", object.id.to_string())
        .with("line", line(record.id));
    out.push(d.fix(Fix::guess("fix", edits)));
}

/// A part of the outermost union.
struct Member {
    node: NodeId,
    bounds: Aabb,
    /// Whether all of it lets all light through, and nothing gives it an index.
    is_clear: bool,
    /// The paint that says so.
    paint: Option<NodeId>,
}

/// Properties that paints above a node give to it.
#[derive(Clone, Copy, Default)]
struct Above {
    /// Whether a paint has optics, and whether these are clear.
    optics: Option<(bool, NodeId)>,
    has_index: bool,
}

/// All parts, in the order of the operands; `None` if there are too many.
fn members(context: &Context, root: NodeId) -> Option<Vec<Member>> {
    let scene = context.scene;
    let clear = clear(scene);
    let mut out = Vec::new();
    let mut todo = vec![(root, root, Matrix::IDENTITY, Above::default())];
    let mut left = NODES;
    while let Some((operand, node, matrix, mut above)) = todo.pop() {
        left = left.checked_sub(1)?;
        match scene.nodes[node as usize] {
            Node::Union(a, b) => {
                todo.extend([b, a].map(|child| (child, child, matrix, above)));
            }
            Node::Transform { child, matrix: m } => {
                let moved = matrix.after(&scene.matrices[m as usize]);
                todo.push((operand, child, moved, above));
            }
            Node::Copy { child, .. } => todo.push((operand, child, matrix, above)),
            Node::Paint { child, paint } => {
                let paint = &scene.paints[paint as usize];
                let own = paint.optics.map(|o| (is_clear(&o), node));
                above.optics = above.optics.or(own);
                above.has_index |= bends(paint);
                todo.push((operand, child, matrix, above));
            }
            _ => {
                let own = clear[node as usize];
                let (is_clear, paint) = match above.optics {
                    Some((is_clear, paint)) => (is_clear, Some(paint)),
                    None => (own.paint.is_some(), own.paint),
                };
                out.push(Member {
                    node: operand,
                    bounds: match scene.nodes[node as usize] {
                        Node::Shape(s) => scene.shapes[s as usize].geometry.bounds(&matrix),
                        _ => context.bounds()[node as usize].all.transformed(&matrix),
                    },
                    is_clear: is_clear && !above.has_index && !own.has_index,
                    paint,
                });
            }
        }
    }
    Some(out)
}

/// Whether a paint gives another index than that of the space outside. What an assignment gives has an index, too.
fn bends(paint: &Paint) -> bool {
    paint.index.is_some_and(|index| index != DEFAULT_INDEX)
}

fn is_clear(o: &Optics) -> bool {
    o.kd == [0.0; 3] && o.ks == [0.0; 3] && o.kt == [1.0; 3]
}

/// Properties of a node by itself.
#[derive(Clone, Copy, Default)]
struct Own {
    /// A paint with clear optics, where all parts have such.
    paint: Option<NodeId>,
    /// Whether anything of it has an index.
    has_index: bool,
}

fn clear(scene: &Scene) -> Vec<Own> {
    fold_up(&scene.nodes, |id, node, done: &[Own]| {
        let of = |n: NodeId| done[n as usize];
        match node {
            Node::Shape(_) => Own::default(),
            Node::Union(a, b) | Node::Intersection(a, b) => Own {
                paint: of(a).paint.and(of(b).paint).and(of(a).paint),
                has_index: of(a).has_index || of(b).has_index,
            },
            // Of a tool nothing is seen.
            Node::Difference(a, _) => of(a),
            Node::Complement(child) | Node::Transform { child, .. } | Node::Copy { child, .. } => {
                of(child)
            }
            Node::Paint { child, paint } => {
                let paint = &scene.paints[paint as usize];
                let own = |o: Optics| is_clear(&o).then_some(id);
                Own {
                    paint: paint.optics.map_or(of(child).paint, own),
                    has_index: bends(paint) || of(child).has_index,
                }
            }
        }
    })
}

/// Whether two boxes have at most their borders in common.
fn is_apart(a: &Aabb, b: &Aabb) -> bool {
    let hair = CLEARANCE_REL
        * [a, b]
            .iter()
            .filter(|x| x.is_finite())
            .fold(1.0, |m: f64, x| m.max(x.far()));
    (0..3).any(|i| a.max[i] <= b.min[i] + hair || b.max[i] <= a.min[i] + hair)
}
