//! N609: a single shape, difference or intersection that is moved and then turned about an axis through the origin,
//! which takes it elsewhere.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Edit, Fix, Span, Value};
use crate::geometry::array::{length, sub};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::rules::{PLACE_REL_GAP, TRANSFORMATIONS};
use crate::lint::spelling::near;
use crate::scene::{Node, Vec3, transformation};
use crate::solids::shapes::facts::Facts as _;
use crate::syntax::table::{Effect, Family, Kind, RecordKind};
use crate::syntax::{Record, quote};

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut chains: FxHashMap<u32, Vec<&Record>> = FxHashMap::default();
    let (mut objects, mut parts) = (FxHashSet::default(), FxHashSet::default());
    for record in context.records() {
        if TRANSFORMATIONS.contains(&record.kind) {
            chains.entry(record.id).or_default().push(record);
            continue;
        }
        if matches!(record.ty().effect, Effect::Defines(Kind::Object)) {
            objects.insert(record.id);
        }
        if record.ty().family == Family::Operation && record.kind != RecordKind::Union {
            parts.extend(context.references(record));
        }
    }
    let is_turned = |chain: &[&Record]| {
        let of = |kind| chain.iter().position(|r| r.kind == kind);
        let pair = of(RecordKind::Translation).zip(of(RecordKind::Rotation));
        pair.is_some_and(|(moved, turned)| moved < turned)
    };
    let mut turned = chains
        .iter()
        .filter(|(id, chain)| objects.contains(*id) && is_turned(chain));
    // Several turned objects are an arrangement around the origin, and are meant.
    let (Some((id, chain)), None) = (turned.next(), turned.next()) else {
        return;
    };
    // The object is an arm of a group if another object that contains it is moved, or a copy.
    let is_group = context.records().any(|r| {
        let is_other = r.id != *id && (r.kind == RecordKind::Copy || chains.contains_key(&r.id));
        is_other && context.references(r).any(|part| part == *id)
    });
    // Another rule reports an object that is not drawn.
    let is_used = || {
        let mut records = context.records();
        records.any(|r| context.references(r).any(|used| used == *id))
    };
    if is_group || parts.contains(id) || context.has_broken() || !is_used() {
        return;
    }
    out.extend(solid(context, *id).and_then(|solid| finding(context, *id, solid, chain)));
}

/// The title of a shape, a difference or an intersection, and its bounds before any transformation. `None` for other
/// objects.
fn solid(context: &Context, id: u32) -> Option<(&'static str, Aabb)> {
    let scene = context.scene;
    if let Some(shape) = scene.shapes.iter().find(|s| s.id == id) {
        return Some((shape.ty().title, shape.geometry.bounds(&Matrix::IDENTITY)));
    }
    let is_one = |node: &Node| matches!(node, Node::Difference(..) | Node::Intersection(..));
    let mut nodes = scene.nodes.iter().zip(&scene.origins);
    let node = nodes.position(|(node, origin)| origin.id == id && is_one(node))?;
    let title = context.titles().get(&id).copied()?;
    Some((title, context.bounds()[node].all))
}

/// The exchange of a solid's only transformations, a translation and a rotation right behind it.
pub(in crate::lint::rules) struct Swap {
    /// The bounding box of the solid after the exchange.
    pub bounds: Aabb,
    pub fix: Fix,
}

/// The exchange of a solid's translation and rotation that stand above the byte offset `place`. `None` if the solid has
/// other transformations.
pub(in crate::lint::rules) fn swap(context: &Context, id: u32, place: u32) -> Option<Swap> {
    let is_own = |r: &&Record| r.id == id && TRANSFORMATIONS.contains(&r.kind);
    let chain: Vec<&Record> = context.records().filter(is_own).take(3).collect();
    let [moved, turned] = chain[..] else {
        return None;
    };
    let is_pair = (moved.kind, turned.kind) == (RecordKind::Translation, RecordKind::Rotation);
    let spans = [moved, turned].map(|r| context.record_params(r).span());
    if !is_pair || spans[1].end > place {
        return None;
    }
    let (_, bounds) = solid(context, id)?;
    let [moved, turned] =
        [moved, turned].map(|r| transformation(&context.record_params(r), &mut Vec::new()));
    Some(Swap {
        bounds: bounds.transformed(&moved?.after(&turned?)),
        fix: swapped(context, spans),
    })
}

fn swapped(context: &Context, [one, two]: [Span; 2]) -> Fix {
    let edits = [(one, two), (two, one)].map(|(span, other)| Edit {
        span,
        text: context.text[other.range()].to_owned(),
    });
    Fix {
        applicability: Applicability::Choice,
        ..Fix::guess("fix", edits.into())
    }
}

/// The finding about a solid with a translation, then a rotation, and no other transformation. `None` for any other
/// solid, or if the rotation leaves the solid where it is.
fn finding(
    context: &Context,
    id: u32,
    (title, bounds): (&'static str, Aabb),
    chain: &[&Record],
) -> Option<Diagnostic> {
    let [moved, turned] = *chain else {
        return None;
    };
    if (moved.kind, turned.kind) != (RecordKind::Translation, RecordKind::Rotation) {
        return None;
    }
    let [first, second] = [moved, turned].map(|r| context.record_params(r));
    let [place, turn] = [&first, &second].map(|p| transformation(p, &mut Vec::new()));
    let (place, turn) = (place?, turn?);
    if !bounds.is_bounded() {
        return None;
    }
    let before = place.point(bounds.centre());
    let after = turn.point(before);
    if length(sub(before, after)) <= PLACE_REL_GAP * length(before) {
        return None;
    }
    let said = |place: Vec3| {
        let size = length(before);
        quote(&place.map(|x| near(x, size)).join(" "))
    };
    let [one, two] = [first.span(), second.span()];
    let fix = swapped(context, [one, two]);
    Some(
        Diagnostic::new(Code::N609, two)
            .with("type", Value::Term(title))
            .with("id", id.to_string())
            .with("from", said(before))
            .with("to", said(after))
            .label(one, "move")
            .fix(fix),
    )
}
