//! W337: a clear object without a refractive index, of which a picture shows nothing; and glass without an index in a
//! scene where other glass has one, or that a comment calls glass.
//!
//! In a union the first part that holds a point owns it, so a clear part may cut a hole into a part behind it. A clear
//! part that does so has an effect.

mod called;
mod unlike;

use rustc_hash::FxHashSet;

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Value};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::parts::{Parts, parts};
use crate::lint::rules::optics_by_comment::with_other_optics;
use crate::scene::{DEFAULT_INDEX, Node, NodeId, Optics, Origin, Paint, Rgb, Scene, fold_up};
use crate::solids::proofs::Proofs;
use crate::solids::shapes::facts::Facts;
use crate::solids::within::CLEARANCE_REL;
use crate::solids::{Named, named};
use crate::syntax::Record;
use crate::syntax::table::RecordKind;

/// Most nodes visited, and most pairs of parts compared: some hundredths of a second.
const NODES: usize = 200_000;
const PAIRS: usize = 1_000_000;
/// Most pairs of parts with overlapping boxes that are examined more closely: some hundredths of a second.
const CLOSE_PAIRS: usize = 20_000;

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let scene = context.scene;
    let Some(render) = scene.render else { return };
    let has = |test: Test| {
        let mut optics = scene.paints.iter().filter_map(|p| p.optics);
        optics.any(|o| test(&o))
    };
    let is_unlike = has(is_glass) && scene.paints.iter().any(|p| bent(p).is_some());
    if !has(lets_through) {
        return;
    }
    // An author who writes the index of a vacuum anywhere knows about indices.
    let is_vacuum = |r: &Record| {
        let p = context.record_params(r);
        r.kind == RecordKind::RefractiveIndex && p.numbers(0) == DEFAULT_INDEX
    };
    if context.records().any(is_vacuum) {
        return;
    }
    let kinds = parts(scene);
    if has(is_clear) {
        out.extend(invisible(context, render.root, &kinds));
    }
    if is_unlike {
        out.extend(unlike::others(context, render.root, &kinds));
    }
    out.extend(called::called(context, render.root, &kinds));
}

/// The finding about clear objects without an index, except those that cut holes into other parts.
fn invisible(context: &Context, root: NodeId, kinds: &[Parts]) -> Option<Diagnostic> {
    let scene = context.scene;
    let all = members(context, root, is_clear)?;
    let mut left = PAIRS;
    let mut proofs: Option<Proofs> = None;
    let mut close_left = CLOSE_PAIRS;
    let mut told = FxHashSet::default();
    let mut unseen = Vec::new();
    for (i, part) in all.iter().enumerate().filter(|(_, part)| part.is_plain()) {
        match left.checked_sub(all.len() - i) {
            Some(rest) => left = rest,
            None => break,
        }
        let cuts = |other: &Member| {
            let is_near = !other.is_plain() && !is_apart(&part.bounds, &other.bounds);
            if !is_near || close_left == 0 || part.moved != other.moved {
                return is_near;
            }
            close_left -= 1;
            let [one, two] = [part, other].map(|m| [(m.node, false)]);
            let proofs = proofs.get_or_insert_with(|| Proofs::new(scene, context.bounds()));
            proofs.nothing(&one, &two, None).is_none()
        };
        if !part.is_solid(kinds) || all[i + 1..].iter().any(cuts) {
            continue;
        }
        if let (Some(object), Some(paint)) = (named(scene, part.node), part.paint)
            && told.insert(paint)
        {
            unseen.push((object, scene.origins[paint as usize]));
        }
    }
    let cases = ["", "several"];
    finding(context, &unseen, cases, "1.5 1.5 1.5")
}

/// The finding about objects without an index, each with the record of its optics, and the fix that gives them one.
/// `None` if no objects are left. `one` and `several` are the cases of the finding.
fn finding(
    context: &Context,
    objects: &[(Named, Origin)],
    [one, several]: [&'static str; 2],
    index: &str,
) -> Option<Diagnostic> {
    // W342 reports optics that differ from what a comment says.
    let others = match objects.is_empty() {
        true => return None,
        false => with_other_optics(context),
    };
    let is_told = |object: &Named, record: &Origin| {
        let optics = context
            .params(record.span)
            .filter(|p| p.ty.kind == RecordKind::Assignment)
            .and_then(|p| u32::try_from(p.integer(1)).ok());
        let ids = [Some(object.id), Some(record.id), optics];
        ids.into_iter().flatten().any(|id| others.contains(&id))
    };
    let objects: Vec<(Named, Origin)> = objects
        .iter()
        .filter(|(object, record)| !is_told(object, record))
        .copied()
        .collect();
    let &(object, record) = objects.first()?;
    let line = |id: u32| format!("{id} -203 {index}");
    let edits = objects.iter().flat_map(|(_, record)| {
        let lines = [line(record.id)];
        let fix = context.add_behind(record.span, "fix", Applicability::Unsafe, &lines);
        fix.edits
    });
    let mut edits: Vec<_> = edits.collect();
    edits.sort_by_key(|e| e.span.start);
    let d = Diagnostic::new(Code::W337, record.span)
        .case(if objects.len() == 1 { one } else { several })
        .with("count", Value::Count(objects.len() as u64))
        .with("object", Value::Term(object.title))
        .with("object-id", object.id.to_string())
        .with("line", line(record.id));
    Some(d.fix(Fix::guess("fix", edits)))
}

/// A condition on optics, which chooses the parts that a search is about.
type Test = fn(&Optics) -> bool;

/// A part of the outermost union.
struct Member {
    node: NodeId,
    /// The transformation of the union that the part is an operand of.
    moved: Matrix,
    bounds: Aabb,
    /// Whether the optics of the whole part meet the condition.
    meets: bool,
    /// An index that a paint above the part or within it gives.
    index: Option<Rgb>,
    /// The paint whose optics count; `None` if there is none above, and those within do not all meet the condition.
    paint: Option<NodeId>,
}

impl Member {
    /// Whether the part meets the condition and has no index.
    fn is_plain(&self) -> bool {
        self.meets && self.index.is_none()
    }

    fn is_solid(&self, kinds: &[Parts]) -> bool {
        let Parts { surface, solid } = kinds[self.node as usize];
        solid && surface.is_none()
    }
}

/// Properties that paints above a node give to it.
#[derive(Clone, Copy, Default)]
struct Above {
    /// Whether the outermost optics above meet the condition, and the paint that gives them.
    optics: Option<(bool, NodeId)>,
    index: Option<Rgb>,
}

/// All parts of the outermost union, in the order of the operands, with their optics held against the condition `test`.
/// `None` if there are too many.
fn members(context: &Context, root: NodeId, test: Test) -> Option<Vec<Member>> {
    let scene = context.scene;
    let owns = owns(scene, test);
    let mut out = Vec::new();
    let mut todo = vec![(
        (root, Matrix::IDENTITY),
        root,
        Matrix::IDENTITY,
        Above::default(),
    )];
    let mut left = NODES;
    while let Some((operand, node, matrix, mut above)) = todo.pop() {
        left = left.checked_sub(1)?;
        match scene.nodes[node as usize] {
            Node::Union(a, b) => {
                todo.extend([b, a].map(|child| ((child, matrix), child, matrix, above)));
            }
            Node::Transform { child, matrix: m } => {
                let moved = matrix.after(&scene.matrices[m as usize]);
                todo.push((operand, child, moved, above));
            }
            Node::Copy { child, .. } => todo.push((operand, child, matrix, above)),
            Node::Paint { child, paint } => {
                let paint = &scene.paints[paint as usize];
                let own = paint.optics.map(|o| (test(&o), node));
                above.optics = above.optics.or(own);
                above.index = above.index.or(bent(paint));
                todo.push((operand, child, matrix, above));
            }
            _ => {
                let own = owns[node as usize];
                let (meets, paint) = match above.optics {
                    Some((meets, paint)) => (meets, Some(paint)),
                    None => (own.paint.is_some(), own.paint),
                };
                out.push(Member {
                    node: operand.0,
                    moved: operand.1,
                    bounds: match scene.nodes[node as usize] {
                        Node::Shape(s) => scene.shapes[s as usize].geometry.bounds(&matrix),
                        _ => context.bounds()[node as usize].all.transformed(&matrix),
                    },
                    meets,
                    index: above.index.or(own.index),
                    paint,
                });
            }
        }
    }
    Some(out)
}

/// The index of a paint, if it differs from that of the space outside. An assignment always gives an index, often that
/// of the space outside.
fn bent(paint: &Paint) -> Option<Rgb> {
    paint.index.filter(|&index| index != DEFAULT_INDEX)
}

/// Whether half of the light or more goes through, in each colour channel.
fn lets_through(o: &Optics) -> bool {
    o.kt.iter().all(|&x| x >= 0.5)
}

/// Whether half of the light or more goes through, in each colour channel, and none is scattered.
fn is_glass(o: &Optics) -> bool {
    o.kd == [0.0; 3] && lets_through(o)
}

fn is_clear(o: &Optics) -> bool {
    o.kd == [0.0; 3] && o.ks == [0.0; 3] && o.kt == [1.0; 3]
}

/// Properties of a node by itself.
#[derive(Clone, Copy, Default)]
struct Own {
    /// A paint whose optics meet the condition, if the optics of all parts do.
    paint: Option<NodeId>,
    /// An index that any part of the node has.
    index: Option<Rgb>,
}

fn owns(scene: &Scene, test: Test) -> Vec<Own> {
    fold_up(&scene.nodes, |id, node, done: &[Own]| {
        let of = |n: NodeId| done[n as usize];
        match node {
            Node::Shape(_) => Own::default(),
            Node::Union(a, b) | Node::Intersection(a, b) => Own {
                paint: of(a).paint.and(of(b).paint).and(of(a).paint),
                index: of(a).index.or(of(b).index),
            },
            // Nothing is seen of the tool of a difference.
            Node::Difference(a, _) => of(a),
            Node::Complement(child) | Node::Transform { child, .. } | Node::Copy { child, .. } => {
                of(child)
            }
            Node::Paint { child, paint } => {
                let paint = &scene.paints[paint as usize];
                let own = |o: Optics| test(&o).then_some(id);
                Own {
                    paint: paint.optics.map_or(of(child).paint, own),
                    index: bent(paint).or(of(child).index),
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
