//! The move of a shape or a camera that has a place of its own, right behind another shape or a lamp that stays at the
//! origin.

use rustc_hash::{FxHashMap, FxHashSet};

use crate::diagnostics::{Applicability, Code, Diagnostic, Fix, Severity, Value};
use crate::geometry::{Aabb, Matrix};
use crate::lint::Context;
use crate::lint::rules::TRANSFORMATIONS;
use crate::scene::{Shape, Vec3};
use crate::solids::shapes::facts::Facts as _;
use crate::syntax::table::RecordKind;
use crate::syntax::{Record, quote};

const ORIGIN: Vec3 = [0.0; 3];

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let shapes = context.scene.shapes.iter();
    let shapes: FxHashMap<u32, &Shape> = shapes.map(|s| (s.id, s)).collect();
    // A shape that is only turned or scaled stays at the origin.
    let places = [RecordKind::Translation, RecordKind::RotationMatrix];
    let changes = (context.records()).filter(|r| places.contains(&r.kind));
    let changed: FxHashSet<u32> = changes.map(|r| r.id).collect();
    let copied: FxHashSet<u32> = (context.records())
        .filter(|r| r.kind == RecordKind::Copy)
        .flat_map(|r| context.references(r))
        .collect();
    let mut defined: FxHashMap<u32, &Record> = FxHashMap::default();
    let mut moved: FxHashSet<u32> = FxHashSet::default();
    let mut above: Option<&Record> = None;
    for record in context.records() {
        let is_shape = matches!(record.kind, RecordKind::Shape(_));
        let is_first = is_change(record) && moved.insert(record.id);
        if record.kind == RecordKind::Translation
            && is_first
            && let Some(own) = defined.get(&record.id)
            && let Some(other) = above.and_then(|r| defined.get(&r.id))
            && own.first < other.first
            && !changed.contains(&other.id)
            && !copied.contains(&other.id)
            && has_place(context, &shapes, own)
            && is_about_origin(&shapes, other)
        {
            out.push(finding(context, record, other));
        }
        if is_shape || matches!(record.kind, RecordKind::PointLight | RecordKind::Camera) {
            defined.entry(record.id).or_insert(record);
        }
        above = Some(record);
    }
}

fn is_change(record: &Record) -> bool {
    TRANSFORMATIONS.contains(&record.kind)
}

/// Whether the record's own numbers put a shape or a camera elsewhere than at the origin.
fn has_place(context: &Context, shapes: &FxHashMap<u32, &Shape>, own: &Record) -> bool {
    match own.kind {
        RecordKind::Camera => context.record_params(own).numbers(0) != ORIGIN,
        _ => bounds(shapes, own.id).is_some_and(|b| b.is_bounded() && !b.contains(ORIGIN)),
    }
}

/// Whether the record `other` is a shape around the origin, or a lamp.
fn is_about_origin(shapes: &FxHashMap<u32, &Shape>, other: &Record) -> bool {
    let is_around = |b: Aabb| b.is_bounded() && b.contains(ORIGIN);
    other.kind == RecordKind::PointLight || bounds(shapes, other.id).is_some_and(is_around)
}

fn bounds(shapes: &FxHashMap<u32, &Shape>, id: u32) -> Option<Aabb> {
    let shape = shapes.get(&id)?;
    Some(shape.geometry.bounds(&Matrix::IDENTITY))
}

/// The finding about the move `place` of one shape that is rather meant for the shape `other`.
fn finding(context: &Context, place: &Record, other: &Record) -> Diagnostic {
    let p = context.record_params(place);
    let id = other.id.to_string();
    let fix = Fix::replace("fix-write", Applicability::Unsafe, p.id_span(), id.clone());
    Diagnostic::new(Code::W336, p.span())
        .case("shape")
        .severity(Severity::Note)
        .with("type", Value::Term(other.ty().title))
        .with("id", p.id.to_string())
        .with("other", id.clone())
        .label(context.record_params(other).span(), "first")
        .fix(fix.with("number", quote(&id)))
}
