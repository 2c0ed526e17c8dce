//! Two shapes of one kind, with the same numbers, in one place.

use crate::diagnostics::{Code, Diagnostic, Edit, Fix, Value};
use crate::geometry::Matrix;
use crate::lint::Context;
use crate::lint::rules::TRANSFORMATIONS;
use crate::scene::{Geometry, Node, NodeId, Scene};
use crate::solids::shapes::facts::Facts;
use crate::solids::{Named, named};
use crate::syntax::table::ShapeKind;
use crate::syntax::{Record, quote};

/// Largest difference of two matrices that are equal but for rounding, as a share of their largest entry.
const MATRIX_REL_EPS: f64 = 1e-12;
/// Step of the grid on which bounds are compared, as a share of their size.
const GRID_REL_STEP: f64 = 1e-6;

/// The kind of a shape, and its bounds on a grid.
#[derive(PartialEq, Eq, Hash)]
pub(super) struct Key(ShapeKind, [i64; 6]);

impl Key {
    /// The key of a shape, moved and painted or not; `None` for other objects.
    pub(super) fn new(scene: &Scene, node: NodeId) -> Option<Key> {
        let (shape, matrix) = placed(scene, node)?;
        let kind = scene.shapes[shape as usize].kind;
        let bounds = geometry(scene, shape).bounds(&matrix);
        let size = match bounds.is_finite() {
            true => bounds.far().max(f64::MIN_POSITIVE),
            false => 1.0,
        };
        let ends = [bounds.min, bounds.max].concat();
        // Infinite ends become the largest and smallest integers.
        let on_grid = |i: usize| (ends[i] / size / GRID_REL_STEP).round() as i64;
        Some(Key(kind, std::array::from_fn(on_grid)))
    }
}

fn placed(scene: &Scene, node: NodeId) -> Option<(u32, Matrix)> {
    let (core, matrix) = scene.core(node, Matrix::IDENTITY);
    match scene.nodes[core as usize] {
        Node::Shape(shape) => Some((shape, matrix)),
        _ => None,
    }
}

fn geometry(scene: &Scene, shape: u32) -> &Geometry {
    &scene.shapes[shape as usize].geometry
}

/// Whether two nodes are equal shapes in one place, but for rounding of the place. `false` for other objects.
pub(in crate::lint::rules) fn are(scene: &Scene, a: NodeId, b: NodeId) -> bool {
    let (Some((a, m)), Some((b, n))) = (placed(scene, a), placed(scene, b)) else {
        return false;
    };
    let pairs = || (m.0.iter().flatten()).zip(n.0.iter().flatten());
    let size = pairs().fold(0.0, |s: f64, (x, y)| s.max(x.abs()).max(y.abs()));
    a != b
        && geometry(scene, a) == geometry(scene, b)
        && pairs().all(|(x, y)| (x - y).abs() <= MATRIX_REL_EPS * size)
}

/// The finding about a union of two equal shapes in one place.
pub(super) fn finding(
    context: &Context,
    union: NodeId,
    a: NodeId,
    b: NodeId,
) -> Option<Diagnostic> {
    let scene = context.scene;
    let (a, b) = (named(scene, a)?, named(scene, b)?);
    let (one, two) = match a.span.start <= b.span.start {
        true => (a, b),
        false => (b, a),
    };
    let taken = scene.origins[union as usize];
    let d = Diagnostic::new(Code::W333, two.span)
        .case("equal")
        .with("id", taken.id.to_string())
        .with("one", Value::Term(one.title))
        .with("one-id", one.id.to_string())
        .with("two-id", two.id.to_string())
        .label(one.span, "one");
    Some(match moved(context, one, two) {
        Some(fix) => d.fix(fix),
        None => d,
    })
}

/// The fix that writes the ID of the second shape into those transformations of the first one that stand right behind
/// the second. `None` if there are none.
fn moved(context: &Context, one: Named, two: Named) -> Option<Fix> {
    let own = context.document.item_at(two.span.start)?;
    let behind = context.document.items[own + 1..].iter();
    let of_either = |r: &&Record| r.id == one.id || r.id == two.id;
    let changes = behind.map_while(|item| item.record().filter(of_either));
    let slips = changes.filter(|r| r.id == one.id && TRANSFORMATIONS.contains(&r.kind));
    let text = two.id.to_string();
    let edits: Vec<Edit> = slips
        .map(|r| Edit {
            span: context.document.id_token(r).span(),
            text: text.clone(),
        })
        .collect();
    let is_one = !edits.is_empty() && one.id != two.id;
    is_one.then(|| Fix::guess("fix-id", edits).with("number", quote(&text)))
}
